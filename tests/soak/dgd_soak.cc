// dgd_soak: random pairs of sets of all types for as long as one likes, every answer checked. See --help.
#include <csignal>
#include <cstdio>
#include <iostream>
#include <string>

#include "program_main.h"
#include "soak/shrink.h"
#include "soak/soak_options.h"
#include "soak/soak_report.h"
#include "soak/soak_run.h"

namespace dgd_soak {
namespace {

/// What is wrong first, without the frame and the numbers: "relative gap: ". Empty if all is well.
std::string KindOf(const std::string& complaints) {
  const auto begin = complaints.find(", ");
  if (begin == std::string::npos) return "";
  return complaints.substr(begin, complaints.find_first_of("0123456789\n", begin) - begin);
}

template <class S>
std::string KindOfFailure(const SoakCase& soak_case, const Query& query) {
  dgd_test::Tally tally;
  return KindOf(Examine<S>(soak_case, query, tally));
}

/// Everything about the case in one scalar, and about the simplest one that fails alike.
template <class S>
bool Replay(const char* scalar, const SoakCase& soak_case, const SoakOptions& options) {
  std::cout << '\n' << scalar << '\n' << Describe<S>(soak_case, options.query);
  const std::string kind = KindOfFailure<S>(soak_case, options.query);
  if (kind.empty()) return true;
  if (options.shrink) {
    const SoakCase simplest =
        Shrink(soak_case, [&](const SoakCase& c) { return KindOfFailure<S>(c, options.query) == kind; });
    std::cout << "\n" << scalar << ", the simplest that fails alike\n" << Dump(simplest.pair);
    std::cout << Describe<S>(simplest, options.query);
  }
  return false;
}

ExitStatus Replay(const SoakOptions& options) {
  const SoakCase soak_case = MakeCase(options.seed, *options.replay, options.frames);
  std::cout << "case " << soak_case.index << ", placement " << NameOf(soak_case.placement) << ", growth distance "
            << (soak_case.growth_distance > 0 ? std::to_string(soak_case.growth_distance) : "unknown") << "\n"
            << Dump(soak_case.pair);
  bool is_well = true;
  if (options.in_double) is_well = Replay<double>("double", soak_case, options) && is_well;
  if (options.in_float) is_well = Replay<float>("float", soak_case, options) && is_well;
  return is_well ? kSuccess : kFailedCase;
}

ExitStatus Run(const SoakOptions& options) {
  if (options.replay) return Replay(options);
  SoakState state = options.is_resumed ? Load(options.state, options.CaseOptions()) : SoakState(options.CaseOptions());
  // Complaints about files come before the work, not after it.
  if (!options.state.empty()) Save(state, options.state);
  if (!options.csv.empty()) WriteCsv(state, options, options.csv);

  const bool is_complete = RunSoak(options, state);
  std::cout << "dgd_soak " << state.case_options << ", " << state.done << " pairs\n\n" << FormatReport(state, options);
  if (!options.csv.empty()) WriteCsv(state, options, options.csv);
  if (!is_complete) {
    std::cout << "ended early, after " << state.done << " of " << options.pairs << " pairs";
    if (!options.state.empty()) std::cout << "; go on with --resume " << options.state.string();
    std::cout << '\n';
    return kInterrupted;
  }
  return HasFailures(state) ? kFailedCase : kSuccess;
}

}  // namespace
}  // namespace dgd_soak

int main(int argc, char** argv) {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { dgd_soak::RequestStop(); });
  return dgd_demos::RunProgram(dgd_soak::ParseCommandLine(argc, argv), dgd_soak::Run);
}
