#include "physics/near_miss.h"

#include <cmath>
#include <vector>

#include "physics/lab.h"

namespace dgd_physics {
namespace {

enum class Rod { kCapsule, kBox };

/// Along x.
btConvexShape& MakeRod(Lab& lab, Rod rod, double half_length, double radius) {
  if (rod == Rod::kBox) return lab.Make<btBoxShape>(Vec(half_length, radius, radius));
  return lab.Make<btCapsuleShapeX>(btScalar(radius), btScalar(2 * (half_length - radius)));
}

struct NearRod {
  Rod spinning, fixed;
  double half_length, radius;  // m
  double offset;               // Of the fixed rod's axis from that of the spin, m.
  double clearance;            // m
  double spin;                 // rad/s
  int index;
};

/// A rod spins in a plane above another, which lies beside the axis of the spin or across it: spin kept in four
/// seconds.
Sample MeasureNearRod(const Conditions& conditions, const NearRod& it) {
  constexpr double kDuration = 4;  // s
  Lab lab(conditions, 0);
  const double heading = HeadingOf(it.index);
  const double below = 2 * it.radius + it.clearance;
  const btVector3 aside = Direction(heading + kPi / 2) * btScalar(it.offset);
  lab.AddStatic(MakeRod(lab, it.fixed, 2 * it.half_length, it.radius), At(aside - Vec(0, 0, below), Yaw(heading)));
  btRigidBody& body = lab.AddBody(MakeRod(lab, it.spinning, it.half_length, it.radius), 1,
                                  At(Vec(0, 0, 0), Yaw(heading + kPi / 2 + PhaseOf(it.index))), {.friction = 0.5});
  body.setAngularVelocity(Vec(0, 0, it.spin));
  lab.Run(kDuration);
  return RelativeToTheory(std::string(it.spinning == Rod::kBox ? "box" : "capsule") + " rod over " +
                              (it.fixed == Rod::kBox ? "box" : "capsule") + " rod, " + Text(it.clearance) + " m clear",
                          double(body.getAngularVelocity().z()) / it.spin, 1);
}

}  // namespace

Samples MeasureNearRod(const Conditions& conditions) {
  const std::vector<NearRod> cases = {{Rod::kCapsule, Rod::kCapsule, 0.5, 0.05, 0, 5e-4, 3, 0},
                                      {Rod::kBox, Rod::kBox, 0.5, 0.05, 0, 5e-4, 3, 1},
                                      {Rod::kCapsule, Rod::kBox, 0.5, 0.05, 0.3, 5e-4, 3, 2},
                                      {Rod::kBox, Rod::kCapsule, 0.5, 0.05, 0.2, 5e-4, 3, 3},
                                      {Rod::kBox, Rod::kBox, 1, 0.1, 0.5, 5e-4, 5, 2},
                                      {Rod::kCapsule, Rod::kCapsule, 1, 0.1, 0.6, 5e-4, 2, 1},
                                      {Rod::kBox, Rod::kBox, 0.2, 0.02, 0.1, 5e-4, 3, 3},
                                      {Rod::kCapsule, Rod::kCapsule, 0.2, 0.01, 0.05, 2e-3, 6, 0}};
  Samples samples;
  for (const NearRod& it : SelectCases(conditions, cases, 3)) samples.push_back(MeasureNearRod(conditions, it));
  return samples;
}

}  // namespace dgd_physics
