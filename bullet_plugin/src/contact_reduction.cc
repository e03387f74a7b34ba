#include "contact_reduction.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bullet_conversions.h"
#include "pair_motion.h"

namespace dgd_bullet {
namespace {

/// Cosine of the angle within which normals have one direction: of slopes that steeper surfaces must not displace.
constexpr double kSameDirection = 0.9;

/// How much more a point must span, in length, than one that the manifold has.
constexpr double kClearly = 1.2;

/// Least part of the spacing by which a point must widen what is spanned.
constexpr double kLeastGain = 0.1;

class Reduction {
 public:
  Reduction(std::span<const MeshContact> contacts, const dgd::PatchSettings<double>& settings, const PairMotion& motion,
            const btPersistentManifold& manifold)
      : contacts_(contacts), settings_(settings), motion_(motion) {
    FindContinued(manifold);
    for (const MeshContact& contact : contacts) middle_ += contact.on_b;
    middle_ /= static_cast<double>(contacts.size());
  }

  ReducedContacts Choose() {
    for (const bool touching : {true, false}) {
      while (kept_.size < settings_.max_points && Keep(DeepestOfNewDirection(touching))) continue;
      while (kept_.size < settings_.max_points && Keep(Widest(touching))) continue;
    }
    return kept_;
  }

 private:
  static constexpr int kNone = -1;

  /// Notes the contact that is nearest to each of the manifold's points, in body A's frame.
  void FindContinued(const btPersistentManifold& manifold) {
    const btTransform& pose_a = manifold.getBody0()->getWorldTransform();
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      const Vector3 on_a = FromBullet(pose_a * point.m_localPointA);
      const Vector3 normal = FromBullet(point.m_normalWorldOnB);
      double nearest_sq = settings_.spacing * settings_.spacing;
      int nearest = kNone;
      for (int i = 0; i < size(); ++i) {
        const MeshContact& contact = At(i);
        const double distance_sq = (contact.OnA() - on_a).squaredNorm();
        if (!(distance_sq < nearest_sq) || !(contact.normal_on_b.dot(normal) > kSameDirection)) continue;
        nearest_sq = distance_sq;
        nearest = i;
      }
      continued_[static_cast<std::size_t>(j)] = nearest;
      has_impulse_[static_cast<std::size_t>(j)] = point.m_appliedImpulse > 0;
    }
    cached_ = manifold.getNumContacts();
  }

  bool IsContinued(int i) const {
    return std::find(continued_.begin(), continued_.begin() + cached_, i) != continued_.begin() + cached_;
  }
  bool CarriedLoad(int i) const {
    for (int j = 0; j < cached_; ++j) {
      if (continued_[static_cast<std::size_t>(j)] == i && has_impulse_[static_cast<std::size_t>(j)]) return true;
    }
    return false;
  }

  /// Whether a contact touches, or will by the end of the step.
  bool Touches(int i) const {
    const MeshContact& contact = At(i);
    if (contact.separation <= settings_.equal_depth) return true;
    const double approach = motion_.Approach(contact.OnA(), -contact.normal_on_b);
    return contact.separation - approach <= settings_.equal_depth || CarriedLoad(i);
  }

  bool HasDirectionOfKept(int i) const {
    return std::any_of(kept_.indices.begin(), kept_.indices.begin() + kept_.size,
                       [&](int kept) { return At(kept).normal_on_b.dot(At(i).normal_on_b) > kSameDirection; });
  }

  bool IsApartFromKept(int i) const {
    return std::all_of(kept_.indices.begin(), kept_.indices.begin() + kept_.size, [&](int kept) {
      return (At(kept).on_b - At(i).on_b).squaredNorm() > settings_.spacing * settings_.spacing;
    });
  }

  /// The deepest contact whose direction no kept one has; of those as deep, one that the manifold has, and the one
  /// farthest out.
  int DeepestOfNewDirection(bool touching) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < size(); ++i) {
      if (At(i).separation < least && !HasDirectionOfKept(i) && Touches(i) == touching) least = At(i).separation;
    }
    int chosen = kNone;
    double best = -1;
    for (int i = 0; i < size(); ++i) {
      if (!(At(i).separation <= least + settings_.equal_depth) || HasDirectionOfKept(i) || Touches(i) != touching) {
        continue;
      }
      const double out = Weight(i) * (At(i).on_b - middle_).norm();
      if (!(out > best)) continue;
      best = out;
      chosen = i;
    }
    return chosen;
  }

  /// The contact that widens most what the kept ones span.
  int Widest(bool touching) const {
    if (kept_.size == 0) return kNone;
    double best = kLeastGain * settings_.spacing;
    int chosen = kNone;
    for (int i = 0; i < size(); ++i) {
      if (Touches(i) != touching || !IsApartFromKept(i)) continue;
      const double gain = Gain(At(i).on_b);
      if (!(gain > kLeastGain * settings_.spacing) || !(Weight(i) * gain > best)) continue;
      best = Weight(i) * gain;
      chosen = i;
    }
    return chosen;
  }

  /// Metres by which a point widens what the kept ones span: its distance from one, or from the line of two; of what
  /// four span beyond three, the part over the length of the first two.
  double Gain(const Vector3& point) const {
    const Vector3& a = Kept(0);
    if (kept_.size == 1) return (point - a).norm();
    const Vector3 along = Kept(1) - a;
    const double length = along.norm();
    // Of a point in several directions.
    if (!(length > settings_.spacing)) return (point - a).norm();
    if (kept_.size == 2) return along.cross(point - a).norm() / length;
    const Vector3 &b = Kept(1), &c = Kept(2);
    const double span =
        std::max({(a - b).cross(c - point).norm(), (a - c).cross(b - point).norm(), (a - point).cross(b - c).norm()});
    return (span - along.cross(c - a).norm()) / length;
  }

  bool Keep(int i) {
    if (i == kNone) return false;
    kept_.indices[static_cast<std::size_t>(kept_.size++)] = i;
    return true;
  }

  double Weight(int i) const { return IsContinued(i) ? kClearly : 1; }
  int size() const { return static_cast<int>(contacts_.size()); }
  const MeshContact& At(int i) const { return contacts_[static_cast<std::size_t>(i)]; }
  const Vector3& Kept(int i) const { return At(kept_.indices[static_cast<std::size_t>(i)]).on_b; }

  const std::span<const MeshContact> contacts_;
  const dgd::PatchSettings<double>& settings_;
  const PairMotion& motion_;
  Vector3 middle_ = Vector3::Zero();
  int cached_ = 0;
  std::array<int, MANIFOLD_CACHE_SIZE> continued_;  // By the manifold's points: a contact, or kNone.
  std::array<bool, MANIFOLD_CACHE_SIZE> has_impulse_;
  ReducedContacts kept_;
};

}  // namespace

ReducedContacts ReduceContacts(std::span<const MeshContact> contacts, const dgd::PatchSettings<double>& settings,
                               const PairMotion& motion, const btPersistentManifold& manifold) {
  if (contacts.empty()) return {};
  return Reduction(contacts, settings, motion, manifold).Choose();
}

}  // namespace dgd_bullet
