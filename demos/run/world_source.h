// A scene or a world file of Bullet's, read and checked once, from which each run makes its own world.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/world_view.h"
#include "scene/bodies.h"
#include "scene/scene_file.h"
#include "simulation/narrowphase.h"
#include "simulation/simulated_world.h"
#include "world_file/checked_world.h"

namespace dgd_demos {

struct WorldRequest {
  std::filesystem::path file;       ///< A scene (.json), or a file of Bullet's serializer (.bullet).
  std::uint64_t seed = 1;           ///< Seed of a scene's random bodies.
  std::optional<double> duration;   ///< s, in place of the scene's, or of kWorldFileDuration.
  std::optional<double> time_step;  ///< s, in place of the world's own.
  SceneChanges changes = {};        ///< Values of a scene in place of the file's.
};

inline constexpr double kWorldFileDuration = 10;  ///< s; default, since a world file has no duration.

class WorldSource {
 public:
  /// @throws SceneError in a sentence that names file, place and value.
  explicit WorldSource(const WorldRequest& request);

  /// @throws SceneError, std::invalid_argument about an option of the narrowphase.
  std::unique_ptr<SimulatedWorld> Make(const NarrowphaseChoice& narrowphase) const;

  double duration() const { return duration_; }  ///< s
  /// The scene; nothing for a world file.
  const std::optional<Scene>& scene() const { return scene_; }
  /// Times of the pictures, s, ascending: a scene's own; of a world file begin, middle and end.
  std::vector<double> snapshots() const;
  /// How its pictures show it, from the poses that it begins with on. @throws as Make().
  WorldView View() const;
  /// Sentences about parts of a world file that are not restored, and about shapes that the oracle does not judge.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  std::optional<double> time_step_;  // s
  std::optional<Scene> scene_;
  std::vector<Body> bodies_;
  std::optional<CheckedWorld> world_file_;
  std::vector<std::string> remarks_;
  double duration_ = kWorldFileDuration;
};

}  // namespace dgd_demos
