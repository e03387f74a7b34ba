#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/hard/draw.h"

namespace dgd_test::hard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::array kCubeTypes = {SetType::kBox, SetType::kPolytope, SetType::kMesh, SetType::kAffineBox,
                                   SetType::kPlainBox};

/// All its lengths are the same; a cube where the type has corners.
SetNumbers Cube(SetType type, double half) {
  SetNumbers cube;
  cube.type = type;
  cube.lengths = Vector3d::Constant(half);
  if (type == SetType::kAffineBox) {
    // Not a cube before it is mapped.
    const Vector3d stretch(2, 0.5, 4);
    cube.stretch = stretch.asDiagonal();
    cube.lengths = cube.lengths.cwiseQuotient(stretch);
    cube.points = {Vector3d::Zero()};
  }
  if (type == SetType::kPolytope || type == SetType::kMesh) {
    for (int corner = 0; corner < 8; ++corner) {
      const auto sign = [&](int bit) { return (corner >> bit & 1) != 0 ? 1 : -1; };
      cube.points.push_back(half * Vector3d(sign(0), sign(1), sign(2)));
    }
  }
  return cube;
}

enum Feature { kFace, kEdge, kVertex };

/// Turns a cube so that the feature is its highest, and its lowest: a face, an edge along x, a vertex.
Matrix3d Upright(Feature feature) {
  switch (feature) {
    case kFace:
      return Matrix3d::Identity();
    case kEdge:
      return Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitX()).toRotationMatrix();
    case kVertex:
      break;
  }
  return Eigen::AngleAxisd(std::acos(1 / std::sqrt(3.0)), Vector3d(1, -1, 0).normalized()).toRotationMatrix();
}

/// From the cube's centre to it, of half an edge.
double Height(Feature feature) { return std::sqrt(1.0 + static_cast<int>(feature)); }

Matrix3d AboutZ(double angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(); }

Side SideOfGap(double gap) {
  constexpr double kClear = 1e-9;  // m
  if (gap == 0) return Side::kTouching;
  if (std::abs(gap) < kClear) return Side::kUnknown;
  return gap > 0 ? Side::kApart : Side::kOverlapping;
}

/// A set that stands on the plane z = 0, on a flat face about the z axis.
SetNumbers Standing(SetType type, double size, PoseNumbers& pose) {
  pose.translation.z() = size;
  SetNumbers set = Cube(type, size);
  switch (type) {
    case SetType::kFrustum:
      set.lengths[1] = size / 2;
      [[fallthrough]];
    case SetType::kCone:  // Whose height, not half of it, is the size.
      pose.translation.z() = size / 2;
      break;
    case SetType::kTriangle:
      set.points = {{size, 0, 0}, {-size, size, 0}, {-size, -size, 0}};
      pose.translation.z() = 0;
      break;
    default:
      break;
  }
  return set;
}

}  // namespace

HardCase DrawTouchingFeatures(Random& random, int index) {
  const auto feature_1 = static_cast<Feature>(index % 3), feature_2 = static_cast<Feature>(index / 3 % 3);
  const double half_1 = random.LogUniform(0.1, 1), half_2 = random.LogUniform(0.1, 1);
  PairNumbers pair{Cube(kCubeTypes[static_cast<std::size_t>(index / 9) % kCubeTypes.size()], half_1),
                   Cube(kCubeTypes[static_cast<std::size_t>(random.Below(kCubeTypes.size()))], half_2),
                   {},
                   {}};
  pair.set_1.radius = random.Below(3) == 0 ? 0.04 : 0;
  pair.set_2.radius = random.Below(3) == 0 ? 0.04 : 0;
  const double turn = random.Flip() ? std::numbers::pi / 2 * random.Below(4) : random.Uniform(-3, 3);
  pair.pose_1 = {Upright(feature_1), {0, 0, -half_1 * Height(feature_1) - pair.set_1.radius}};
  pair.pose_2 = {AboutZ(turn) * Upright(feature_2), {0, 0, half_2 * Height(feature_2) + pair.set_2.radius}};
  // Aside, as far as one of them is still below the other: within a face's inscribed circle, or along an edge.
  if (feature_1 == kFace || feature_2 == kFace) {
    const double reach = feature_1 == kFace ? half_1 : half_2;
    pair.pose_2.translation += AboutZ(random.Uniform(-3, 3)) * Vector3d(random.Uniform(0, reach), 0, 0);
  } else if (feature_1 == kEdge) {
    pair.pose_2.translation.x() += random.Uniform(-half_1, half_1);
  }
  MoveBoth(random, pair);
  return {pair, Side::kTouching};
}

HardCase DrawSlidingFaces(Random& random, int index) {
  constexpr std::array kTypes = {SetType::kBox,      SetType::kCylinder,  SetType::kCone,
                                 SetType::kFrustum,  SetType::kPolytope,  SetType::kMesh,
                                 SetType::kPlainBox, SetType::kAffineBox, SetType::kTriangle};
  const double size_1 = random.LogUniform(0.1, 1), size_2 = random.LogUniform(0.1, 1);
  PairNumbers pair;
  pair.set_1 = Standing(kTypes[static_cast<std::size_t>(index) % (kTypes.size() - 1)], size_1, pair.pose_1);
  pair.set_2 =
      Standing(kTypes[static_cast<std::size_t>(random.Below(static_cast<int>(kTypes.size())))], size_2, pair.pose_2);
  // The first one hangs down from the plane.
  const Matrix3d flip = Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  pair.pose_1 = {flip, {0, 0, -pair.pose_1.translation.z()}};
  const double gap = TinyGap(random, 1e-16, 1e-3);
  pair.pose_2.translation.z() += gap;
  // From the middle to beyond the border; exactly to it in some.
  const double reach = size_1 + size_2;
  const double slide = random.Below(4) == 0 ? reach : random.Uniform(0, 1.2) * reach;
  pair.pose_2.translation += AboutZ(random.Flip() ? 0 : random.Uniform(-3, 3)) * Vector3d(slide, 0, 0);
  if (random.Flip()) pair.pose_2.rotation = AboutZ(random.Uniform(-3, 3));
  MoveBoth(random, pair);
  // Beyond the inscribed circles, what is above what is not told.
  const bool is_above = slide < 0.3 * std::min(size_1, size_2);
  return {pair, is_above ? SideOfGap(gap) : Side::kUnknown};
}

HardCase DrawNearlyParallelEdges(Random& random, int index) {
  const double half_1 = random.LogUniform(0.1, 1), half_2 = random.LogUniform(0.1, 1);
  const auto type = [&](int number) { return kCubeTypes[static_cast<std::size_t>(number) % kCubeTypes.size()]; };
  PairNumbers pair{Cube(type(index), half_1), Cube(type(index / 5), half_2), {}, {}};
  const double gap = TinyGap(random, 1e-16, 1e-3);
  const double angle = random.LogUniform(1e-14, 0.1);
  pair.pose_1 = {Upright(kEdge), {0, 0, -half_1 * Height(kEdge)}};
  pair.pose_2 = {AboutZ(angle) * Upright(kEdge), {0, 0, half_2 * Height(kEdge) + gap}};
  // Along the edges, which still cross.
  pair.pose_2.translation.x() += random.Uniform(0, 1) * std::min(half_1, half_2);
  MoveBoth(random, pair);
  return {pair, SideOfGap(gap)};
}

}  // namespace dgd_test::hard
