// The outcome of a run of a study. As one line of JSON it is what the run's process prints, and a file of the study's
// folder.
#pragma once

#include <string>
#include <string_view>

#include "report/figures.h"

namespace dgd_demos {

struct RunRecord {
  enum class Status {
    kDone,
    kLost,    ///< A body left the world or was not finite; the run ended there, and has figures.
    kFailed,  ///< The run crashed or could not be carried out, and has no figures.
  };

  int number;  ///< RunSpec::number
  Status status;
  std::string message;     ///< Reason why the run is lost or failed; empty if it is done.
  std::string build_type;  ///< Build type of the program that carried it out.
  FigureValues figures;    ///< Empty if it failed.
};

const char* NameOf(RunRecord::Status status);  ///< "done", "lost", "failed"

/// Formats a record without a newline. Numbers read back to the bit.
std::string ToLine(const RunRecord& record);
/// @throws std::runtime_error if the text is not a line of ToLine().
RunRecord ParseRunRecord(std::string_view line);

}  // namespace dgd_demos
