// The folder of a study's results: a file for each run that is done, so that a process that dies loses only the runs
// that it had begun.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "sweep/run_record.h"
#include "sweep/study.h"

namespace dgd_demos {

class StudyFolder {
 public:
  /// Makes the folder if it is missing. An existing one must have the same identity: the study's JSON, the content of
  /// its worlds, and the precisions of its runs, which are the program's own if the study lists none.
  /// @throws std::runtime_error if the folder has another identity, or cannot be written.
  StudyFolder(const std::filesystem::path& folder, const Study& study);

  const std::filesystem::path& path() const { return folder_; }

  /// Reads the records of all runs that are done, by the runs' numbers.
  /// @throws std::runtime_error that names a damaged record.
  std::map<int, RunRecord> ReadRecords() const;

  /// Writes a record to disk as a whole, or not at all.
  /// @throws std::runtime_error if it cannot be written.
  void Write(const RunRecord& record) const;
  /// Copies the records of another folder of the same study.
  void TakeFrom(const StudyFolder& other) const;

 private:
  std::filesystem::path FileOf(int number) const;

  std::filesystem::path folder_;
};

}  // namespace dgd_demos
