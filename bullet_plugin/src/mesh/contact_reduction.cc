#include "mesh/contact_reduction.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Cosine of the angle within which normals have one direction: of slopes that steeper surfaces must not displace. The
/// value is not critical: with 0.7 and 0.99, MeshContacts and HullsOnMesh pass as well.
constexpr double kSameDirection = 0.9;

/// How much more a point must span, in length, than one that the manifold has. With 1, contacts take turns, and a box
/// ends 11.3 mm deep in a real step that stops it at 10 m/s, where MeshContacts.RealStep_StopsABox allows 10.
constexpr double kClearly = 1.2;

/// Least part of the spacing by which a point must widen what is spanned. With 0, a rod on a plate's mesh creeps by 1.2
/// mm in double, where SmallBodyOnLarge.AtRestNearTheCorner_StaysThere allows 1.
constexpr double kLeastGain = 0.1;

class Reduction {
 public:
  Reduction(std::span<MeshContact> contacts, const dgd::PatchSettings<double>& settings, const PairMotion& motion,
            const btPersistentManifold& manifold)
      : contacts_(contacts), settings_(settings) {
    DGD_ASSERT(!contacts.empty() && settings.max_points <= MANIFOLD_CACHE_SIZE);
    for (MeshContact& contact : contacts) {
      contact.touches =
          contact.separation <= settings.equal_depth ||
          contact.separation - motion.Approach(contact.on_a, -contact.normal_on_b) <= settings.equal_depth;
      middle_ += contact.on_b;
    }
    FindContinued(manifold);
    middle_ /= static_cast<double>(contacts.size());
  }

  ReducedContacts Choose() {
    for (const bool touching : {true, false}) {
      while (size_ < settings_.max_points && Keep(DeepestOfNewDirection(touching))) continue;
      while (size_ < settings_.max_points && Keep(Widest(touching))) continue;
    }
    ReducedContacts reduced;
    for (; reduced.size < size_; ++reduced.size) {
      const int kept = kept_[static_cast<std::size_t>(reduced.size)];
      reduced.contacts[static_cast<std::size_t>(reduced.size)] = HasDirectionAlone(kept) ? MiddleOf(kept) : At(kept);
    }
    return reduced;
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
      for (int i = 0; i < count(); ++i) {
        const MeshContact& contact = At(i);
        const double distance_sq = (contact.on_a - on_a).squaredNorm();
        if (!(distance_sq < nearest_sq) || !(contact.normal_on_b.dot(normal) > kSameDirection)) continue;
        nearest_sq = distance_sq;
        nearest = i;
      }
      if (nearest == kNone) continue;
      contacts_[static_cast<std::size_t>(nearest)].is_continued = true;
      if (point.m_appliedImpulse > 0) contacts_[static_cast<std::size_t>(nearest)].touches = true;
    }
  }

  bool HasDirectionAlone(int i) const {
    return std::all_of(kept_.begin(), kept_.begin() + size_, [&](int kept) {
      return kept == i || !(At(kept).normal_on_b.dot(At(i).normal_on_b) > kSameDirection);
    });
  }

  /// The middle of the contacts that have the direction of this one and are as deep, on the nearest one's triangle.
  MeshContact MiddleOf(int i) const {
    const MeshContact& deepest = At(i);
    const double as_deep = deepest.separation + settings_.equal_depth;
    const auto is_among = [&](const MeshContact& contact) {
      return contact.separation <= as_deep && contact.normal_on_b.dot(deepest.normal_on_b) > kSameDirection;
    };
    // The middle of what they span, not their mean: a mesh has more corners in one place than in another.
    const Matrix3 axes = dgd::FrameAlong<double>(deepest.normal_on_b);
    const auto middle_of = [&](Vector3 MeshContact::*place) -> Vector3 {
      Vector3 low = axes.transpose() * deepest.*place, high = low;
      for (const MeshContact& contact : contacts_) {
        if (!is_among(contact)) continue;
        const Vector3 along = axes.transpose() * contact.*place;
        low = low.cwiseMin(along);
        high = high.cwiseMax(along);
      }
      return axes * ((low + high) / 2);
    };
    DGD_ASSERT(IsUnit(deepest.normal_on_b));
    MeshContact middle = deepest;
    // Of contacts ahead of touching, the two places are apart, and the body has its arm at its own.
    middle.on_a = middle_of(&MeshContact::on_a);
    middle.on_b = middle_of(&MeshContact::on_b);
    const double distance = (middle.on_a - middle.on_b).dot(middle.normal_on_b);
    middle.on_a += (middle.separation - distance) * middle.normal_on_b;
    double nearest_sq = std::numeric_limits<double>::infinity();
    for (const MeshContact& contact : contacts_) {
      const double distance_sq = (contact.on_b - middle.on_b).squaredNorm();
      if (!is_among(contact) || !(distance_sq < nearest_sq)) continue;
      nearest_sq = distance_sq;
      middle.triangle = contact.triangle;
    }
    return middle;
  }

  /// The deepest contact whose direction no kept one has; of those as deep, one that the manifold has, and the one
  /// farthest out.
  int DeepestOfNewDirection(bool touching) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count(); ++i) {
      if (At(i).separation < least && At(i).touches == touching && At(i).is_new_direction) least = At(i).separation;
    }
    if (least == std::numeric_limits<double>::infinity()) return kNone;
    int chosen = kNone;
    double best = -1;
    for (int i = 0; i < count(); ++i) {
      if (!(At(i).separation <= least + settings_.equal_depth) || At(i).touches != touching ||
          !At(i).is_new_direction) {
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
    if (size_ == 0) return kNone;
    double best = kLeastGain * settings_.spacing;
    int chosen = kNone;
    for (int i = 0; i < count(); ++i) {
      if (At(i).touches != touching || !At(i).is_apart) continue;
      const double gain = Gain(At(i).on_b);
      if (!(gain > kLeastGain * settings_.spacing) || !(Weight(i) * gain > best)) continue;
      best = Weight(i) * gain;
      chosen = i;
    }
    return chosen;
  }

  /// The length by which a point widens what the kept ones span, metres: its distance from one, or from the line of
  /// two; beyond three, the area that four span more over the length of the first two.
  double Gain(const Vector3& point) const {
    const Vector3& a = Kept(0);
    if (size_ == 1) return (point - a).norm();
    const Vector3 along = Kept(1) - a;
    const double length = along.norm();
    // One point may have contacts in several directions.
    if (!(length > settings_.spacing)) return (point - a).norm();
    if (size_ == 2) return along.cross(point - a).norm() / length;
    const Vector3 &b = Kept(1), &c = Kept(2);
    const double span =
        std::max({(a - b).cross(c - point).norm(), (a - c).cross(b - point).norm(), (a - point).cross(b - c).norm()});
    return (span - along.cross(c - a).norm()) / length;
  }

  bool Keep(int i) {
    if (i == kNone) return false;
    DGD_ASSERT(size_ < MANIFOLD_CACHE_SIZE);
    kept_[static_cast<std::size_t>(size_++)] = i;
    const MeshContact kept = At(i);
    for (MeshContact& contact : contacts_) {
      if (contact.normal_on_b.dot(kept.normal_on_b) > kSameDirection) contact.is_new_direction = false;
      if (!((contact.on_b - kept.on_b).squaredNorm() > settings_.spacing * settings_.spacing)) contact.is_apart = false;
    }
    return true;
  }

  double Weight(int i) const { return At(i).is_continued ? kClearly : 1; }
  int count() const { return static_cast<int>(contacts_.size()); }
  const MeshContact& At(int i) const {
    DGD_ASSERT(i >= 0 && i < count());
    return contacts_[static_cast<std::size_t>(i)];
  }
  const Vector3& Kept(int i) const {
    DGD_ASSERT(i >= 0 && i < size_);
    return At(kept_[static_cast<std::size_t>(i)]).on_b;
  }

  const std::span<MeshContact> contacts_;
  const dgd::PatchSettings<double>& settings_;
  Vector3 middle_ = Vector3::Zero();
  std::array<int, MANIFOLD_CACHE_SIZE> kept_{};
  int size_ = 0;  // Number of those kept.
};

}  // namespace

ReducedContacts ReduceContacts(std::span<MeshContact> contacts, const dgd::PatchSettings<double>& settings,
                               const PairMotion& motion, const btPersistentManifold& manifold) {
  if (contacts.empty()) return {};
  if (contacts.size() == 1) return {{contacts[0]}, 1};
  return Reduction(contacts, settings, motion, manifold).Choose();
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
