// The shading programs: bodies and ground in the light of one direction, and the depth seen from that light.
#pragma once

#include <Eigen/Core>
#include <string>

namespace dgd_demos {

/// A linked GLSL program of the current context. Lives as long as the context.
class ShaderProgram {
 public:
  /// @throws std::runtime_error with the driver's log.
  ShaderProgram(const char* vertex_source, const char* fragment_source);

  void Use() const;
  /// Sets a uniform of this program, which must be in use.
  void Set(const char* name, int value) const;
  void Set(const char* name, double value) const;
  void Set(const char* name, const Eigen::Vector3d& value) const;
  void Set(const char* name, const Eigen::Matrix4d& value) const;

 private:
  int Location(const char* name) const;
  unsigned program_;
};

/// Bodies and ground in the light of one direction. Uniforms of both: model, view_projection, world_to_light (mat4),
/// shadow_map (texture unit), shadow_offset (m), light_direction (vec3), light_strength, ambient, headroom, albedo
/// (vec3, linear). Of the body's: eye (vec3), gloss. Of the ground's: background (vec3, linear), target (vec3),
/// fade_start and fade_end (m from the target).
ShaderProgram MakeBodyProgram();
ShaderProgram MakeGroundProgram();

/// Depth only. Uniforms: model, world_to_light.
ShaderProgram MakeShadowProgram();

/// What the programs write for a linear colour. The square root spreads the 256 steps of a byte evenly for the eye; the
/// head room keeps a bright light from being cut off before the mean over all lights is taken.
inline constexpr double kHeadroom = 4;
Eigen::Vector3d EncodeLinear(const Eigen::Vector3d& linear);

}  // namespace dgd_demos
