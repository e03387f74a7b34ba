#include "physics/truth_options.h"

#include <optional>

#include "command_line.h"
#include "physics/experiment.h"

namespace dgd_physics {
namespace {

constexpr const char* kDescription =
    R"(Runs experiments whose results are known in closed form, in Bullet worlds on the built-in narrowphase and on the
plugin, and prints how far each is from theory. physics_truth runs Bullet in float, physics_truth_float64 in double.)";

constexpr const char* kFooter = R"(
Examples:
  physics_truth                                  all classes at 60, 240 and 1000 Hz: minutes
  physics_truth --quick                          some cases of each: seconds
  physics_truth --classes bounce,taps --cases    two classes, with each case's figures
  physics_truth_float64 --rates 240 --csv f.csv  one rate, Bullet in double; every case to a file

Worlds:   Bullet's default solver and settings, unless a class is about them; stepSimulation(1 / rate, 0),
          no sleeping; the plugin's default options. Sizes, masses, friction, headings in the plane, and
          moments within a step change from case to case.
Columns:  root mean square, over the cases of a class, of |measured - theory| / scale: the scale is
          theory itself unless the class says otherwise. One case counts 1 at most, and NaN counts 1.
Verdict:  ours fails above 1.1 times the built-in's error plus 0.003. Classes marked e (restitution) must
          also stay below 0.02 at 60 Hz, 0.01 at 240 Hz and 0.005 at 1000 Hz.

Exit status: 0 no class fails; 1 some do, which are listed; 2 wrong command line, or the file cannot be
written.

Classes:
)";

constexpr double kMaxRate = 100'000;  // Hz

std::string ClassesInWords() {
  constexpr std::size_t kColumn = 17;
  std::string text;
  for (const Experiment& experiment : Experiments()) {
    std::string name(experiment.name);
    name.resize(kColumn, ' ');
    text += "  " + name + (experiment.is_restitution ? "e " : "  ") + std::string(experiment.summary) + "\n";
  }
  return text;
}

}  // namespace

std::variant<TruthOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  TruthOptions options;
  std::vector<std::string> names;
  for (const Experiment& experiment : Experiments()) names.emplace_back(experiment.name);
  dgd_demos::CommandLine line("physics_truth", kDescription, kFooter + ClassesInWords());
  line.AddFlag("--quick", options.is_quick, "Only some cases of each class");
  line.AddFlag("--compounds", options.in_compounds, "Each convex body's shape is the only child of a compound");
  line.AddChoices("--classes", "A,B", options.classes, names, "Some of the classes below; default: all");
  line.AddNumbers("--rates", "HZ", options.rates, {1, kMaxRate}, "Steps per second");
  line.AddFlag("--cases", options.lists_cases, "Also prints each case");
  line.AddPath("--csv", "FILE", options.csv, "File for one row per case");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

}  // namespace dgd_physics
