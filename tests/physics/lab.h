// A world for experiments, with a given step, and what stands in it. Metres, kilograms, seconds; z is up.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "physics/experiment.h"
#include "plugin/test_world.h"

namespace dgd_physics {

using dgd_test::Vec;

inline constexpr double kGravity = 9.81;  // m/s^2
inline constexpr double kPi = 3.14159265358979323846;

/// Directions in the plane, radians from x: most are along no axis.
inline constexpr std::array<double, 4> kHeadings = {0, 0.4, 1.1, 2.3};
inline double HeadingOf(int index) { return kHeadings[static_cast<std::size_t>(index) % kHeadings.size()]; }
inline btVector3 Direction(double heading) { return Vec(std::cos(heading), std::sin(heading), 0); }

/// Where in the step something happens: in [0, 1), spread evenly over successive indices.
double PhaseOf(int index);

/// What a body is made of. Bullet multiplies the values of two bodies that touch.
struct Surface {
  double friction = 0.5;
  double restitution = 0;
};

/// Bodies that stand on end, on a flat face if they have one.
enum class Form {
  kSphere,
  kBox,
  kHull,
  kCylinder,
  kCapsule,
  kEqualSpheres,    ///< A rounded plate: the hull of spheres of one radius.
  kUnequalSpheres,  ///< The same plate with a larger sphere on top.
  kScaled,          ///< The hull by way of btUniformScalingShape.
  kAppShape,        ///< Of a class of the app's own (truncated_pyramid.h).
};
std::string NameOf(Form form);

/// Those that Bullet's narrowphase sees through their support function alone.
inline constexpr std::array kSupportForms = {Form::kEqualSpheres, Form::kUnequalSpheres, Form::kScaled,
                                             Form::kAppShape};
inline bool IsSupportForm(Form form) { return std::ranges::find(kSupportForms, form) != kSupportForms.end(); }

/// What bodies stand on: the plane z = 0, as each of Bullet's types.
enum class Ground { kPlane, kBox, kMesh, kHeightfield };
std::string NameOf(Ground ground);

/// Flat ground of squares. Split along one diagonal, or along both in turns.
struct Grid {
  int cells = 20;    ///< Squares along each side; even.
  double pitch = 1;  ///< Side of a square, metres.
  bool alternates = false;
};

class Lab {
 public:
  explicit Lab(const Conditions& conditions, double gravity = kGravity);

  double dt() const { return dt_; }
  /// How many steps last at least so long.
  int StepsIn(double seconds) const { return static_cast<int>(std::ceil(seconds / dt_ - 1e-9)); }
  void Step() { world_.world().stepSimulation(btScalar(dt_), 0); }
  void Run(double seconds);
  /// Runs while a kinematic body is moved by its pose, as apps do.
  /// @param pose_at  btTransform(double time): at the end of each step.
  template <class PoseAt>
  void RunMoving(btRigidBody& kinematic, double seconds, const PoseAt& pose_at) {
    const int steps = StepsIn(seconds);
    for (int step = 1; step <= steps; ++step) {
      kinematic.setWorldTransform(pose_at(step * dt_));
      Step();
    }
  }

  template <class T, class... Arguments>
  T& Make(Arguments&&... arguments) {
    return world_.Make<T>(std::forward<Arguments>(arguments)...);
  }
  /// @param half  Half the width, metres; heights differ from it.
  btConvexShape& MakeForm(Form form, double half);
  /// A regular prism with upright axis, without its margin.
  btConvexHullShape& MakePrism(int sides, double radius, double half_height, double margin);

  btRigidBody& AddBody(btCollisionShape& shape, double mass, const btTransform& pose, Surface surface = {});
  btRigidBody& AddStatic(btCollisionShape& shape, const btTransform& pose, Surface surface = {1, 1});
  /// A body moved by the app. Flagged as Bullet's manual does it, which leaves it flagged as static, too.
  btRigidBody& AddKinematic(btCollisionShape& shape, const btTransform& pose, Surface surface = {1, 1});
  /// Flat ground at z = 0 of the frame.
  btRigidBody& AddGround(Ground ground, const btTransform& frame = btTransform::getIdentity(), const Grid& grid = {},
                         Surface surface = {1, 1});

  btDiscreteDynamicsWorld& world() { return world_.world(); }
  dgd_test::TestWorld& test_world() { return world_; }

 private:
  btCollisionShape& MakeGroundShape(Ground ground, const Grid& grid);

  dgd_test::TestWorld world_;
  double dt_;
  bool in_compounds_;
};

btTransform At(const btVector3& position, const btQuaternion& rotation = btQuaternion::getIdentity());
/// Turned about z.
btQuaternion Yaw(double angle);
/// Carries z to a direction, by the shortest way.
btQuaternion FromZ(const btVector3& direction);

/// Gives a round body the velocity and the spin of one that rolls along a heading.
void SetRolling(btRigidBody& body, double radius, double speed, double heading);

/// How far a shape reaches along a direction of its own frame, margin included.
double ExtentOf(const btConvexShape& shape, const btVector3& direction);
/// How far it reaches down as it stands.
inline double FootOf(const btConvexShape& shape) { return ExtentOf(shape, Vec(0, 0, -1)); }

/// The shape that a body was made with, which may be the only child of a compound.
btCollisionShape& ShapeOf(btRigidBody& body);

inline btVector3 PositionOf(const btRigidBody& body) { return body.getWorldTransform().getOrigin(); }
/// Height of the centre of mass.
inline double HeightOf(const btRigidBody& body) { return double(body.getWorldTransform().getOrigin().z()); }
/// Kinetic energy, joules.
double KineticEnergyOf(const btRigidBody& body);
/// Angle of the body's own z axis from the world's, radians.
double TiltOf(const btRigidBody& body);
/// How much a free flight was disturbed: change of the velocity, and of the spin at a distance `half`, m/s.
double DisturbanceOf(const btRigidBody& body, const btVector3& velocity, const btVector3& spin, double half);
/// Component along a horizontal heading.
inline double Along(const btVector3& vector, double heading) { return double(vector.dot(Direction(heading))); }

/// With few digits, for the names of samples.
std::string Text(double number);

}  // namespace dgd_physics
