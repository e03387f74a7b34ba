// The contract of a contact, for every ordered pair of convex types and from deeply overlapping to just apart:
//  * the normal is a unit vector from B to A: moving A along it parts the two;
//  * the point is on B's surface, and the point that Bullet derives from it, point + depth * normal, on A's;
//  * the depth is a signed distance, margins included: that of the deepest point is the distance of the two supporting
//    planes along the normal, and no point claims more overlap;
//  * its sign is that of the exact signed distance.
// "Exact" is Bullet's own geometry, core plus margin, through Bullet's own support functions, and boxes as good as
// sharp (bullet_oracle.h).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr double kSize = 1;  // Metres, of every shape of the zoo.

/// Rounding of Bullet's scalar, for lengths of a few metres: the poses and the points come in it.
constexpr double kRounding = 32 * double(std::numeric_limits<btScalar>::epsilon());
/// What the solver leaves on curved shapes: its relative tolerance times their size, and the same of the squared angle
/// that a flat optimum leaves to the normal.
constexpr double kSurface = 1e-7 + kRounding;
/// The patch drops the witness for a corner that is as deep within this part of the contact distance, at most 2 cm
/// here (contact_patch.h).
constexpr double kAsDeep = 1e-3 * 0.02;
/// Part of a depth by which a point may be off a surface, in the worst case: bodies deep inside each other.
constexpr double kBeside = 1;

/// Where the two bodies stand.
enum class Nearness { kApart, kTouching, kShallow, kDeep };
constexpr Nearness kNearnesses[] = {Nearness::kApart, Nearness::kTouching, Nearness::kShallow, Nearness::kDeep};

/// The signed distance wanted, metres.
double Gap(Random& random, Nearness nearness, double margins) {
  switch (nearness) {
    case Nearness::kApart:
      return kSize * random.Uniform(1e-4, 5e-3);
    case Nearness::kTouching:
      return 0;
    case Nearness::kShallow:
      return -std::min(margins / 2, kSize * random.Uniform(1e-4, 5e-3));
    default:
      return -margins - kSize * random.Uniform(0.01, 0.1);
  }
}

/// Puts both bodies anywhere, then B along the shortest way to where the signed distance is as wanted.
void Place(Random& random, Nearness nearness, PairQuery& pair) {
  const btTransform pose_a = MakeTransform(random.Rotation(), kSize * random.InCube());
  const Eigen::Matrix3d rotation_b = random.Rotation();
  Vector position_b = ToEigen(pose_a.getOrigin()) + 5 * kSize * random.UnitVector();
  pair.SetPoses(pose_a, MakeTransform(rotation_b, position_b));
  const SignedDistance far = DistanceOfShapes(pair.A(), pair.B());
  const double gap = Gap(random, nearness, pair.A().Margin() + pair.B().Margin());
  position_b += (far.value - gap) * far.normal_b_to_a;
  pair.SetPoses(pose_a, MakeTransform(rotation_b, position_b));
}

std::string Describe(const btTransform& pose) {
  std::ostringstream text;
  text.precision(17);
  for (int row = 0; row < 3; ++row) {
    const btVector3& axis = pose.getBasis()[row];
    text << axis.x() << ", " << axis.y() << ", " << axis.z() << ",  ";
  }
  text << "at " << pose.getOrigin().x() << ", " << pose.getOrigin().y() << ", " << pose.getOrigin().z();
  return text.str();
}

/// One step of one pair, and what its contacts are judged by.
struct SteppedPair {
  PosedConvex a, b;
  std::vector<Contact> contacts;
  SignedDistance exact;
};

// The rules of the contract, each for one step. Those about the deepest contact need one.

void ExpectAContactWhereBodiesTouch(const SteppedPair& pair) {
  if (pair.exact.value <= kSurface) {
    EXPECT_FALSE(pair.contacts.empty());
  }
}

void ExpectOneUnitNormalForAllPoints(const SteppedPair& pair) {
  for (const Contact& contact : pair.contacts) {
    ASSERT_TRUE(contact.normal_b_to_a.allFinite());
    EXPECT_NEAR(contact.normal_b_to_a.norm(), 1, kRounding);
    EXPECT_EQ(contact.normal_b_to_a, pair.contacts[0].normal_b_to_a);
  }
}

void ExpectThatMovingAAlongTheNormalByTheOverlapPartsTheBodies(const SteppedPair& pair) {
  constexpr double kClear = 0.01;
  const Contact& deepest = Deepest(pair.contacts);
  btTransform moved = pair.a.pose;
  moved.setOrigin(moved.getOrigin() + ToBullet((kClear - deepest.depth) * deepest.normal_b_to_a));
  EXPECT_GE(DistanceOfShapes({pair.a.shape, moved}, pair.b).value, kClear - kAsDeep - kSurface);
}

void ExpectDepthOfTheSupportingPlanes(const SteppedPair& pair) {
  const Contact& deepest = Deepest(pair.contacts);
  const double separation = PlaneSeparation(pair.a, pair.b, deepest.normal_b_to_a);
  EXPECT_NEAR(deepest.depth, separation, kAsDeep + kSurface);
  EXPECT_GE(deepest.depth, separation - kSurface) << "claims more overlap than there is";
}

void ExpectDepthOfTheSignOfTheExactDistance(const SteppedPair& pair) {
  const double depth = Deepest(pair.contacts).depth;
  // No direction parts the shapes by more than their distance.
  EXPECT_LE(depth, pair.exact.upper + kAsDeep + kSurface);
  if (pair.exact.value > kAsDeep + kSurface) {
    EXPECT_GT(depth, -kSurface);
  }
}

void ExpectDeepestPointOnTheSupportingPlaneOfB(const SteppedPair& pair) {
  const Contact& deepest = Deepest(pair.contacts);
  EXPECT_NEAR(deepest.normal_b_to_a.dot(deepest.on_b), pair.b.SupportValue(deepest.normal_b_to_a),
              kAsDeep + 2 * kSurface);
}

// Or beside it by what the growth distance's normal, off the touching pose, is turned from the exact one: a point half
// way between two surfaces that are apart is then beside a round one.
void ExpectEveryPointOnB(const SteppedPair& pair) {
  for (const Contact& contact : pair.contacts) {
    EXPECT_LE(Outside(pair.b, contact.on_b), kBeside * std::abs(contact.depth) + 4 * kSurface);
  }
}

// Where the bodies touch, the growth distance's normal is the contact normal, exactly.
void ExpectExactNormalAndDepthWhereBodiesTouch(const SteppedPair& pair) {
  if (std::abs(pair.exact.value) > kSurface) return;
  const Contact& deepest = Deepest(pair.contacts);
  EXPECT_NEAR(deepest.depth, pair.exact.value, kAsDeep + kSurface);
  // Sharp corners and edges have many normals, and rounding of the pose chooses among them.
  const double margins = pair.a.Margin() + pair.b.Margin();
  if (margins < 0.02 * kSize) return;
  EXPECT_LE((deepest.normal_b_to_a - pair.exact.normal_b_to_a).norm(), std::sqrt(kSurface / margins));
  EXPECT_LE(std::abs(Outside(pair.a, deepest.OnA())), kAsDeep + 4 * kSurface);
  EXPECT_LE(std::abs(Outside(pair.b, deepest.on_b)), kAsDeep + 4 * kSurface);
}

void ExpectEveryRule(const SteppedPair& pair) {
  ExpectAContactWhereBodiesTouch(pair);
  ExpectOneUnitNormalForAllPoints(pair);
  if (pair.contacts.empty()) return;
  ExpectThatMovingAAlongTheNormalByTheOverlapPartsTheBodies(pair);
  ExpectDepthOfTheSupportingPlanes(pair);
  ExpectDepthOfTheSignOfTheExactDistance(pair);
  ExpectDeepestPointOnTheSupportingPlaneOfB(pair);
  ExpectEveryPointOnB(pair);
  ExpectExactNormalAndDepthWhereBodiesTouch(pair);
}

/// Shape A by its place in the zoo, and the route to the narrowphase.
class ContactContract : public testing::TestWithParam<std::tuple<int, Route>> {
 protected:
  static constexpr int kPosesPerPair = 4;

  Dispatching dispatching_{std::get<1>(GetParam())};
};

// Shape A against every shape, at every nearness: each pair is placed and stepped once for all rules, since placing it
// takes the oracle longer than the step. Stops at the first pair that breaks one.
TEST_P(ContactContract, PairWithEveryShape_KeepsEveryRule) {
  std::vector<ZooShape> zoo_a = MakeShapeZoo(kSize), zoo_b = MakeShapeZoo(kSize);
  const ZooShape& a = zoo_a[static_cast<std::size_t>(std::get<0>(GetParam()))];
  for (const ZooShape& b : zoo_b) {
    for (const Nearness nearness : kNearnesses) {
      Random random(TestSeed());
      for (int i = 0; i < kPosesPerPair; ++i) {
        PairQuery pair(dispatching_.dispatcher(), *a.shape, *b.shape);
        Place(random, nearness, pair);
        const std::vector<Contact> contacts = pair.Step();
        SCOPED_TRACE(a.name + " on " + b.name + ", pose " + std::to_string(i) + " of nearness " +
                     std::to_string(static_cast<int>(nearness)) + "\n  A " +
                     Describe(pair.body_a().getWorldTransform()) + "\n  B " +
                     Describe(pair.body_b().getWorldTransform()));
        ExpectEveryRule({pair.A(), pair.B(), contacts, DistanceOfShapes(pair.A(), pair.B())});
        // Pairs that have an interior never need Bullet's GJK/EPA.
        EXPECT_EQ(dispatching_.statistics().Fallbacks(), 0U);
        if (HasFailure()) return;
      }
    }
  }
}

std::string NameOfCase(const testing::TestParamInfo<std::tuple<int, Route>>& info) {
  return ShapeZooNames()[static_cast<std::size_t>(std::get<0>(info.param))] + "_" + Name(std::get<1>(info.param));
}
INSTANTIATE_TEST_SUITE_P(AllTypes, ContactContract,
                         testing::Combine(testing::Range(0, static_cast<int>(ShapeZooNames().size())),
                                          testing::Values(Route::kConfiguration, Route::kRegister)),
                         NameOfCase);

// The answers that can be written down.

class ClosedForm : public testing::Test {
 protected:
  /// One contact of two shapes, with its depth, normal and point on B as they must be.
  void ExpectContact(btConvexShape& a, const Vector& position_a, btConvexShape& b, double depth, const Vector& normal,
                     const Vector& on_b, const Eigen::Matrix3d& rotation_a = Eigen::Matrix3d::Identity()) {
    // The whole scene is turned and moved as well: nothing may depend on the axes.
    Random random(TestSeed());
    for (int i = 0; i < 20; ++i) {
      const Eigen::Matrix3d turn = i == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random.Rotation();
      const Vector shift = i == 0 ? Vector(0, 0, 0) : random.InCube();
      PairQuery pair(dispatching_.dispatcher(), a, b);
      pair.SetPoses(MakeTransform(turn * rotation_a, turn * position_a + shift), MakeTransform(turn, shift));
      const std::vector<Contact> contacts = pair.Step();
      ASSERT_FALSE(contacts.empty());
      const Contact& deepest = Deepest(contacts);
      EXPECT_NEAR(deepest.depth, depth, kAsDeep + kSurface);
      // Exact where the bodies touch, and turned by about the depth (over a length of a metre) elsewhere.
      EXPECT_LE((deepest.normal_b_to_a - turn * normal).norm(), std::sqrt(kSurface) + std::abs(depth));
      EXPECT_LE((deepest.on_b - (turn * on_b + shift)).norm(), 1e-3);
    }
  }

  Dispatching dispatching_{Route::kConfiguration};
  btSphereShape sphere_{btScalar(0.5)}, ball_{btScalar(0.25)};
  btBoxShape box_{Vec(0.5, 0.4, 0.3)};
  btCapsuleShapeX capsule_{btScalar(0.2), btScalar(1)};
};

TEST_F(ClosedForm, SphereOnSphere) {
  const Vector direction = Vector(1, -2, 2) / 3;
  for (const double depth : {-0.7, -0.3, -0.01, 0.0, 0.004}) {
    ExpectContact(ball_, (0.75 + depth) * direction, sphere_, depth, direction, 0.5 * direction);
  }
}

TEST_F(ClosedForm, SphereOnBoxFace) {
  for (const double depth : {-0.1, -0.01, 0.0, 0.004}) {
    ExpectContact(ball_, {0.2, -0.1, 0.55 + depth}, box_, depth, Vector::UnitZ(), {0.2, -0.1, 0.3});
  }
}

TEST_F(ClosedForm, SphereOnBoxEdgeAndCorner) {
  const Vector core(0.5, 0.4, 0.3);
  const Vector edge_normal = Vector(1, 0, 1).normalized(), corner_normal = Vector(1, 2, 2).normalized();
  for (const double depth : {-0.002, 0.0, 0.004}) {
    const Vector edge(core.x(), 0.1, core.z());
    ExpectContact(ball_, edge + (0.25 + depth) * edge_normal, box_, depth, edge_normal, edge);
    ExpectContact(ball_, core + (0.25 + depth) * corner_normal, box_, depth, corner_normal, core);
  }
}

TEST_F(ClosedForm, SphereOnCapsule) {
  const Vector side = Vector(0, 3, 4) / 5, end = Vector(2, 1, 2) / 3;
  for (const double depth : {-0.002, 0.0, 0.004}) {
    ExpectContact(ball_, Vector(0.3, 0, 0) + (0.45 + depth) * side, capsule_, depth, side,
                  Vector(0.3, 0, 0) + 0.2 * side);
    ExpectContact(ball_, Vector(0.5, 0, 0) + (0.45 + depth) * end, capsule_, depth, end, Vector(0.5, 0, 0) + 0.2 * end);
  }
}

TEST_F(ClosedForm, CapsulesCrossing) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vector::UnitZ()).toRotationMatrix();
  for (const double depth : {-0.002, 0.0, 0.004}) {
    ExpectContact(capsule_, {0, 0, 0.4 + depth}, capsule_, depth, Vector::UnitZ(), {0, 0, 0.2}, turn);
  }
}

TEST_F(ClosedForm, BoxCornerOnBoxFace) {
  const Vector down = Vector(1, 2, 2) / 3;  // Of the tilted box, in its own frame, towards its corner (+, +, +).
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(std::acos(-down.z()), down.cross(-Vector::UnitZ()).normalized()).toRotationMatrix();
  const Vector corner(0.5, 0.4, 0.3);
  for (const double depth : {-0.001, 0.0, 0.004}) {
    const Vector corner_in_world(0.1, 0.05, 0.3 + depth);
    btBoxShape cube(Vec(0.5, 0.4, 0.3));
    ExpectContact(cube, corner_in_world - tilt * corner, box_, depth, Vector::UnitZ(), {0.1, 0.05, 0.3}, tilt);
  }
}

// A sphere's deepest point lies on the line through its centre along the normal: elsewhere, the contact would spin it
// and stop only a part of its motion.
TEST_F(ClosedForm, SphereOnAnything_ContactIsOnTheLineThroughItsCentre) {
  Random random(TestSeed());
  for (const ZooShape& shape : MakeShapeZoo(kSize)) {
    for (const Nearness nearness : kNearnesses) {
      SCOPED_TRACE(shape.name + ", nearness " + std::to_string(static_cast<int>(nearness)));
      for (int i = 0; i < 10; ++i) {
        PairQuery first(dispatching_.dispatcher(), ball_, *shape.shape);
        Place(random, nearness, first);
        PairQuery last(dispatching_.dispatcher(), *shape.shape, ball_);
        last.SetPoses(first.body_b().getWorldTransform(), first.body_a().getWorldTransform());
        const Vector center = ToEigen(first.body_a().getWorldTransform().getOrigin());
        for (PairQuery* pair : {&first, &last}) {
          const std::vector<Contact> contacts = pair->Step();
          if (contacts.empty()) continue;
          const Contact& deepest = Deepest(contacts);
          EXPECT_LE((deepest.on_b - center).cross(deepest.normal_b_to_a).norm(), 1e-4);
        }
        if (HasFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace dgd_test
