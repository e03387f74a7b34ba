// What came of a run of a study, as one line of JSON: what a process that carried it out prints, and what a study's
// folder keeps of it.
#pragma once

#include <string>
#include <string_view>

#include "report/figures.h"

namespace dgd_demos {

struct RunRecord {
  enum class Status {
    kDone,
    kLost,    ///< A body left the world or was not finite; the run ended there, and has figures.
    kFailed,  ///< Without figures.
  };

  int number;  ///< RunSpec::number
  Status status;
  std::string message;     ///< Of what is not done: a sentence.
  std::string build_type;  ///< Of the program that carried it out.
  FigureValues figures;    ///< Empty if it failed.
};

const char* NameOf(RunRecord::Status status);  ///< "done", "lost", "failed"

/// Without a newline. Numbers read back to the bit.
std::string ToLine(const RunRecord& record);
/// @throws std::runtime_error if the text is no such line.
RunRecord ParseRunRecord(std::string_view line);

}  // namespace dgd_demos
