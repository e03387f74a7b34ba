// The folder of a study's results: a file for each run that is done, so that what dies loses nothing but what was
// running.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "sweep/run_record.h"
#include "sweep/study.h"

namespace dgd_demos {

class StudyFolder {
 public:
  /// Makes the folder if it is missing. One that is there must be of the same study, with the same worlds.
  /// @throws std::runtime_error if it is of another one, or cannot be written.
  StudyFolder(const std::filesystem::path& folder, const Study& study);

  const std::filesystem::path& path() const { return folder_; }

  /// Of all runs that are done.
  /// @throws std::runtime_error about a record that is damaged.
  std::map<int, RunRecord> ReadRecords() const;

  /// On disk as a whole, or not at all.
  /// @throws std::runtime_error if it cannot be written.
  void Write(const RunRecord& record) const;
  /// Takes over what another folder of the same study has.
  void TakeFrom(const StudyFolder& other) const;

 private:
  std::filesystem::path FileOf(int number) const;

  std::filesystem::path folder_;
};

}  // namespace dgd_demos
