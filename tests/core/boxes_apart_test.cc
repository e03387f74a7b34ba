// The signed distance of two boxes, without a search: the same answer as SignedDistance() gives, certified, with what
// the boxes show each other, and a refusal where neither a face nor two edges hold it.
#include "dgd/boxes_apart.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "dgd/signed_distance_certificate.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::FaceHolder;
using dgd::Status;
using Eigen::Vector3d;

constexpr double kAngularTolerance = 1.47;

template <class S>
using RoundedBox = dgd::RoundedSet<dgd::Box<S>>;

template <class S>
struct Anew {
  dgd::SignedDistanceResult<S> result;
  dgd::FacingFaces<S> facing;
};

/// By a search, from nothing.
template <class S>
Anew<S> MeasureAnew(const RoundedBox<S>& box_1, const dgd::Pose<S>& pose_1, const RoundedBox<S>& box_2,
                    const dgd::Pose<S>& pose_2) {
  Anew<S> anew;
  const AnyPair<S, 3> pair(Erase(box_1), pose_1, Erase(box_2), pose_2);
  dgd::WarmStart<S> warm_start;
  dgd::Result<S> growth = pair.GrowthDistance({}, &warm_start);
  anew.result = pair.SignedDistance(growth, &warm_start);
  growth.normal = anew.result.normal;
  growth.witness_1 = anew.result.witness_1;
  growth.witness_2 = anew.result.witness_2;
  anew.facing = dgd::FindFacingFaces(box_1, pose_1, box_2, pose_2, growth, S(kAngularTolerance));
  return anew;
}

/// Of the overlap on set 1's surface, as it lies in the world; square metres.
template <class S>
Vector3d AreaOf(const dgd::FacingFaces<S>& facing) {
  const auto in_world = [&](int i) -> Vector3d {
    const dgd::Corner<S>& corner = facing.overlap[i];
    return facing.frame.ToWorld({corner.x, corner.y, corner.height_1}).template cast<double>();
  };
  const int size = facing.overlap.size;
  double middle_x = 0, middle_y = 0;
  for (int i = 0; i < size; ++i) {
    middle_x += double(facing.overlap[i].x) / size;
    middle_y += double(facing.overlap[i].y) / size;
  }
  std::vector<int> around(static_cast<std::size_t>(size));
  std::iota(around.begin(), around.end(), 0);
  std::ranges::sort(around, {}, [&](int i) {
    return std::atan2(double(facing.overlap[i].y) - middle_y, double(facing.overlap[i].x) - middle_x);
  });
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < around.size(); ++i) {
    area += (in_world(around[i]) - in_world(around[0])).cross(in_world(around[i + 1]) - in_world(around[0])) / 2;
  }
  return area;
}

struct Count {
  int near = 0, on_face = 0, on_edges = 0, overlaps = 0, separated = 0, refused = 0;
};

/// One pair, from a state that may be of any other one.
template <class S>
void Compare(const RoundedBox<S>& box_1, const dgd::Pose<S>& pose_1, const RoundedBox<S>& box_2,
             const dgd::Pose<S>& pose_2, FaceHolder& holder, dgd::WarmStart<S>& state, Count& count) {
  constexpr double kLimit = 0.1;  // m
  const double tolerance = sizeof(S) == sizeof(float) ? 2e-5 : 1e-13;
  dgd::Settings<S> settings;
  settings.separation_limit = S(kLimit);
  const double radii = double(box_1.radius + box_2.radius);
  const Anew<S> anew = MeasureAnew(box_1, pose_1, box_2, pose_2);
  const dgd::WarmStart<S> last = state;
  dgd::FacingFaces<S> facing;
  const auto result =
      dgd::FollowBoxes(box_1, pose_1, box_2, pose_2, settings, S(kAngularTolerance), holder, state, facing);
  const double separation = double(result.separation);
  count.near += double(anew.result.separation)<kLimit&& double(anew.result.separation) + radii> tolerance;
  if (result.status == Status::kStalled) {
    ++count.refused;
    EXPECT_EQ(facing.overlap.size, 0);
    EXPECT_EQ(state.normal_1, last.normal_1);
    EXPECT_EQ(state.size, last.size);
    holder = FaceHolder::kNone;
    return;
  }
  const auto certificate = dgd::Certify(box_1, pose_1, box_2, pose_2, result);
  EXPECT_LE(certificate.separation_error, tolerance);
  holder = dgd::HolderOf(facing);
  if (result.status == Status::kSeparated) {
    ++count.separated;
    EXPECT_GT(separation, kLimit);
    EXPECT_GT(double(anew.result.separation), kLimit - tolerance);
    EXPECT_EQ(state.size, 0);
    EXPECT_EQ(holder, FaceHolder::kNone);
    return;
  }
  ASSERT_EQ(result.status, Status::kOptimal);
  EXPECT_GT(separation + radii, 0);
  EXPECT_LE(double(result.upper_bound), separation + 2 * tolerance);
  EXPECT_NEAR(separation, double(anew.result.separation), 2 * tolerance);
  EXPECT_TRUE(certificate.Holds(2 * tolerance, 2 * tolerance))
      << certificate.primal_infeasibility << ' ' << certificate.separation_error << ' ' << certificate.connection_error
      << ' ' << certificate.neighbour_gain;
  ++(holder == FaceHolder::kNone ? count.on_edges : count.on_face);
  // The faces that are seen along the normal, if it is the same one: nearly parallel faces have others beside it.
  if ((result.normal - anew.result.normal).norm() > S(tolerance)) return;
  const Vector3d area = AreaOf(facing), area_anew = AreaOf(anew.facing);
  const Vector3d normal = result.normal.template cast<double>();
  // Either may be the one that carries the corners; seen along the normal they are as large.
  EXPECT_NEAR(std::abs(area.dot(normal)), std::abs(area_anew.dot(normal)), std::sqrt(tolerance));
  if (facing.overlap.size == 0 || anew.facing.overlap.size == 0) return;
  ++count.overlaps;
  EXPECT_NEAR(double(facing.Nearest()->Separation()), double(anew.facing.Nearest()->Separation()), 2 * tolerance);
}

template <class S>
void CompareRandomBoxes(int rounds) {
  constexpr int kFrames = 8;
  Random random(TestSeed());
  Count count;
  for (int i = 0; i < rounds && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("round " + std::to_string(i));
    const auto random_box = [&]() -> RoundedBox<S> {
      Vector3d half;
      for (int axis = 0; axis < 3; ++axis) half[axis] = random.LogUniform(0.05, 1);
      if (random.Below(8) == 0) half[random.Below(3)] = 0;  // A plate.
      const double radius = random.Uniform(0.01, 0.05);
      return {dgd::Box<S>(half.cast<S>()), S(radius)};
    };
    const RoundedBox<S> box_1 = random_box(), box_2 = random_box();
    dgd::Pose<double> pose_1{random.Rotation(), random.InCube()}, pose_2 = pose_1;
    // Aligned, nearly so, or anyhow.
    switch (random.Below(4)) {
      case 0:
        break;
      case 1:
        pose_2.rotation = Eigen::AngleAxisd(random.LogUniform(1e-9, 0.1), random.UnitVector()) * pose_2.rotation;
        break;
      case 2:
        pose_2.rotation = Eigen::AngleAxisd(random.Uniform(-3, 3), pose_2.rotation.col(2)) * pose_2.rotation;
        break;
      default:
        pose_2.rotation = random.Rotation();
    }
    const auto rounded = [](const dgd::Pose<double>& pose) -> dgd::Pose<S> {
      return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
    };
    // From somewhere on the way to the other, so that not only corners are near each other.
    const Vector3d way = random.UnitVector();
    const double wanted = random.Uniform(-0.9, 0.5) * double(box_1.radius + box_2.radius);
    double near = 0, far = 4;
    for (int halving = 0; halving < 12; ++halving) {
      const double middle = (near + far) / 2;
      pose_2.translation = pose_1.translation + middle * way;
      const auto result = MeasureAnew(box_1, rounded(pose_1), box_2, rounded(pose_2)).result;
      (double(result.separation) < wanted ? near : far) = middle;
    }
    FaceHolder holder = FaceHolder::kNone;
    dgd::WarmStart<S> state;
    for (int frame = 0; frame < kFrames; ++frame) {
      Compare(box_1, rounded(pose_1), box_2, rounded(pose_2), holder, state, count);
      const double much = frame % 3 == 2 ? 0.3 : 0.01;
      pose_2.rotation = Eigen::AngleAxisd(much, random.UnitVector()) * pose_2.rotation;
      pose_2.translation += much * random.InCube();
    }
  }
  std::printf("%d near: %d on a face, %d on edges, %d with overlaps to compare; %d separated, %d refused\n", count.near,
              count.on_face, count.on_edges, count.overlaps, count.separated, count.refused);
  EXPECT_GT(count.on_face, 0.2 * count.near);
  EXPECT_GT(count.on_edges, 0.2 * count.near);
  EXPECT_GT(count.on_face + count.on_edges, 0.7 * count.near);
  EXPECT_GT(count.overlaps, 0.8 * (count.on_face + count.on_edges));
  EXPECT_GT(count.separated, 0);
  EXPECT_GT(count.refused, 0);
}

TEST(BoxesApart, RandomBoxes_AsBySearchInDouble) { CompareRandomBoxes<double>(TestCount(20000, 400)); }
TEST(BoxesApart, RandomBoxes_AsBySearchInFloat) { CompareRandomBoxes<float>(TestCount(5000, 200)); }

// What an engine in float calls a rotation is a box with sides that are not quite square.
TEST(BoxesApart, RotationsFromFloat_ProvenOfTheirOwnCorners) {
  Random random(TestSeed());
  int optimal = 0;
  for (int i = 0; i < TestCount(5000, 100); ++i) {
    const RoundedBox<double> box_1{dgd::Box<double>({1, 0.5, 0.25}), 0.04}, box_2{dgd::Box<double>({0.3, 0.6, 0.4}), 0};
    const auto rotation = [&]() -> Eigen::Matrix3d { return random.Rotation().cast<float>().cast<double>(); };
    const dgd::Pose<double> pose_1{rotation(), random.InCube()};
    dgd::Pose<double> pose_2{rotation(), pose_1.translation};
    pose_2.translation += random.Uniform(0.9, 1.5) * random.UnitVector();
    dgd::WarmStart<double> state;
    dgd::FacingFaces<double> facing;
    const auto result =
        dgd::FollowBoxes(box_1, pose_1, box_2, pose_2, {}, kAngularTolerance, FaceHolder::kNone, state, facing);
    if (result.status != Status::kOptimal) continue;
    ++optimal;
    // Of all pairs of corners.
    double above = std::numeric_limits<double>::infinity(), below = -above;
    for (dgd::VertexId corner = 0; corner < 8; ++corner) {
      below = std::max(below, result.normal.dot(pose_1 * box_1.core.Vertex(corner)));
      above = std::min(above, result.normal.dot(pose_2 * box_2.core.Vertex(corner)));
    }
    EXPECT_NEAR(result.separation, above - below - box_1.radius, 1e-14);
    // Neither witness point is beyond its box's plane, nor the two farther apart than the planes.
    EXPECT_NEAR((result.witness_2 - result.witness_1).norm(), std::abs(result.separation), 1e-14);
    EXPECT_NEAR(result.normal.dot(result.witness_1), below + box_1.radius, 1e-14);
  }
  EXPECT_GT(optimal, TestCount(5000, 100) / 4);
}

TEST(BoxesApart, TwoEdges_AreFoundAgainFromWhatIsRemembered) {
  const RoundedBox<double> box{dgd::Box<double>({1, 0.2, 0.2}), 0.05};
  const dgd::Pose<double> pose_1{Eigen::AngleAxisd(0.7, Vector3d::UnitX()).toRotationMatrix(), Vector3d::Zero()};
  dgd::Pose<double> pose_2;
  pose_2.rotation = Eigen::AngleAxisd(1.3, Vector3d::UnitZ()) * pose_1.rotation;
  pose_2.translation = Vector3d(0.1, 0.05, 0.65);
  dgd::WarmStart<double> state;
  dgd::FacingFaces<double> facing;
  const auto result =
      dgd::FollowBoxes(box, pose_1, box, pose_2, {}, kAngularTolerance, FaceHolder::kNone, state, facing);
  ASSERT_EQ(result.status, Status::kOptimal);
  EXPECT_EQ(dgd::HolderOf(facing), FaceHolder::kNone);
  EXPECT_LT((result.normal - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_EQ(state.size, 2);
  // Along x in either box's own frame, and what FollowDistance() begins with.
  EXPECT_EQ(state.features_1[0] ^ state.features_1[1], 1U);
  EXPECT_EQ(state.features_2[0] ^ state.features_2[1], 1U);
  const auto followed = dgd::FollowDistance(box, pose_1, box, pose_2, {}, state);
  EXPECT_EQ(followed.status, Status::kOptimal);
  EXPECT_NEAR(followed.separation, result.separation, 1e-14);
}

// Faces turned away from the normal count as edges, where the caller says so: no overlap then.
TEST(BoxesApart, AngularTolerance_TellsFacesFromEdges) {
  const RoundedBox<double> plate{dgd::Box<double>({2, 2, 0.1}), 0.05}, cube{dgd::Box<double>({0.5, 0.5, 0.5}), 0.05};
  dgd::Pose<double> on_edge;
  on_edge.rotation = Eigen::AngleAxisd(0.5, Vector3d::UnitX()).toRotationMatrix();
  on_edge.translation = Vector3d(0, 0, 0.95);
  for (const double tolerance : {0.4, 0.6}) {
    dgd::WarmStart<double> state;
    dgd::FacingFaces<double> facing;
    const auto result = dgd::FollowBoxes(plate, {}, cube, on_edge, {}, tolerance, FaceHolder::kNone, state, facing);
    EXPECT_EQ(result.status, tolerance > 0.5 ? Status::kOptimal : Status::kStalled);
    EXPECT_EQ(facing.overlap.size, tolerance > 0.5 ? 4 : 0);
  }
}

TEST(BoxesApart, OverlapOrBadInput_IsRefused) {
  const RoundedBox<double> box{dgd::Box<double>({1, 1, 1}), 0.1};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const FaceHolder holder : {FaceHolder::kNone, FaceHolder::kSet1, FaceHolder::kSet2}) {
      dgd::WarmStart<double> state;
      state.normal_1 = Vector3d::UnitZ();
      dgd::FacingFaces<double> facing;
      const auto follow = [&](const dgd::Pose<double>& pose_1, const dgd::Pose<double>& pose_2) {
        return dgd::FollowBoxes(box, pose_1, box, pose_2, {}, kAngularTolerance, holder, state, facing).status;
      };
      dgd::Pose<double> beside, inside, lost, turned;
      beside.translation.z() = 2.1;
      inside.translation.z() = 1.9;
      lost.translation.x() = bad;
      turned.translation.z() = 2.1;
      turned.rotation(1, 2) = bad;
      EXPECT_EQ(follow({}, beside), Status::kOptimal);
      EXPECT_EQ(follow({}, inside), Status::kStalled);
      for (const dgd::Pose<double>& none : {lost, turned}) {
        EXPECT_EQ(follow({}, none), Status::kStalled);
        EXPECT_EQ(follow(none, {}), Status::kStalled);
      }
      EXPECT_EQ(facing.overlap.size, 0);
      EXPECT_EQ(state.normal_1, Vector3d::UnitZ());
    }
  }
}

}  // namespace
}  // namespace dgd_test
