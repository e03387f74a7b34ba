// The signed distance against closed forms: apart, in overlap, and where sets are flat, symmetric, or just touch.
#include "dgd/signed_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "dgd/signed_distance_certificate.h"
#include "support/pairs/any_pair.h"
#include "support/scalars.h"

namespace dgd_test {
namespace {

template <class S>
class SignedDistanceTest : public ::testing::Test {
 protected:
  using Vector = dgd::Vector3<S>;

  static dgd::Pose<S> At(const Vector& translation, const dgd::Matrix3<S>& rotation = dgd::Matrix3<S>::Identity()) {
    return {rotation, translation};
  }
  static dgd::Matrix3<S> Turn(S angle, const Vector& axis) {
    return Eigen::AngleAxis<S>(angle, axis.normalized()).toRotationMatrix();
  }

  /// With set 1 where it is.
  template <class Core1, class Core2>
  static dgd::SignedDistanceResult<S> Ask(const dgd::RoundedSet<Core1>& set_1, const dgd::RoundedSet<Core2>& set_2,
                                          const dgd::Pose<S>& pose_2) {
    const AnyPair<S, 3> pair(Erase(set_1), {}, Erase(set_2), pose_2);
    dgd::WarmStart<S> warm_start;
    const auto from_basis = pair.SignedDistance(pair.GrowthDistance({}, &warm_start), &warm_start);
    const auto from_nothing = pair.SignedDistance({});
    EXPECT_EQ(from_nothing.status, dgd::Status::kOptimal);
    EXPECT_NEAR(from_nothing.separation, from_basis.separation, kTolerance);
    EXPECT_TRUE(pair.Certify(from_basis).Holds(kTolerance, kWitness));
    return from_basis;
  }

  static void ExpectDistance(const dgd::SignedDistanceResult<S>& result, S distance) {
    EXPECT_EQ(result.status, dgd::Status::kOptimal);
    EXPECT_NEAR(result.separation, distance, kTolerance);
    EXPECT_GE(result.upper_bound, distance - kTolerance);
    EXPECT_NEAR((result.witness_2 - result.witness_1 - result.separation * result.normal).norm(), 0, kWitness);
    EXPECT_NEAR(result.normal.norm(), 1, kTolerance);
  }
  static void ExpectNormal(const dgd::SignedDistanceResult<S>& result, const Vector& normal) {
    EXPECT_NEAR((result.normal - normal).norm(), 0, kWitness) << result.normal.transpose();
  }

  /// Of sets up to 5 m.
  static constexpr S kTolerance = sizeof(S) == 8 ? S(2e-8) : S(2e-3);
  /// Points and normals have the root of the tolerance where the sets are curved.
  static constexpr S kWitness = sizeof(S) == 8 ? S(1e-4) : S(2e-2);
  /// Of polytopes.
  static constexpr S kExact = 16 * dgd::kEpsilon<S>;
};

TYPED_TEST_SUITE(SignedDistanceTest, Scalars);

TYPED_TEST(SignedDistanceTest, UnitBoxesOverlappingByATenth_AreATenthDeepAlongTheirAxis) {
  using S = TypeParam;
  const dgd::RoundedSet box{dgd::Box<S>({S(0.5), S(0.5), S(0.5)})};
  for (int axis = 0; axis < 3; ++axis) {
    for (const S side : {S(1), S(-1)}) {
      // Off the axis by a lot: the growth distance's normal still is a face's, or none of them.
      dgd::Vector3<S> offset(S(0.3), S(0.4), S(0.2));
      offset[axis] = side * S(0.9);
      const auto result = this->Ask(box, box, this->At(offset));
      this->ExpectDistance(result, S(-0.1));
      EXPECT_NEAR(result.separation, S(-0.1), this->kExact);
      this->ExpectNormal(result, side * dgd::Vector3<S>::Unit(axis));
    }
  }
}

TYPED_TEST(SignedDistanceTest, CoincidentBoxes_AreAsDeepAsTheShortestSide) {
  using S = TypeParam;
  const dgd::RoundedSet box{dgd::Box<S>({S(0.5), S(0.2), S(0.7)})};
  const auto result = this->Ask(box, box, this->At({0, 0, 0}));
  this->ExpectDistance(result, S(-0.4));
  EXPECT_NEAR(std::abs(result.normal.y()), 1, this->kExact);
}

TYPED_TEST(SignedDistanceTest, BoxDeepInAnother_LeavesThroughTheNearestFaceWhateverTheCentresSay) {
  using S = TypeParam;
  const dgd::RoundedSet plate{dgd::Box<S>({4, 4, S(0.1)})};
  const dgd::RoundedSet box{dgd::Box<S>({S(0.5), S(0.5), S(0.5)}), S(0.05)};
  // The growth distance's ray runs along the plate.
  const auto result = this->Ask(plate, box, this->At({3, 2, S(0.3)}));
  this->ExpectDistance(result, S(-0.1 - 0.55 + 0.3));
  this->ExpectNormal(result, dgd::Vector3<S>::UnitZ());
}

TYPED_TEST(SignedDistanceTest, BoxesEdgeOverEdge_AreSeparatedAlongTheirCommonNormal) {
  using S = TypeParam;
  const auto box = Erase(dgd::RoundedSet{dgd::Box<S>({S(0.5), S(0.5), S(0.5)})});
  // Both stand on an edge, the edges across each other: their tops are half a diagonal from the centres.
  const S half_diagonal = std::sqrt(S(0.5));
  const dgd::Matrix3<S> on_edge = this->Turn(std::numbers::pi_v<S> / 4, dgd::Vector3<S>::UnitX());
  const dgd::Matrix3<S> across = this->Turn(std::numbers::pi_v<S> / 2, dgd::Vector3<S>::UnitZ()) * on_edge;
  for (const S gap : {S(0.3), S(0.001), S(0), S(-0.001), S(-0.1)}) {
    const dgd::Pose<S> pose_1 = this->At({0, 0, 0}, on_edge);
    const dgd::Pose<S> pose_2 = this->At({S(0.1), S(-0.2), 2 * half_diagonal + gap}, across);
    const AnyPair<S, 3> pair(box, pose_1, box, pose_2);
    const auto result = pair.SignedDistance(pair.GrowthDistance());
    this->ExpectDistance(result, gap);
    EXPECT_NEAR(result.separation, gap, 4 * this->kExact);
    if (gap != 0) this->ExpectNormal(result, dgd::Vector3<S>::UnitZ());
  }
}

TYPED_TEST(SignedDistanceTest, Spheres_AreAsFarAsTheirCentresLessTheRadii) {
  using S = TypeParam;
  const dgd::RoundedSet a{dgd::Point<S>(), S(0.5)}, b{dgd::Point<S>(), S(0.25)};
  const dgd::Vector3<S> direction = dgd::Vector3<S>(1, -2, 2) / 3;
  for (const S distance : {S(5), S(0.75), S(0.3), S(1e-3)}) {
    const auto result = this->Ask(a, b, this->At(distance * direction));
    this->ExpectDistance(result, distance - S(0.75));
    this->ExpectNormal(result, direction);
  }
  this->ExpectDistance(this->Ask(a, b, this->At({0, 0, 0})), S(-0.75));
}

TYPED_TEST(SignedDistanceTest, CrossingCapsules_PartAcrossBothAxes) {
  using S = TypeParam;
  const dgd::RoundedSet capsule = dgd::Capsule(S(0.1), S(0.5));
  const dgd::Matrix3<S> across = this->Turn(std::numbers::pi_v<S> / 2, dgd::Vector3<S>::UnitX());
  for (const S offset : {S(0.5), S(0.05), S(0)}) {
    const auto result = this->Ask(capsule, capsule, this->At({offset, S(0.1), S(0.2)}, across));
    this->ExpectDistance(result, offset - S(0.2));
    EXPECT_NEAR(std::abs(result.normal.x()), 1, this->kTolerance);
  }
  // Parallel: the axes overlap, any normal across them will do.
  this->ExpectDistance(this->Ask(capsule, capsule, this->At({0, 0, S(0.3)})), S(-0.2));
}

TYPED_TEST(SignedDistanceTest, FlatSetsWithoutInterior_HaveADistance) {
  using S = TypeParam;
  const auto triangle = Erase(dgd::RoundedSet{dgd::Triangle<S>({0, 0, 0}, {1, 0, 0}, {0, 1, 0})});
  this->ExpectDistance(AnyPair<S, 3>(triangle, {}, triangle, this->At({S(0.2), S(0.1), S(0.5)})).SignedDistance({}),
                       S(0.5));
  // In one plane, overlapping: nothing to move apart.
  this->ExpectDistance(AnyPair<S, 3>(triangle, {}, triangle, this->At({S(0.2), S(0.1), 0})).SignedDistance({}), 0);
}

// Squares of a core's tiny lengths are no numbers: fuzz_solver found a normal 3e-25 long.
TYPED_TEST(SignedDistanceTest, CoresThatAreTiny_HaveAUnitNormal) {
  using S = TypeParam;
  const S tiny = S(4e-13);
  const dgd::Triangle<S> triangle(dgd::Vector3<S>(tiny, 0, 0), dgd::Vector3<S>(0, tiny, 0),
                                  dgd::Vector3<S>(-tiny, -tiny, 0));
  const auto grain = Erase(dgd::RoundedSet{dgd::Point<S>()});
  for (const S radius : {S(2847.85), S(1), S(1e-3), S(1e-5)}) {
    const auto check = [&](const auto& core) {
      const AnyPair<S, 3> pair(Erase(dgd::RoundedSet{core, radius}), {}, grain, {});
      const auto result = pair.SignedDistance(pair.GrowthDistance());
      EXPECT_NE(result.status, dgd::Status::kInvalidInput);
      EXPECT_NEAR(result.normal.norm(), 1, 4 * dgd::kEpsilon<S>);
      EXPECT_NEAR(result.separation / radius, -1, 1e-6);
    };
    check(triangle);
    check(dgd::Cone<S>(tiny, tiny));
    check(dgd::Box<S>(dgd::Vector3<S>(tiny, tiny, tiny)));
  }
}

// Roundoff tears the expanding polytope's surface, whose edges are then more than its faces can have.
TEST(SignedDistance, ThinPlateInABoxAMillionTimesAsLarge_KeepsTheBounds) {
  using Vector3 = Eigen::Vector3d;
  const Vector3 half_of_box(0x1.28096b1771d83p+9, 0x1.5419fa658014bp+7, 0x1.511b6acb64ed9p+9);
  const Vector3 half_of_plate(0x1.7d5a64daff08cp-14, 0x1.93906aa685725p-1, 0x1.3d03bfc68d7ebp-2);
  const dgd::RoundedSet box{dgd::Box<double>(half_of_box)};
  const dgd::RoundedSet plate{dgd::Box<double>(half_of_plate), 0x1.f353341b3d49fp-24};
  dgd::Pose<double> pose_1, pose_2;
  pose_1.rotation << 0x1.b3b6129658368p-2, 0x1.c53ab6551332p-1, -0x1.810ace6c7fa36p-3, 0x1.462168ca2a7f8p-4,
      -0x1.f2d418f02b2dp-3, -0x1.eee77e7ed5b5ap-1, -0x1.cd8ac223346b8p-1, 0x1.95d57c23364ap-2, -0x1.649945ea53c5p-3;
  pose_2.rotation << 0x1.dd9c5e7ca9bacp-2, -0x1.7807a921a4c62p-1, -0x1.f8d8ade8ac91cp-2, 0x1.188d6c70a6552p-1,
      0x1.5ad78e9f9628cp-1, -0x1.f6888a1e86994p-2, 0x1.638961b90e64ep-1, -0x1.51f0d18b8d77cp-5, 0x1.6fd1ee466795p-1;
  pose_2.translation = Vector3(-0x1.81ea049292fbfp+6, 0x1.2574fe44a7d16p+6, -0x1.97cbbe194fc7ap+3);
  const auto result = dgd::SignedDistance(box, pose_1, plate, pose_2);
  EXPECT_LT(result.separation, 0);
  EXPECT_NEAR(result.separation, result.upper_bound, 1e-4);
}

TYPED_TEST(SignedDistanceTest, SphereInEllipsoid_LeavesAlongTheShortAxis) {
  using S = TypeParam;
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<S>({2, 1, S(0.5)})};
  const dgd::RoundedSet sphere{dgd::Point<S>(), S(0.1)};
  const auto result = this->Ask(ellipsoid, sphere, this->At({S(0.4), S(0.1), S(0.01)}));
  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  // Nearly above its centre the nearest point of the surface is nearly along the short axis.
  EXPECT_GT(result.normal.z(), S(0.95));
  EXPECT_NEAR(result.separation, S(-0.58), S(0.02));
}

TYPED_TEST(SignedDistanceTest, CylinderOnItsCapAndOnItsSide_IsAsDeepAsItSank) {
  using S = TypeParam;
  const dgd::RoundedSet floor{dgd::Box<S>({5, 5, 1})};
  const dgd::RoundedSet cylinder{dgd::Cylinder<S>(S(0.5), S(0.4))};
  const auto on_cap = this->Ask(floor, cylinder, this->At({2, 1, S(1.35)}));
  this->ExpectDistance(on_cap, S(-0.05));
  this->ExpectNormal(on_cap, dgd::Vector3<S>::UnitZ());
  const dgd::Matrix3<S> lying = this->Turn(std::numbers::pi_v<S> / 2, {1, 2, 0});
  const auto on_side = this->Ask(floor, cylinder, this->At({2, 1, S(1.45)}, lying));
  this->ExpectDistance(on_side, S(-0.05));
  this->ExpectNormal(on_side, dgd::Vector3<S>::UnitZ());
}

// All around the axis the normals are alike, or nearly so: an inner approximation has no room for as many points as it
// takes to tell which is the best.
TYPED_TEST(SignedDistanceTest, RoundInAConeNearItsAxis_LeavesThroughItsSide) {
  using S = TypeParam;
  const S radius = S(0.9), height = S(1.7), slant = std::hypot(radius, height);
  const dgd::RoundedSet cone{dgd::Cone<S>(radius, height), S(0)};
  for (const S aside : {S(0), S(1e-6), S(1e-4), S(1e-3), S(1e-2)}) {
    for (const S up : {S(-0.05), S(0.2), S(0.6)}) {
      SCOPED_TRACE(testing::Message() << aside << " m aside, " << up << " m up");
      const S to_side = (radius * (height / 2 - up) - height * aside) / slant;
      const dgd::Vector3<S> center(aside * S(0.6), aside * S(0.8), up);
      this->ExpectDistance(this->Ask(cone, dgd::Sphere(S(0.25)), this->At(center)), -to_side - S(0.25));
    }
  }
}

TYPED_TEST(SignedDistanceTest, NanPose_IsInvalid) {
  using S = TypeParam;
  const auto box = Erase(dgd::RoundedSet{dgd::Box<S>({1, 1, 1})});
  const auto pose = this->At({std::numeric_limits<S>::quiet_NaN(), 0, 0});
  EXPECT_EQ((AnyPair<S, 3>(box, {}, box, pose).SignedDistance({}).status), dgd::Status::kInvalidInput);
}

}  // namespace
}  // namespace dgd_test
