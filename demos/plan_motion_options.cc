#include "plan_motion_options.h"

#include <optional>
#include <string>

#include "command_line.h"
#include "scene_options.h"

namespace dgd_demos {
namespace {

constexpr const char* kDescription =
    R"(Plans the motion of a robot arm between obstacles with OMPL, on collision checks by the growth distance; proves
that the path is free, pushes it away from what it nearly hits, along the growth distance's gradients, and has it
carried out in a Bullet world.)";

constexpr const char* kFooter = R"(
Examples:
  plan_motion                                   a UR5e among five obstacles, into out/motion
  plan_motion --seeds 20 --no-picture           the median of twenty plans
  plan_motion --compare                         the same checks by FCL and by Bullet: times, differing answers
  plan_motion --scene my.json --planner rrt     an arm and obstacles of your own (format: scenes/README.md)

How a path is made:
  search            RRT-Connect (a tree from each end) or RRT (a tree from the start, which takes far longer);
                    states along a motion are checked every 0.1 % of the search space's extent
  simplification    shortcuts, until none helps
  re-check          at ten times the resolution, with a certificate for each pair in each state that it is apart;
                    a path that fails is not printed, and the search begins again, until the time limit
  smoothing         each configuration is pushed along the joint-space gradient of the growth distance of what is
                    near, and pulled towards its neighbours; the path gets a tenth longer at most. Re-checked, too

  execution         the arm as a Bullet multibody with joint motors and gravity, on this project's narrowphase,
                    along the smoothed path, as fast as the joints' velocity limits and 5 rad/s^2 allow

Figures:
  pair checks       one pair of convex bodies each: a link and an obstacle, or two links that are no neighbours; a
                    state's first collision ends its checks
  by a cached plane decided by the plane that separated the pair last, without a search
  clearance         the least signed distance of any pair along the path, at the resolution of the re-check
  tracking error    from the flange in the world to where the path has it at that time
  growth distance   the common scale at which a pair touches, each body scaled about its centre: above 1 apart

Written into DIR (with --seeds N: paths and pictures into DIR/seed_1, ...):
  runs.csv               one row a run with all figures, in SI units; written as soon as a run is done
  path_found.csv         as the search found it; of a search that ran out of time, the branch that came nearest
  path_simplified.csv    after the certified re-check
  path_smoothed.csv      after smoothing and its re-check
                         each with joint angles, flange and clearance in each row
  path.png, path_other_side.png
                         start, goal and the arm between; the flange's way in red, and in grey before smoothing
  execution.csv          one row a step: angles, velocities and efforts, flange, tracking error
  execution.png          the arm at six moments of the execution
  comparison.csv         with --compare
  plan.json              what the results are of. Those of another run in DIR are refused, or replaced with
                         --overwrite, and always in the folder "out/motion", unless you name it

The same seed gives the same path, unless the time limit ends a search.

Exit status: 0 all runs have a plan and were carried out; 1 one has none, or start or goal is in collision; 2 wrong command line or
scene file (a limit exceeded, an unknown joint), or the output cannot be written.)";

constexpr const char* kDefaultFolder = "out/motion";
constexpr const char* kDefaultScene = "scenes/ur5e_five_obstacles.json";
constexpr int kMaxSeeds = 10'000;
constexpr Limits<double> kTimeLimit = {1e-3, 3600};  // s

}  // namespace

std::variant<PlanMotionOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  PlanMotionOptions options;
  options.scene = FindData(kDefaultScene);
  std::string planner = "rrt_connect";
  bool no_picture = false;

  CommandLine line("plan_motion", kDescription, kFooter);
  line.AddPath("--scene", "FILE", options.scene, "Scene file (JSON)");
  AddOutOption(line, options.out, options.overwrite, kDefaultFolder);
  line.AddChoice("--planner", "WHICH", planner, {"rrt_connect", "rrt"}, "rrt_connect or rrt");
  line.AddSeed(options.seed, "Seed of the search");
  line.AddNumber("--seeds", "N", options.seeds, {1, kMaxSeeds}, "Runs, with this seed and those after it");
  line.AddNumber("--time-limit", "S", options.time_limit, kTimeLimit, "Of each run's planning, s");
  line.AddFlag("--compare", options.compares, "Time the same checks by FCL and Bullet");
  line.AddFlag("--no-picture", no_picture, "Draw no pictures");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  options.planner = planner == "rrt" ? PlannerKind::kRrt : PlannerKind::kRrtConnect;
  CompleteOut(options.out, options.overwrite, kDefaultFolder);
  options.draws = !no_picture;
  return options;
}

}  // namespace dgd_demos
