// headless_sim: worlds in Bullet, on one narrowphase or several, one at a time or a whole study. See --help.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "command_line.h"
#include "program_main.h"
#include "run/export_command.h"
#include "run/render_command.h"
#include "run/run_command.h"
#include "scene/json_reader.h"
#include "scene/scene_error.h"
#include "scene_options.h"
#include "sibling_program.h"
#include "simulation/narrowphase.h"
#include "stop_signals.h"
#include "sweep/run_one.h"
#include "sweep/sweep_command.h"
#include "world_file/bullet_file.h"

namespace dgd_demos {
namespace {

constexpr const char* kHelp = R"(Worlds in Bullet, on its own narrowphase and on the growth distance, without a screen.
Usage: headless_sim COMMAND [OPTIONS]

  run WORLD     one world, measured and drawn; trajectories and contacts for NumPy
  sweep STUDY   many worlds: all combinations of seeds, narrowphases and values, resumable, on many processors
  render WORLD TRAJECTORY     pictures of a trajectory that run has written, or the frames of a film
  export SCENE FILE.bullet    a scene as one of Bullet's world files, for other programs
  list          the scenes that come with this program, with a line each

headless_sim COMMAND --help describes each. Bullet is in %s precision here; %s is the same in %s.
)";

int Help(std::FILE* stream, int status) {
  const bool is_float = std::string_view(BulletPrecision()) == "float";
  std::fprintf(stream, kHelp, BulletPrecision(), is_float ? "headless_sim_float64" : "headless_sim",
               is_float ? "double" : "float");
  return status;
}

struct ListOptions {};

std::variant<ListOptions, ExitStatus> ParseListOptions(int argc, const char* const* argv) {
  CommandLine line("headless_sim list",
                   "Lists the scenes that come with this program, by the names that its other commands take.", "");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return ListOptions{};
}

// The scenes of this project, each with the first sentence of its description.
ExitStatus List(const ListOptions&) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(FindData("scenes"))) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const std::filesystem::path& file : files) {
    const nlohmann::json scene = ParseJsonFile(file);
    const std::string about = scene.value("about", "");
    std::printf("%-24s%s%s\n", file.stem().c_str(), scene.contains("arms") ? "For plan_motion: " : "",
                about.substr(0, about.find(". ")).c_str());
  }
  return kSuccess;
}

// `one SPEC`, by which `sweep` starts each run: RunSpec::ToJson() as an argument, ToLine() of its record as output.
ExitStatus One(const std::string& spec) {
  std::printf("%s\n", ToLine(RunOne(RunSpec::FromJson(nlohmann::json::parse(spec)))).c_str());
  return kSuccess;
}

// Runs the world by the program of each precision requested, into a folder of its own if there are two.
int RunBySiblings(const RunOptions& options, const std::vector<std::string>& arguments) {
  if (options.precision == "both" && IsWorldFile(options.world)) {
    const std::string precision = NameOf(ReadBulletFile(options.world).precision);
    throw SceneError(options.world.string() + ": was written by a Bullet in " + precision +
                     " and runs in that alone; --precision must be " + precision);
  }
  const StopSignals stop_signals;
  int worst = kSuccess;
  for (const std::string precision : {"float", "double"}) {
    if (IsStopRequested() || (options.precision != "both" && options.precision != precision)) continue;
    const std::filesystem::path out = options.precision == "both" ? options.out / precision : options.out;
    std::vector<std::string> in_precision = arguments;
    // The last of several counts.
    in_precision.insert(in_precision.end(), {"--precision", precision, "--out", out.string()});
    if (options.overwrite) in_precision.push_back("--overwrite");
    worst = std::max(worst, RunAndWait(ProgramFor(precision), in_precision));
  }
  return worst;
}

// `run`, in this process if it has the precision requested.
int RunInPrecision(int argc, char** argv) {
  const auto parsed = ParseRunOptions(argc, argv);
  const auto* options = std::get_if<RunOptions>(&parsed);
  if (options == nullptr || options->precision.empty() || options->precision == BulletPrecision()) {
    return RunProgram(parsed, Run);
  }
  return RunGuarded([&] { return RunBySiblings(*options, {argv, argv + argc}); }, kBadInput);
}

int Main(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "run") return RunInPrecision(argc - 1, argv + 1);
  if (command == "render") return RunProgram(ParseRenderOptions(argc - 1, argv + 1), Render);
  if (command == "export") return RunProgram(ParseExportOptions(argc - 1, argv + 1), Export);
  if (command == "sweep") return RunProgram(ParseSweepOptions(argc - 1, argv + 1), Sweep);
  if (command == "list") return RunProgram(ParseListOptions(argc - 1, argv + 1), List);
  if (command == "one" && argc == 3) return RunProgram(std::variant<std::string, ExitStatus>(argv[2]), One);
  if (command == "--help" || command == "-h") return Help(stdout, kSuccess);
  if (!command.empty()) std::fprintf(stderr, "%s is not a command.\n", argv[1]);
  return Help(stderr, kBadInput);
}

}  // namespace
}  // namespace dgd_demos

int main(int argc, char** argv) { return dgd_demos::Main(argc, argv); }
