#include "run/run_options.h"

#include <iostream>

#include "command_line.h"
#include "scene_options.h"

namespace dgd_demos {
namespace {

constexpr const char* kDropDescription =
    R"(Drops the bodies of a scene in Bullet, with the growth distance as its narrowphase, with the built-in
GJK/EPA, or with one after the other, and compares the two: penetration, energy, contacts, time.)";

constexpr const char* kRunDescription =
    R"(Runs a world in Bullet, with the growth distance as its narrowphase, with the built-in GJK/EPA, or with one after the
other, and compares the two: penetration, energy, contacts, time.)";

constexpr const char* kDropExamples = R"(
Examples:
  polytope_drop                                     fifty polytopes, both narrowphases, into out/
  polytope_drop --narrowphase dgd --seed 7          the growth distance alone, other polytopes
  polytope_drop --scene my.json --out my_results    a scene of your own (format: scenes/README.md)
  polytope_drop --duration 2 --no-snapshots         a quick look at the figures

)";

constexpr const char* kRunExamples = R"(
Examples:
  headless_sim run tower_20                                     a scene of `headless_sim list`, both narrowphases
  headless_sim run my.json --set friction_anchors=off           a scene of your own, with an option of the plugin
  headless_sim run my.json --precision both                     Bullet in float and in double, into out/float and
                                                                out/double
  headless_sim run my.json --trajectory --sample-every 0.05     20 poses a second for NumPy, and for
                                                                `headless_sim render my.json out/dgd_trajectory.npy`
  headless_sim run my.json --checkpoint 60 --resume --out long  a long run, which goes on where it was when the same
                                                                command is given again
  headless_sim run my_app.bullet --duration 20                  a world that your app has written with Bullet's
                                                                serializer

To write your world from your app:
  btDefaultSerializer serializer;
  world->serialize(&serializer);
  std::ofstream("my_app.bullet", std::ios::binary).write(
      reinterpret_cast<const char*>(serializer.getBufferPointer()), serializer.getCurrentBufferSize());

)";

constexpr const char* kFiles = R"(Written into DIR:
  builtin.csv, dgd.csv          one row a step; on disk within a tenth of a second, so that a crash loses no more
      time_s                          at the end of the step
      kinetic_energy_j, potential_energy_j   at that time; potential energy is 0 on the ground's top
      contacts                        points in all contact manifolds
      deepest_reported_penetration_m  by the contact points
      narrowphase_us                  wall time of the step's collision detection after the broadphase
      pairs                           pairs of overlapping bounding boxes
      queries                         those of them that Bullet's dispatcher did not skip as asleep
      fallbacks                       queries that the growth distance handed back to GJK/EPA
      deepest_true_penetration_m      by an exact oracle that shares no code with either narrowphase
                                      (pairs with a mesh or another shape that it does not know are left
                                      out of it, and counted in the table)
  builtin_t00.50s.png, ...      pictures at the scene's times, or of a world file at begin,
                                middle and end; blue bodies are still, red ones fast
  end_state.png                 the end of the run; of both side by side, if both ran
  builtin.rec, dgd.rec          with --record: the queries of the narrowphase, for narrowphase_replay; one MB
                                holds 5000 pairs (10000 in float)
  builtin_trajectory.npy, ...   with --trajectory: for numpy.load(), poses and velocities of all bodies, also of a
                                run that was killed; columns time, position (of the centre of mass), orientation
                                (x, y, z, w), velocity, angular_velocity: ["position"][sample, body]
  builtin_contacts.npy, ...     with --contacts: a row a contact point; columns time, body_a, body_b, position_a,
                                position_b, normal (from B to A), distance, impulse (N s, along the normal).
                                Found at the poses that the step began with, so those of one step before "time";
                                dgd's that the step closes have distance -1e-9 and places that are still apart
  bodies.csv                    with either: the names of the bodies
  builtin.checkpoint, ...       with --checkpoint: the state of the run. The same command with --resume goes on from
                                there after a crash, a kill or Ctrl-C, and ends with the files of a run that was
                                never stopped: to the bit for the built-in, and for dgd with warm_start=off (but for
                                measured times). With warm starts, pairs begin without them, and figures differ as
                                between two seeds
  run.json                      what the results are of. Those of another run in DIR are left alone and the run
                                refused; with --overwrite they are removed, and always in "out", unless you name
                                it or --resume
  summary.csv                   the table that is printed at the end; its wall time counts Bullet's steps
                                alone, without oracle, files and pictures

Ctrl-C and SIGTERM end a run after its step, with complete files, and at once while it reads its world.

Exit status: 0 all went well; 1 a body left the world or a value was not finite; 2 wrong command line
or world, or the output cannot be written; 130 stopped.)";

constexpr const char* kResultsFolder = "out";
constexpr const char* kDefaultScene = "scenes/polytopes_50.json";

constexpr Limits<double> kSampleInterval = {0, 3600};     // s
constexpr Limits<double> kCheckpointInterval = {0, 1e9};  // s

void AddOptions(CommandLine& line, RunOptions& options, std::string& narrowphase, bool& no_snapshots) {
  line.AddChoice("--narrowphase", "WHICH", narrowphase, {"dgd", "builtin", "both"}, "dgd, builtin or both");
  line.AddSeed(options.seed, "Seed of the random bodies");
  AddOutOption(line, options.out, options.overwrite, kResultsFolder);
  AddDurationOption(line, options.duration);
  AddOracleEveryOption(line, options.oracle_every);
  line.AddFlag("--no-snapshots", no_snapshots, "Draw no pictures");
  line.AddFlag("--record", options.record, "Record the queries of each narrowphase");
  line.AddFlag("--trajectory", options.write_trajectory, "Write poses and velocities for NumPy");
  line.AddFlag("--contacts", options.write_contacts, "Write the contacts for NumPy");
  line.AddNumber("--sample-every", "S", options.sample_interval, kSampleInterval,
                 "Simulated time from one sample of these to the next in s, each at the nearest\nstep; 0: every step");
  line.AddNumber(
      "--checkpoint", "S", options.checkpoint_interval, kCheckpointInterval,
      "Write the state of the run every S seconds of wall time, and when it ends\nor is stopped; 0: every step");
  line.AddFlag("--resume", options.resume, "Continue from the checkpoints in DIR; without any, from the beginning");
}

bool IsSound(const RunOptions& options) {
#ifndef DGD_DEMOS_RECORD
  if (options.record) {
    std::cerr << "--record: this program was built without the recorder (CMake's option DGD_BUILD_RECORD)\n";
    return false;
  }
#endif
  if (options.record && (options.checkpoint_interval || options.resume)) {
    std::cerr << "--record: not with --checkpoint or --resume, since records cannot be continued\n";
    return false;
  }
  return true;
}

void Complete(RunOptions& options, const std::string& narrowphase, bool no_snapshots, const std::string& settings) {
  const std::string dgd = settings.empty() ? "dgd" : "dgd:" + settings;
  const bool is_asked_for = options.overwrite;
  CompleteOut(options.out, options.overwrite, kResultsFolder);
  if (options.resume) options.overwrite = is_asked_for;  // What is to go on must not be lost by a slip in a command.
  if (narrowphase != "dgd") options.narrowphases.push_back("builtin");
  if (narrowphase != "builtin") options.narrowphases.push_back(dgd);
  options.draw_snapshots = !no_snapshots;
}

}  // namespace

std::filesystem::path WorldFileNamed(const std::filesystem::path& world) {
  if (!IsSceneName(world)) return FindData(world);
  const std::filesystem::path file = FindData("scenes" / std::filesystem::path(world.string() + ".json"));
  std::error_code ignored;
  return std::filesystem::exists(file, ignored) ? file : world;
}

std::variant<RunOptions, ExitStatus> ParsePolytopeDropOptions(int argc, const char* const* argv) {
  RunOptions options;
  options.world = FindData(kDefaultScene);
  std::string narrowphase = "both";
  bool no_snapshots = false;
  CommandLine line("polytope_drop", kDropDescription, std::string(kDropExamples) + kFiles);
  line.AddPath("--scene", "FILE", options.world, "Scene file (JSON)");
  AddOptions(line, options, narrowphase, no_snapshots);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  if (!IsSound(options)) return kBadInput;
  Complete(options, narrowphase, no_snapshots, "");
  return options;
}

std::variant<RunOptions, ExitStatus> ParseRunOptions(int argc, const char* const* argv) {
  RunOptions options;
  std::string narrowphase = "both";
  bool no_snapshots = false;
  std::vector<std::string> settings;
  CommandLine line("headless_sim run", kRunDescription, std::string(kRunExamples) + kFiles);
  line.AddArgument("world", "WORLD", options.world,
                   "Scene (.json or the name of one), or Bullet's world file (.bullet)");
  line.AddWords("--set", "LIST", settings, "Options of the plugin, as patch_size=2,friction_anchors=off");
  line.AddNumber("--time-step", "S", options.time_step, kAnyNumber, "Length of a step in s, in place of the world's");
  line.AddChoice("--precision", "WHICH", options.precision, {"float", "double", "both"},
                 "Of Bullet: float, double or both");
  AddOptions(line, options, narrowphase, no_snapshots);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  if (!IsSound(options)) return kBadInput;
  std::string all_settings;
  for (const std::string& setting : settings) all_settings += (all_settings.empty() ? "" : ",") + setting;
  Complete(options, narrowphase, no_snapshots, all_settings);
  options.world = WorldFileNamed(options.world);
  return options;
}

}  // namespace dgd_demos
