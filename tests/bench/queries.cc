// Queries of one kind, to be counted by callgrind: see query_instructions.sh.
#include <Eigen/Geometry>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "dgd/any_set.h"

namespace {

using Vector3 = Eigen::Vector3d;
using Pose = dgd::Pose<double>;

/// Random numbers that are the same everywhere, unlike the standard library's distributions.
class Draw {
 public:
  double Uniform(double low, double high) { return low + (high - low) * double(engine_()) / double(engine_.max()); }
  Vector3 Direction() {
    for (;;) {
      const Vector3 v(Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1));
      if (v.squaredNorm() <= 1 && v.squaredNorm() > 0.01) return v.normalized();
    }
  }
  /// At a distance from the origin, in any orientation.
  Pose At(double distance) {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(Uniform(0, 3), Direction()).toRotationMatrix();
    pose.translation = distance * Direction();
    return pose;
  }
  /// By 1 %, as from frame to frame.
  Pose MovedALittle(const Pose& pose) {
    Pose moved;
    moved.rotation = Eigen::AngleAxisd(0.01, Direction()).toRotationMatrix() * pose.rotation;
    moved.translation = pose.translation + 0.005 * Direction();
    return moved;
  }
  dgd::Polytope<double> Hull(int vertices) {
    std::vector<Vector3> points;
    for (int i = 0; i < vertices; ++i) points.push_back(0.5 * Direction());
    return dgd::Polytope<double>(points);
  }

 private:
  std::mt19937 engine_{1};
};

constexpr int kPairs = 100, kFrames = 5;

/// The sets of a kind of pair, in turns; about 1 m across.
std::vector<dgd::AnySet> MakeSets(const std::string& kind, Draw& draw) {
  using dgd::RoundedSet;
  static std::vector<dgd::Polytope<double>> hulls;
  static std::vector<dgd::Ellipsoid<double>> ellipsoids(1, dgd::Ellipsoid<double>({0.2, 0.3, 0.5}));
  const double radius = kind.starts_with("rounded-") ? 0.04 : 0;
  const std::string shape = radius > 0 ? kind.substr(8) : kind;
  const int vertices = shape == "meshes" ? 500 : 0;
  hulls.reserve(kPairs);
  for (int i = 0; i < kPairs; ++i) hulls.push_back(draw.Hull(vertices > 0 ? vertices : 8 + i % 13));
  std::vector<dgd::AnySet> sets;
  for (int i = 0; i < 2 * kPairs; ++i) {
    const dgd::Polytope<double>& hull = hulls[std::size_t(i * 7 % kPairs)];
    if (shape == "boxes") {
      sets.emplace_back(RoundedSet{
          dgd::Box<double>({draw.Uniform(0.1, 0.5), draw.Uniform(0.1, 0.5), draw.Uniform(0.1, 0.5)}), radius});
    } else if (shape == "capsule-hull" && i % 2 == 0) {
      sets.emplace_back(RoundedSet{dgd::Segment<double>(0.3), 0.2});
    } else if (shape == "cylinders" || (shape == "hull-cylinder" && i % 2 == 1)) {
      sets.emplace_back(RoundedSet{dgd::Cylinder<double>(0.3, 0.4), radius});
    } else if (shape == "cones") {
      sets.emplace_back(RoundedSet{dgd::Cone<double>(0.3, 0.8), radius});
    } else if (shape == "ellipsoids") {
      sets.emplace_back(RoundedSet{dgd::Ellipsoid<double>({0.2, 0.3, 0.5}), radius});
    } else if (shape == "custom-ellipsoids") {
      sets.emplace_back(RoundedSet{dgd::CustomCore(ellipsoids[0]), radius});
    } else if (shape == "custom-hulls") {
      sets.emplace_back(RoundedSet{dgd::CustomCore(hull), radius});
    } else {
      sets.emplace_back(RoundedSet{dgd::CoreReference<dgd::Polytope<double>>(hull), radius});
    }
  }
  return sets;
}

/// What callgrind counts: the queries of one pair.
[[gnu::noinline]] void Measured(const std::string& query, const dgd::AnySet& a, const Pose& pose_a,
                                const dgd::AnySet& b, const std::vector<Pose>& frames) {
  dgd::WarmStart<double> state;
  const dgd::Pose<double>& pose_b = frames[0];
  if (query == "growth") {
    (void)dgd::GrowthDistance(a, pose_a, b, pose_b);
  } else if (query == "check") {
    (void)dgd::DetectCollision(a, pose_a, b, pose_b);
  } else if (query == "warm") {
    for (const Pose& pose : frames) (void)dgd::GrowthDistance(a, pose_a, b, pose, {}, &state);
  } else {
    const dgd::Result<double> growth = dgd::GrowthDistance(a, pose_a, b, pose_b, {}, &state);
    dgd::WarmStart<double> follow;
    (void)dgd::SignedDistance(a, pose_a, b, pose_b, growth, &state, {}, &follow);
    if (query == "follow") {
      for (const Pose& pose : frames) (void)dgd::UpdateDistance(a, pose_a, b, pose, {}, follow);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: queries growth|warm|signed|follow|check KIND; see query_instructions.sh\n");
    return 2;
  }
  const std::string query = arguments[1], kind = arguments[2];
  Draw draw;
  const std::vector<dgd::AnySet> sets = MakeSets(kind, draw);
  // Rounded sets are apart: their cores stay so. The others overlap or are apart.
  const bool is_apart = query == "follow";
  for (int i = 0; i < kPairs; ++i) {
    const Pose pose_a = draw.At(0);
    std::vector<Pose> frames = {draw.At(is_apart ? draw.Uniform(1, 1.1) : draw.Uniform(0.5, 1))};
    for (int frame = 1; frame < kFrames; ++frame) frames.push_back(draw.MovedALittle(frames.back()));
    Measured(query, sets[std::size_t(2 * i)], pose_a, sets[std::size_t(2 * i + 1)], frames);
  }
  return 0;
}
