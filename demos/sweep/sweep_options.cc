#include <charconv>
#include <iostream>
#include <optional>

#include "command_line.h"
#include "scene_options.h"
#include "sweep/sweep_command.h"

namespace dgd_demos {
namespace {

constexpr const char* kDescription =
    R"(Simulates a study: worlds with all combinations of seeds, narrowphases and values of their keys. Leaves one CSV and
tables of medians. What is done is not done again: called once more, it goes on from where it was ended.)";

constexpr const char* kFooter = R"(
STUDY is a JSON file, in which "about" and "worlds" are required:
  { "about": "friction and time step of the tower",    any text
    "worlds": ["tower_20", "my.json", "app.bullet"],   scenes of `headless_sim list`; files from its folder on
    "narrowphases": ["builtin", "dgd", "dgd:friction_anchors=off"],    the first two if left out
    "seeds": { "from": 1, "to": 20 },                  or a list, of scenes with random bodies; 1 if left out
    "precisions": ["float", "double"],                 of Bullet; that of this program if left out
    "vary": { "/time_step": [0.002, 0.004],            all combinations of these values of the scene;
              "/ground/friction": [0.3, 0.6] },        or a list of objects with one value for each path
    "duration": 10, "time_step": 0.004,                s, in place of the worlds' own
    "oracle_every": 10 }                               steps; 1 if left out

Examples:
  headless_sim sweep scenes/studies/contacts.json                   all scenes that contacts are judged by
  headless_sim sweep my.json --jobs 8                               eight runs at a time
  mpirun -n 65 headless_sim sweep my.json                           64 at a time, on as many machines
  headless_sim sweep my.json --out part_3 --shard 3/10              a tenth of it: one of an array of jobs
  headless_sim sweep my.json --merge part_1,part_2,...,part_10      and all of them together

Written into DIR:
  runs.csv       a row a run, in the study's order, in SI units; the same whoever carried out the runs, but for
                 the times narrowphase_us_per_query and wall_time_s
  tables.txt     what is printed: for each world, change and precision, the median over the seeds, its
                 interquartile range (IQR), and the ratio to the first narrowphase
  runs/          a file a run; remove one, and that run is done again

Figures, over a run:
  deepest penetration           as the contact points report it, and as it truly was: by an exact oracle that
                                shares no code with either narrowphase. In the last second: at rest, that is.
                                Pairs with a mesh, or another shape that it does not know, are counted
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

Ended by Ctrl-C or SIGTERM, it gives up the runs of that moment and writes CSV and tables of those that are done. A run
that crashes or cannot be carried out is recorded with its message, and the others go on.

Exit status: 0 all runs are done; 1 a body was lost, or a run failed; 2 wrong command line, study or scene, or the
output cannot be written; 130 ended before all were done.)";

constexpr int kMaxJobs = 4096;

// "3/10": the third of ten.
bool ParseShard(const std::string& text, SweepOptions& options) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || slash == end || *slash != '/') return false;
  const auto [last, other_error] = std::from_chars(slash + 1, end, options.shards);
  options.shard = number - 1;
  return other_error == std::errc() && last == end && number >= 1 && number <= options.shards;
}

}  // namespace

std::variant<SweepOptions, ExitStatus> ParseSweepOptions(int argc, const char* const* argv) {
  SweepOptions options;
  std::string shard;
  CommandLine line("headless_sim sweep", kDescription, kFooter);
  line.AddArgument("study", "STUDY", options.study, "The study (JSON)");
  line.AddPath("--out", "DIR", options.out,
               "Folder for the results; made if missing. Default: out/, then the study's name");
  line.AddNumber("--jobs", "N", options.jobs, {1, kMaxJobs}, "Runs at a time; with mpirun, its ranks but one");
  line.AddText("--shard", "I/N", shard, "Only the I-th of N parts of the runs");
  line.AddFlag("--retry-failed", options.retry_failed, "Do runs again that have failed");
  line.AddWords("--merge", "LIST", options.merge, "Run nothing; gather what these folders of shards have");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  if (!shard.empty() && !ParseShard(shard, options)) {
    std::cerr << "--shard: must be I/N with I from 1 to N, as 3/10, not " << shard << '\n';
    return kBadInput;
  }
  if (!shard.empty() && !options.merge.empty()) {
    std::cerr << "--merge: runs nothing, and so has no use for --shard\n";
    return kBadInput;
  }
  if (options.retry_failed && !options.merge.empty()) {
    std::cerr << "--merge: runs nothing, and so has no use for --retry-failed\n";
    return kBadInput;
  }
  options.study = FindData(options.study);
  if (options.out.empty()) options.out = std::filesystem::path("out") / options.study.stem();
  return options;
}

}  // namespace dgd_demos
