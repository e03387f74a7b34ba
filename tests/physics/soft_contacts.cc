// btCollisionObject::setContactStiffnessAndDamping(): a contact that is a spring and a damper. A body at rest dips by
// m g / (n k) on n contacts of stiffness k, regardless of the step.
#include <cmath>
#include <vector>

#include "physics/lab.h"
#include "physics/resting.h"

namespace dgd_physics {
namespace {

struct Soft {
  Form form;
  Ground ground;
  double dip, half, mass;  // In theory, m; m, kg
  bool is_body_soft;       // In place of the ground.
  int index;
};

std::vector<Soft> SoftCases() {
  constexpr std::array kForms = {Form::kSphere, Form::kBox};
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh};
  // Bullet splits impulses beyond 4 cm (m_splitImpulsePenetrationThreshold), and loses the spring.
  constexpr std::array<double, 5> kDips = {0.01, 0.002, 0.03, 0.005, 0.02};  // m
  constexpr std::array<double, 3> kHalves = {0.25, 0.5, 0.15};               // m
  constexpr std::array<double, 3> kMasses = {1, 15, 0.2};                    // kg
  std::vector<Soft> cases;
  for (int i = 0; i < 24; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kForms[j % 2], kGrounds[j / 2 % 3], kDips[j % 5], kHalves[(j + j / 6) % 3],
                     kMasses[(j + j / 3) % 3], i % 4 == 3, i});
  }
  return cases;
}

Sample MeasureSoft(const Conditions& conditions, const Soft& it) {
  constexpr double kSettleTime = 3;  // s
  Lab lab(conditions);
  btRigidBody& ground = lab.AddGround(it.ground, btTransform::getIdentity(), {}, Surface{.friction = 1});
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double foot = FootOf(shape);
  btRigidBody& body = lab.AddBody(shape, it.mass, At(Vec(0.23, 0.31, foot), Yaw(HeadingOf(it.index))));
  const int contacts = it.form == Form::kBox ? 4 : 1;
  const double stiffness = it.mass * kGravity / (contacts * it.dip);
  const double damping = std::sqrt(stiffness * it.mass / contacts);  // Half of the critical.
  (it.is_body_soft ? body : ground).setContactStiffnessAndDamping(btScalar(stiffness), btScalar(damping));
  lab.Run(kSettleTime);
  return RelativeToTheory(NameOf(it.form) + " " + Text(it.half) + " m, " + Text(it.mass) + " kg on " +
                              NameOf(it.ground) + ", " + Text(stiffness) + " N/m" +
                              (it.is_body_soft ? " of the body's" : "") + ": dip, m",
                          foot - HeightOf(body), it.dip, NameOf(it.form));
}

}  // namespace

Samples MeasureSoftContacts(const Conditions& conditions) {
  return MeasureCases(conditions, SoftCases(), 5,
                      [](const Conditions& under, const Soft& it) { return MeasureSoft(under, it); });
}

}  // namespace dgd_physics
