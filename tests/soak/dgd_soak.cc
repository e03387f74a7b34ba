// dgd_soak: random pairs of sets of all types for as long as one likes, every answer checked. See --help.
#include <csignal>
#include <cstdio>
#include <iostream>

#include "program_main.h"
#include "soak/soak_options.h"
#include "soak/soak_report.h"
#include "soak/soak_run.h"

namespace dgd_soak {
namespace {

ExitStatus Replay(const SoakOptions& options) {
  const SoakCase soak_case = MakeCase(options.seed, *options.replay, options.frames);
  std::cout << "case " << soak_case.index << ", placement " << NameOf(soak_case.placement) << ", growth distance "
            << (soak_case.growth_distance > 0 ? std::to_string(soak_case.growth_distance) : "unknown") << "\n"
            << Dump(soak_case.pair);
  std::string text;
  if (options.in_double) text += "\ndouble\n" + Describe<double>(soak_case, options.query);
  if (options.in_float) text += "\nfloat\n" + Describe<float>(soak_case, options.query);
  std::cout << text;
  return text.find("\ncomplaints\n") == std::string::npos ? kSuccess : kFailedCase;
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
