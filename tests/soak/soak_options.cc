#include "soak/soak_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <limits>
#include <sstream>
#include <thread>

#include "seed_option.h"

namespace dgd_soak {
namespace {

constexpr const char* kDescription =
    R"(Asks the solver about random pairs of sets of all types, in double and in float, and checks every
answer: by its certificate, by the growth distance known from the construction, float against
double, warm against cold, and the collision check against the growth distance.)";

constexpr const char* kFooter = R"(
Examples:
  dgd_soak                                        a first look: about a minute
  dgd_soak --pairs 10000000 --state soak.state    a night; Ctrl-C saves the state and ends
  dgd_soak --pairs 10000000 --resume soak.state   goes on where that ended, to the same tables
  dgd_soak --types box,cone --scalar double       pairs of boxes and cones only
  dgd_soak --seed 1 --replay 4711 --shrink        all about one case, and made simpler if it fails
  dgd_soak --pairs 1000000 --frames 999 --scalar double --mode cold,warm
           --types point,segment,triangle,box,cylinder,cone,frustum,ellipsoid,polytope,affine-box
                                                  1e9 certified answers: to make a pair takes
                                                  longer than to ask a hundred times about it

Sets:     every length log-uniform; of a set's longest to its shortest, up to 1000; half of them with
          a radius. Half of the pairs from deep inside each other to far apart; the others one of:
          touching exactly, nearly so, aligned along axes, centres on an axis, centres nearly
          coincident, far apart, or as before.
Modes:    cold: each pair alone. warm: set 2 moves by 1 % in --frames frames, each from the last one's
          warm start. yesno: the collision check must not contradict the growth distance.
Bounds:   on the way the lower one never falls and the upper one never rises, but for rounding.
Limits:   in double a relative gap of the tolerance, primal infeasibility of 1e-12 of the pair's size,
          1e-10 with a curved core, beyond what the growth distance makes of the last digit of a
          witness point in the world; in float some units of rounding, and an answer may end short of the
          tolerance where the rounding of its points says more; see tests/support/pairs/limits.h.
Table:    iterations are support function evaluations, per query; figures are the worst of all;
          infeasibility, beyond that last digit, and separation error are relative to the pair's size.

Exit status: 0 all went well; 1 a case failed; 2 wrong command line or state file, or the output cannot
be written; 3 ended early, by Ctrl-C or SIGTERM.)";

constexpr std::int64_t kMaxPairs = 1'000'000'000'000;
constexpr int kMaxFrames = 100'000;
constexpr int kMaxThreads = 256;

std::string TypeNames() {
  std::string names;
  for (const auto& info : dgd_test::kSetTypes) names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

std::string CheckTypeName(const std::string& name) {
  return dgd_test::SetTypeNamed(name) ? "" : "no type " + name + "; there are " + TypeNames();
}

/// The raw words of the command line, before they mean something.
struct Words {
  std::vector<std::string> types;
  std::string scalar = "both";
  std::vector<std::string> modes = {"cold", "warm", "yesno"};
  std::string resume;
};

void AddCaseOptions(CLI::App& app, SoakOptions& options, Words& words) {
  app.add_option("--pairs", options.pairs, "Pairs of sets, of all types in turn")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, kMaxPairs).description(""))
      ->capture_default_str();
  app.add_option("--frames", options.frames, "Warm queries of each pair, after the cold one")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxFrames).description(""))
      ->capture_default_str();
  dgd_demos::AddSeedOption(app, options.seed, "Seed of the random pairs");
  app.add_option("--types", words.types, "Both sets are of these types: " + TypeNames())
      ->type_name("A,B")
      ->delimiter(',')
      ->check(CLI::Validator(CheckTypeName, ""));
  app.add_option("--scalar", words.scalar, "double, float or both")
      ->type_name("S")
      ->check(CLI::IsMember({"double", "float", "both"}).description(""))
      ->capture_default_str();
  app.add_option("--mode", words.modes, "Some of cold, warm, yesno")
      ->type_name("M,M")
      ->delimiter(',')
      ->check(CLI::IsMember({"cold", "warm", "yesno"}).description(""))
      ->capture_default_str();
  app.add_option("--tolerance", options.query.tolerance, "Relative gap asked for in double; 0 for the library's")
      ->type_name("T")
      ->check(CLI::Range(0.0, 0.1).description(""))
      ->capture_default_str();
}

void AddRunOptions(CLI::App& app, SoakOptions& options, Words& words) {
  app.add_option("--threads", options.threads, "Threads")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxThreads).description(""))
      ->capture_default_str();
  app.add_option("--csv", options.csv, "File for the tables, with the indices of the worst cases")->type_name("FILE");
  auto* state = app.add_option("--state", options.state, "File that the progress is saved to")->type_name("FILE");
  app.add_option("--resume", words.resume, "State file to go on from, and to save to")
      ->type_name("FILE")
      ->check(CLI::ExistingFile.description(""))
      ->excludes(state);
  auto* replay =
      app.add_option("--replay", options.replay, "Print everything about the case of this index, and no more")
          ->type_name("INDEX")
          ->check(CLI::Range(std::int64_t{0}, kMaxPairs * 100).description(""));
  app.add_flag("--shrink", options.shrink, "And, if it fails, about the simplest one that fails alike")->needs(replay);
}

std::string Complete(SoakOptions& options, const Words& words) {
  const auto has_mode = [&](const char* mode) { return std::ranges::find(words.modes, mode) != words.modes.end(); };
  options.query.modes = {has_mode("cold"), has_mode("warm"), has_mode("yesno")};
  options.in_double = words.scalar != "float";
  options.in_float = words.scalar != "double";
  for (const std::string& name : words.types) options.types.push_back(*dgd_test::SetTypeNamed(name));
  if (!words.resume.empty()) {
    options.state = words.resume;
    options.is_resumed = true;
  }
  const bool any_pair =
      options.types.empty() || std::ranges::any_of(AllTypePairs(), [&](const TypePair& pair) {
        return std::ranges::count(options.types, pair.type_1) > 0 && std::ranges::count(options.types, pair.type_2) > 0;
      });
  return any_pair ? "" : "--types: no pair of these types";
}

}  // namespace

std::string SoakOptions::CaseOptions() const {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "--seed " << seed;
  if (!types.empty()) out << " --types ";
  for (std::size_t i = 0; i < types.size(); ++i) out << (i == 0 ? "" : ",") << dgd_test::InfoOf(types[i]).name;
  if (in_double != in_float) out << " --scalar " << (in_double ? "double" : "float");
  const Modes& modes = query.modes;
  if (!(modes.cold && modes.warm && modes.yes_no)) {
    std::string list;
    if (modes.cold) list += ",cold";
    if (modes.warm) list += ",warm";
    if (modes.yes_no) list += ",yesno";
    out << " --mode " << list.substr(1);
  }
  if (frames != kMotionFrames) out << " --frames " << frames;
  if (query.tolerance > 0) out << " --tolerance " << query.tolerance;
  return out.str();
}

std::variant<SoakOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  SoakOptions options;
  Words words;
  options.threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
  CLI::App app(kDescription, "dgd_soak");
  app.footer(kFooter);
  app.get_formatter()->column_width(30);
  AddCaseOptions(app, options, words);
  AddRunOptions(app, options, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& end) {
    // CLI11's own statuses tell kinds of mistakes apart; ours says only that there was one.
    return app.exit(end, std::cout, std::cerr) == 0 ? kSuccess : kBadInput;
  }
  if (const std::string complaint = Complete(options, words); !complaint.empty()) {
    std::cerr << complaint << '\n';
    return kBadInput;
  }
  return options;
}

}  // namespace dgd_soak
