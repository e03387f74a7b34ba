#include "render/shaders.h"

#include <array>
#include <stdexcept>

#include "render/gl.h"

namespace dgd_demos {
namespace {

// Shared by bodies and ground. The place in the shadow map is looked up a little off the surface, so that a surface
// does not shade itself; it is linear in the position, so the rasterizer can carry it along.
constexpr const char* kLightingVertexSource = R"(
#version 120
uniform mat4 model;
uniform mat4 view_projection;
uniform mat4 world_to_light;
uniform float shadow_offset;
varying vec3 position;
varying vec3 normal;
varying vec3 shadow_place;
void main() {
  vec4 world = model * gl_Vertex;
  position = world.xyz;
  normal = mat3(model) * gl_Normal;
  shadow_place = 0.5 + 0.5 * (world_to_light * (world + vec4(shadow_offset * normal, 0.0))).xyz;
  gl_Position = view_projection * world;
}
)";

constexpr const char* kBodyFragmentSource = R"(
#version 120
uniform sampler2DShadow shadow_map;
uniform vec3 light_direction;
uniform float light_strength;
uniform float ambient;
uniform float headroom;
uniform vec3 eye;
uniform vec3 albedo;
uniform float gloss;
varying vec3 position;
varying vec3 normal;
varying vec3 shadow_place;
void main() {
  vec3 n = normalize(normal);
  float light = light_strength * max(dot(n, light_direction), 0.0) * shadow2D(shadow_map, shadow_place).r;
  vec3 half_way = normalize(light_direction + normalize(eye - position));
  float highlight = max(dot(n, half_way), 0.0);
  for (int i = 0; i < 5; ++i) highlight *= highlight;  // To the power of 32.
  vec3 colour = albedo * (light + ambient) + vec3(gloss * light * highlight);
  gl_FragColor = vec4(sqrt(colour / headroom), 1.0);
}
)";

// A chequered floor with squares of one metre that fades into the background. Outside of the shadow map, it is in the
// light: the map's border has the greatest depth.
constexpr const char* kGroundFragmentSource = R"(
#version 120
uniform sampler2DShadow shadow_map;
uniform vec3 light_direction;
uniform float light_strength;
uniform float ambient;
uniform float headroom;
uniform vec3 albedo;
uniform vec3 background;
uniform vec3 target;
uniform float fade_start;
uniform float fade_end;
varying vec3 position;
varying vec3 normal;
varying vec3 shadow_place;
void main() {
  float light = light_strength * max(dot(normal, light_direction), 0.0) * shadow2D(shadow_map, shadow_place).r;
  vec2 square = floor(position.xy);
  float shade = mod(square.x + square.y, 2.0) < 0.5 ? 1.0 : 0.9;
  float fade = smoothstep(fade_start, fade_end, distance(position.xy, target.xy));
  vec3 colour = mix(shade * albedo * (light + ambient), background, fade);
  gl_FragColor = vec4(sqrt(colour / headroom), 1.0);
}
)";

constexpr const char* kShadowVertexSource = R"(
#version 120
uniform mat4 model;
uniform mat4 world_to_light;
void main() { gl_Position = world_to_light * (model * gl_Vertex); }
)";

constexpr const char* kShadowFragmentSource = R"(
#version 120
void main() {}
)";

unsigned Compile(unsigned kind, const char* source) {
  const unsigned shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  int compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
  throw std::runtime_error("a shader does not compile: " + std::string(log.data()));
}

}  // namespace

ShaderProgram::ShaderProgram(const char* vertex_source, const char* fragment_source) : program_(glCreateProgram()) {
  for (const auto& [kind, source] :
       {std::pair(GL_VERTEX_SHADER, vertex_source), {GL_FRAGMENT_SHADER, fragment_source}}) {
    const unsigned shader = Compile(kind, source);
    glAttachShader(program_, shader);
    glDeleteShader(shader);  // Once the program is gone.
  }
  glLinkProgram(program_);
  int linked = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) throw std::runtime_error("a shader program does not link");
}

void ShaderProgram::Use() const { glUseProgram(program_); }

void ShaderProgram::Set(const char* name, int value) const { glUniform1i(Location(name), value); }

void ShaderProgram::Set(const char* name, double value) const {
  glUniform1f(Location(name), static_cast<float>(value));
}

void ShaderProgram::Set(const char* name, const Eigen::Vector3d& value) const {
  const Eigen::Vector3f single = value.cast<float>();
  glUniform3fv(Location(name), 1, single.data());
}

void ShaderProgram::Set(const char* name, const Eigen::Matrix4d& value) const {
  const Eigen::Matrix4f single = value.cast<float>();
  glUniformMatrix4fv(Location(name), 1, GL_FALSE, single.data());  // Both are column by column.
}

int ShaderProgram::Location(const char* name) const { return glGetUniformLocation(program_, name); }

ShaderProgram MakeBodyProgram() { return {kLightingVertexSource, kBodyFragmentSource}; }

ShaderProgram MakeGroundProgram() { return {kLightingVertexSource, kGroundFragmentSource}; }

ShaderProgram MakeShadowProgram() { return {kShadowVertexSource, kShadowFragmentSource}; }

Eigen::Vector3d EncodeLinear(const Eigen::Vector3d& linear) { return (linear / kHeadroom).cwiseSqrt(); }

}  // namespace dgd_demos
