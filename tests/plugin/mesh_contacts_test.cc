// What moves over a mesh moves as over one face: no ghosts at internal edges, and real edges count.
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "plugin/triangle_grid.h"

namespace dgd_test {
namespace {

/// Kinds of ground that show the same surface.
enum class Ground { kMesh, kOtherDiagonal, kScaled, kHeightfield, kBetweenCorners };
constexpr Ground kGrounds[] = {Ground::kMesh, Ground::kOtherDiagonal, Ground::kScaled, Ground::kHeightfield,
                               Ground::kBetweenCorners};

/// A world with a mesh, on our narrowphase. Metres, seconds; z is up, gravity 10 m/s^2.
class MeshWorld {
 public:
  explicit MeshWorld(double hz) : time_step_(1 / hz), world_(Route::kConfiguration) {
    world_.world().setGravity(Vec(0, 0, -10));
  }

  /// @param height  double(double x, double y).
  template <class Height>
  btRigidBody& AddGround(Ground ground, double half_width, double cell, double friction, const Height& height) {
    const int cells = int(std::lround(2 * half_width / cell));
    btCollisionShape& shape =
        ground == Ground::kHeightfield ? MakeHeightfield(cells, cell, height) : MakeMesh(ground, cells, cell, height);
    btRigidBody& body = world_.Add(shape, 0, Vec(0, 0, 0));
    body.setFriction(btScalar(friction));
    return body;
  }
  btRigidBody& AddFlat(Ground ground, double half_width, double cell, double friction) {
    return AddGround(ground, half_width, cell, friction, [](double, double) { return 0.0; });
  }
  /// Of triangles of the caller's own.
  btRigidBody& AddMesh(const std::vector<std::array<btVector3, 3>>& triangles, double friction) {
    auto& mesh = world_.Make<btTriangleMesh>();
    for (const auto& [a, b, c] : triangles) mesh.addTriangle(a, b, c);
    btRigidBody& body = world_.Add(world_.Make<btBvhTriangleMeshShape>(&mesh, true), 0, Vec(0, 0, 0));
    body.setFriction(btScalar(friction));
    return body;
  }
  btRigidBody& AddBody(btConvexShape& shape, const btTransform& pose, double friction) {
    btRigidBody& body = world_.Add(shape, 1, pose);
    body.setFriction(btScalar(friction));
    body.setActivationState(DISABLE_DEACTIVATION);
    return body;
  }

  void Step() { world_.world().stepSimulation(btScalar(time_step_), 0, btScalar(time_step_)); }
  int Steps(double seconds) const { return int(std::lround(seconds / time_step_)); }
  TestWorld& world() { return world_; }

 private:
  template <class Height>
  btCollisionShape& MakeMesh(Ground ground, int cells, double cell, const Height& height) {
    auto& mesh = world_.Make<btTriangleMesh>();
    const double scale = ground == Ground::kScaled ? 2 : 1;
    const auto corner = [&](double i, double j) {
      const double x = (i - 0.5 * cells) * cell, y = (j - 0.5 * cells) * cell;
      return Vec(x / scale, y / scale, height(x, y) / scale);
    };
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const btVector3 a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
        if (ground == Ground::kOtherDiagonal) {
          mesh.addTriangle(a, b, d);
          mesh.addTriangle(b, c, d);
        } else if (ground == Ground::kBetweenCorners && (i + j) % 2 == 0) {
          // Its neighbours' edges have no corner in their middle.
          const btVector3 middle = corner(i + 0.5, j);
          mesh.addTriangle(a, middle, d);
          mesh.addTriangle(middle, c, d);
          mesh.addTriangle(middle, b, c);
        } else {
          mesh.addTriangle(a, b, c);
          mesh.addTriangle(a, c, d);
        }
      }
    }
    auto& shape = world_.Make<btBvhTriangleMeshShape>(&mesh, true);
    if (ground != Ground::kScaled) return shape;
    return world_.Make<btScaledBvhTriangleMeshShape>(&shape, Vec(scale, scale, scale));
  }

  template <class Height>
  btCollisionShape& MakeHeightfield(int cells, double cell, const Height& height) {
    const int points = cells + 1;
    auto& heights = world_.Make<std::vector<float>>();
    for (int j = 0; j < points; ++j) {
      for (int i = 0; i < points; ++i) {
        heights.push_back(float(height((i - 0.5 * cells) * cell, (j - 0.5 * cells) * cell)));
      }
    }
    auto& shape =
        world_.Make<btHeightfieldTerrainShape>(points, points, heights.data(), btScalar(-5), btScalar(5), 2, false);
    shape.setLocalScaling(Vec(cell, cell, 1));
    return shape;
  }

  const double time_step_;
  TestWorld world_;
};

btTransform Upright(double x, double y, double z, double heading = 0) {
  return btTransform(btQuaternion(Vec(0, 0, 1), btScalar(heading)), Vec(x, y, z));
}

/// Shapes that slide on a flat side, and how high above it their origin is.
struct Slider {
  std::string name;
  std::shared_ptr<btConvexShape> shape;
  double height;
};

std::vector<Slider> MakeSliders() {
  return {{"box", std::make_shared<btBoxShape>(Vec(0.25, 0.25, 0.25)), 0.25},
          {"flat box", std::make_shared<btBoxShape>(Vec(0.4, 0.3, 0.1)), 0.1},
          {"prism", MakePrism(6, 0.25, 0.2), 0.24},  // With its margin.
          {"cylinder", std::make_shared<btCylinderShapeZ>(Vec(0.25, 0.25, 0.2)), 0.2}};
}

// Bullet's own: 1.73 m/s after three seconds on cells of 5 cm at 60 Hz, and hops of a millimetre on all.
TEST(MeshContacts, RollingBall_KeepsItsSpeedAndNeverHops) {
  constexpr double kSpeed = 1.5;
  for (const Ground ground : kGrounds) {
    for (const double cell : {0.1, 0.5, 2.0}) {
      for (const double hz : {60.0, 240.0, 1000.0}) {
        for (const double heading : {0.0, 0.25 * std::numbers::pi, 2.0}) {
          SCOPED_TRACE(testing::Message() << "ground " << int(ground) << ", cells of " << cell << " m, " << hz
                                          << " Hz, heading " << heading);
          // As long as it takes, where few triangles are enough for it.
          const double seconds = cell < 0.2 || hz > 300 ? 2 : cell < 1 ? 4 : 10;
          const double half_width = cell * std::ceil((0.5 * kSpeed * seconds + 2) / cell);
          MeshWorld world(hz);
          world.AddFlat(ground, half_width, cell, 1);
          btSphereShape sphere(btScalar(0.5));
          const double c = std::cos(heading), s = std::sin(heading), start = -0.5 * kSpeed * seconds;
          btRigidBody& ball = world.AddBody(sphere, Upright(start * c + 0.013, start * s + 0.007, 0.5), 1);
          ball.setLinearVelocity(Vec(kSpeed * c, kSpeed * s, 0));
          ball.setAngularVelocity(Vec(-2 * kSpeed * s, 2 * kSpeed * c, 0));
          double highest = 0, lowest = 1;
          for (int i = 0; i < world.Steps(seconds); ++i) {
            world.Step();
            highest = std::max(highest, double(ball.getWorldTransform().getOrigin().z()));
            lowest = std::min(lowest, double(ball.getWorldTransform().getOrigin().z()));
          }
          EXPECT_NEAR(double(ball.getLinearVelocity().dot(Vec(c, s, 0))), kSpeed, 0.005 * kSpeed);
          EXPECT_LT(highest, 0.5 + 5e-5);
          EXPECT_GT(lowest, 0.5 - 5e-5);
        }
      }
    }
  }
}

// One triangle's contact is of now, the next one's of where the ball will be at the end of the step.
TEST(MeshContacts, BallThatPassesASeam_KeepsItsHeight) {
  constexpr double kSpeed = 1.5, kCell = 0.5;
  for (const double hz : {60.0, 240.0, 1000.0}) {
    for (int i = 0; i < 20; ++i) {
      MeshWorld world(hz);
      world.AddFlat(Ground::kMesh, 5, kCell, 1);
      btSphereShape sphere(btScalar(0.5));
      btRigidBody& ball = world.AddBody(sphere, Upright(-0.1 - 0.01 * i * kSpeed / hz, 0.007, 0.5), 1);
      ball.setLinearVelocity(Vec(kSpeed, 0, 0));
      ball.setAngularVelocity(Vec(0, 2 * kSpeed, 0));
      double off = 0;
      for (int step = 0; step < world.Steps(0.5); ++step) {
        world.Step();
        off = std::max(off, std::abs(double(ball.getWorldTransform().getOrigin().z()) - 0.5));
      }
      EXPECT_LT(off, 1e-5) << hz << " Hz, " << i;
    }
  }
}

// Bullet's own stops them: the box keeps a fifth of its speed on cells of 10 cm.
TEST(MeshContacts, SlidingBody_KeepsItsSpeedAndDirection) {
  for (const Slider& slider : MakeSliders()) {
    for (const Ground ground : kGrounds) {
      for (const double cell : {0.05, 0.2, 2.0}) {
        for (const double speed : {0.3, 3.0, 20.0}) {
          SCOPED_TRACE(testing::Message() << slider.name << ", ground " << int(ground) << ", cells of " << cell
                                          << " m, " << speed << " m/s");
          const double way = cell < 0.3 ? 1.5 : 6, heading = 0.2;
          const double half_width = cell * std::ceil((0.5 * way + 1) / cell);
          MeshWorld world(60);
          world.AddFlat(ground, half_width, cell, 0);
          const double c = std::cos(heading), s = std::sin(heading);
          btRigidBody& body =
              world.AddBody(*slider.shape, Upright(-0.5 * way * c + 0.013, -0.5 * way * s, slider.height, 0.3), 0);
          for (int i = 0; i < 20; ++i) world.Step();
          body.setLinearVelocity(Vec(speed * c, speed * s, 0));
          for (int i = 0; i < world.Steps(std::min(way / speed, 10.0)); ++i) world.Step();
          const btVector3 velocity = body.getLinearVelocity();
          EXPECT_NEAR(double(velocity.x()), speed * c, 0.01 * speed);
          EXPECT_NEAR(double(velocity.y()), speed * s, 0.01 * speed);
          EXPECT_NEAR(double(body.getWorldTransform().getOrigin().z()), slider.height, 1e-3);
          EXPECT_LT(double(body.getAngularVelocity().length()), 0.02 * speed);
        }
      }
    }
  }
}

// Down one slope and up the other: the speed is that of the height, nothing is thrown up.
TEST(MeshContacts, OverRidgesAndIntoValleys_NothingJumps) {
  for (const double sign : {1.0, -1.0}) {
    for (const double cell : {0.1, 0.5}) {
      for (const double slope : {0.02, 0.1}) {
        SCOPED_TRACE(testing::Message() << sign << ", cells of " << cell << " m, slope " << slope);
        MeshWorld world(240);
        const auto height = [&](double x, double) { return sign * slope * -std::abs(x); };
        world.AddGround(Ground::kMesh, 4, cell, 0, height);
        btSphereShape sphere(btScalar(0.3));
        const double tilt = std::atan(slope), start = -2;
        btRigidBody& ball = world.AddBody(sphere, Upright(start, 0.013, height(start, 0) + 0.3 / std::cos(tilt)), 0);
        ball.setLinearVelocity(Vec(2 * std::cos(tilt), 0, 2 * sign * std::sin(tilt)));
        const auto energy = [&] {
          return 0.5 * double(ball.getLinearVelocity().length2()) +
                 10 * double(ball.getWorldTransform().getOrigin().z());
        };
        const double before = energy();
        double highest = -1;
        while (ball.getWorldTransform().getOrigin().x() < 2) {
          world.Step();
          const btVector3& place = ball.getWorldTransform().getOrigin();
          highest = std::max(highest, double(place.z()) - height(double(place.x()), 0));
        }
        // A valley's kink takes what of the speed is across its other side.
        EXPECT_LT(energy(), before + 0.02);
        EXPECT_GT(energy(), before - 0.02 - (sign < 0 ? 2 * std::pow(2 * std::sin(2 * tilt), 2) : 0));
        EXPECT_LT(highest, 0.3 / std::cos(tilt) + 0.03);
      }
    }
  }
}

TEST(MeshContacts, RealStep_StopsABox) {
  for (const double cell : {0.1, 0.5}) {
    for (const double speed : {1.0, 10.0}) {
      SCOPED_TRACE(testing::Message() << "cells of " << cell << " m, " << speed << " m/s");
      MeshWorld world(60);
      std::vector<std::array<btVector3, 3>> triangles;
      const auto add = [&](const btVector3& a, const btVector3& b, const btVector3& c, const btVector3& d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      };
      constexpr double kStep = 0.1;
      const int cells = int(std::lround(4 / cell));
      for (int j = 0; j < cells; ++j) {
        const double y = -2 + j * cell;
        for (int i = 0; i < cells; ++i) {
          const double x = -2 + i * cell, z = i * 2 >= cells ? kStep : 0;
          add(Vec(x, y, z), Vec(x + cell, y, z), Vec(x + cell, y + cell, z), Vec(x, y + cell, z));
        }
        add(Vec(0, y, 0), Vec(0, y, kStep), Vec(0, y + cell, kStep), Vec(0, y + cell, 0));
      }
      world.AddMesh(triangles, 0);
      btBoxShape box(Vec(0.25, 0.25, 0.05));
      btRigidBody& body = world.AddBody(box, Upright(-1.5, 0.03, 0.05), 0);
      body.setLinearVelocity(Vec(speed, 0, 0));
      for (int i = 0; i < world.Steps(3 / speed); ++i) world.Step();
      EXPECT_LT(double(body.getLinearVelocity().x()), 0.05);
      EXPECT_LT(double(body.getWorldTransform().getOrigin().x()), -0.24);
      EXPECT_GT(double(body.getWorldTransform().getOrigin().x()), -0.35) << "glides back slowly at most";
      EXPECT_LT(double(body.getWorldTransform().getOrigin().z()), 0.06);
    }
  }
}

// At the rim of a table, and on the tip of a roof.
TEST(MeshContacts, BordersAndRidges_Count) {
  {
    MeshWorld world(60);
    world.AddFlat(Ground::kMesh, 1, 0.5, 0);
    btSphereShape sphere(btScalar(0.3));
    btRigidBody& ball = world.AddBody(sphere, Upright(-2, 0.1, 0.05), 0);
    ball.setGravity(Vec(0, 0, 0));
    ball.setLinearVelocity(Vec(2, 0, 0));
    for (int i = 0; i < 60; ++i) world.Step();
    EXPECT_LT(double(ball.getWorldTransform().getOrigin().x()), -1.2) << "flies into the mesh's border";
  }
  for (const double offset : {0.0, 0.05}) {
    MeshWorld world(60);
    world.AddGround(Ground::kMesh, 2, 0.5, 1, [](double x, double) { return -0.8 * std::abs(x); });
    btBoxShape box(Vec(0.5, 0.5, 0.1));
    btRigidBody& body = world.AddBody(box, Upright(offset, 0.1, 0.3), 1);
    for (int i = 0; i < 20; ++i) world.Step();
    EXPECT_NEAR(double(body.getWorldTransform().getOrigin().z()), 0.1, 0.02) << "lands on the ridge";
  }
}

// With restitution, and without: as off a box whose top is as high.
TEST(MeshContacts, Bounces_AreThoseOffABox) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    for (const Slider& slider : MakeSliders()) {
      double heights[2] = {};
      for (const bool on_mesh : {false, true}) {
        MeshWorld world(240);
        btRigidBody& ground = on_mesh ? world.AddFlat(Ground::kMesh, 2, 0.3, 0.5) : world.world().AddGround(2);
        ground.setRestitution(btScalar(restitution));
        ground.setFriction(btScalar(0.5));
        btRigidBody& body = world.AddBody(*slider.shape, Upright(0.02, 0.03, slider.height + 0.5), 0.5);
        body.setRestitution(btScalar(1));
        bool has_bounced = false;
        double top = 0;
        for (int i = 0; i < world.Steps(0.8); ++i) {
          world.Step();
          has_bounced |= body.getLinearVelocity().z() > btScalar(0.01);
          if (has_bounced) top = std::max(top, double(body.getWorldTransform().getOrigin().z()) - slider.height);
        }
        heights[on_mesh] = top;
      }
      EXPECT_NEAR(heights[1], heights[0], 0.01) << slider.name << ", restitution " << restitution;
    }
  }
}

// Without CCD, and where bodies come down from aside on triangles that they are not over yet.
TEST(MeshContacts, FastBodies_AreMet) {
  for (const Slider& slider : MakeSliders()) {
    for (const double cell : {0.1, 1.0}) {
      for (const double sideways : {0.0, 20.0}) {
        for (const double down : {5.0, 40.0}) {
          MeshWorld world(60);
          world.AddFlat(Ground::kMesh, 5, cell, 0);
          btRigidBody& body = world.AddBody(*slider.shape, Upright(-3, 0.03, 2, 0.3), 0);
          body.setLinearVelocity(Vec(sideways, 0, -down));
          double lowest = 2;
          for (int i = 0; i < 18; ++i) {
            world.Step();
            lowest = std::min(lowest, double(body.getWorldTransform().getOrigin().z()));
          }
          EXPECT_GT(lowest, slider.height - 0.01)
              << slider.name << ", cells of " << cell << " m, " << sideways << " m/s and " << down << " m/s down";
        }
      }
    }
  }
}

TEST(MeshContacts, BodiesOnAFineMesh_KeepStill) {
  for (const Slider& slider : MakeSliders()) {
    for (const Ground ground : {Ground::kMesh, Ground::kHeightfield}) {
      MeshWorld world(60);
      world.AddFlat(ground, 1, 0.05, 0.5);
      btRigidBody& body = world.AddBody(*slider.shape, Upright(0.013, 0.007, slider.height + 0.02, 0.3), 0.5);
      double fastest = 0;
      for (int i = 0; i < 300; ++i) {
        world.Step();
        if (i >= 120) fastest = std::max(fastest, double(body.getLinearVelocity().length()));
      }
      EXPECT_LT(fastest, 1e-3) << slider.name << ", ground " << int(ground);
    }
  }
}

int started = 0, ended = 0;

TEST(MeshContacts, RollingBall_StartsItsContactOnce) {
  for (const bool on_mesh : {true, false}) {
    for (const double hz : {60.0, 240.0}) {
      MeshWorld world(hz);
      if (on_mesh) {
        world.AddFlat(Ground::kMesh, 6, 0.3, 1);
      } else {
        world.world().AddGround(10);
      }
      btSphereShape sphere(btScalar(0.5));
      btRigidBody& ball = world.AddBody(sphere, Upright(-4, 0.1, 0.5), 1);
      ball.setLinearVelocity(Vec(2, 0, 0));
      ball.setAngularVelocity(Vec(0, 4, 0));
      started = ended = 0;
      gContactStartedCallback = [](btPersistentManifold* const&) { ++started; };
      gContactEndedCallback = [](btPersistentManifold* const&) { ++ended; };
      for (int i = 0; i < world.Steps(4); ++i) world.Step();
      gContactStartedCallback = nullptr;
      gContactEndedCallback = nullptr;
      EXPECT_EQ(started, 1) << on_mesh;
      EXPECT_EQ(ended, 0) << on_mesh;
    }
  }
}

// The point is on the triangle that it names, also when it goes on from one to the next; a point ahead of touching is
// as far from it as the body goes in a step, at most.
TEST(MeshContacts, Points_NameTheTriangleBelowThem) {
  MeshWorld world(60);
  std::vector<std::array<btVector3, 3>> triangles;
  constexpr int kCells = 20;
  constexpr double kCell = 0.3;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const auto corner = [&](int k, int l) {
        return Vec((k - 0.5 * kCells) * kCell, (l - 0.5 * kCells) * kCell, 0.05 * std::sin(k) * std::cos(l));
      };
      triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  world.AddMesh(triangles, 0.1);
  btBoxShape box(Vec(0.5, 0.4, 0.2));
  btRigidBody& body = world.AddBody(box, Upright(-1.5, 0.1, 0.4), 0.1);
  body.setLinearVelocity(Vec(1, 0, 0));
  int seen = 0;
  for (int i = 0; i < 150; ++i) {
    world.Step();
    for (int m = 0; m < world.world().dispatcher().getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *world.world().dispatcher().getManifoldByIndexInternal(m);
      const bool is_mesh_first = manifold.getBody1() == &body;
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold.getContactPoint(k);
        const int index = is_mesh_first ? point.m_index0 : point.m_index1;
        ASSERT_GE(index, 0);
        ASSERT_LT(index, int(triangles.size()));
        const auto& [a, b, c] = triangles[std::size_t(index)];
        const btVector3& place = is_mesh_first ? point.m_positionWorldOnA : point.m_positionWorldOnB;
        const auto side = [](const btVector3& from, const btVector3& to, const btVector3& at) {
          return double((to.x() - from.x()) * (at.y() - from.y()) - (to.y() - from.y()) * (at.x() - from.x()));
        };
        // Seen from above; anchored points are off by part of a millimetre, those ahead of their time by more.
        if ((point.m_positionWorldOnA - point.m_positionWorldOnB).length() > btScalar(0.005)) continue;
        EXPECT_GT(std::min({side(a, b, place), side(b, c, place), side(c, a, place)}), -5e-3);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 100);
}

int adjusted = 0;

bool Adjust(btManifoldPoint& point, const btCollisionObjectWrapper* wrapper_0, int part_0, int index_0,
            const btCollisionObjectWrapper* wrapper_1, int part_1, int index_1) {
  ++adjusted;
  const bool is_first = wrapper_0->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE;
  EXPECT_TRUE(is_first || wrapper_1->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE);
  if (is_first) {
    btAdjustInternalEdgeContacts(point, wrapper_0, wrapper_1, part_0, index_0);
  } else {
    btAdjustInternalEdgeContacts(point, wrapper_1, wrapper_0, part_1, index_1);
  }
  return true;
}

// An app that has Bullet's own remedy keeps it.
TEST(MeshContacts, InternalEdgeUtility_GoesOnWorking) {
  MeshWorld world(60);
  btRigidBody& ground = world.AddFlat(Ground::kMesh, 6, 0.3, 0);
  btTriangleInfoMap info;
  btGenerateInternalEdgeInfo(static_cast<btBvhTriangleMeshShape*>(ground.getCollisionShape()), &info);
  ground.setCollisionFlags(ground.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  btBoxShape box(Vec(0.25, 0.25, 0.25));
  btRigidBody& body = world.AddBody(box, Upright(-4, 0.1, 0.25), 0);
  body.setLinearVelocity(Vec(3, 0, 0));
  adjusted = 0;
  gContactAddedCallback = Adjust;
  for (int i = 0; i < world.Steps(2.5); ++i) world.Step();
  gContactAddedCallback = nullptr;
  EXPECT_GT(adjusted, 400);
  EXPECT_NEAR(double(body.getLinearVelocity().x()), 3, 0.03);
}

// A child of a compound that slides over a mesh, and one that a ball rolls over.
TEST(MeshContacts, CompoundsOverAMesh_Slide) {
  MeshWorld world(60);
  world.AddFlat(Ground::kMesh, 6, 0.2, 0);
  btBoxShape box(Vec(0.2, 0.2, 0.2));
  btCompoundShape compound;
  compound.addChildShape(Upright(-0.3, 0, 0), &box);
  compound.addChildShape(Upright(0.3, 0, 0), &box);
  btRigidBody& body = world.world().Add(compound, 1, Vec(-4, 0.1, 0.2));
  body.setFriction(0);
  body.setActivationState(DISABLE_DEACTIVATION);
  body.setLinearVelocity(Vec(3, 0, 0));
  for (int i = 0; i < world.Steps(2.5); ++i) world.Step();
  EXPECT_NEAR(double(body.getLinearVelocity().x()), 3, 0.03);
  EXPECT_NEAR(double(body.getWorldTransform().getOrigin().z()), 0.2, 1e-3);
}

// Beside a wall, floor and wall both count: the body is neither let into one nor pushed off the other.
TEST(MeshContacts, InACorner_BothSidesAreKept) {
  MeshWorld world(60);
  std::vector<std::array<btVector3, 3>> triangles;
  for (int i = 0; i < 20; ++i) {
    const double y = -2 + 0.2 * i;
    for (int k = 0; k < 10; ++k) {
      const double x = -2 + 0.2 * k;
      triangles.push_back({Vec(x, y, 0), Vec(x + 0.2, y, 0), Vec(x + 0.2, y + 0.2, 0)});
      triangles.push_back({Vec(x, y, 0), Vec(x + 0.2, y + 0.2, 0), Vec(x, y + 0.2, 0)});
    }
    triangles.push_back({Vec(0, y, 0), Vec(0, y, 1), Vec(0, y + 0.2, 1)});
    triangles.push_back({Vec(0, y, 0), Vec(0, y + 0.2, 1), Vec(0, y + 0.2, 0)});
  }
  world.AddMesh(triangles, 0);
  btBoxShape box(Vec(0.25, 0.25, 0.25));
  btRigidBody& body = world.AddBody(box, Upright(-0.25, -1.2, 0.25), 0);
  body.setGravity(Vec(5, 0, -10));
  body.setLinearVelocity(Vec(0, 1, 0));
  for (int i = 0; i < 120; ++i) world.Step();
  EXPECT_NEAR(double(body.getLinearVelocity().y()), 1, 0.01);
  EXPECT_NEAR(double(body.getWorldTransform().getOrigin().x()), -0.25, 3e-3);
  EXPECT_NEAR(double(body.getWorldTransform().getOrigin().z()), 0.25, 2e-3);
}

}  // namespace
}  // namespace dgd_test
