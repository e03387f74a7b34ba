// What apps set: PyBullet's server m_erp2 = 0.08, SimBenchmark 0, others a slop, no split impulse, another solver, or
// multibodies in place of rigid bodies. Newton's law of restitution, and rest, depend on none of it.
#include "physics/solver_settings.h"

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "physics/lab.h"
#include "physics/multibody_world.h"

namespace dgd_physics {
namespace {

enum class Setting { kErp0, kErp008, kErp02, kErp08, kSlop, kNoSplit, kThreshold0, kMlcp, kNncg, kMultibody };
constexpr std::array kSettings = {Setting::kErp0, Setting::kErp008,   Setting::kErp02,      Setting::kErp08,
                                  Setting::kSlop, Setting::kNoSplit,  Setting::kThreshold0, Setting::kMlcp,
                                  Setting::kNncg, Setting::kMultibody};

std::string NameOf(Setting setting) {
  constexpr std::array kNames = {"erp2 0",   "erp2 0.08",         "erp2 0.2", "erp2 0.8", "slop of 1 mm",
                                 "no split", "split threshold 0", "MLCP",     "NNCG",     "multibodies"};
  return kNames[static_cast<std::size_t>(setting)];
}

void Apply(Lab& lab, Setting setting) {
  btContactSolverInfo& info = lab.world().getSolverInfo();
  switch (setting) {
    case Setting::kErp0:
      info.m_erp2 = 0;
      break;
    case Setting::kErp008:
      info.m_erp2 = btScalar(0.08);
      break;
    case Setting::kErp08:
      info.m_erp2 = btScalar(0.8);
      break;
    case Setting::kSlop:
      info.m_linearSlop = btScalar(0.001);
      break;
    case Setting::kNoSplit:
      info.m_splitImpulse = 0;
      break;
    case Setting::kThreshold0:
      info.m_splitImpulsePenetrationThreshold = 0;
      break;
    case Setting::kMlcp:
      lab.world().setConstraintSolver(&lab.Make<btMLCPSolver>(&lab.Make<btDantzigSolver>()));
      break;
    case Setting::kNncg:
      lab.world().setConstraintSolver(&lab.Make<btNNCGConstraintSolver>());
      break;
    default:
      break;
  }
}

/// What a ball or a box falls on.
enum class Floor { kCompound, kPlane, kBox, kMesh };

struct Fall {
  Setting setting;
  Floor floor;
  bool is_ball;
  double half, height;  // m
  double restitution;
  int index;

  std::string Name() const {
    constexpr std::array kFloors = {"compound", "plane", "box", "mesh"};
    return NameOf(setting) + ": " + (is_ball ? "ball " : "box ") + Text(half) + " m on " +
           kFloors[static_cast<std::size_t>(floor)] + " from " + Text(height) + " m, e " + Text(restitution);
  }
};

/// A rigid body over a floor, or a multibody of a base alone.
class FallingBody {
 public:
  FallingBody(const Conditions& conditions, const Fall& it) : lab_(conditions) {
    Apply(lab_, it.setting);
    btRigidBody& floor = AddFloor(it.floor);
    auto& shape = it.is_ball ? static_cast<btConvexShape&>(lab_.Make<btSphereShape>(btScalar(it.half)))
                             : lab_.Make<btBoxShape>(Vec(it.half, it.half, it.half));
    const btTransform pose = At(Vec(0.23, 0.31, it.half + it.height), Yaw(HeadingOf(it.index)));
    const Surface surface = {.friction = 0.5, .restitution = it.restitution};
    if (it.setting != Setting::kMultibody) {
      body_ = &lab_.AddBody(shape, 1, pose, surface);
      return;
    }
    multibodies_.emplace(conditions);
    multibodies_->AddStatic(*floor.getCollisionShape(), floor.getWorldTransform(), {1, 1});
    multibody_ = &multibodies_->AddBase(shape, 1, pose, surface);
  }

  Lab& lab() { return lab_; }
  void Step() {
    if (multibodies_) {
      multibodies_->Step();
    } else {
      lab_.Step();
    }
  }
  double Height() const { return multibody_ != nullptr ? double(multibody_->getBasePos().z()) : HeightOf(*body_); }
  btVector3 Velocity() const { return multibody_ != nullptr ? multibody_->getBaseVel() : body_->getLinearVelocity(); }
  btVector3 Spin() const { return multibody_ != nullptr ? multibody_->getBaseOmega() : body_->getAngularVelocity(); }

 private:
  /// Its top is z = 0.
  btRigidBody& AddFloor(Floor floor) {
    if (floor == Floor::kPlane) return lab_.AddGround(Ground::kPlane);
    if (floor == Floor::kBox) return lab_.AddGround(Ground::kBox);
    if (floor == Floor::kMesh) return lab_.AddGround(Ground::kMesh);
    // As PyBullet's ground planes: a box with an origin of its own.
    auto& compound = lab_.Make<btCompoundShape>();
    compound.addChildShape(At(Vec(0, 0, -5)), &lab_.Make<btBoxShape>(Vec(15, 15, 5)));
    return lab_.AddStatic(compound, At(Vec(0, 0, 0)));
  }

  Lab lab_;  // Owns the shapes.
  std::optional<MultibodyWorld> multibodies_;
  btRigidBody* body_ = nullptr;
  btMultiBody* multibody_ = nullptr;
};

/// Greatest height after the third rebound, over that of the drop.
Sample MeasureThirdRebound(const Conditions& conditions, const Fall& it) {
  constexpr int kRebounds = 3;
  FallingBody falling(conditions, it);
  const double fall_time = std::sqrt(2 * it.height / kGravity);
  int rebounds = 0;
  double top = 0;
  bool was_rising = false;
  for (int step = falling.lab().StepsIn(fall_time * 8); step > 0; --step) {
    falling.Step();
    const bool is_rising = falling.Velocity().z() > 0;
    if (is_rising && !was_rising) ++rebounds;
    if (rebounds >= kRebounds) top = std::max(top, falling.Height() - it.half);
    if (rebounds >= kRebounds && !is_rising) break;
    was_rising = is_rising;
  }
  return RelativeToTheory(it.Name() + ": height of the third rebound", top,
                          it.height * std::pow(it.restitution, 2 * kRebounds), NameOf(it.setting));
}

/// After a drop without restitution: speed over 5 cm/s as in `rest`, and height over that of the drop.
Samples MeasureSettled(const Conditions& conditions, const Fall& it) {
  constexpr double kSettleTime = 1, kAtRest = 0.05;  // s, after the impact; m/s
  FallingBody falling(conditions, it);
  for (int step = falling.lab().StepsIn(std::sqrt(2 * it.height / kGravity) + kSettleTime); step > 0; --step)
    falling.Step();
  const double speed = std::hypot(double(falling.Velocity().length()), it.half * double(falling.Spin().length()));
  return {Sample{it.Name() + ": speed at rest, m/s", speed, 0, kAtRest, NameOf(it.setting)},
          Sample{it.Name() + ": height at rest, m", falling.Height() - it.half, 0, it.height, NameOf(it.setting)}};
}

/// Each setting over each floor; in a quick run over one.
std::vector<Fall> FallCases(const Conditions& conditions) {
  constexpr std::array kFloors = {Floor::kCompound, Floor::kPlane, Floor::kBox, Floor::kMesh};
  constexpr std::array<double, 3> kHeights = {1, 2.5, 0.5};    // m
  constexpr std::array<double, 3> kHalves = {0.1, 0.25, 0.5};  // m
  constexpr std::array<double, 3> kRestitutions = {1, 0.8, 0.9};
  std::vector<Fall> cases;
  for (const Setting setting : kSettings) {
    for (const int round : SelectIndices(conditions, 4, 4)) {
      const int i = static_cast<int>(setting) + 3 * round;
      const std::size_t j = static_cast<std::size_t>(i);
      const double height = kHeights[j % 3] * (1 + 0.05 * PhaseOf(i));
      cases.push_back(
          {setting, kFloors[j % 4], round % 2 == 1, kHalves[(j + j / 4) % 3], height, kRestitutions[j / 2 % 3], i});
    }
  }
  return cases;
}

}  // namespace

Samples MeasureReboundSettings(const Conditions& conditions) {
  Samples samples;
  for (Fall fall : FallCases(conditions)) {
    fall.is_ball = true;
    samples.push_back(MeasureThirdRebound(conditions, fall));
  }
  return samples;
}

Samples MeasureRestSettings(const Conditions& conditions) {
  Samples samples;
  for (Fall fall : FallCases(conditions)) {
    fall.restitution = 0;
    AddTo(samples, MeasureSettled(conditions, fall));
  }
  return samples;
}

}  // namespace dgd_physics
