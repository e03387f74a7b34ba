// Materials by callback: a game in which the app, not the bodies, decides on restitution and friction.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Way { kCombine, kAdded, kProcessed };

std::string NameOf(Way way) {
  if (way == Way::kCombine) return "combining callback";
  return way == Way::kAdded ? "added callback" : "processed callback";
}

struct Material {
  btScalar restitution = 0, friction = 0;
};
Material app_material;

btScalar MaxRestitution(const btCollisionObject* first, const btCollisionObject* second) {
  return std::max(first->getRestitution(), second->getRestitution());
}
btScalar MaxFriction(const btCollisionObject* first, const btCollisionObject* second) {
  return std::max(first->getFriction(), second->getFriction());
}
void SetMaterial(btManifoldPoint& point) {
  point.m_combinedRestitution = app_material.restitution;
  point.m_combinedFriction = app_material.friction;
}
bool SetOnAdded(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*, int,
                int) {
  SetMaterial(point);
  return true;
}
bool SetOnProcessed(btManifoldPoint& point, void*, void*) {
  SetMaterial(point);
  return true;
}

/// Callbacks and a ground and body whose own material does not say what the app wants.
class MaterialLab {
 public:
  MaterialLab(const Conditions& conditions, Way way, Material material, Ground ground)
      : restitution_(gCalculateCombinedRestitutionCallback,
                     way == Way::kCombine ? MaxRestitution : gCalculateCombinedRestitutionCallback),
        friction_(gCalculateCombinedFrictionCallback,
                  way == Way::kCombine ? MaxFriction : gCalculateCombinedFrictionCallback),
        added_(gContactAddedCallback, way == Way::kAdded ? SetOnAdded : nullptr),
        processed_(gContactProcessedCallback, way == Way::kProcessed ? SetOnProcessed : nullptr),
        lab_(conditions) {
    app_material = material;
    if (way == Way::kCombine)
      body_surface_ = {.friction = double(material.friction), .restitution = double(material.restitution)};
    lab_.AddGround(ground, btTransform::getIdentity(), {}, {.friction = 0, .restitution = 0});
  }

  btRigidBody& AddBody(Form form, double half, double height, int index) {
    btConvexShape& shape = lab_.MakeForm(form, half);
    foot_ = FootOf(shape);
    const btTransform pose = At(Vec(0.23, 0.31, foot_ + height), Yaw(HeadingOf(index) + 0.2));
    btRigidBody& body = lab_.AddBody(shape, 1, pose, body_surface_);
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    return body;
  }

  Lab& lab() { return lab_; }
  double foot() const { return foot_; }

 private:
  CallbackGuard<CalculateCombinedCallback> restitution_, friction_;
  CallbackGuard<ContactAddedCallback> added_;
  CallbackGuard<ContactProcessedCallback> processed_;
  Lab lab_;
  Surface body_surface_ = {.friction = 0, .restitution = 0};
  double foot_ = 0;
};

constexpr std::array kWays = {Way::kCombine, Way::kAdded, Way::kProcessed};
constexpr std::array kForms = {Form::kSphere, Form::kBox, Form::kHull};
constexpr std::array kGroundsInTurn = {Ground::kBox, Ground::kPlane, Ground::kMesh};

/// Height of the rebound, over that of the drop, against the square of the app's restitution.
Case RunRebound(const Conditions& conditions, int index) {
  const std::size_t i = static_cast<std::size_t>(index);
  const Way way = kWays[i % 3];
  const double restitution = (i / 3) % 2 == 0 ? 1 : 0.5, height = 0.5 + 2 * PhaseOf(index);
  const Form form = kForms[(i + i / 3) % 3];
  const Ground ground = kGroundsInTurn[(i + i / 9) % 3];
  MaterialLab world(conditions, way, {btScalar(restitution), 0}, ground);
  btRigidBody& body = world.AddBody(form, 0.1, height, index);
  const double fall = std::sqrt(2 * height / kGravity);
  double top = 0;
  world.lab().Run(fall + 3 * world.lab().dt());
  for (int step = world.lab().StepsIn(1.2 * fall); step > 0; --step) {
    world.lab().Step();
    top = std::max(top, HeightOf(body) - world.foot());
  }
  return {NameOf(way),
          dgd_physics::NameOf(form) + " on " + dgd_physics::NameOf(ground) + " from " + Text(height) +
              " m, e = " + Text(restitution) + " by " + NameOf(way),
          {std::abs(top / height - restitution * restitution), 0}};
}

/// Way of a body that slides, against v^2 / (2 mu g).
Case RunSlide(const Conditions& conditions, int index) {
  const std::size_t i = static_cast<std::size_t>(index);
  const Way way = kWays[i % 3];
  const double friction = (i / 3) % 2 == 0 ? 0.5 : 0.2, speed = 2, half = 0.2;
  const Form form = i % 2 == 0 ? Form::kBox : Form::kHull;
  const Ground ground = kGroundsInTurn[(i + i / 3) % 3];
  MaterialLab world(conditions, way, {0, btScalar(friction)}, ground);
  btRigidBody& body = world.AddBody(form, half, 0, index);
  world.lab().Run(0.3);
  const btVector3 start = PositionOf(body);
  // Half a step's deceleration more, so that positions of the uniformly slowed body are the true ones.
  const double decel = friction * kGravity;
  body.setLinearVelocity(Direction(HeadingOf(index)) * btScalar(speed + 0.5 * decel * world.lab().dt()));
  world.lab().Run(1.2 * speed / decel);
  const double theory = speed * speed / (2 * decel);
  return {NameOf(way),
          dgd_physics::NameOf(form) + " on " + dgd_physics::NameOf(ground) + ", friction " + Text(friction) + " by " +
              NameOf(way),
          {0, std::abs(double((PositionOf(body) - start).length()) / theory - 1)}};
}

Cases RunMaterials(const Conditions& conditions) {
  Cases cases;
  for (const int i : SelectIndices(conditions, 36, 2)) cases.push_back(RunRebound(conditions, i));
  for (const int i : SelectIndices(conditions, 18, 2)) cases.push_back(RunSlide(conditions, i));
  return cases;
}

}  // namespace

App Materials() {
  return {"materials",
          "restitution and friction that the app sets in its callbacks: height of the rebound, way of a slide",
          {{"error of the rebound, share of the drop", Combine::kMean, 0.1, 0.005, "half a centimetre of a metre"},
           {"error of the way, share", Combine::kMean, 0.1, 0.005, "the same"}},
          RunMaterials};
}

}  // namespace dgd_apps
