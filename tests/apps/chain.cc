// A wrecking ball on a chain of hinges hits a wall of boxes; and a heavy box stands on light ones.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

/// Hinges of a chain of capsules, from a fixed point to a ball.
class HingedChain {
 public:
  HingedChain(Lab& lab, double ball_mass) : world_(lab.world()) {
    constexpr int kLinks = 6;
    constexpr double kHalfLink = 0.25, kBall = 0.5;  // m
    auto& link = lab.Make<btCapsuleShapeX>(btScalar(0.08), btScalar(0.3));
    btRigidBody* before = &lab.AddStatic(MakeCube(lab, 0.1), At(Vec(0, 0, 0)));
    btVector3 end = Vec(0, 0, 0);
    for (int i = 0; i < kLinks; ++i) {
      btRigidBody& body = lab.AddBody(link, 1, At(Vec((2 * i + 1) * kHalfLink + 0.05, 0, 0)));
      Join(*before, body, i == 0 ? Vec(0.05, 0, 0) : end, Vec(-kHalfLink, 0, 0));
      before = &body;
      end = Vec(kHalfLink, 0, 0);
    }
    auto& ball = lab.Make<btSphereShape>(btScalar(kBall));
    const double reach = kBall + 0.05;
    Join(*before, lab.AddBody(ball, ball_mass, At(Vec(2 * kLinks * kHalfLink + 0.05 + reach, 0, 0))), end,
         Vec(-reach, 0, 0));
  }
  ~HingedChain() {
    for (const auto& hinge : hinges_) world_.removeConstraint(hinge.get());
  }
  HingedChain(const HingedChain&) = delete;
  HingedChain& operator=(const HingedChain&) = delete;

  double WidestJoint() const {
    double widest = 0;
    for (const auto& it : hinges_) {
      const btVector3 a = it->getRigidBodyA().getCenterOfMassTransform() * it->getAFrame().getOrigin();
      const btVector3 b = it->getRigidBodyB().getCenterOfMassTransform() * it->getBFrame().getOrigin();
      widest = std::max(widest, double((a - b).length()));
    }
    return widest;
  }

 private:
  void Join(btRigidBody& a, btRigidBody& b, const btVector3& on_a, const btVector3& on_b) {
    hinges_.push_back(std::make_unique<btHingeConstraint>(a, b, on_a, on_b, Vec(0, 1, 0), Vec(0, 1, 0)));
    world_.addConstraint(hinges_.back().get(), true);
  }

  btDiscreteDynamicsWorld& world_;
  std::vector<std::unique_ptr<btHingeConstraint>> hinges_;
};

Case RunWreckingBall(const Conditions& conditions, double ratio, Form brick, int index) {
  constexpr double kSwingTime = 2.5;  // s
  Lab lab(conditions);
  const HingedChain chain(lab, ratio);
  const double floor = -4.8;
  lab.AddStatic(lab.Make<btBoxShape>(Vec(20, 20, 1)), At(Vec(0, 0, floor - 1)));
  btConvexShape& shape = brick == Form::kBox ? MakeCube(lab, 0.4) : lab.MakeForm(brick, 0.5);
  const double foot = FootOf(shape), x = -0.5 - 0.1 * PhaseOf(index);
  for (int row = 0; row < 4; ++row) {
    for (int column = -1; column < 2; ++column)
      lab.AddBody(shape, 1, At(Vec(x, 1.01 * column, floor + foot * (1 + 2 * row))), Surface{.friction = 0.6});
  }
  double overlap = 0, widest = 0;
  for (int step = lab.StepsIn(kSwingTime); step > 0; --step) {
    lab.Step();
    if (step * lab.dt() < kSwingTime - 0.1) overlap = std::max(overlap, DeepestOverlap(lab));
    widest = std::max(widest, chain.WidestJoint());
  }
  return {"wrecking ball",
          "wrecking ball of " + Text(ratio) + " kg at " + NameOf(brick),
          {1000 * overlap, 1000 * widest, 0, 0}};
}

/// Way, metres, and speed, m/s, of a heavy body on some light ones, that stand on the ground at an angle.
struct Sag {
  double sunk, speed;
};
Sag SagOf(const Conditions& conditions, double ratio, int count, Form form, double heading) {
  constexpr double kHalf = 0.5, kSettleTime = 1.5, kMeasureTime = 0.5;  // m, s
  Lab lab(conditions);
  lab.AddGround(Ground::kBox);
  btConvexShape& shape = form == Form::kBox ? MakeCube(lab, kHalf) : lab.MakeForm(form, kHalf);
  const double foot = FootOf(shape);
  std::vector<const btRigidBody*> bodies;
  for (int i = 0; i <= count; ++i) {
    const btTransform pose = At(Vec(0.02 * i, 0, foot * (1 + 2 * i)), Yaw(heading));
    bodies.push_back(&lab.AddBody(shape, i == count ? ratio : 1, pose, Surface{.friction = 0.6}));
  }
  lab.Run(kSettleTime);
  const double sunk = std::max(0.0, (1 + 2 * count) * foot - HeightOf(*bodies.back()));
  return {sunk, RestSpeed(lab, kMeasureTime, kHalf)};
}

/// The mean of several headings: a single tower under thirty times its weight may come down or not, by its last bits.
Case RunHeavyOnLight(const Conditions& conditions, double ratio, int count, Form form, int index) {
  constexpr int kHeadings = 4;  // As many as HeadingOf() has.
  Sag sum{};
  for (int i = 0; i < kHeadings; ++i) {
    const Sag sag = SagOf(conditions, ratio, count, form, HeadingOf(index + i));
    sum.sunk += sag.sunk;
    sum.speed += sag.speed;
  }
  return {form == Form::kBox ? "heavy on boxes" : "heavy on hulls",
          Text(ratio) + " kg on " + Text(count) + " " + NameOf(form) + " of 1 kg",
          {0, 0, 1000 * sum.sunk / kHeadings, 1000 * sum.speed / kHeadings}};
}

Cases RunChain(const Conditions& conditions) {
  // At 60 Hz Bullet's ten iterations do not carry 100 kg on two bodies of 1 kg: both collapse.
  const std::array<double, 3> ratios = {1, 10, conditions.rate < 240 ? 30.0 : 100.0};
  constexpr std::array kForms = {Form::kBox, Form::kHull};
  Cases cases;
  for (int i = 0; i < 6; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    if (!conditions.is_quick || i % 2 == i / 3)
      cases.push_back(RunWreckingBall(conditions, ratios[j % 3], kForms[j / 3], i));
    for (const int count : {1, 2}) cases.push_back(RunHeavyOnLight(conditions, ratios[j % 3], count, kForms[j / 3], i));
  }
  return cases;
}

}  // namespace

App Chain() {
  return {"chain",
          "wrecking balls of 1 to 100 kg on chains, and heavy boxes on light ones: overlaps and open joints",
          {{"deepest overlap, mm", Combine::kMean, 0.1, 2, "a blow that comes at another moment of the step"},
           {"widest joint, mm", Combine::kMean, 0.3, 5, "by how the ball rebounds, which is chance"},
           {"heavy on light: sunk, mm", Combine::kMean, 0.1, 0.5, "half a millimetre is not seen"},
           {"heavy on light: speed, mm/s", Combine::kMean, 0.1, 2, "what moves 2 mm/s falls asleep all the same"}},
          RunChain};
}

}  // namespace dgd_apps
