#include "physics/lab.h"

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "plugin/truncated_pyramid.h"

namespace dgd_physics {
namespace {

dgd_test::Route RouteOf(Narrowphase narrowphase) {
  return narrowphase == Narrowphase::kOurs ? dgd_test::Route::kConfiguration : dgd_test::Route::kBuiltin;
}

btTriangleMesh& AddSquares(btTriangleMesh& mesh, const Grid& grid) {
  const int middle = grid.cells / 2;
  const auto corner = [&grid, middle](int i, int j) {
    return Vec((i - middle) * grid.pitch, (j - middle) * grid.pitch, 0);
  };
  for (int i = 0; i < grid.cells; ++i) {
    for (int j = 0; j < grid.cells; ++j) {
      const bool is_falling = grid.alternates && (i + j) % 2 != 0;
      const btVector3 split = is_falling ? corner(i, j + 1) : corner(i + 1, j + 1);
      mesh.addTriangle(corner(i, j), corner(i + 1, j), split);
      mesh.addTriangle(is_falling ? corner(i + 1, j) : corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
  return mesh;
}

/// Spheres around the corners of a rectangle, which stand on the ground, and a larger one above it or not.
btMultiSphereShape& MakeSpheres(Lab& lab, double half, bool has_larger) {
  std::array<btVector3, 5> centers = {Vec(-0.7, -0.5, 0), Vec(-0.7, 0.5, 0), Vec(0.7, -0.5, 0), Vec(0.7, 0.5, 0),
                                      Vec(0, 0.1, 0.3)};
  std::array<btScalar, 5> radii = {btScalar(0.3), btScalar(0.3), btScalar(0.3), btScalar(0.3), btScalar(0.5)};
  for (btVector3& center : centers) center *= btScalar(half);
  for (btScalar& radius : radii) radius *= btScalar(half);
  return lab.Make<btMultiSphereShape>(centers.data(), radii.data(), has_larger ? 5 : 4);
}

}  // namespace

double PhaseOf(int index) {
  constexpr double kGoldenSection = 0.6180339887498949;
  const double phase = (index + 0.5) * kGoldenSection;
  return phase - std::floor(phase);
}

std::string NameOf(Form form) {
  switch (form) {
    case Form::kSphere:
      return "sphere";
    case Form::kBox:
      return "box";
    case Form::kHull:
      return "hull";
    case Form::kCylinder:
      return "cylinder";
    case Form::kCapsule:
      return "capsule";
    case Form::kEqualSpheres:
      return "equal spheres";
    case Form::kUnequalSpheres:
      return "unequal spheres";
    case Form::kScaled:
      return "scaled hull";
    default:
      return "app's own";
  }
}

std::string NameOf(Ground ground) {
  switch (ground) {
    case Ground::kPlane:
      return "plane";
    case Ground::kBox:
      return "box";
    case Ground::kMesh:
      return "mesh";
    default:
      return "heightfield";
  }
}

Lab::Lab(const Conditions& conditions, double gravity)
    : world_(RouteOf(conditions.narrowphase)), dt_(1 / conditions.rate), in_compounds_(conditions.in_compounds) {
  world().setGravity(Vec(0, 0, -gravity));
}

void Lab::Run(double seconds) {
  for (int step = StepsIn(seconds); step > 0; --step) Step();
}

btConvexShape& Lab::MakeForm(Form form, double half) {
  switch (form) {
    case Form::kSphere:
      return Make<btSphereShape>(btScalar(half));
    case Form::kBox:
      return Make<btBoxShape>(Vec(half, 0.8 * half, 0.6 * half));
    case Form::kHull:
      return MakePrism(6, 0.9 * half, 0.6 * half, 0.1 * half);
    case Form::kCylinder:
      return Make<btCylinderShapeZ>(Vec(half, half, 0.6 * half));
    case Form::kCapsule:
      return Make<btCapsuleShapeZ>(btScalar(0.6 * half), btScalar(0.8 * half));
    case Form::kEqualSpheres:
      return MakeSpheres(*this, half, false);
    case Form::kUnequalSpheres:
      return MakeSpheres(*this, half, true);
    case Form::kScaled: {
      constexpr double kScale = 1.5;
      btConvexShape& hull = MakeForm(Form::kHull, half / kScale);
      return Make<btUniformScalingShape>(&hull, btScalar(kScale));
    }
    default:
      return Make<dgd_test::TruncatedPyramid>(Vec(0.8 * half, 0.6 * half, 0.4 * half), 0.1 * half);
  }
}

btConvexHullShape& Lab::MakePrism(int sides, double radius, double half_height, double margin) {
  auto& hull = Make<btConvexHullShape>();
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * (i + 0.5) / sides;
    for (const double z : {-half_height, half_height}) {
      hull.addPoint(Vec(radius * std::cos(angle), radius * std::sin(angle), z), false);
    }
  }
  hull.recalcLocalAabb();
  hull.setMargin(btScalar(margin));
  return hull;
}

btRigidBody& Lab::AddBody(btCollisionShape& shape, double mass, const btTransform& pose, Surface surface) {
  btRigidBody& body = world_.Add(shape, mass, pose);
  if (in_compounds_ && shape.isConvex()) {
    auto& compound = Make<btCompoundShape>();
    compound.addChildShape(btTransform::getIdentity(), &shape);
    body.setCollisionShape(&compound);  // The child's moment of inertia stays; a compound's own is that of a box.
  }
  body.setFriction(btScalar(surface.friction));
  body.setRestitution(btScalar(surface.restitution));
  body.setActivationState(DISABLE_DEACTIVATION);
  return body;
}

btRigidBody& Lab::AddStatic(btCollisionShape& shape, const btTransform& pose, Surface surface) {
  return AddBody(shape, 0, pose, surface);
}

btRigidBody& Lab::AddKinematic(btCollisionShape& shape, const btTransform& pose, Surface surface) {
  btRigidBody& body = AddStatic(shape, pose, surface);
  body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  return body;
}

btRigidBody& Lab::AddGround(Ground ground, const btTransform& frame, const Grid& grid, Surface surface) {
  constexpr double kHalfDepth = 1;  // Of a box.
  btTransform pose = frame;
  if (ground == Ground::kBox) pose = frame * At(Vec(0, 0, -kHalfDepth));
  return AddStatic(MakeGroundShape(ground, grid), pose, surface);
}

btCollisionShape& Lab::MakeGroundShape(Ground ground, const Grid& grid) {
  const double half_width = 0.5 * grid.cells * grid.pitch;
  switch (ground) {
    case Ground::kPlane:
      return Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0));
    case Ground::kBox:
      return Make<btBoxShape>(Vec(half_width, half_width, 1));
    case Ground::kMesh:
      return Make<btBvhTriangleMeshShape>(&AddSquares(Make<btTriangleMesh>(), grid), true);
    default:
      break;
  }
  const int corners = grid.cells + 1;
  auto& heights = Make<std::vector<float>>(static_cast<std::size_t>(corners * corners), 0.0F);
  auto& field = Make<btHeightfieldTerrainShape>(corners, corners, heights.data(), btScalar(-1), btScalar(1), 2, false);
  field.setLocalScaling(Vec(grid.pitch, grid.pitch, 1));
  field.setUseDiamondSubdivision(grid.alternates);
  return field;
}

btCollisionShape& ShapeOf(btRigidBody& body) {
  btCollisionShape& shape = *body.getCollisionShape();
  return shape.isCompound() ? *static_cast<btCompoundShape&>(shape).getChildShape(0) : shape;
}

btTransform At(const btVector3& position, const btQuaternion& rotation) { return btTransform(rotation, position); }

btQuaternion Yaw(double angle) { return {Vec(0, 0, 1), btScalar(angle)}; }

btQuaternion FromZ(const btVector3& direction) { return shortestArcQuat(Vec(0, 0, 1), direction); }

void SetRolling(btRigidBody& body, double radius, double speed, double heading) {
  body.setLinearVelocity(Direction(heading) * btScalar(speed));
  body.setAngularVelocity(Vec(0, 0, 1).cross(Direction(heading)) * btScalar(speed / radius));
}

double ExtentOf(const btConvexShape& shape, const btVector3& direction) {
  return double(shape.localGetSupportingVertex(direction).dot(direction));
}

double KineticEnergyOf(const btRigidBody& body) {
  const btVector3 spin = body.getAngularVelocity() * body.getWorldTransform().getBasis();  // Body frame.
  double energy = 0.5 / double(body.getInvMass()) * double(body.getLinearVelocity().length2());
  for (int axis = 0; axis < 3; ++axis) {
    energy += 0.5 * double(spin[axis]) * double(spin[axis]) / double(body.getInvInertiaDiagLocal()[axis]);
  }
  return energy;
}

double TiltOf(const btRigidBody& body) {
  const btVector3 axis = body.getWorldTransform().getBasis().getColumn(2);
  return std::atan2(std::hypot(double(axis.x()), double(axis.y())), double(axis.z()));
}

double DisturbanceOf(const btRigidBody& body, const btVector3& velocity, const btVector3& spin, double half) {
  return std::hypot(double((body.getLinearVelocity() - velocity).length()),
                    half * double((body.getAngularVelocity() - spin).length()));
}

std::string Text(double number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", number);
  return text.data();
}

}  // namespace dgd_physics
