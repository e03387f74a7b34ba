// The distance followed from frame to frame: the same answer as SignedDistance() gives from scratch, certified, and a
// clear refusal where curved cores overlap.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "dgd/any_set.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "dgd/signed_distance_certificate.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::Status;
using Eigen::Vector3d;

std::vector<Vector3d> HullPoints(Random& random, int count) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(0.5 * random.UnitVector());
  return points;
}

struct Count {
  int frames = 0, followed = 0, separated = 0, refused = 0;
  int in_overlap = 0;   // Of those followed: with cores that overlap.
  int stalled = 0;      // Of those refused: short of the tolerance by rounding, though the cores are apart.
  long iterations = 0;  // Of those followed.

  void Print(const char* what) const {
    std::printf(
        "%s: %d frames: %d followed, %d of them in overlap, in %.2f iterations, %d separated, %d refused, "
        "%d of them apart\n",
        what, frames, followed, in_overlap, double(iterations) / followed, separated, refused, stalled);
  }
};

/// Two sets that drift past each other, shaken, for some frames: queried by following, and from scratch.
template <class S>
void QueryDrift(Random& random, const AnySet<S, 3>& set_1, const AnySet<S, 3>& set_2, Count& count) {
  using PolytopeSet = dgd::RoundedSet<ErasedVertexCore<S, 3>>;
  const bool is_polytope = std::holds_alternative<PolytopeSet>(set_1) && std::holds_alternative<PolytopeSet>(set_2);
  const auto radius_of = [](const auto& set) { return double(set.radius); };
  const double radius = std::visit(radius_of, set_1) + std::visit(radius_of, set_2);
  AnyPair<S, 3> pair(set_1, {}, set_2, {});
  constexpr int kFrames = 60;
  constexpr double kLimit = 0.3;  // m
  const double tolerance = sizeof(S) == sizeof(float) ? 1e-5 : is_polytope ? 1e-13 : 1e-8;
  dgd::Settings<S> settings;
  settings.separation_limit = S(kLimit);
  dgd::Pose<double> pose_1{random.Rotation(), random.InCube()}, pose_2{random.Rotation(), pose_1.translation};
  const Vector3d across = random.UnitVector(), drift = random.UnitVector();
  pose_2.translation += random.Uniform(0, 1.2) * across - 1.2 * drift;
  dgd::WarmStart<S> state;
  bool can_follow = !is_polytope;
  for (int frame = 0; frame < kFrames; ++frame) {
    pose_2.translation += 2.4 / kFrames * drift + 0.01 * random.InCube();
    pose_2.rotation = Eigen::AngleAxisd(0.02, random.UnitVector()) * pose_2.rotation;
    pair.MoveTo(dgd::Pose<S>{pose_1.rotation.cast<S>(), pose_1.translation.cast<S>()},
                dgd::Pose<S>{pose_2.rotation.cast<S>(), pose_2.translation.cast<S>()});
    dgd::WarmStart<S> warm_start, fresh;
    const auto growth = pair.GrowthDistance({}, &warm_start);
    const auto from_scratch = pair.SignedDistance(growth, &warm_start, {}, &fresh);
    const double separation_from_scratch = double(from_scratch.separation);
    if (can_follow) {
      ++count.frames;
      const dgd::WarmStart<S> before = state;
      const auto followed = pair.UpdateDistance(settings, state);
      switch (followed.status) {
        case Status::kOptimal: {
          ++count.followed;
          count.iterations += followed.iterations;
          if (separation_from_scratch + radius < -tolerance) ++count.in_overlap;
          // What separates the sets by more is right; from scratch, a search in float may have stalled.
          EXPECT_GE(double(followed.separation), separation_from_scratch - 2 * tolerance);
          EXPECT_LE(double(followed.upper_bound), double(followed.separation) + 2 * tolerance);
          if (from_scratch.status == Status::kOptimal) {
            EXPECT_NEAR(double(followed.separation), separation_from_scratch, 2 * tolerance);
          }
          const auto certificate = pair.Certify(followed);
          EXPECT_TRUE(certificate.Holds(2 * tolerance, std::sqrt(tolerance)))
              << certificate.primal_infeasibility << ' ' << certificate.separation_error << ' '
              << certificate.connection_error << ' ' << certificate.neighbour_gain;
          break;
        }
        case Status::kSeparated: {
          ++count.separated;
          const auto certificate = pair.Certify(followed);
          EXPECT_LE(certificate.separation_error, tolerance);
          EXPECT_GT(double(followed.separation), kLimit);
          EXPECT_EQ(state.size, 0);
          break;
        }
        default:
          ++count.refused;
          if (separation_from_scratch + radius > tolerance) ++count.stalled;
          EXPECT_EQ(state.features_1, before.features_1);
          EXPECT_EQ(state.size, before.size);
      }
      can_follow = followed.status == Status::kOptimal;
    }
    if (can_follow) continue;
    const bool is_followed = is_polytope || separation_from_scratch + radius > tolerance;
    can_follow = from_scratch.status == Status::kOptimal && is_followed && separation_from_scratch < kLimit;
    state = fresh;
  }
}

/// With and without vertices on the other side.
template <class S>
void QueryCurvedDrift(Random& random, S radius, const AnySet<S, 3>& hull, Count& count) {
  const auto cylinder = Erase(dgd::RoundedSet{dgd::Cylinder<S>(S(0.3), S(0.2)), radius});
  const auto cone = Erase(dgd::RoundedSet{dgd::Cone<S>(S(0.3), S(0.6)), radius});
  QueryDrift(random, cylinder, hull, count);
  QueryDrift(random, cylinder, cone, count);
  QueryDrift(random, cone, hull, count);
}

template <class S>
void PassAllTypes(int rounds) {
  Random random(TestSeed());
  Count count, curved;
  for (int i = 0; i < rounds && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("round " + std::to_string(i));
    const dgd::Polytope<S> hull(HullPoints(random, 8 + random.Below(12))), large(HullPoints(random, 200));
    const auto vector = [&] { return Vector3d(0.4 * random.InCube()).cast<S>().eval(); };
    const S radius = S(random.Uniform(0.02, 0.2));
    const auto rounded_hull = Erase(dgd::RoundedSet{dgd::CoreReference(hull), radius});
    const auto rounded_large = Erase(dgd::RoundedSet{dgd::CoreReference(large), radius});
    const auto sharp_hull = Erase(dgd::RoundedSet{dgd::CoreReference(hull), S(0)});
    const auto box = Erase(dgd::RoundedSet{dgd::Box<S>(dgd::Vector3<S>(S(0.3), S(0.2), S(0.4))), radius});
    const auto triangle = Erase(dgd::RoundedSet{dgd::Triangle<S>(vector(), vector(), vector()), radius});
    const auto capsule = Erase(dgd::Capsule(radius, S(0.3)));
    const auto sphere = Erase(dgd::Sphere(S(0.3)));
    QueryDrift(random, rounded_hull, rounded_hull, count);
    QueryDrift(random, rounded_hull, rounded_large, count);
    QueryDrift(random, sharp_hull, sharp_hull, count);
    QueryDrift(random, box, rounded_hull, count);
    QueryDrift(random, box, box, count);
    QueryDrift(random, triangle, rounded_hull, count);
    QueryDrift(random, capsule, box, count);
    QueryDrift(random, capsule, capsule, count);
    QueryDrift(random, sphere, rounded_hull, count);
    QueryDrift(random, sphere, sphere, count);
    QueryCurvedDrift<S>(random, radius, rounded_hull, curved);
  }
  count.Print("polytopes");
  EXPECT_GT(count.followed, 0.7 * count.frames);
  EXPECT_GT(count.in_overlap, 0.1 * count.frames);
  EXPECT_GT(count.separated, 0);
  EXPECT_LE(count.refused, 0.01 * count.frames);
  EXPECT_LE(count.stalled, 0.001 * count.frames);
  EXPECT_LT(double(count.iterations), 2.5 * count.followed);
  curved.Print("curved");
  EXPECT_GT(curved.followed, 0.5 * curved.frames);
  EXPECT_GT(curved.separated, 0);
  EXPECT_GT(curved.refused, 0);
  EXPECT_LE(curved.stalled, 0.01 * curved.frames);
  EXPECT_LT(double(curved.iterations), 9.0 * curved.followed);
}

TEST(UpdateDistance, SetsThatPassEachOther_AsFromScratchInDouble) { PassAllTypes<double>(TestCount(40, 4)); }
TEST(UpdateDistance, SetsThatPassEachOther_AsFromScratchInFloat) { PassAllTypes<float>(TestCount(20, 2)); }

TEST(UpdateDistance, NoStateOrBadInput_IsRefused) {
  const dgd::AnySet box = dgd::RoundedSet{dgd::Box<double>(Vector3d(1, 1, 1)), 0.1};
  dgd::Pose<double> pose;
  pose.translation = Vector3d(0, 0, 2.1);
  dgd::WarmStart<double> state;
  EXPECT_EQ(dgd::UpdateDistance(box, {}, box, pose, {}, state).status, Status::kStalled);
  // Vertices that no longer exist are no state.
  state.size = 3;
  state.features_1 = state.features_2 = {100, 101, 102};
  EXPECT_EQ(dgd::UpdateDistance(box, {}, box, pose, {}, state).status, Status::kStalled);
  state.features_1 = state.features_2 = {0, 1, 2};
  pose.translation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(dgd::UpdateDistance(box, {}, box, pose, {}, state).status, Status::kInvalidInput);
}

TEST(UpdateDistance, CurvedCoresWithoutState_StartFromTheLineOfTheCentres) {
  const dgd::AnySet cylinder = dgd::RoundedSet{dgd::Cylinder<double>(0.5, 1), 0.1};
  dgd::Pose<double> pose;
  pose.translation = Vector3d(0.1, 0, 2.15);
  dgd::WarmStart<double> state;
  const auto result = dgd::UpdateDistance(cylinder, {}, cylinder, pose, {}, state);
  EXPECT_EQ(result.status, Status::kOptimal);
  EXPECT_NEAR(result.separation, -0.05, 1e-9);
  EXPECT_NEAR((result.normal - Vector3d::UnitZ()).norm(), 0, 1e-6);
  pose.translation.z() = 1.9;
  EXPECT_EQ(dgd::UpdateDistance(cylinder, {}, cylinder, pose, {}, state).status, Status::kStalled);
}

}  // namespace
}  // namespace dgd_test
