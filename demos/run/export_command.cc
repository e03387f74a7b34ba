#include "run/export_command.h"

#include <cstdio>
#include <memory>
#include <optional>

#include "command_line.h"
#include "run/run_options.h"
#include "run/world_source.h"
#include "scene/scene_error.h"
#include "world_file/bullet_file.h"
#include "world_file/write_world.h"

namespace dgd_demos {
namespace {

constexpr const char* kDescription =
    R"(Writes a scene as one of Bullet's world files, which other programs read with btBulletWorldImporter, of the same
precision: bodies with shapes, names and velocities, gravity and the solver's settings, before the first step.)";

constexpr const char* kFooter = R"(
Examples:
  headless_sim export tower_20 tower.bullet               for programs with Bullet in float
  headless_sim_float64 export my.json my.bullet --seed 3  in double

Exit status: 0 it is written; 2 wrong command line or scene, or the file cannot be written.)";

}  // namespace

std::variant<ExportOptions, ExitStatus> ParseExportOptions(int argc, const char* const* argv) {
  ExportOptions options;
  CommandLine line("headless_sim export", kDescription, kFooter);
  line.AddArgument("scene", "SCENE", options.scene, "Scene file (JSON), or the name of a scene");
  line.AddArgument("file", "FILE", options.file, "Where to write it; its name ends in .bullet");
  line.AddSeed(options.seed, "Seed of the random bodies");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  options.scene = WorldFileNamed(options.scene);
  return options;
}

ExitStatus Export(const ExportOptions& options) {
  if (!IsWorldFile(options.file)) throw SceneError(options.file.string() + ": its name must end in .bullet");
  const WorldSource source({options.scene, options.seed, std::nullopt, std::nullopt});
  const std::unique_ptr<SimulatedWorld> world = source.Make(Narrowphase::kBuiltin);
  WriteWorldFile(*world, options.file);
  std::printf("%s: %zu bodies, Bullet in %s precision\n", options.file.c_str(), world->Bodies().size(),
              BulletPrecision());
  return kSuccess;
}

}  // namespace dgd_demos
