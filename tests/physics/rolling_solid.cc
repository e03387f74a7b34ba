#include "physics/rolling_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgd_physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTouching = 1e-7;  // m

class Rolling {
 public:
  Rolling(const Solid& solid, const SolidMotion& motion, const Vector3d& gravity, double friction)
      : solid_(solid), gravity_(gravity), friction_(friction), now_(motion), impulses_(solid.corners.size()) {
    std::ranges::fill(impulses_, Vector3d::Zero());
  }

  /// As far as the next impact, at most `most` seconds. How far it came.
  double Advance(double most) {
    double step = most;
    for (int i = 0; i < kMostCuts; ++i) {
      const SolidMotion next = Moved(Accelerated(step), step);
      const double cut = CutAtImpact(next, step);
      if (cut >= step || i == kMostCuts - 1) {
        now_ = next;
        break;
      }
      step = cut;
    }
    return step;
  }
  const SolidMotion& now() const { return now_; }

 private:
  static constexpr int kMostCuts = 5;
  static constexpr double kLeastStep = 1e-9;  // s

  struct Contact {
    std::size_t corner;
    Vector3d arm;
    double gap;
    Vector3d mass;  // Inverse effective, along the axes.
  };

  double GapOf(const Vector3d& position, const Matrix3d& basis, std::size_t corner) const {
    return position.z() + basis.row(2).dot(solid_.corners[corner]) - solid_.margin;
  }

  /// With the velocities at the end of a step.
  SolidMotion Accelerated(double step) {
    const Matrix3d basis = now_.rotation.toRotationMatrix();
    const Matrix3d inertia = basis * solid_.inertia.asDiagonal() * basis.transpose();
    inverse_inertia_ = basis * solid_.inertia.cwiseInverse().asDiagonal() * basis.transpose();
    SolidMotion motion = now_;
    motion.velocity += gravity_ * step;
    motion.spin -= inverse_inertia_ * now_.spin.cross(inertia * now_.spin) * step;
    FindContacts(basis);
    SolveContacts(motion, step);
    return motion;
  }

  void FindContacts(const Matrix3d& basis) {
    contacts_.clear();
    for (std::size_t i = 0; i < solid_.corners.size(); ++i) {
      const double gap = GapOf(now_.position, basis, i);
      if (gap > kTouching) {
        impulses_[i].setZero();
        continue;
      }
      const Vector3d arm = basis * solid_.corners[i] - solid_.margin * Vector3d::UnitZ();
      Vector3d mass;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d turn = arm.cross(Vector3d::Unit(axis));
        mass[axis] = 1 + turn.dot(inverse_inertia_ * turn);
      }
      contacts_.push_back({i, arm, gap, mass});
    }
  }

  void Push(SolidMotion& motion, const Contact& contact, const Vector3d& impulse) const {
    motion.velocity += impulse;
    motion.spin += inverse_inertia_ * contact.arm.cross(impulse);
  }
  static Vector3d VelocityAt(const SolidMotion& motion, const Contact& contact) {
    return motion.velocity + motion.spin.cross(contact.arm);
  }

  /// Projected Gauss-Seidel, from the last step's impulses, until they do not change.
  void SolveContacts(SolidMotion& motion, double dt) {
    constexpr int kMostRounds = 300;
    constexpr double kConverged = 1e-7;  // m/s
    for (const Contact& contact : contacts_) Push(motion, contact, impulses_[contact.corner]);
    for (int round = 0; round < kMostRounds; ++round) {
      double change = 0;
      for (const Contact& contact : contacts_) change = std::max(change, Solve(motion, contact, dt));
      if (change < kConverged) break;
    }
  }
  double Solve(SolidMotion& motion, const Contact& contact, double dt) {
    Vector3d& total = impulses_[contact.corner];
    const Vector3d before = total;
    const double allowed = -std::max(0.0, contact.gap) / dt;
    total.z() = std::max(0.0, total.z() - (VelocityAt(motion, contact).z() - allowed) / contact.mass.z());
    Push(motion, contact, (total.z() - before.z()) * Vector3d::UnitZ());
    const Vector3d slip = VelocityAt(motion, contact);
    total.head<2>() -= slip.head<2>().cwiseQuotient(contact.mass.head<2>());
    const double most = friction_ * total.z(), length = total.head<2>().norm();
    if (length > most) total.head<2>() *= most / length;
    Push(motion, contact, {total.x() - before.x(), total.y() - before.y(), 0});
    return (total - before).norm();
  }

  static SolidMotion Moved(SolidMotion motion, double step) {
    motion.position += step * motion.velocity;
    const double angle = step * motion.spin.norm();
    if (angle > 0) motion.rotation = Eigen::AngleAxisd(angle, motion.spin.normalized()) * motion.rotation;
    motion.rotation.normalize();
    return motion;
  }

  /// When the first corner that was above the plane comes down to it, on its way to `next`; `step` if none does.
  double CutAtImpact(const SolidMotion& next, double step) const {
    const Matrix3d before = now_.rotation.toRotationMatrix(), after = next.rotation.toRotationMatrix();
    double cut = step;
    for (std::size_t i = 0; i < solid_.corners.size(); ++i) {
      const double end = GapOf(next.position, after, i);
      if (end >= -kTouching) continue;
      const double begin = GapOf(now_.position, before, i);
      if (begin > kTouching) cut = std::min(cut, step * begin / (begin - end));
    }
    return std::max(cut, kLeastStep);
  }

  const Solid& solid_;
  Vector3d gravity_;
  double friction_;
  SolidMotion now_;
  Matrix3d inverse_inertia_;
  std::vector<Contact> contacts_;
  std::vector<Vector3d> impulses_;
};

}  // namespace

SolidMotion RollOnLowestCorner(const Solid& solid, const Eigen::Quaterniond& rotation, const Vector3d& heading,
                               double speed) {
  Vector3d lowest = Vector3d::Constant(std::numeric_limits<double>::infinity());
  for (const Vector3d& corner : solid.corners) {
    const Vector3d turned = rotation * corner;
    if (turned.z() < lowest.z()) lowest = turned;
  }
  const Vector3d from_ground = solid.margin * Vector3d::UnitZ() - lowest;
  SolidMotion motion{Vector3d(0, 0, from_ground.z()), rotation};
  motion.spin = Vector3d::UnitZ().cross(heading) * speed / from_ground.z();
  motion.velocity = motion.spin.cross(from_ground);
  return motion;
}

SolidMotion Integrate(const Solid& solid, SolidMotion motion, const Vector3d& gravity, double friction, double seconds,
                      double dt) {
  Rolling rolling(solid, motion, gravity, friction);
  for (double time = 0; time < seconds;) time += rolling.Advance(std::min(dt, seconds - time));
  return rolling.now();
}

}  // namespace dgd_physics
