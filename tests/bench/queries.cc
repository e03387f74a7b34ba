// Queries of one kind, to be counted by callgrind: see query_instructions.sh.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

#include "dgd/any_set.h"
#include "dgd/shapes.h"
#include "support/random.h"

namespace {

using Vector3 = Eigen::Vector3d;
using Pose = dgd::Pose<double>;

/// @param thickness  Of the other two extents.
dgd::Polytope<double> RandomHull(dgd_test::Random& random, int vertices, double thickness) {
  std::vector<Vector3> points;
  for (int i = 0; i < vertices; ++i) {
    points.push_back(Vector3(0.5, 0.5, 0.5 * thickness).cwiseProduct(random.UnitVector()));
  }
  return dgd::Polytope<double>(points);
}

/// At a distance from the origin, in any orientation.
Pose RandomPose(dgd_test::Random& random, double distance) {
  return {random.Rotation(), distance * random.UnitVector()};
}

/// Moved by 1 %, as from frame to frame.
Pose MovedALittle(dgd_test::Random& random, const Pose& pose) {
  const Eigen::AngleAxisd turn(0.01, random.UnitVector());
  return {turn.toRotationMatrix() * pose.rotation, pose.translation + 0.005 * random.UnitVector()};
}

constexpr int kPairs = 100, kFrames = 5;

constexpr std::array kKinds = {"hulls",
                               "meshes",
                               "flat-hulls",
                               "capsule-hull",
                               "hull-cylinder",
                               "boxes",
                               "cylinders",
                               "cones",
                               "ellipsoids",
                               "custom-hulls",
                               "custom-ellipsoids",
                               "rounded-hulls",
                               "rounded-cylinders"};
constexpr std::array kQueries = {"growth", "warm", "near", "check", "signed", "alone", "update", "overlap"};

/// What the sets refer to.
struct Cores {
  std::vector<dgd::Polytope<double>> hulls;
  dgd::Ellipsoid<double> ellipsoid{{0.2, 0.3, 0.5}};
};

Cores MakeCores(dgd_test::Random& random, std::string_view kind) {
  Cores cores;
  const double thickness = kind == "flat-hulls" ? 0.1 : 1;
  for (int i = 0; i < kPairs; ++i) {
    cores.hulls.push_back(RandomHull(random, kind == "meshes" ? 500 : 8 + i % 13, thickness));
  }
  return cores;
}

/// The first or the second set of the i-th pair of a kind, about 1 m across.
dgd::AnySet MakeSet(dgd_test::Random& random, const Cores& cores, std::string_view kind, int i, bool is_second) {
  using dgd::RoundedSet;
  const double radius = kind.starts_with("rounded-") ? 0.04 : 0;
  const dgd::Polytope<double>& hull = cores.hulls[std::size_t((2 * i + is_second) * 7 % kPairs)];
  if (kind == "boxes") {
    const Vector3 half(random.Uniform(0.1, 0.5), random.Uniform(0.1, 0.5), random.Uniform(0.1, 0.5));
    return RoundedSet{dgd::Box<double>(half)};
  }
  if (kind == "capsule-hull" && !is_second) return dgd::Capsule(0.2, 0.3);
  if (kind.ends_with("cylinders") || (kind == "hull-cylinder" && is_second)) {
    return RoundedSet{dgd::Cylinder<double>(0.3, 0.4), radius};
  }
  if (kind == "cones") return RoundedSet{dgd::Cone<double>(0.3, 0.8)};
  if (kind == "ellipsoids") return RoundedSet{cores.ellipsoid};
  if (kind == "custom-ellipsoids") return RoundedSet{dgd::CustomCore(cores.ellipsoid)};
  if (kind == "custom-hulls") return RoundedSet{dgd::CustomCore(hull)};
  return RoundedSet{dgd::CoreReference<dgd::Polytope<double>>(hull), radius};
}

/// How far the sets' origins are from each other, metres. The cores of an updated pair stay apart, or in overlap; those
/// of a signed distance alone are apart more often than not, and checks are of pairs that overlap more often than not.
double RandomDistance(dgd_test::Random& random, std::string_view query) {
  if (query == "update") return random.Uniform(1, 1.1);
  if (query == "alone") return random.Uniform(0.7, 1.2);
  if (query == "overlap") return random.Uniform(0.6, 0.8);
  return query == "check" ? random.Uniform(0.3, 0.8) : random.Uniform(0.5, 1);
}

/// As the plugin does before each query, but for two long bodies.
dgd::Result<double> GrowthDistanceNear(dgd::AnySet a, const Pose& pose_a, dgd::AnySet b, const Pose& pose_b,
                                       dgd::WarmStart<double>& state) {
  if (a.MovesCenter() || b.MovesCenter()) {
    const Vector3 center_a = pose_a * a.Center(), center_b = pose_b * b.Center();
    a.MoveCenterNear(pose_a.rotation.transpose() * (center_b - pose_a.translation));
    b.MoveCenterNear(pose_b.rotation.transpose() * (center_a - pose_b.translation));
  }
  return dgd::GrowthDistance(a, pose_a, b, pose_b, {}, &state);
}

/// What callgrind counts: the queries of one pair.
[[gnu::noinline]] void Measured(std::string_view query, const dgd::AnySet& a, const Pose& pose_a, const dgd::AnySet& b,
                                const std::vector<Pose>& frames) {
  dgd::WarmStart<double> state;
  const Pose& pose_b = frames[0];
  if (query == "growth") {
    (void)dgd::GrowthDistance(a, pose_a, b, pose_b);
  } else if (query == "check") {
    (void)dgd::DetectCollision(a, pose_a, b, pose_b);
  } else if (query == "warm") {
    for (const Pose& pose : frames) (void)dgd::GrowthDistance(a, pose_a, b, pose, {}, &state);
  } else if (query == "near") {
    for (const Pose& pose : frames) (void)GrowthDistanceNear(a, pose_a, b, pose, state);
  } else if (query == "alone") {
    (void)dgd::SignedDistance(a, pose_a, b, pose_b);
  } else {
    const dgd::Result<double> growth = dgd::GrowthDistance(a, pose_a, b, pose_b, {}, &state);
    dgd::WarmStart<double> follow;
    (void)dgd::SignedDistance(a, pose_a, b, pose_b, growth, &state, {}, &follow);
    if (query == "signed") return;
    for (const Pose& pose : frames) {
      if (dgd::UpdateDistance(a, pose_a, b, pose, {}, follow).status == dgd::Status::kOptimal) continue;
      (void)dgd::SignedDistance(a, pose_a, b, pose, {}, &follow);
    }
  }
}

template <class Names>
bool IsAmong(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3 || !IsAmong(kQueries, arguments[1]) || !IsAmong(kKinds, arguments[2])) {
    std::fputs("usage: queries QUERY KIND; query_instructions.sh names them\n", stderr);
    return 2;
  }
  const std::string_view query = arguments[1], kind = arguments[2];
  dgd_test::Random random(1);
  const Cores cores = MakeCores(random, kind);
  for (int i = 0; i < kPairs; ++i) {
    const dgd::AnySet a = MakeSet(random, cores, kind, i, false), b = MakeSet(random, cores, kind, i, true);
    const Pose pose_a = RandomPose(random, 0);
    std::vector<Pose> frames = {RandomPose(random, RandomDistance(random, query))};
    while (int(frames.size()) < kFrames) frames.push_back(MovedALittle(random, frames.back()));
    Measured(query, a, pose_a, b, frames);
  }
  return 0;
}
