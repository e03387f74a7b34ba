// What a debug drawer is shown of the contacts.
#include <LinearMath/btIDebugDraw.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

class Recorder : public btIDebugDraw {
 public:
  struct Line {
    Vector from, to;
  };

  explicit Recorder(int mode) : mode_(mode) {}

  void drawLine(const btVector3& from, const btVector3& to, const btVector3&) override {
    lines.push_back({ToEigen(from), ToEigen(to)});
  }
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
  void reportErrorWarning(const char* text) override { ADD_FAILURE() << text; }
  void draw3dText(const btVector3&, const char* text) override { texts.emplace_back(text); }
  void setDebugMode(int mode) override { mode_ = mode; }
  int getDebugMode() const override { return mode_; }

  std::vector<Line> lines;
  std::vector<std::string> texts;

 private:
  int mode_;
};

/// A unit cube on the ground, one step of which is shown.
void ShowCube(Recorder& recorder, double height) {
  TestWorld world(Route::kConfiguration);
  world.AddGround();
  world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.5 + height));
  world.world().setDebugDrawer(&recorder);
  world.Simulate(TestWorld::kTimeStep);
}

TEST(ContactDrawer, Patch_IsOutlinedOnBothBodiesWithItsNormals) {
  Recorder recorder(btIDebugDraw::DBG_DrawContactPoints);
  ShowCube(recorder, 0);
  EXPECT_TRUE(recorder.texts.empty());
  ASSERT_EQ(recorder.lines.size(), 12U);
  int sides = 0, normals = 0;
  for (const Recorder::Line& line : recorder.lines) {
    const Vector way = line.to - line.from;
    if (std::abs(way.z()) < 0.01) {
      EXPECT_NEAR(line.from.z(), 0, 0.01);
      EXPECT_GT(way.norm(), 0.9);
      EXPECT_LT(way.norm(), 1.1) << "a diagonal is no side";
      ++sides;
    } else {
      EXPECT_NEAR(way.head<2>().norm(), 0, 1e-6);
      ++normals;
    }
  }
  EXPECT_EQ(sides, 8);
  EXPECT_EQ(normals, 4);
}

TEST(ContactDrawer, Text_TellsTheSeparation) {
  Recorder recorder(btIDebugDraw::DBG_DrawText);
  ShowCube(recorder, -0.1);
  EXPECT_TRUE(recorder.lines.empty());
  ASSERT_EQ(recorder.texts.size(), 1U);
  EXPECT_EQ(recorder.texts[0], "-100 mm");
}

TEST(ContactDrawer, NoContactOrNoSuchMode_DrawsNothing) {
  Recorder apart(btIDebugDraw::DBG_DrawContactPoints | btIDebugDraw::DBG_DrawText);
  ShowCube(apart, 1);
  EXPECT_TRUE(apart.lines.empty());
  EXPECT_TRUE(apart.texts.empty());
  Recorder other(btIDebugDraw::DBG_DrawConstraints);
  ShowCube(other, 0);
  EXPECT_TRUE(other.lines.empty());
  EXPECT_TRUE(other.texts.empty());
}

/// Where the boxes of a heap end after a second on some ground, watched or not.
std::vector<Vector> HeapAfterASecond(bool is_on_plane, btIDebugDraw* drawer) {
  TestWorld world(Route::kConfiguration);
  if (is_on_plane) {
    world.Add(world.Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0)), 0, Vec(0, 0, 0));
  } else {
    world.AddGround();
  }
  auto& box = world.Make<btBoxShape>(Vec(0.2, 0.2, 0.2));
  std::vector<const btRigidBody*> bodies;
  for (int i = 0; i < 6; ++i) bodies.push_back(&world.Add(box, 1, Vec(0.1 * (i % 2), 0.05 * (i % 3), 0.25 + 0.45 * i)));
  world.world().setDebugDrawer(drawer);
  world.Simulate(1);
  std::vector<Vector> places;
  for (const btRigidBody* body : bodies) places.push_back(ToEigen(body->getWorldTransform().getOrigin()));
  return places;
}

TEST(ContactDrawer, Watching_ChangesNothing) {
  for (const bool is_on_plane : {false, true}) {
    Recorder recorder(btIDebugDraw::DBG_DrawContactPoints | btIDebugDraw::DBG_DrawText);
    EXPECT_EQ(HeapAfterASecond(is_on_plane, &recorder), HeapAfterASecond(is_on_plane, nullptr));
    EXPECT_FALSE(recorder.lines.empty());
  }
}

}  // namespace
}  // namespace dgd_test
