// Contract: the view of a world file is upright whichever way gravity points, its ground is a floor that does not count
// for the frame, and every body of the worlds that Bullet's serializer wrote has a surface.
#include "report/world_view.h"

#include <gtest/gtest.h>

#include <string>

#include "simulation/bullet_math.h"
#include "world_file/bullet_worlds.h"
#include "world_file/imported_world.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;
using Role = DrawnBody::Role;

std::unique_ptr<ImportedWorld> Import(dgd_test::BulletWorld& world) {
  return std::make_unique<ImportedWorld>(LoadWorldBytes("a world of the tests", world.Serialize()),
                                         Narrowphase::kBuiltin);
}

TEST(WorldViewTest, AllWorlds_HaveASurfaceForEachBody) {
  for (const dgd_test::WorldCase& world_case : dgd_test::AllWorldCases()) {
    const auto world = Import(*world_case.make());
    const WorldView view = ViewOf(*world);
    ASSERT_EQ(view.bodies.size(), world->Bodies().size());
    EXPECT_EQ(view.world_to_view, Eigen::Matrix3d::Identity()) << world_case.name;
    for (std::size_t i = 0; i < view.bodies.size(); ++i) {
      EXPECT_FALSE(view.bodies[i].surface.empty()) << world_case.name << ", " << world->Bodies()[i].name;
      EXPECT_EQ(view.bodies[i].role == Role::kBody, world->Bodies()[i].moves) << world_case.name << ", " << i;
    }
  }
}

TEST(WorldViewTest, GroundsAreFloorsAndTerrainIsScenery) {
  EXPECT_EQ(ViewOf(*Import(*dgd_test::MakeWorld("boxes"))).bodies[0].role, Role::kFloor);
  EXPECT_EQ(ViewOf(*Import(*dgd_test::MakeWorld("plane"))).bodies.back().role, Role::kFloor);
  EXPECT_EQ(ViewOf(*Import(*dgd_test::MakeWorld("terrain"))).bodies[0].role, Role::kScenery);
}

// A ball above a ground, with gravity along -y or +z.
TEST(WorldViewTest, Up_IsOppositeGravity) {
  for (const Vector3d& up : {Vector3d(0, 1, 0), Vector3d(0, 0, -1), Vector3d(0.6, 0, -0.8)}) {
    dgd_test::BulletWorld original(false);
    original.world().setGravity(ToBullet(Vector3d(-9.81 * up)));
    auto& plane = original.Make<btStaticPlaneShape>(ToBullet(up), btScalar(0));
    original.Add(plane, 0, btVector3(0, 0, 0));
    original.Add(original.Make<btSphereShape>(btScalar(0.5)), 1, ToBullet(Vector3d(3 * up)));
    const auto world = Import(original);
    const WorldView view = ViewOf(*world);
    EXPECT_LT((view.world_to_view * up - Vector3d::UnitZ()).norm(), 1e-6);
    EXPECT_NEAR(view.world_to_view.determinant(), 1, 1e-9) << "mirrored";
    const Snapshot state = InView(view, {0, world->Poses(), SpeedsOf(world->Motions())});
    EXPECT_LT((state.poses[1].position - Vector3d(0, 0, 3)).norm(), 1e-5);
    EXPECT_EQ(view.bodies[0].role, Role::kFloor);
    ASSERT_EQ(BallsAround(view.bodies, state).size(), 1u);
    EXPECT_NEAR(BallsAround(view.bodies, state)[0].radius, 0.5, 1e-6);
  }
}

TEST(WorldViewTest, SceneryCountsForTheFrameOnlyNearTheBodies) {
  const Snapshot state{0, {{}, {Eigen::Matrix3d::Identity(), Vector3d(1, 0, 0)}, {}}, {0, 0, 0}};
  const std::vector<DrawnBody> bodies = {{{}, 1}, {{}, 0.5, Role::kScenery}, {{}, 100, Role::kScenery}};
  EXPECT_EQ(WithSurroundings(BallsAround(bodies, state), bodies, state).size(), 2u);
  const std::vector<DrawnBody> still = {
      {{}, 1, Role::kScenery}, {{}, 100, Role::kFloor}, {{}, std::numeric_limits<double>::infinity(), Role::kFloor}};
  EXPECT_EQ(WithSurroundings({}, still, state).size(), 2u) << "nothing moves: all that is finite";
}

}  // namespace
}  // namespace dgd_demos
