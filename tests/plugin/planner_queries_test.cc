// Closest points through a result of the app's own, as motion planners query them (MoveIt, Tesseract): of shapes that
// only their support function knows, such as a link swept from one pose to another. They count the points, and read
// times of collision from the places.
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/swept_shape.h"
#include "plugin/test_world.h"
#include "plugin/truncated_pyramid.h"

namespace dgd_test {
namespace {

/// Metres: what places of shapes of half a metre are off by, of curved ones in float.
constexpr double kPlace = 2e-5;

template <class Shape>
std::shared_ptr<Shape> WithoutMargin(std::shared_ptr<Shape> shape) {
  shape->setMargin(0);
  return shape;
}

/// A random pose whose origin is up to `reach` from the world's along each axis.
btTransform RandomPose(Random& random, double reach) {
  return MakeTransform(random.Rotation(), reach * random.InCube());
}

/// Shapes that show nothing but their support function; new ones with each call.
std::vector<ZooShape> MakeSupportShapes(Random& random) {
  const auto box = WithoutMargin(std::make_shared<btBoxShape>(Vec(0.12, 0.15, 0.2)));
  const auto cylinder = WithoutMargin(std::make_shared<btCylinderShape>(Vec(0.2, 0.25, 0.2)));
  const auto hull = WithoutMargin(MakeRandomHull(random, 20, 0.5));
  const auto ball = std::make_shared<btSphereShape>(btScalar(0.2));
  const btTransform way = RandomPose(random, 0.6);
  const btVector3 centers[] = {Vec(-0.2, 0, 0), Vec(0.2, 0, 0), Vec(0, 0.3, 0)};
  const btScalar radii[] = {btScalar(0.1), btScalar(0.05), btScalar(0.15)};
  std::vector<ZooShape> shapes;
  const auto add = [&](const std::string& name, const auto& kept, auto shape, bool is_smooth) {
    shapes.push_back({name, {kept}, std::move(shape), is_smooth});
  };
  add("swept box", box, std::make_shared<SweptShape>(*box, way), false);
  add("swept cylinder", cylinder, std::make_shared<SweptShape>(*cylinder, way), true);
  add("swept hull", hull, std::make_shared<SweptShape>(*hull, way), false);
  add("swept ball", ball, std::make_shared<SweptShape>(*ball, way), true);
  add("box by its support function", box, std::make_shared<SweptShape>(*box, At(0, 0, 0)), false);
  add("scaled box", box, std::make_shared<btUniformScalingShape>(box.get(), btScalar(0.7)), false);
  add("scaled cylinder", cylinder, std::make_shared<btUniformScalingShape>(cylinder.get(), btScalar(0.7)), true);
  add("unequal spheres", nullptr, std::make_shared<btMultiSphereShape>(centers, radii, 3), true);
  add("truncated pyramid", nullptr, std::make_shared<TruncatedPyramid>(Vec(0.3, 0.2, 0.15), 0.02), false);
  add("ellipsoid", nullptr, std::make_shared<Ellipsoid>(Vec(0.3, 0.2, 0.1)), true);
  return shapes;
}

/// How far shapes are apart.
enum class Placement { kApart, kTouching, kOverlapping, kDeep };

/// Moves B along the line of the least translation until the shapes are as far apart as they are to be.
void Place(Placement placement, Random& random, PairQuery& pair) {
  btTransform pose_b = RandomPose(random, placement == Placement::kDeep ? 0.1 : 0.7);
  pair.SetPoses(RandomPose(random, 0.1), pose_b);
  if (placement == Placement::kDeep) return;
  const double wanted = placement == Placement::kApart      ? random.Uniform(0, 0.1)
                        : placement == Placement::kTouching ? random.Uniform(-1e-6, 1e-6)
                                                            : -random.Uniform(0, 0.05);
  for (int i = 0; i < 3; ++i) {
    const SignedDistance distance = DistanceOfShapes(pair.A(), pair.B());
    pose_b.setOrigin(pose_b.getOrigin() - ToBullet((wanted - distance.value) * distance.normal_b_to_a));
    pair.SetPoses(btTransform(pair.body_a().getWorldTransform()), pose_b);
  }
}

/// The places are on the shapes, as far apart along the normal as the contact says, and that is as far as the shapes
/// are.
void ExpectNearestPoints(const PairQuery& pair, const Contact& contact) {
  const PosedConvex a = pair.A(), b = pair.B();
  EXPECT_NEAR(Outside(a, contact.OnA()), 0, kPlace);
  EXPECT_NEAR(Outside(b, contact.on_b), 0, kPlace);
  EXPECT_NEAR(contact.normal_b_to_a.dot(contact.on_b), b.SupportValue(contact.normal_b_to_a), kPlace);
  EXPECT_NEAR(-contact.normal_b_to_a.dot(contact.OnA()), a.SupportValue(-contact.normal_b_to_a), kPlace);
  // Of several normals along which curved shapes overlap about as deep, a search may end at one that is not the least.
  const double distance = DistanceOfShapes(a, b).value;
  EXPECT_NEAR(contact.depth, distance, kPlace + (distance < 0 ? -0.01 * distance : 0));
}

TEST(PlannerQueries, PlacesOfSupportShapes_AreOnBothSurfaces) {
  Dispatching dispatching(Route::kRegister);
  Random random(TestSeed());
  const auto box = WithoutMargin(std::make_shared<btBoxShape>(Vec(0.5, 0.4, 0.3)));
  const auto hull = MakeRandomHull(random, 30, 0.8);
  btSphereShape ball(btScalar(0.3));
  SweptShape swept(*box, At(0.4, 0.2, 0));
  for (int round = 0; round < 3; ++round) {
    for (const ZooShape& shape : MakeSupportShapes(random)) {
      for (btConvexShape* other : {static_cast<btConvexShape*>(box.get()), static_cast<btConvexShape*>(hull.get()),
                                   static_cast<btConvexShape*>(&ball), static_cast<btConvexShape*>(&swept)}) {
        for (const Placement placement :
             {Placement::kApart, Placement::kTouching, Placement::kOverlapping, Placement::kDeep}) {
          SCOPED_TRACE(shape.name + " and " + other->getName() + ", placement " + std::to_string(int(placement)));
          PairQuery pair(dispatching.dispatcher(), *other, *shape.shape);
          Place(placement, random, pair);
          const std::vector<Contact> contacts = pair.ClosestPoints(0.2);
          ASSERT_EQ(contacts.size(), 1U);
          ExpectNearestPoints(pair, contacts[0]);
        }
      }
    }
  }
  EXPECT_EQ(dispatching.statistics().Fallbacks(), 0U);
}

// An app counts contacts: one of each pair, however much of their faces meets.
TEST(PlannerQueries, PointsOfAPair_AreAsManyAsWithBulletsOwn) {
  Dispatching ours(Route::kRegister), theirs(Route::kBuiltin);
  btBoxShape floor(Vec(2, 2, 0.5));
  for (const ZooShape& shape : MakeShapeZoo(1)) {
    const double touching = 0.5 + double(shape.shape->localGetSupportingVertex(Vec(0, 0, 1)).z());
    for (const double gap : {-0.01, 0.05}) {
      SCOPED_TRACE(shape.name + ", gap " + std::to_string(gap));
      for (Dispatching* dispatching : {&ours, &theirs}) {
        PairQuery pair(dispatching->dispatcher(), *shape.shape, floor);
        pair.SetPoses(At(0, 0, 0), At(0, 0, touching + gap));
        EXPECT_EQ(pair.ClosestPoints(0.1).size(), 1U);
      }
    }
  }
}

// An app asks for more by Bullet's own features of polyhedra.
TEST(PlannerQueries, PolyhedraWithFeatures_HaveAPatch) {
  Dispatching dispatching(Route::kRegister);
  btBoxShape floor(Vec(2, 2, 0.5)), brick(Vec(0.2, 0.2, 0.1));
  PairQuery pair(dispatching.dispatcher(), brick, floor);
  pair.SetPoses(At(0, 0, 0.599), At(0, 0, 0));
  EXPECT_EQ(pair.ClosestPoints(0.1).size(), 1U);
  brick.initializePolyhedralFeatures();
  floor.initializePolyhedralFeatures();
  EXPECT_EQ(pair.ClosestPoints(0.1).size(), 4U);
}

/// Evaluations of the support function by random queries.
/// @param moved  By how many small moves the pair goes on after its first query.
int CountEvaluations(Dispatching& dispatching, const btConvexShape& shape, int moved) {
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  box.setMargin(0);
  Random random(TestSeed());
  int evaluations = 0;
  for (int i = 0; i < 200; ++i) {
    SweptShape swept(shape, RandomPose(random, 1));
    const btTransform pose = RandomPose(random, 1.2);
    btCollisionObject a, b;
    a.setCollisionShape(&box);
    b.setCollisionShape(&swept);
    const btCollisionObjectWrapper wrapped_a(nullptr, &box, &a, a.getWorldTransform(), -1, -1);
    b.setWorldTransform(pose);
    const btCollisionObjectWrapper wrapped_b(nullptr, &swept, &b, b.getWorldTransform(), -1, -1);
    struct Result : btManifoldResult {
      using btManifoldResult::btManifoldResult;
      void addContactPoint(const btVector3&, const btVector3&, btScalar) override {}
    };
    btCollisionAlgorithm* algorithm =
        dispatching.dispatcher().findAlgorithm(&wrapped_a, &wrapped_b, nullptr, BT_CLOSEST_POINT_ALGORITHMS);
    int before = swept.Evaluations();
    for (int move = 0; move <= moved; ++move) {
      if (move == 1) before = swept.Evaluations();
      b.setWorldTransform(
          MakeTransform(Eigen::AngleAxisd(0.01 * move, Vector::UnitY()).toRotationMatrix(), {0.005 * move, 0, 0}) *
          pose);
      Result result(&wrapped_a, &wrapped_b);
      result.m_closestPointDistanceThreshold = btScalar(0.1);
      algorithm->processCollision(&wrapped_a, &wrapped_b, btDispatcherInfo(), &result);
    }
    evaluations += swept.Evaluations() - before;
    algorithm->~btCollisionAlgorithm();
    dispatching.dispatcher().freeCollisionAlgorithm(algorithm);
  }
  return evaluations;
}

// A support function may cost an app microseconds.
TEST(PlannerQueries, SupportFunction_IsEvaluatedNoMoreThanByBulletsOwn) {
  Dispatching ours(Route::kRegister), theirs(Route::kBuiltin);
  btBoxShape box(Vec(0.125, 0.15, 0.2));
  btCylinderShape cylinder(Vec(0.25, 0.25, 0.25));
  btSphereShape ball(btScalar(0.2));
  for (btConvexShape* shape : {static_cast<btConvexShape*>(&box), static_cast<btConvexShape*>(&cylinder),
                               static_cast<btConvexShape*>(&ball)}) {
    for (const int moved : {0, 3}) {
      SCOPED_TRACE(std::string(shape->getName()) + ", moved " + std::to_string(moved));
      EXPECT_LE(CountEvaluations(ours, *shape, moved), CountEvaluations(theirs, *shape, moved));
    }
  }
}

/// A planner's estimate of when a swept shape touches: its farthest points towards the other, at the beginning and at
/// the end of the way, and how far the place of contact is from either.
double TimeOfContact(const SweptShape& swept, const btTransform& pose, const Vector& towards, const Vector& place) {
  const auto farthest = [&](const btTransform& at) -> Vector {
    const btVector3 direction = ToBullet(towards) * at.getBasis();
    const auto* polyhedron = dynamic_cast<const btPolyhedralConvexShape*>(&swept.shape());
    if (polyhedron == nullptr) return ToEigen(at * swept.shape().localGetSupportingVertex(direction));
    // The mean of all corners that are as far.
    const btScalar height = direction.dot(polyhedron->localGetSupportingVertex(direction)) - btScalar(1e-3);
    btVector3 sum(0, 0, 0);
    int count = 0;
    for (int i = 0; i < polyhedron->getNumVertices(); ++i) {
      btVector3 corner;
      polyhedron->getVertex(i, corner);
      if (direction.dot(corner) < height) continue;
      sum += corner;
      ++count;
    }
    return ToEigen(at * (sum / btScalar(count)));
  };
  const double from = (place - farthest(pose)).norm(), to = (place - farthest(pose * swept.way())).norm();
  return from / (from + to);
}

class Casts : public testing::TestWithParam<Route> {
 protected:
  Dispatching dispatching_{GetParam()};
};

// A box of 25 cm is swept past the corner of a box of 1 m, aslant.
TEST_P(Casts, BoxPastAnEdge_TouchesAQuarterOfTheWay) {
  btBoxShape fixed(Vec(0.5, 0.5, 0.5)), moving(Vec(0.125, 0.125, 0.125));
  fixed.setMargin(0);
  moving.setMargin(0);
  SweptShape cast(moving, At(3.8, 3.8, 0));
  PairQuery pair(dispatching_.dispatcher(), fixed, cast);
  pair.SetPoses(At(0, 0, 0), At(-1.4, -0.5, 0));
  const std::vector<Contact> contacts = pair.ClosestPoints(0.1);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].depth, -0.2475, 1e-3);
  EXPECT_NEAR((contacts[0].OnA() - Vector(-0.5, 0.5, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((contacts[0].on_b - Vector(-0.325, 0.325, 0)).norm(), 0, 1e-3);
  const btTransform& pose = pair.body_b().getWorldTransform();
  EXPECT_NEAR(TimeOfContact(cast, pose, contacts[0].normal_b_to_a, contacts[0].on_b), 0.25, 1e-3);
}

// Two balls of 25 cm cross each other's way, one from below.
TEST_P(Casts, BallsThatCross_TouchHalfWay) {
  btSphereShape ball(btScalar(0.25));
  for (const double start : {-1.0, -0.5}) {
    SweptShape cast_a(ball, At(0, 1 - start, 0)), cast_b(ball, At(0, 0, 2));
    PairQuery pair(dispatching_.dispatcher(), cast_a, cast_b);
    pair.SetPoses(At(-0.2, start, 0.25), At(0.2, 0, -0.75));
    const std::vector<Contact> contacts = pair.ClosestPoints(0.1);
    ASSERT_EQ(contacts.size(), 1U);
    const Contact& contact = contacts[0];
    EXPECT_NEAR(contact.depth, -0.1, 1e-4);
    EXPECT_NEAR((contact.OnA() - Vector(0.05, 0, 0.25)).norm(), 0, 1e-3);
    EXPECT_NEAR((contact.on_b - Vector(-0.05, 0, 0.25)).norm(), 0, 1e-3);
    EXPECT_NEAR(TimeOfContact(cast_a, pair.body_a().getWorldTransform(), -contact.normal_b_to_a, contact.OnA()),
                -start / (1 - start), 1e-3);
    EXPECT_NEAR(TimeOfContact(cast_b, pair.body_b().getWorldTransform(), contact.normal_b_to_a, contact.on_b), 0.5,
                1e-3);
  }
}

// A box of 20 cm is swept through a box of 1 m: it overlaps most of the way, and each of its places is as good.
TEST_P(Casts, BoxThroughABox_TouchesWhereItIsInside) {
  btBoxShape fixed(Vec(0.5, 0.5, 0.5)), moving(Vec(0.1, 0.1, 0.1));
  fixed.setMargin(0);
  moving.setMargin(0);
  SweptShape cast(moving, At(4, 0, 0)), still(fixed, At(0, 0, 0));
  for (btConvexShape* other : {static_cast<btConvexShape*>(&fixed), static_cast<btConvexShape*>(&still)}) {
    PairQuery pair(dispatching_.dispatcher(), *other, cast);
    pair.SetPoses(At(0, 0, 0), At(-2, 0, 0));
    const std::vector<Contact> contacts = pair.ClosestPoints(0.1);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_NEAR(contacts[0].depth, -0.6, 1e-3);
    const double time =
        TimeOfContact(cast, pair.body_b().getWorldTransform(), contacts[0].normal_b_to_a, contacts[0].on_b);
    EXPECT_GE(time, 1.5 / 4 - 1e-3);
    EXPECT_LE(time, 2.5 / 4 + 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Routes, Casts, testing::Values(Route::kRegister, Route::kBuiltin),
                         [](const testing::TestParamInfo<Route>& route) { return Name(route.param); });

}  // namespace
}  // namespace dgd_test
