#include "contact_report_options.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "command_line.h"
#include "scene_options.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {
namespace {

constexpr const char* kDescription =
    R"(Runs scenes to judge contacts by in Bullet, on its built-in narrowphase and on the growth distance, and prints
their figures side by side, a table a scene.)";

constexpr const char* kFooter = R"(
Examples:
  contact_report                                      all scenes; about a minute
  contact_report --scenes tower_20,arch               two of them
  contact_report --scenes polytopes_50 --seeds 20     the median of twenty heaps
  contact_report --scenes my.json --duration 5        a scene of your own (format: scenes/README.md)

Figures, over the run of a scene:
  deepest penetration           as the contact points report it, and as it truly was: by an exact oracle that
                                shares no code with either narrowphase. In the last second: at rest, that is
  time to rest                  from when on the kinetic energy of all bodies stays below 0.01 J; "-": never
  energy dissipated             share of the kinetic and potential energy at the start
  largest rise of energy        of kinetic and potential energy together: over one step, and above the least
                                that it had been before; what makes a rise is the contact solver or a wrong contact
  rms speed in the last half    root mean square of the speeds of the moving bodies' centres: jitter, if it should
                                be still
  farthest from its start       largest displacement of a body's centre at the end: drift, if it should stay
  bodies out of place           that end farther from their start than half their radius: 0 for what still stands
  bodies lost                   runs that ended because a body left the world or was not finite
  narrowphase per queried pair  wall time of the collision detection after the broadphase, for each pair of
                                bounding boxes that is not asleep

Scenes that are to stand run for 60 s with sleeping disabled ("sleeping" in the file), for sleeping would hide jitter
and drift; where Bullet's contact solver by itself would let them creep away, the file gives it more iterations
and a second friction direction ("solver"). Scenes with random bodies run once for each seed; the table has the
median of each figure, and the sum of lost bodies and fallbacks. The oracle looks at every step; --oracle-every N is
faster, and may miss the deepest moment of an impact.

Narrowphases: builtin is Bullet's; dgd the plugin with its default options; dgd_growth has the growth distance's own
normals in place of those of least translation; dgd_sharp leaves out the margins, which the oracle, judging the
scene's shapes with them, counts as penetration; dgd_lean has no manifolds for pairs that do not touch, which costs
Bullet less.

FILE gets a row a run as soon as it is done, in SI units: interrupt at any time.

Exit status: 0 all went well; 1 a body left the world or a value was not finite, whatever the narrowphase;
2 wrong command line or scene file, or the output cannot be written.)";

// The scenes to judge contacts by. Each is a file in scenes/.
const std::vector<std::string> kDefaultScenes = {
    "polytopes_50", "rest_on_plane",  "tower_20",       "wall_6x6",       "pyramid_28", "dominoes_10",
    "coin",         "mass_ratio_100", "size_ratio_100", "thrown_at_wall", "arch",       "cylinder_cone_on_end"};

constexpr int kMaxSeeds = 10'000;

// A scene of this project by its name, or any file.
std::filesystem::path SceneFile(const std::string& name) {
  if (std::filesystem::path(name).extension() == ".json") return name;
  return FindData(std::filesystem::path("scenes") / (name + ".json"));
}

}  // namespace

std::variant<ContactReportOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  std::map<std::string, Narrowphase> choices;
  std::vector<std::string> names;
  for (const Narrowphase narrowphase : AllNarrowphases()) {
    names.emplace_back(NameOf(narrowphase));
    choices[names.back()] = narrowphase;
  }
  std::vector<std::string> narrowphases = {"builtin", "dgd"};
  ContactReportOptions options;
  options.out = std::string("out/contacts_") + BulletPrecision() + ".csv";
  std::vector<std::string> scenes = kDefaultScenes;

  CommandLine line("contact_report", kDescription, kFooter);
  line.AddWords("--scenes", "LIST", scenes, "Names of scenes, or scene files (.json), with commas between them");
  line.AddChoices("--narrowphases", "LIST", narrowphases, names, "Which to compare, the others with the first");
  line.AddNumber("--seeds", "N", options.seeds, {1, kMaxSeeds},
                 "Runs of each scene with random bodies, with the seeds 1 to N");
  line.AddPath("--out", "FILE", options.out, "CSV file for the figures of each run; its folder is made if missing");
  AddDurationOption(line, options.duration);
  AddOracleEveryOption(line, options.oracle_every);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  for (const std::string& name : scenes) options.scenes.push_back(SceneFile(name));
  for (const std::string& name : narrowphases) options.narrowphases.push_back(choices.at(name));
  return options;
}

}  // namespace dgd_demos
