#include "bench/pair_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scene/mesh_file.h"
#include "support/pairs/random_pair.h"

namespace dgd_bench {
namespace {

using dgd_test::PairNumbers;
using dgd_test::Random;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;

constexpr dgd_test::LengthRange kTwoDecades{0.0025, 0.25};  // m
constexpr double kHullDiameter = 1.0;                       // m
constexpr double kHullMargin = 0.04;                        // m
constexpr int kFewestHullVertices = 8, kMostHullVertices = 20;
constexpr std::array kMeshVertices = {241, 500, 1000, 2000, 3000, 4516};

PairNumbers PairOf(SetNumbers set_1, SetNumbers set_2) { return {std::move(set_1), std::move(set_2), {}, {}}; }

/// A sphere or a capsule, which need their radius, or a curved core or box without one.
SetNumbers RandomPrimitive(Random& random, bool must_be_curved) {
  constexpr std::array kTypes = {SetType::kPoint,   SetType::kSegment,   SetType::kCylinder, SetType::kCone,
                                 SetType::kFrustum, SetType::kEllipsoid, SetType::kBox};
  const int count = static_cast<int>(kTypes.size()) - (must_be_curved ? 1 : 0);
  const SetType type = kTypes[static_cast<std::size_t>(random.Below(count))];
  const bool is_rounded = type == SetType::kPoint || type == SetType::kSegment;
  return RandomSetOf(random, type, kTwoDecades, is_rounded);
}

PairNumbers DrawPrimitives(Random& random, const Meshes&) {
  SetNumbers curved = RandomPrimitive(random, true);
  return PairOf(std::move(curved), RandomPrimitive(random, false));
}

SetNumbers RandomHull(Random& random, double margin) {
  SetNumbers set;
  set.type = SetType::kPolytope;
  set.radius = margin;
  const int count = kFewestHullVertices + random.Below(kMostHullVertices - kFewestHullVertices + 1);
  for (int i = 0; i < count; ++i) {
    const double part = random.Uniform(0.8, 1.0);
    set.points.push_back(kHullDiameter / 2 * part * random.UnitVector());
  }
  return set;
}

PairNumbers DrawHulls(Random& random, double margin) {
  SetNumbers set_1 = RandomHull(random, margin);
  return PairOf(std::move(set_1), RandomHull(random, margin));
}

SetNumbers RandomMesh(Random& random, const Meshes& meshes) {
  SetNumbers set;
  set.type = SetType::kMesh;
  set.points = meshes[static_cast<std::size_t>(random.Below(static_cast<int>(meshes.size())))];
  return set;
}

PairNumbers DrawMeshes(Random& random, const Meshes& meshes) {
  SetNumbers set_1 = RandomMesh(random, meshes);
  return PairOf(std::move(set_1), RandomMesh(random, meshes));
}

/// A pair of any types of the list.
template <std::size_t count>
PairNumbers DrawOf(Random& random, const std::array<SetType, count>& types) {
  const auto draw = [&] {
    const SetType type = types[static_cast<std::size_t>(random.Below(static_cast<int>(count)))];
    return RandomSetOf(random, type, kTwoDecades, !dgd_test::InfoOf(type).is_solid);
  };
  SetNumbers set_1 = draw();
  return PairOf(std::move(set_1), draw());
}

/// Round hulls, sharp, all points of which are vertices.
template <int count>
PairNumbers DrawRound(Random& random, const Meshes&) {
  const auto draw = [&] {
    SetNumbers set;
    set.type = SetType::kPolytope;
    for (int i = 0; i < count; ++i) set.points.push_back(kHullDiameter / 2 * random.UnitVector());
    return set;
  };
  SetNumbers set_1 = draw();
  return PairOf(std::move(set_1), draw());
}

constexpr double kMotion = 0.01;
constexpr double kReach = 0.7;

dgd_test::PoseNumbers RandomPose(Random& random, int dimension, double extent) {
  dgd_test::PoseNumbers pose{RandomRotation(random, dimension), kReach * extent * random.InCube()};
  if (dimension == 2) pose.translation.z() = 0;
  return pose;
}

}  // namespace

PairPoses DrawPoses(Random& random, int dimension, double extent) {
  PairPoses poses;
  poses.pose_1 = RandomPose(random, dimension, extent);
  poses.last_pose_2 = RandomPose(random, dimension, extent);
  poses.pose_2 = MovedALittle(random, poses.last_pose_2, dimension, kMotion, extent);
  return poses;
}

Meshes EllipsoidMeshes(Random& random) {
  Meshes meshes;
  for (const int count : kMeshVertices) {
    const Vector3d semi_axes(0.5, random.LogUniform(0.05, 0.5), 0.05);
    auto& points = meshes.emplace_back();
    for (int i = 0; i < count; ++i) points.push_back(semi_axes.cwiseProduct(random.UnitVector()));
  }
  return meshes;
}

Meshes ReadMeshes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) throw std::runtime_error(folder.string() + ": no such folder");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  }
  if (files.empty()) throw std::runtime_error(folder.string() + ": no .obj files");
  std::ranges::sort(files);
  Meshes meshes;
  for (const auto& file : files) meshes.push_back(dgd_demos::LoadConvexMesh(file, 1).vertices);
  return meshes;
}

const std::vector<PairClass>& AllPairClasses() {
  static const std::vector<PairClass> classes = {
      {"curved", "primitives, a curved one in each pair", 3, 1, DrawPrimitives},
      {"rounded-hulls", "hulls of 8..20 vertices, margin 4 cm", 3, 1,
       [](Random& random, const Meshes&) { return DrawHulls(random, kHullMargin); }},
      {"sharp-hulls", "hulls of 8..20 vertices, no margin", 3, 1,
       [](Random& random, const Meshes&) { return DrawHulls(random, 0); }},
      {"meshes", "meshes, no margin", 3, 50, DrawMeshes},
      {"dsf", "differentiable support functions over hulls", 3, 10,
       [](Random& random, const Meshes&) { return DrawOf(random, std::array{SetType::kDsf}); }},
      {"2d", "circles, stadia, rectangles, ellipses, polygons", 2, 1,
       [](Random& random, const Meshes&) {
         return DrawOf(random, std::array{SetType::kCircle, SetType::kStadium, SetType::kRectangle, SetType::kEllipse,
                                          SetType::kPolygon});
       }},
      {"vertices-8", "hulls of 8 points on a sphere", 3, 1, DrawRound<8>, 8},
      {"vertices-32", "hulls of 32 points on a sphere", 3, 1, DrawRound<32>, 32},
      {"vertices-128", "hulls of 128 points on a sphere", 3, 10, DrawRound<128>, 128},
      {"vertices-512", "hulls of 512 points on a sphere", 3, 20, DrawRound<512>, 512},
      {"vertices-2048", "hulls of 2048 points on a sphere", 3, 50, DrawRound<2048>, 2048},
      {"vertices-4096", "hulls of 4096 points on a sphere", 3, 50, DrawRound<4096>, 4096},
  };
  return classes;
}

}  // namespace dgd_bench
