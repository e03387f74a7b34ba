#include "motion/path_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "render/scene_renderer.h"
#include "render/shortest_turn.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr int kWidth = 1280, kHeight = 720;
constexpr int kPanelWidth = 640, kPanelHeight = 400;  // Of a contact sheet.
constexpr int kPosesBetween = 5;                      // Of the arm, between start and goal.
constexpr double kTraceStep = 0.04;                   // rad
constexpr double kTraceRadius = 0.01;                 // m
constexpr double kBeforeRadius = 0.004;               // m
constexpr double kLargestInFrame = 0.7;               // Of an obstacle that has to be in the picture as a whole, m.

// sRGB.
const Vector3d kStartColour(0.20, 0.55, 0.86), kGoalColour(0.25, 0.65, 0.33), kBetweenColour(0.83, 0.84, 0.87);
const Vector3d kTraceColour(0.86, 0.10, 0.08), kBeforeColour(0.35, 0.35, 0.38), kObstacleColour(0.87, 0.67, 0.36),
    kLargeObstacleColour(0.84, 0.81, 0.74);

// What is drawn, as the renderer takes it.
struct Drawing {
  Eigen::Matrix3d turn;  // About the vertical axis, of all that is drawn.
  std::vector<Body> bodies;
  Snapshot state;
  std::vector<Vector3d> colours;

  void Add(const Shape& shape, const Pose& world_pose, const Vector3d& colour) {
    const Pose pose{turn * world_pose.rotation, turn * world_pose.position};
    Body body{"", shape, 0, 0, std::nullopt, 0, 0, 0, pose, {}};
    bodies.push_back(body);
    state.poses.push_back(pose);
    state.speeds.push_back(0);
    colours.push_back(colour);
  }
};

Eigen::Matrix3d TurnAboutVertical(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

// The configuration at a share of the path's length.
Configuration At(const JointPath& path, double share) {
  double remaining = share * Length(path);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = (path[i] - path[i - 1]).norm();
    if (remaining <= length && length > 0) return path[i - 1] + (path[i] - path[i - 1]) * (remaining / length);
    remaining -= length;
  }
  return path.back();
}

// Whether a shape looks the same in both poses: a link that turns about its own axis. Drawn twice, it would flicker.
bool IsSamePlace(const dgd::Pose<double>& a, const dgd::Pose<double>& b) {
  constexpr double kSame = 1e-3;  // m
  return (a.translation - b.translation).norm() < kSame && (a.rotation.col(2) - b.rotation.col(2)).norm() < kSame;
}

// @param drawn  In and out: the poses of all arms that are drawn already.
void AddArm(const CollisionModel& model, const Configuration& state, const Vector3d& colour, Drawing& drawing,
            std::vector<CollisionModel::Poses>& drawn) {
  CollisionModel::Poses poses;
  model.ComputePoses(state, poses);
  drawn.push_back(poses);
  for (std::size_t i = 0; i < poses.size() && model.parts()[i].link; ++i) {
    const auto is_here = [&](const CollisionModel::Poses& others) { return IsSamePlace(others[i], poses[i]); };
    if (std::any_of(drawn.begin(), drawn.end() - 1, is_here)) continue;
    const Pose pose{poses[i].rotation, poses[i].translation};
    drawing.Add(model.parts()[i].body.shape(), pose, colour);
  }
}

void AddTrace(const CollisionModel& model, const JointPath& path, double radius, const Vector3d& colour,
              Drawing& drawing) {
  Vector3d last = FlangePose(model.arm(), path.front()).position;
  const JointPath states = Subdivide(path, kTraceStep);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Vector3d next = FlangePose(model.arm(), states[i]).position;
    const double length = (next - last).norm();
    // Pieces as short as that change nothing that one sees, and a thousand take a minute to draw. The path's end shows
    // unless the last piece's round end covers it.
    const bool is_end = i + 1 == states.size();
    if (length < (is_end ? 0.5 : 3) * radius) continue;
    Pose pose;
    pose.position = (last + next) / 2;
    const Vector3d direction = (next - last) / length;
    if (direction.z() < 1) {
      pose.rotation = direction.z() > -1 ? ShortestTurn(Vector3d::UnitZ(), direction).toRotationMatrix()
                                         : Eigen::AngleAxisd(std::acos(-1), Vector3d::UnitX()).toRotationMatrix();
    }
    drawing.Add(Capsule{radius, length}, pose, colour);
    last = next;
  }
}

// A floor below all fixed bodies, for their shadows.
double FloorHeight(const CollisionModel& model) {
  double lowest = 0;
  for (const CollisionModel::Part& part : model.parts()) {
    if (!part.link) lowest = std::min(lowest, -part.body.SupportValue(ToDgd(part.pose), -Vector3d::UnitZ()));
  }
  return lowest;
}

// The floor and all that does not move.
void AddSurroundings(const CollisionModel& model, Drawing& drawing, std::vector<Ball>& frame) {
  constexpr double kFloorThickness = 0.1;  // m
  Pose floor;
  floor.position.z() = FloorHeight(model) - kFloorThickness;
  drawing.Add(Box{{20, 20, kFloorThickness}}, floor, kBetweenColour);
  for (const CollisionModel::Part& part : model.parts()) {
    if (part.link) continue;
    const double radius = BoundingRadius(part.body.shape(), 0);
    const bool is_large = radius > kLargestInFrame;
    drawing.Add(part.body.shape(), part.pose, is_large ? kLargeObstacleColour : kObstacleColour);
    if (!is_large) frame.push_back({part.pose.position, radius});
  }
}

// What the arm takes up along a path, so that all pictures of a motion are seen from the same place.
void AddArmToFrame(const CollisionModel& model, const JointPath& path, std::vector<Ball>& frame) {
  CollisionModel::Poses poses;
  for (int place = 0; place <= kPosesBetween + 1; ++place) {
    model.ComputePoses(At(path, place / (kPosesBetween + 1.0)), poses);
    for (std::size_t i = 0; i < poses.size() && model.parts()[i].link; ++i) {
      frame.push_back({poses[i].translation, BoundingRadius(model.parts()[i].body.shape(), 0)});
    }
  }
}

Image DrawMoment(const ExecutionPicture& picture, std::size_t step) {
  const CollisionModel& model = picture.model;
  Drawing drawing{TurnAboutVertical(picture.turn), {}, {}, {}};
  std::vector<Ball> frame;
  std::vector<CollisionModel::Poses> drawn;
  AddSurroundings(model, drawing, frame);
  AddArmToFrame(model, picture.planned, frame);
  AddArm(model, picture.states[step], kBetweenColour, drawing, drawn);
  AddTrace(model, picture.planned, kBeforeRadius, kBeforeColour, drawing);
  const JointPath until(picture.states.begin(), picture.states.begin() + static_cast<std::ptrdiff_t>(step) + 1);
  AddTrace(model, until, kTraceRadius, kTraceColour, drawing);
  for (Ball& ball : frame) ball.centre = drawing.turn * ball.centre;
  SceneRenderer renderer(DrawnBodiesOf(drawing.bodies), SpeedScale(1), kPanelWidth, kPanelHeight);
  const std::vector<LegendEntry> legend = {{kTraceColour, "way of the flange"}, {kBeforeColour, "planned"}};
  char title[32];
  std::snprintf(title, sizeof title, "%.2f s", picture.times[step]);
  return renderer.Render({drawing.state, FrameAll(frame, renderer.aspect()), title, "", drawing.colours, legend});
}

}  // namespace

Image Draw(const PathPicture& picture) {
  const CollisionModel& model = picture.model;
  Drawing drawing{TurnAboutVertical(picture.turn), {}, {}, {}};
  std::vector<Ball> frame;
  std::vector<CollisionModel::Poses> drawn;
  AddSurroundings(model, drawing, frame);
  AddArmToFrame(model, picture.path, frame);
  AddArm(model, picture.path.front(), kStartColour, drawing, drawn);
  AddArm(model, picture.path.back(), kGoalColour, drawing, drawn);
  for (int i = 1; i <= kPosesBetween; ++i) {
    AddArm(model, At(picture.path, i / (kPosesBetween + 1.0)), kBetweenColour, drawing, drawn);
  }
  AddTrace(model, picture.before, kBeforeRadius, kBeforeColour, drawing);
  AddTrace(model, picture.path, kTraceRadius, kTraceColour, drawing);

  for (Ball& ball : frame) ball.centre = drawing.turn * ball.centre;
  SceneRenderer renderer(DrawnBodiesOf(drawing.bodies), SpeedScale(1), kWidth, kHeight);
  const std::vector<LegendEntry> legend = {{kStartColour, "start"},
                                           {kGoalColour, "goal"},
                                           {kBetweenColour, "between"},
                                           {kTraceColour, "path of the flange"},
                                           {kBeforeColour, "before smoothing"},
                                           {kObstacleColour, "obstacles"}};
  return renderer.Render(
      {drawing.state, FrameAll(frame, renderer.aspect()), picture.title, picture.subtitle, drawing.colours, legend});
}

Image DrawContactSheet(const ExecutionPicture& picture) {
  constexpr std::size_t kColumns = 3, kRows = 2;
  std::optional<Image> sheet;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::optional<Image> strip;
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::size_t moment = row * kColumns + column, last = picture.states.size() - 1;
      const Image panel = DrawMoment(picture, last * moment / (kColumns * kRows - 1));
      strip = strip ? SideBySide(*strip, panel) : panel;
    }
    sheet = sheet ? Stacked(*sheet, *strip) : *strip;
  }
  return *sheet;
}

}  // namespace dgd_demos
