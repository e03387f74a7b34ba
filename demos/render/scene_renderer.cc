#include "render/scene_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "render/colour_space.h"
#include "render/gl.h"
#include "render/light_samples.h"
#include "render/off_screen.h"
#include "render/shaders.h"
#include "render/shortest_turn.h"

namespace dgd_demos {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kPasses = 32;                       // Half are the sun's. With 24, soft shadows show their layers.
constexpr int kShadowMapSize = 768;               // Pixels. Their steps blur, as each pass turns them another way.
const Vector3d kBackground(0.93, 0.94, 0.955);    // sRGB
const Vector3d kGroundColour(0.80, 0.80, 0.79);   // sRGB
const Vector3d kSceneryColour(0.72, 0.71, 0.68);  // sRGB
constexpr double kGloss = 0.25;
constexpr double kAmbient = 0.12;  // Light that has been reflected more than once.
// The ground fades into the background at these distances from the middle, in distances of the camera.
constexpr double kFadeStart = 0.35, kFadeEnd = 0.9;

Matrix4d ModelMatrix(const Pose& pose) {
  Matrix4d model = Matrix4d::Identity();
  model.topLeftCorner<3, 3>() = pose.rotation;
  model.topRightCorner<3, 1>() = pose.position;
  return model;
}

// Bodies side by side at the same speed can be told apart if they differ a little in brightness.
Vector3d BodyAlbedo(const SpeedScale& scale, double speed, std::size_t index) {
  constexpr int kShades = 5;
  constexpr double kDarkest = 0.86;
  const double shade = kDarkest + (1 - kDarkest) * static_cast<double>(index * 3 % kShades) / (kShades - 1);
  return shade * LinearFromSrgb(SpeedScale::ColourAt(scale.PlaceOf(speed)));
}

// An orthogonal view along the light that holds the scene.
Matrix4d WorldToLight(const Vector3d& direction, const Ball& scene) {
  const Eigen::Matrix3d world_to_axes = ShortestTurn(direction, Vector3d::UnitZ()).toRotationMatrix();
  Matrix4d matrix = Matrix4d::Identity();
  Eigen::Matrix3d scaled = world_to_axes / scene.radius;
  scaled.row(2) *= -1;  // OpenGL's depth grows away from the light.
  matrix.topLeftCorner<3, 3>() = scaled;
  matrix.topRightCorner<3, 1>() = -scaled * scene.centre;
  return matrix;
}

// Sums passes in linear light, and hands out their mean as a picture.
class Accumulator {
 public:
  Accumulator(int width, int height)
      : width_(width), height_(height), sum_(3 * static_cast<std::size_t>(width) * height) {
    for (int byte = 0; byte < 256; ++byte)
      light_of_byte_[byte] = static_cast<float>(kHeadroom * byte * byte / (255.0 * 255.0));
  }

  void Add(const std::vector<std::uint8_t>& rgba) {
    for (std::size_t pixel = 0; 3 * pixel < sum_.size(); ++pixel) {
      for (std::size_t c = 0; c < 3; ++c) sum_[3 * pixel + c] += light_of_byte_[rgba[4 * pixel + c]];
    }
    ++passes_;
  }

  Image Mean() const {
    Image image(width_, height_);
    for (int row = 0; row < height_; ++row) {
      const int source_row = height_ - 1 - row;  // OpenGL's rows go upwards.
      const float* source = &sum_[3 * static_cast<std::size_t>(source_row) * width_];
      std::transform(source, source + 3 * width_, image.Pixel(0, row), [&](float sum) {
        return static_cast<std::uint8_t>(
            std::lround(255 * SrgbFromLinear(std::min(1.0, sum / static_cast<double>(passes_)))));
      });
    }
    return image;
  }

 private:
  int width_, height_;
  std::vector<float> sum_;
  std::array<float, 256> light_of_byte_;
  int passes_ = 0;
};

}  // namespace

class SceneRenderer::Impl {
 public:
  Impl(std::vector<DrawnBody> bodies, const SpeedScale& speed_scale, int width, int height)
      : screen_(width, height),
        body_program_(MakeBodyProgram()),
        ground_program_(MakeGroundProgram()),
        shadow_program_(MakeShadowProgram()),
        bodies_(std::move(bodies)),
        speed_scale_(speed_scale) {
    MakeShadowMap();
    MakeDisplayLists();
  }

  double aspect() const { return static_cast<double>(screen_.width()) / screen_.height(); }

  Image Render(const PictureRequest& request) {
    screen_.MakeCurrent();
    const Ball scene = BallAroundAll(WithSurroundings(BallsAround(bodies_, request.state), bodies_, request.state));
    Accumulator accumulator(screen_.width(), screen_.height());
    for (int pass = 0; pass < kPasses; ++pass) {
      const LightSample light = LightOfPass(pass, kPasses);
      const Vector2d jitter = JitterOfPass(pass);
      const Matrix4d world_to_light = WorldToLight(light.direction, scene);
      DrawShadowMap(request.state, world_to_light);
      DrawScene(request, light, world_to_light, scene, jitter);
      DrawOverlay({request.title, request.subtitle, request.legend}, speed_scale_, screen_.width(), screen_.height(),
                  jitter);
      glFinish();
      accumulator.Add(screen_.rgba());
    }
    return accumulator.Mean();
  }

 private:
  // A texture that holds depths and compares with them, and a frame buffer to draw them.
  void MakeShadowMap() {
    unsigned texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    // 16 bits: a step of the depth is then still far less than the offset that keeps a surface from shading itself.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT16, kShadowMapSize, kShadowMapSize, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr std::array<float, 4> kFarthest = {1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kFarthest.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glGenFramebuffers(1, &shadow_buffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, shadow_buffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("OpenGL cannot draw into a depth texture");
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  // One list a body, in its local frame.
  void MakeDisplayLists() {
    first_list_ = glGenLists(static_cast<int>(bodies_.size()));
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      glNewList(first_list_ + static_cast<unsigned>(i), GL_COMPILE);
      glBegin(GL_TRIANGLES);
      for (const SurfaceVertex& vertex : std::exchange(bodies_[i].surface, {})) {
        glNormal3fv(vertex.normal.data());
        glVertex3fv(vertex.position.data());
      }
      glEnd();
      glEndList();
    }
  }

  bool IsFloor(std::size_t index) const { return bodies_[index].role == DrawnBody::Role::kFloor; }

  void DrawBody(std::size_t index) const { glCallList(first_list_ + static_cast<unsigned>(index)); }

  Vector3d AlbedoOf(std::size_t index, const PictureRequest& request) const {
    if (!request.colours.empty()) return LinearFromSrgb(request.colours[index]);
    if (bodies_[index].role == DrawnBody::Role::kScenery) return LinearFromSrgb(kSceneryColour);
    return BodyAlbedo(speed_scale_, request.state.speeds[index], index);
  }

  // Floors get shadows but cast none.
  void DrawShadowMap(const Snapshot& state, const Matrix4d& world_to_light) {
    glBindFramebuffer(GL_FRAMEBUFFER, shadow_buffer_);
    glViewport(0, 0, kShadowMapSize, kShadowMapSize);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glClear(GL_DEPTH_BUFFER_BIT);
    shadow_program_.Use();
    shadow_program_.Set("world_to_light", world_to_light);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (IsFloor(i)) continue;
      shadow_program_.Set("model", ModelMatrix(state.poses[i]));
      DrawBody(i);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  void DrawScene(const PictureRequest& request, const LightSample& light, const Matrix4d& world_to_light,
                 const Ball& scene, const Vector2d& jitter) {
    const Vector3d background = LinearFromSrgb(kBackground);
    const Vector3d encoded = EncodeLinear(background);
    glViewport(0, 0, screen_.width(), screen_.height());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glClearColor(static_cast<float>(encoded.x()), static_cast<float>(encoded.y()), static_cast<float>(encoded.z()), 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    Matrix4d shift = Matrix4d::Identity();  // By a part of a pixel, in clip space.
    shift(0, 3) = -2 * jitter.x() / screen_.width();
    shift(1, 3) = -2 * jitter.y() / screen_.height();

    // Floors last: most of them is then found to be hidden before it is shaded.
    UseForPass(body_program_, request, light, world_to_light, scene, shift);
    body_program_.Set("eye", request.camera.Position());
    body_program_.Set("gloss", kGloss);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (IsFloor(i)) continue;
      body_program_.Set("model", ModelMatrix(request.state.poses[i]));
      body_program_.Set("albedo", AlbedoOf(i, request));
      DrawBody(i);
    }
    UseForPass(ground_program_, request, light, world_to_light, scene, shift);
    ground_program_.Set("background", background);
    ground_program_.Set("target", request.camera.target);
    ground_program_.Set("fade_start", kFadeStart * request.camera.distance);
    ground_program_.Set("fade_end", kFadeEnd * request.camera.distance);
    ground_program_.Set("albedo", LinearFromSrgb(kGroundColour));
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!IsFloor(i)) continue;
      ground_program_.Set("model", ModelMatrix(request.state.poses[i]));
      DrawBody(i);
    }
  }

  // What bodies and ground have in common.
  void UseForPass(const ShaderProgram& program, const PictureRequest& request, const LightSample& light,
                  const Matrix4d& world_to_light, const Ball& scene, const Matrix4d& shift) const {
    program.Use();
    program.Set("view_projection", Matrix4d(shift * request.camera.ViewProjection(aspect())));
    program.Set("world_to_light", world_to_light);
    program.Set("shadow_map", 0);
    program.Set("shadow_offset", 3 * scene.radius / kShadowMapSize);
    program.Set("light_direction", light.direction);
    program.Set("light_strength", light.strength);
    program.Set("ambient", kAmbient);
    program.Set("headroom", kHeadroom);
  }

  OffScreen screen_;
  ShaderProgram body_program_, ground_program_, shadow_program_;
  std::vector<DrawnBody> bodies_;
  SpeedScale speed_scale_;
  unsigned shadow_buffer_ = 0;
  unsigned first_list_ = 0;
};

SceneRenderer::SceneRenderer(std::vector<DrawnBody> bodies, const SpeedScale& speed_scale, int width, int height)
    : impl_(std::make_unique<Impl>(std::move(bodies), speed_scale, width, height)) {}

SceneRenderer::~SceneRenderer() = default;

Image SceneRenderer::Render(const PictureRequest& request) { return impl_->Render(request); }

double SceneRenderer::aspect() const { return impl_->aspect(); }

}  // namespace dgd_demos
