// headless_sim: worlds in Bullet, on one narrowphase or several, one at a time or a whole study. See --help.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "program_main.h"
#include "run/export_command.h"
#include "run/run_command.h"
#include "scene/json_reader.h"
#include "scene_options.h"
#include "simulation/narrowphase.h"
#include "sweep/local_workers.h"
#include "sweep/run_one.h"
#include "sweep/sweep_command.h"

namespace dgd_demos {
namespace {

constexpr const char* kHelp = R"(Worlds in Bullet, on its own narrowphase and on the growth distance, without a screen.
Usage: headless_sim COMMAND [OPTIONS]

  run WORLD     one world, measured and drawn; trajectories and contacts for NumPy
  sweep STUDY   many worlds: all combinations of seeds, narrowphases and values, resumable, on many processors
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

// The scenes of this project, each with the first sentence of what it says about itself.
int List() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(FindData("scenes"))) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const std::filesystem::path& file : files) {
    const std::string about = ParseJsonFile(file).value("about", "");
    std::printf("%-24s%s\n", file.stem().c_str(), about.substr(0, about.find(". ")).c_str());
  }
  return kSuccess;
}

// A run of a study, as JSON, from `sweep`; its record goes back the same way.
int One(const char* spec) {
  std::cout << ToLine(RunOne(RunSpec::FromJson(nlohmann::json::parse(spec)))) << std::endl;
  return kSuccess;
}

// Options apart from those named, each of which has a value.
std::vector<std::string> Without(int argc, char** argv, const std::vector<std::string>& names) {
  std::vector<std::string> kept;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    if (std::ranges::count(names, argument) > 0) {
      ++i;
    } else if (std::ranges::none_of(names, [&](const auto& name) { return argument.starts_with(name + "="); })) {
      kept.push_back(argument);
    }
  }
  return kept;
}

// `run`, in this program or the one of the other precision; or in both, into a folder each.
int RunInPrecision(int argc, char** argv) {
  const auto parsed = ParseRunOptions(argc, argv);
  const auto* options = std::get_if<RunOptions>(&parsed);
  if (options == nullptr || options->precision.empty() || options->precision == BulletPrecision()) {
    return RunProgram(parsed, Run);
  }
  int worst = kSuccess;
  for (const std::string precision : {"float", "double"}) {
    if (options->precision != "both" && options->precision != precision) continue;
    const std::filesystem::path out = options->precision == "both" ? options->out / precision : options->out;
    std::vector<std::string> arguments = Without(argc, argv, {"--precision", "--out"});
    arguments.insert(arguments.end(), {"--out", out.string()});
    worst = std::max(worst, RunAndWait(ProgramFor(precision), arguments));
  }
  return worst;
}

int Main(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "run") return RunInPrecision(argc - 1, argv + 1);
  if (command == "export") return RunProgram(ParseExportOptions(argc - 1, argv + 1), Export);
  if (command == "sweep") return RunProgram(ParseSweepOptions(argc - 1, argv + 1), Sweep);
  if (command == "list" && argc == 2) return List();
  if (command == "one" && argc == 3) return One(argv[2]);
  if (command == "--help" || command == "-h") return Help(stdout, kSuccess);
  if (!command.empty()) std::fprintf(stderr, "There is no command %s.\n", argv[1]);
  return Help(stderr, kBadInput);
}

}  // namespace
}  // namespace dgd_demos

int main(int argc, char** argv) { return dgd_demos::Main(argc, argv); }
