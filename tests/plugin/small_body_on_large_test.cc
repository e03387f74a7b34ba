// A small body near the border of a large or thin one: the growth distance's normal is that of the face it is on, and
// the body does not go aside.
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

/// Without margin, as all shapes here: a slab of 1 cm has no room for Bullet's.
template <class Shape>
Shape& Sharp(Shape& shape) {
  shape.setMargin(0);
  return shape;
}

btConvexHullShape& MakeBoxHull(TestWorld& world, const Vector& half) {
  auto& hull = world.Make<btConvexHullShape>();
  for (int i = 0; i < 8; ++i) {
    hull.addPoint(Vec(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z()));
  }
  return Sharp(hull);
}

/// About the z axis, of two rings.
btConvexHullShape& MakeRoundHull(TestWorld& world, double base_radius, double top_radius, double half_z, int sides) {
  auto& hull = world.Make<btConvexHullShape>();
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / sides, x = std::cos(angle), y = std::sin(angle);
    hull.addPoint(Vec(base_radius * x, base_radius * y, -half_z));
    hull.addPoint(Vec(top_radius * x, top_radius * y, half_z));
  }
  return Sharp(hull);
}

/// Without the bottom: a thin plate's has contacts through the top.
btCollisionShape& MakeBoxMesh(TestWorld& world, const Vector& half) {
  auto& mesh = world.Make<btTriangleMesh>();
  const auto corner = [&](int i) {
    return Vec(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z());
  };
  constexpr int kFaces[5][4] = {{4, 5, 7, 6}, {1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}};
  for (const auto& [a, b, c, d] : kFaces) {
    mesh.addTriangle(corner(a), corner(b), corner(c));
    mesh.addTriangle(corner(a), corner(c), corner(d));
  }
  return Sharp(world.Make<btBvhTriangleMeshShape>(&mesh, true));
}

/// A wide body, its top the plane z = 0.
struct Slab {
  std::string name;
  double half_width;  ///< Of the top, metres; of a round one the greatest half width that is inside all around.
  bool is_round;
};

constexpr const char* kSlabs[] = {"box", "hull", "cylinder", "disc hull", "frustum hull", "mesh"};

Slab AddSlab(TestWorld& world, const std::string& name, double width, double thickness) {
  constexpr int kSides = 16;  // More are thinned in a contact patch (SupportingFace).
  const double half = width / 2, half_z = thickness / 2, inner = half * std::cos(std::numbers::pi / kSides);
  Slab slab{name, half, false};
  btCollisionShape* shape = nullptr;
  if (name == "box") {
    shape = &Sharp(world.Make<btBoxShape>(Vec(half, half, half_z)));
  } else if (name == "hull") {
    shape = &MakeBoxHull(world, {half, half, half_z});
  } else if (name == "mesh") {
    shape = &MakeBoxMesh(world, {half, half, half_z});
  } else if (name == "cylinder") {
    shape = &Sharp(world.Make<btCylinderShapeZ>(Vec(half, half, half_z)));
    slab = {name, half, true};
  } else {
    shape = &MakeRoundHull(world, name == "disc hull" ? half : half + thickness / 2, half, half_z, kSides);
    slab = {name, inner, true};
  }
  world.Add(*shape, 0, Vec(0, 0, -half_z));
  return slab;
}

/// At a distance from the middle of a side, or from a corner along both sides.
Vector Near(const Slab& slab, double distance, bool is_corner) {
  const double reach = slab.half_width - distance;
  if (!is_corner) return {reach, 0, 0};
  return slab.is_round ? Vector(std::sqrt(0.5) * reach, std::sqrt(0.5) * reach, 0) : Vector(reach, reach, 0);
}

/// The greatest angle between a contact's normal and the z axis, radians; -1 without a contact.
double GreatestLean(TestWorld& world) {
  double lean = -1;
  for (const btManifoldPoint& point : world.Points()) {
    const btVector3& normal = point.m_normalWorldOnB;
    lean = std::max(lean, std::atan2(std::hypot(double(normal.x()), double(normal.y())), std::abs(double(normal.z()))));
  }
  return lean;
}

constexpr const char* kSmall[] = {"box", "flat box", "ball", "cylinder", "cone", "hull", "flat hull"};

/// About `size` across. @return half its height.
std::pair<btConvexShape*, double> MakeSmall(TestWorld& world, const std::string& name, double size) {
  const double half = size / 2, half_z = name.starts_with("flat") ? half / 4 : half;
  if (name.ends_with("box")) return {&Sharp(world.Make<btBoxShape>(Vec(half, half, half_z))), half_z};
  if (name == "ball") return {&world.Make<btSphereShape>(btScalar(half)), half};
  if (name == "cylinder") return {&Sharp(world.Make<btCylinderShapeZ>(Vec(half, half, half))), half};
  if (name == "cone") return {&Sharp(world.Make<btConeShapeZ>(btScalar(half), btScalar(size))), half};
  return {&MakeBoxHull(world, {half, half, half_z}), half_z};
}

/// Overlaps in a small body's sizes; 0 for a tenth of a millimetre, -1 for just touching.
constexpr double kOverlaps[] = {-1, 0, 0.01, 0.05, 0.1};

double DepthOf(double overlap, double size) { return overlap < 0 ? 0 : overlap == 0 ? 1e-4 : overlap * size; }

/// A body on a slab, at `place` from the slab's middle, has the normal of its top. It leaves the world again, for the
/// next one: a new world takes longer than all else.
void ExpectNormalOfFace(TestWorld& world, btConvexShape& shape, double half_height, double depth,
                        const Eigen::Matrix3d& rotation, const Vector& place) {
  btRigidBody& body = world.Add(shape, 1, MakeTransform(rotation, place + Vector(0, 0, half_height - depth)));
  world.Detect();
  const double lean = GreatestLean(world);
  world.world().removeRigidBody(&body);
  EXPECT_LE(lean, 1e-3) << depth << " m deep at " << place.transpose();
  if (depth > 0) {
    EXPECT_GE(lean, 0) << depth << " m deep at " << place.transpose();
  }
}

TEST(SmallBodyOnLarge, NearBorderAndCorner_NormalIsThatOfTheFace) {
  for (const std::string slab_name : kSlabs) {
    for (const double width : {1.0, 10.0, 100.0}) {
      for (const double thickness : {0.01, 0.1, 1.0}) {
        if (thickness > width / 4) continue;
        TestWorld world(Route::kConfiguration);
        const Slab slab = AddSlab(world, slab_name, width, thickness);
        for (const std::string small_name : kSmall) {
          const double size = width > 1 ? 0.2 : 0.05;
          SCOPED_TRACE(small_name + " on a " + slab_name + " of " + std::to_string(width) + " and " +
                       std::to_string(thickness) + " m");
          for (const double overlap : kOverlaps) {
            for (const bool is_corner : {false, true}) {
              const auto [shape, half_height] = MakeSmall(world, small_name, size);
              const double depth = DepthOf(overlap, 2 * half_height);
              if (depth > thickness / 4) continue;
              ExpectNormalOfFace(world, *shape, half_height, depth, Eigen::Matrix3d::Identity(),
                                 Near(slab, 0.25 * size, is_corner));
            }
          }
        }
      }
    }
  }
}

/// Along the x axis.
btConvexShape& MakeRod(TestWorld& world, const std::string& name, double half_length, double radius) {
  if (name == "box") return Sharp(world.Make<btBoxShape>(Vec(half_length, radius, radius)));
  if (name == "hull") return MakeBoxHull(world, {half_length, radius, radius});
  if (name == "capsule") return world.Make<btCapsuleShapeX>(btScalar(radius), btScalar(2 * half_length));
  return Sharp(world.Make<btCylinderShapeX>(Vec(half_length, radius, radius)));
}

TEST(SmallBodyOnLarge, RodOnPlate_NormalIsThatOfTheFace) {
  for (const std::string slab_name : kSlabs) {
    constexpr double kRadius = 0.01, kThickness = 0.01;
    TestWorld world(Route::kConfiguration);
    const Slab slab = AddSlab(world, slab_name, 1, kThickness);
    for (const std::string rod : {"box", "capsule", "cylinder", "hull"}) {
      for (const double half_length : {0.2, 1.5}) {
        SCOPED_TRACE(rod + " of half length " + std::to_string(half_length) + " on a " + slab_name);
        for (const double overlap : kOverlaps) {
          for (const double angle : {0.0, 0.2, std::numbers::pi / 2}) {
            // Across the border with its middle near it, or along it.
            const Vector place = Near(slab, 0.05, false) + Vector(0, slab.is_round ? 0 : 0.2, 0);
            const Eigen::Matrix3d rotation(Eigen::AngleAxisd(angle, Vector::UnitZ()));
            ExpectNormalOfFace(world, MakeRod(world, rod, half_length, kRadius), kRadius, DepthOf(overlap, 2 * kRadius),
                               rotation, place);
          }
        }
      }
    }
  }
}

/// From two millimetres deep, a body is where it was, but for its height, after two seconds.
void ExpectStays(TestWorld& world, btConvexShape& shape, double half_height, const Vector& place) {
  btRigidBody& body = world.Add(shape, 1, ToBullet(place + Vector(0, 0, half_height - 2e-3)));
  for (int step = 0; step < 120; ++step) world.world().stepSimulation(btScalar(1) / 60, 0);
  const Vector moved = ToEigen(body.getWorldTransform().getOrigin()) - place;
  EXPECT_LE(moved.head<2>().norm(), 1e-3);
  EXPECT_NEAR(moved.z(), half_height, 1e-3);
}

TEST(SmallBodyOnLarge, AtRestNearTheCorner_StaysThere) {
  for (const std::string slab_name : kSlabs) {
    for (const double thickness : {0.01, 1.0}) {
      for (const std::string name : kSmall) {
        SCOPED_TRACE(name + " on a " + slab_name + " of " + std::to_string(thickness) + " m");
        TestWorld world(Route::kConfiguration);
        const Slab slab = AddSlab(world, slab_name, 100, thickness);
        const auto [shape, half_height] = MakeSmall(world, name, 0.2);
        ExpectStays(world, *shape, half_height, Near(slab, 0.12, true));
      }
    }
    for (const std::string rod : {"box", "capsule", "cylinder", "hull"}) {
      SCOPED_TRACE("rod, a " + rod + ", on a plate, a " + slab_name);
      TestWorld world(Route::kConfiguration);
      const Slab slab = AddSlab(world, slab_name, 1, 0.01);
      ExpectStays(world, MakeRod(world, rod, 0.5, 0.01), 0.01, Near(slab, 0.05, false));
    }
  }
}

}  // namespace
}  // namespace dgd_test
