#include "options.h"

#include <map>
#include <optional>
#include <string>

#include "command_line.h"
#include "scene_options.h"

namespace dgd_demos {
namespace {

constexpr const char* kDescription =
    R"(Drops the bodies of a scene in Bullet, with the growth distance as its narrowphase, with the built-in
GJK/EPA, or with one after the other, and compares the two: penetration, energy, contacts, time.)";

constexpr const char* kFooter = R"(
Examples:
  polytope_drop                                     fifty polytopes, both narrowphases, into out/
  polytope_drop --narrowphase dgd --seed 7          the growth distance alone, other polytopes
  polytope_drop --scene my.json --out my_results    a scene of your own (format: scenes/README.md)
  polytope_drop --duration 2 --no-snapshots         a quick look at the figures

Written into DIR:
  builtin.csv, dgd.csv          one row a step; written as it goes, so that a crash leaves what was done
      time_s                          at the end of the step
      kinetic_energy_j, potential_energy_j   at that time; potential energy is 0 on the ground's top
      contacts                        points in all contact manifolds
      deepest_reported_penetration_m  by the contact points
      narrowphase_us                  wall time of the step's collision detection after the broadphase
      pairs                           pairs of overlapping bounding boxes
      queries                         those of them that Bullet's dispatcher did not skip as asleep
      fallbacks                       queries that the growth distance handed back to GJK/EPA
      deepest_true_penetration_m      by an exact oracle that shares no code with either narrowphase
  builtin_t00.50s.png, ...      pictures at the scene's times; blue bodies are still, red ones fast
  end_state.png                 the end of the run; of both side by side, if both ran
  builtin.rec, dgd.rec          with --record: what the narrowphase was asked, for narrowphase_replay; one MB
                                holds 5000 pairs (10000 in float)
  summary.csv                   the table that is printed at the end; its wall time counts Bullet's steps
                                alone, without oracle, files and pictures

Exit status: 0 all went well; 1 a body left the world or a value was not finite; 2 wrong command line
or scene file, or the output cannot be written.)";

constexpr const char* kDefaultScene = "scenes/polytopes_50.json";

}  // namespace

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  const std::map<std::string, std::vector<Narrowphase>> choices = {
      {"dgd", {Narrowphase::kDgd}},
      {"builtin", {Narrowphase::kBuiltin}},
      {"both", {Narrowphase::kBuiltin, Narrowphase::kDgd}}};
  Options options;
  options.scene = FindData(kDefaultScene);
  std::string narrowphase = "both";
  bool no_snapshots = false;

  CommandLine line("polytope_drop", kDescription, kFooter);
  line.AddPath("--scene", "FILE", options.scene, "Scene file (JSON)");
  line.AddChoice("--narrowphase", "WHICH", narrowphase, {"dgd", "builtin", "both"}, "dgd, builtin or both");
  line.AddSeed(options.seed, "Seed of the random bodies");
  line.AddPath("--out", "DIR", options.out, "Folder for the results; made if missing");
  AddDurationOption(line, options.duration);
  AddOracleEveryOption(line, options.oracle_every);
  line.AddFlag("--no-snapshots", no_snapshots, "Draw no pictures");
  line.AddFlag("--record", options.record, "Write down what each narrowphase is asked");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  options.narrowphases = choices.at(narrowphase);
  options.draw_snapshots = !no_snapshots;
  return options;
}

}  // namespace dgd_demos
