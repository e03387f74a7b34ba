#include "bench/big_scene.h"

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <LinearMath/btGeometryUtil.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "plugin/triangle_grid.h"
#include "support/random.h"

namespace dgd_bench {
namespace {

using dgd_test::Random;

constexpr double kDensity = 1000;  // kg/m^3

btQuaternion Turn(const btVector3& axis, double angle) { return btQuaternion(axis, btScalar(angle)); }
btQuaternion RandomTurn(Random& random) {
  const Eigen::Vector3d axis = random.UnitVector();
  return Turn(Vec(axis.x(), axis.y(), axis.z()), random.Uniform(0, std::numbers::pi));
}

btBoxShape& MakeBox(BenchWorld& world, double x, double y, double z) { return world.Make<btBoxShape>(Vec(x, y, z)); }

/// The i-th place of a square of side * side places about the origin.
Eigen::Vector2d InGrid(int i, int side, double pitch) {
  const int row = i / side, column = i % side;
  return pitch * Eigen::Vector2d(row - 0.5 * (side - 1), column - 0.5 * (side - 1));
}

/// Eight by eight towers of boxes in the air, which spread as they rise: they fall, and topple.
void BuildBoxes(BenchWorld& world) {
  constexpr int kSide = 8, kLevels = 47;
  constexpr double kHalf = 0.5;
  world.AddGround(100);
  btBoxShape& box = MakeBox(world, kHalf, kHalf, kHalf);
  double spacing = 1.5;
  for (int level = 0; level < kLevels; ++level) {
    for (int i = 0; i < kSide * kSide; ++i) {
      const Eigen::Vector2d place = InGrid(i, kSide, spacing);
      world.Add(box, kDensity, At(Vec(place.x(), place.y(), 1 + 1.25 * level)));
    }
    spacing *= 1.01;
  }
}

void AddPyramid(BenchWorld& world, btBoxShape& box, int levels, double x, double y) {
  constexpr double kPitch = 1.02;
  for (int level = 0; level < levels; ++level) {
    const int side = levels - level;
    for (int i = 0; i < side * side; ++i) {
      const Eigen::Vector2d place = InGrid(i, side, kPitch);
      world.Add(box, kDensity, At(Vec(x + place.x(), y + place.y(), 0.5 + level)));
    }
  }
}

void AddWall(BenchWorld& world, btBoxShape& brick, int length, int levels, double x, double y) {
  for (int level = 0; level < levels; ++level) {
    for (int i = 0; i < length; ++i) {
      const double along = 2 * (i - 0.5 * (length - 1) + 0.25 * (level % 2 == 0 ? 1 : -1));
      world.Add(brick, 2 * kDensity, At(Vec(x + along, y, 0.5 + level)));
    }
  }
}

/// A ring of bricks, each level turned by half a brick.
void AddTower(BenchWorld& world, btBoxShape& brick, int bricks, int levels, double x, double y) {
  const double turn = 2 * std::numbers::pi / bricks, radius = 1.15 / std::tan(turn / 2) + 0.5;
  for (int level = 0; level < levels; ++level) {
    for (int i = 0; i < bricks; ++i) {
      const double angle = (i + 0.5 * (level % 2)) * turn;
      const btQuaternion rotation = Turn(Vec(0, 0, 1), angle + std::numbers::pi / 2);
      world.Add(brick, 2 * kDensity,
                At(Vec(x + radius * std::cos(angle), y + radius * std::sin(angle), 0.5 + level), rotation));
    }
  }
}

void BuildStacks(BenchWorld& world) {
  world.AddGround(100);
  btBoxShape &box = MakeBox(world, 0.5, 0.5, 0.5), &brick = MakeBox(world, 1, 0.5, 0.5);
  for (const double x : {-20.0, 0.0, 20.0}) AddPyramid(world, box, 8, x, -20);
  for (const double y : {-5.0, 0.0, 5.0}) AddWall(world, brick, 10, 10, 0, y);
  for (const double x : {-20.0, 0.0, 20.0}) AddTower(world, brick, 10, 10, x, 20);
}

struct Limb {
  int parent;  // In the list; -1 for the pelvis.
  double radius, length;
  std::array<double, 3> from, to;  // Ends of the capsule's axis; the joint to the parent is at `from`.
  double swing, twist;
};

void AddRagdoll(BenchWorld& world, const std::vector<btCollisionShape*>& shapes, const std::vector<Limb>& limbs,
                const btTransform& pose) {
  std::vector<btRigidBody*> bodies;
  std::vector<btTransform> poses;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const Limb& limb = limbs[i];
    const btVector3 from = Vec(limb.from[0], limb.from[1], limb.from[2]), to = Vec(limb.to[0], limb.to[1], limb.to[2]);
    const btTransform local = At((from + to) / 2, shortestArcQuat(Vec(0, 0, 1), (to - from).normalized()));
    const double mass = kDensity * std::numbers::pi * limb.radius * limb.radius * (limb.length + limb.radius);
    poses.push_back(local);
    bodies.push_back(&world.Add(*shapes[i], mass, pose * local));
    bodies.back()->setDamping(btScalar(0.05), btScalar(0.85));
    if (limb.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(limb.parent);
    // The joint's first axis is the one that it twists about: along the limb.
    const btTransform joint = At(from, shortestArcQuat(Vec(1, 0, 0), (to - from).normalized()));
    auto constraint = std::make_unique<btConeTwistConstraint>(*bodies[parent], *bodies[i],
                                                              poses[parent].inverse() * joint, local.inverse() * joint);
    constraint->setLimit(btScalar(limb.swing), btScalar(limb.swing), btScalar(limb.twist));
    world.Add(std::move(constraint));
  }
}

void BuildRagdolls(BenchWorld& world) {
  const std::vector<Limb> limbs = {{-1, 0.13, 0.2, {-0.1, 0, 1}, {0.1, 0, 1}, 0, 0},
                                   {0, 0.13, 0.25, {0, 0, 1.15}, {0, 0, 1.4}, 0.5, 0.5},
                                   {1, 0.1, 0.06, {0, 0, 1.62}, {0, 0, 1.68}, 0.5, 0.8},
                                   {0, 0.07, 0.36, {-0.15, 0, 0.9}, {-0.15, 0, 0.54}, 0.7, 0.2},
                                   {3, 0.05, 0.34, {-0.15, 0, 0.45}, {-0.15, 0, 0.11}, 0.8, 0.1},
                                   {0, 0.07, 0.36, {0.15, 0, 0.9}, {0.15, 0, 0.54}, 0.7, 0.2},
                                   {5, 0.05, 0.34, {0.15, 0, 0.45}, {0.15, 0, 0.11}, 0.8, 0.1},
                                   {1, 0.05, 0.25, {-0.22, 0, 1.42}, {-0.47, 0, 1.42}, 1.2, 0.4},
                                   {7, 0.04, 0.22, {-0.55, 0, 1.42}, {-0.77, 0, 1.42}, 1, 0.1},
                                   {1, 0.05, 0.25, {0.22, 0, 1.42}, {0.47, 0, 1.42}, 1.2, 0.4},
                                   {9, 0.04, 0.22, {0.55, 0, 1.42}, {0.77, 0, 1.42}, 1, 0.1}};
  world.AddGround(50);
  std::vector<btCollisionShape*> shapes;
  for (const Limb& limb : limbs) {
    shapes.push_back(&world.Make<btCapsuleShapeZ>(btScalar(limb.radius), btScalar(limb.length)));
  }
  Random random(3);
  constexpr int kSide = 4, kLevels = 8;
  for (int i = 0; i < kSide * kSide * kLevels; ++i) {
    const int level = i / (kSide * kSide), place = i % (kSide * kSide);
    const int row = place / kSide, column = place % kSide;
    AddRagdoll(world, shapes, limbs, At(Vec(1.2 * row, 1.2 * column, 1 + 2 * level), RandomTurn(random)));
  }
}

/// A bowl with bumps, metres.
double Landscape(double x, double y) {
  const double radius_sq = x * x + y * y;
  return 0.006 * radius_sq + 0.4 * std::sin(0.7 * x) * std::cos(0.6 * y);
}

btConvexHullShape& MakeHull(BenchWorld& world, Random& random) {
  auto& hull = world.Make<btConvexHullShape>();
  const int count = 12 + random.Below(9);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d point = random.Uniform(0.35, 0.5) * random.UnitVector();
    hull.addPoint(Vec(point.x(), point.y(), point.z()), false);
  }
  hull.recalcLocalAabb();
  return hull;
}

/// Where the i-th of many bodies starts, in layers above the landscape's middle.
btTransform InTheAir(Random& random, int i) {
  constexpr int kSide = 10;
  constexpr double kPitch = 1.6;
  const int level = i / (kSide * kSide);
  const Eigen::Vector2d place = InGrid(i % (kSide * kSide), kSide, kPitch);
  return At(Vec(place.x(), place.y(), 3 + kPitch * level), RandomTurn(random));
}

void BuildHullsOnMesh(BenchWorld& world) {
  auto& mesh = world.Make<btTriangleMesh>();
  dgd_test::AddGrid(mesh, 60, 0.8, Landscape);
  world.Add(world.Make<btBvhTriangleMeshShape>(&mesh, true), 0, At(Vec(0, 0, 0)));
  world.SetFloor(Landscape);
  Random random(5);
  std::vector<btConvexHullShape*> hulls;
  for (int i = 0; i < 20; ++i) hulls.push_back(&MakeHull(world, random));
  for (int i = 0; i < 500; ++i) world.Add(*hulls[static_cast<std::size_t>(i) % 20], 250, InTheAir(random, i));
}

void BuildMixedOnTerrain(BenchWorld& world) {
  constexpr int kSamples = 65, kMiddle = kSamples / 2;
  // In either precision Bullet reads what it calls PHY_FLOAT as its own scalar.
  auto& heights = world.Make<std::vector<btScalar>>();
  for (int j = 0; j < kSamples; ++j) {
    for (int i = 0; i < kSamples; ++i) heights.push_back(btScalar(Landscape(i - kMiddle, j - kMiddle)));
  }
  const auto [lowest, highest] = std::ranges::minmax_element(heights);
  auto& terrain = world.Make<btHeightfieldTerrainShape>(kSamples, kSamples, heights.data(), btScalar(1), *lowest,
                                                        *highest, 2, PHY_FLOAT, false);
  world.Add(terrain, 0, At(Vec(0, 0, double(*lowest + *highest) / 2)));
  world.SetFloor(Landscape);
  Random random(7);
  btBoxShape& plank = MakeBox(world, 0.5, 0.15, 0.15);
  auto& cross = world.Make<btCompoundShape>();
  cross.addChildShape(At(Vec(0, 0, 0)), &plank);
  cross.addChildShape(At(Vec(0, 0, 0), Turn(Vec(0, 0, 1), std::numbers::pi / 2)), &plank);
  const std::vector<btCollisionShape*> shapes = {&MakeBox(world, 0.4, 0.3, 0.2),
                                                 &world.Make<btSphereShape>(btScalar(0.4)),
                                                 &world.Make<btCapsuleShapeZ>(btScalar(0.25), btScalar(0.5)),
                                                 &world.Make<btCylinderShapeZ>(Vec(0.35, 0.35, 0.3)),
                                                 &world.Make<btConeShapeZ>(btScalar(0.4), btScalar(0.8)),
                                                 &MakeHull(world, random),
                                                 &cross};
  for (int i = 0; i < 500; ++i) {
    world.Add(*shapes[static_cast<std::size_t>(i) % shapes.size()], 200, InTheAir(random, i));
  }
}

/// Eight hulls in a cube, as a decomposition leaves them; eight boxes as a ring; and six boxes with two spheres as a
/// cross.
void BuildCompounds(BenchWorld& world) {
  constexpr int kChildren = 8;
  world.AddGround(50);
  Random random(19);
  auto &cube = world.Make<btCompoundShape>(), &ring = world.Make<btCompoundShape>(),
       &cross = world.Make<btCompoundShape>();
  btBoxShape &link = MakeBox(world, 0.12, 0.25, 0.15), &bar = MakeBox(world, 0.25, 0.1, 0.1);
  auto& ball = world.Make<btSphereShape>(btScalar(0.2));
  for (int i = 0; i < kChildren; ++i) {
    const auto side = [i](int bit) { return (i >> bit) % 2 == 0 ? -0.4 : 0.4; };
    cube.addChildShape(At(Vec(side(0), side(1), side(2))), &MakeHull(world, random));
    const btTransform turned = At(Vec(0, 0, 0), Turn(Vec(0, 0, 1), 2 * std::numbers::pi * i / kChildren));
    ring.addChildShape(turned * At(Vec(0.6, 0, 0)), &link);
    if (i >= 6) cross.addChildShape(At(Vec(0, i == 6 ? -0.3 : 0.3, 0.5)), &ball);
  }
  const btQuaternion to_y = Turn(Vec(0, 0, 1), std::numbers::pi / 2), to_z = Turn(Vec(0, 1, 0), std::numbers::pi / 2);
  for (const double side : {-0.35, 0.35}) {
    cross.addChildShape(At(Vec(side, 0, 0)), &bar);
    cross.addChildShape(At(Vec(0, side, 0), to_y), &bar);
    cross.addChildShape(At(Vec(0, 0, side), to_z), &bar);
  }
  const std::vector<btCollisionShape*> shapes = {&cube, &ring, &cross};
  for (int i = 0; i < 300; ++i) {
    world.Add(*shapes[static_cast<std::size_t>(i) % shapes.size()], 200, InTheAir(random, i));
  }
}

/// The cell of a point among others within a box: the planes that are nearer to it, and what they bound.
std::vector<btVector3> VoronoiCell(const std::vector<btVector3>& sites, std::size_t own, const btVector3& half,
                                   double margin) {
  constexpr std::size_t kNeighbours = 60;  // No cell has a face towards one farther away.
  std::vector<btVector3> nearest = sites;
  std::ranges::sort(nearest, {}, [&](const btVector3& site) { return site.distance2(sites[own]); });
  btAlignedObjectArray<btVector3> planes, corners;
  const auto add_plane = [&](const btVector3& normal, btScalar height) {
    btVector3 plane = normal;
    plane.setW(btScalar(margin) - height);  // The margin is added around the cell.
    planes.push_back(plane);
  };
  for (int axis = 0; axis < 3; ++axis) {
    btVector3 normal(0, 0, 0);
    normal[axis] = 1;
    add_plane(normal, half[axis]);
    add_plane(-normal, half[axis]);
  }
  for (std::size_t i = 1; i < std::min(nearest.size(), kNeighbours); ++i) {
    const btVector3 normal = (nearest[i] - sites[own]).normalized();
    add_plane(normal, normal.dot(nearest[i] + sites[own]) / 2);
  }
  btGeometryUtil::getVerticesFromPlaneEquations(planes, corners);
  std::vector<btVector3> list;
  for (int i = 0; i < corners.size(); ++i) list.push_back(corners[i]);
  return list;
}

/// A wall that is broken already, and a ball that shows it.
void BuildRubble(BenchWorld& world) {
  constexpr int kCells = 250;
  constexpr double kMargin = 0.01;
  const btVector3 half = Vec(3, 0.5, 2);
  const double volume = 8 * double(half.x() * half.y() * half.z());
  world.AddGround(200);  // The ball rolls far.
  Random random(11);
  std::vector<btVector3> sites;
  for (int i = 0; i < kCells; ++i) {
    const Eigen::Vector3d in_cube = random.InCube();
    sites.push_back(half * Vec(in_cube.x(), in_cube.y(), in_cube.z()));
  }
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const std::vector<btVector3> corners = VoronoiCell(sites, i, half, kMargin);
    if (corners.size() < 4) continue;
    btVector3 center(0, 0, 0);
    for (const btVector3& corner : corners) center += corner / btScalar(corners.size());
    auto& cell = world.Make<btConvexHullShape>();
    for (const btVector3& corner : corners) cell.addPoint(corner - center, false);
    cell.recalcLocalAabb();
    cell.setMargin(btScalar(kMargin));
    world.Add(cell, kDensity * volume / kCells, At(center + Vec(0, 0, 2)));
  }
  btRigidBody& ball = world.Add(world.Make<btSphereShape>(btScalar(0.6)), 2000, At(Vec(0.3, -8, 2)));
  ball.setLinearVelocity(Vec(0, 15, 2));
}

/// Shapes of all convex kinds, which fall into a pit.
void BuildHeap(BenchWorld& world) {
  constexpr int kBodies = 2000;
  constexpr double kPit = 9;  // Half its width.
  world.AddGround(50);
  btBoxShape &wall_x = MakeBox(world, 1, kPit + 2, 5), &wall_y = MakeBox(world, kPit + 2, 1, 5);
  for (const double side : {-1.0, 1.0}) {
    world.Add(wall_x, 0, At(Vec(side * (kPit + 1), 0, 5)));
    world.Add(wall_y, 0, At(Vec(0, side * (kPit + 1), 5)));
  }
  Random random(13);
  std::vector<btCollisionShape*> shapes = {&MakeBox(world, 0.4, 0.3, 0.2), &world.Make<btSphereShape>(btScalar(0.4)),
                                           &world.Make<btCapsuleShapeZ>(btScalar(0.25), btScalar(0.5)),
                                           &world.Make<btCylinderShapeZ>(Vec(0.35, 0.35, 0.3)),
                                           &world.Make<btConeShapeZ>(btScalar(0.4), btScalar(0.8))};
  for (int i = 0; i < 10; ++i) shapes.push_back(&MakeHull(world, random));
  for (int i = 0; i < kBodies; ++i) {
    world.Add(*shapes[static_cast<std::size_t>(i) % shapes.size()], 200, InTheAir(random, i));
  }
}

/// Hulls of their own, in layers; the more, the wider.
void BuildHullHeap(BenchWorld& world, int bodies) {
  world.AddGround(200);
  Random random(17);
  const int side = static_cast<int>(std::lround(std::cbrt(2.0 * bodies)));
  constexpr double kPitch = 1.2;
  const double half_width = kPitch * side / 2;
  btBoxShape &wall_x = MakeBox(world, 1, half_width + 2, 10), &wall_y = MakeBox(world, half_width + 2, 1, 10);
  for (const double sign : {-1.0, 1.0}) {
    world.Add(wall_x, 0, At(Vec(sign * (half_width + 1), 0, 10)));
    world.Add(wall_y, 0, At(Vec(0, sign * (half_width + 1), 10)));
  }
  for (int i = 0; i < bodies; ++i) {
    const Eigen::Vector2d place = InGrid(i % (side * side), side, kPitch);
    const double height = 1 + kPitch * (i / (side * side));
    world.Add(MakeHull(world, random), 250, At(Vec(place.x(), place.y(), height), RandomTurn(random)));
  }
}

template <int bodies>
void BuildHullHeap(BenchWorld& world) {
  BuildHullHeap(world, bodies);
}

}  // namespace

const std::vector<BigScene>& BigScenes() {
  static const std::vector<BigScene> scenes = {
      {"boxes", "3008 boxes fall as towers", BuildBoxes},
      {"stacks", "three pyramids, walls and towers of boxes, standing", BuildStacks},
      {"ragdolls", "128 ragdolls of 11 capsules fall onto each other", BuildRagdolls},
      {"hulls_on_mesh", "500 hulls of 12 to 20 points fall onto a triangle mesh", BuildHullsOnMesh},
      {"mixed_on_terrain", "500 shapes of seven types fall onto a heightfield", BuildMixedOnTerrain},
      {"compounds", "300 compounds of eight hulls, boxes or spheres fall onto each other", BuildCompounds},
      {"rubble", "a wall of 250 Voronoi cells, and a ball thrown at it", BuildRubble},
      {"heap", "2000 convex shapes of six types fall into a pit", BuildHeap},
      {"heap_1000_hulls", "1000 hulls of 12 to 20 points fall into a pit", BuildHullHeap<1000>},
      {"heap_4000_hulls", "4000 of them", BuildHullHeap<4000>},
      {"heap_8000_hulls", "8000 of them", BuildHullHeap<8000>}};
  return scenes;
}

}  // namespace dgd_bench
