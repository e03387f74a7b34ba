#include "manifold/manifold_writer.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "bound_part.h"
#include "dgd/assert.h"
#include "dgd_bullet/options.h"
#include "finite_result.h"
#include "manifold/contact_materials.h"
#include "manifold/continued_contacts.h"
#include "manifold/finishing.h"
#include "manifold/friction_anchors.h"
#include "manifold/mesh_triangle.h"
#include "shapes/shape_identity.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// The numbers of parts and triangles that a result gives new points, for which Bullet has no other use.
class Identifiers : public btManifoldResult {
 public:
  /// @param is_swapped  Whether the manifold's first body is the result's second.
  static void Apply(const btManifoldResult& output, bool is_swapped, btManifoldPoint& point) {
    point.m_partId0 = output.*(is_swapped ? &Identifiers::m_partId1 : &Identifiers::m_partId0);
    point.m_partId1 = output.*(is_swapped ? &Identifiers::m_partId0 : &Identifiers::m_partId1);
    point.m_index0 = output.*(is_swapped ? &Identifiers::m_index1 : &Identifiers::m_index0);
    point.m_index1 = output.*(is_swapped ? &Identifiers::m_index0 : &Identifiers::m_index1);
  }
};

/// Writes points as btManifoldResult::addContactPoint() leaves them, new ones and those that it continues.
class PointWriter {
 public:
  /// @param anchor_time_step  Seconds, for friction anchors; 0 without them.
  PointWriter(btScalar anchor_time_step, btManifoldResult& output)
      : output_(output),
        manifold_(*output.getPersistentManifold()),
        is_swapped_(manifold_.getBody0() != output.getBody0Internal()),
        pose_a_(manifold_.getBody0()->getWorldTransform()),
        pose_b_(manifold_.getBody1()->getWorldTransform()),
        anchors_(manifold_, anchor_time_step),
        materials_(*WrapperA().getCollisionObject(), *WrapperB().getCollisionObject()),
        is_user_callback_(gContactAddedCallback != nullptr &&
                          HasFlag(*WrapperA().getCollisionObject(), *WrapperB().getCollisionObject(),
                                  btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK)) {}

  void Update(const ManifoldContact& contact, const btVector3& on_a_in_body, btManifoldPoint& point) {
    const bool is_anchored = anchors_.CanAnchor(point);
    const btVector3 slip = is_anchored ? anchors_.SlipOf(point) : btVector3(0, 0, 0);
    Fill(contact, on_a_in_body, point);
    // An app's callbacks alone set these.
    point.m_contactPointFlags = 0;
    point.m_contactMotion1 = point.m_contactMotion2 = 0;
    point.m_contactCFM = point.m_contactERP = point.m_frictionCFM = 0;
    materials_.ApplyTo(point);
    Show(contact, point);
    if (is_anchored) anchors_.Anchor(point, slip);
  }

  /// @param place  Index of a stale point, or the number of points.
  void Add(const ManifoldContact& contact, const btVector3& on_a_in_body, int place) {
    btManifoldPoint point(on_a_in_body, {}, contact.normal_on_b, contact.separation);
    Fill(contact, on_a_in_body, point);
    Identifiers::Apply(output_, is_swapped_, point);
    materials_.ApplyTo(point);
    DGD_ASSERT(place >= 0 && place <= manifold_.getNumContacts() && place < MANIFOLD_CACHE_SIZE);
    const bool is_first = manifold_.getNumContacts() == 0;
    if (place == manifold_.getNumContacts()) {
      // Bullet's predictive contacts may be farther apart than the breaking threshold.
      constexpr bool kIsPredictive = true;
      manifold_.addManifoldPoint(point, kIsPredictive);
    } else {
      manifold_.clearUserCache(manifold_.getContactPoint(place));
      manifold_.getContactPoint(place) = point;
    }
    Show(contact, manifold_.getContactPoint(place));
    if (is_first && gContactStartedCallback != nullptr) gContactStartedCallback(&manifold_);
  }

 private:
  const btCollisionObjectWrapper& WrapperA() const {
    return is_swapped_ ? *output_.getBody1Wrap() : *output_.getBody0Wrap();
  }
  const btCollisionObjectWrapper& WrapperB() const {
    return is_swapped_ ? *output_.getBody0Wrap() : *output_.getBody1Wrap();
  }

  /// Sets the geometry of a point.
  void Fill(const ManifoldContact& contact, const btVector3& on_a_in_body, btManifoldPoint& point) {
    DGD_ASSERT(std::abs(contact.normal_on_b.length2() - 1) <= btScalar(1e-3));
    // All contacts of a manifold have the same normal, most often.
    if (!(contact.normal_on_b == normal_)) {
      normal_ = contact.normal_on_b;
      btPlaneSpace1(normal_, lateral_1_, lateral_2_);
    }
    point.m_localPointA = on_a_in_body;
    point.m_localPointB = pose_b_.invXform(contact.on_b);
    point.m_positionWorldOnA = contact.on_a;
    point.m_positionWorldOnB = contact.on_b;
    point.m_normalWorldOnB = normal_;
    point.m_lateralFrictionDir1 = lateral_1_;
    point.m_lateralFrictionDir2 = lateral_2_;
    point.m_distance1 = contact.separation;
  }

  /// Sets the point's triangle, and calls an app's callback.
  void Show(const ManifoldContact& contact, btManifoldPoint& point) const {
    if (contact.triangle == nullptr) {
      if (is_user_callback_) Call(WrapperA(), WrapperB(), point);
      return;
    }
    // A mesh is the second body in either order of the call.
    point.m_partId1 = contact.triangle->part;
    point.m_index1 = contact.triangle->index;
    if (!is_user_callback_) return;
    const TriangleBody triangle(*contact.triangle, WrapperB());
    Call(WrapperA(), triangle.wrapper(), point);
  }

  void Call(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, btManifoldPoint& point) const {
    const btScalar distance = point.m_distance1;
    gContactAddedCallback(point, &a, point.m_partId0, point.m_index0, &b, point.m_partId1, point.m_index1);
    // Bullet's refresh, which comes after the callbacks, makes the distance that of the point's places.
    if (point.m_distance1 == distance) return;
    point.m_distance1 = (pose_a_(point.m_localPointA) - pose_b_(point.m_localPointB)).dot(point.m_normalWorldOnB);
  }

  btManifoldResult& output_;
  btPersistentManifold& manifold_;
  const bool is_swapped_;
  const btTransform &pose_a_, &pose_b_;  // Poses of the bodies.
  const FrictionAnchors anchors_;
  const ContactMaterials materials_;
  const bool is_user_callback_;
  btVector3 normal_{0, 0, 0}, lateral_1_, lateral_2_;  // Directions of the last contact.
};

/// Bullet refuses points beyond the breaking threshold: speculative ones need it raised until they have passed.
class RaisedThreshold {
 public:
  RaisedThreshold(std::span<const ManifoldContact> contacts, btPersistentManifold& manifold)
      : manifold_(manifold), threshold_(manifold.getContactBreakingThreshold()) {
    // Roundoff must not put a point beyond its own threshold, nor its distance after a refresh.
    constexpr btScalar kSlack = btScalar(1.001);
    btScalar farthest = threshold_;
    for (const ManifoldContact& contact : contacts) farthest = btMax(kSlack * contact.separation, farthest);
    manifold.setContactBreakingThreshold(farthest);
  }
  ~RaisedThreshold() { manifold_.setContactBreakingThreshold(threshold_); }
  RaisedThreshold(const RaisedThreshold&) = delete;
  RaisedThreshold& operator=(const RaisedThreshold&) = delete;

 private:
  btPersistentManifold& manifold_;
  const btScalar threshold_;
};

void WriteInPlace(std::span<const ManifoldContact> contacts, btScalar anchor_time_step, btManifoldResult& output) {
  DGD_ASSERT(contacts.size() <= MANIFOLD_CACHE_SIZE);
  btPersistentManifold& manifold = *output.getPersistentManifold();
  ContinuedContacts continued(contacts, manifold);
  bool has_stale = continued.DropStale(manifold);
  PointWriter writer(contacts.size() >= std::size_t{kMinAnchors} ? anchor_time_step : 0, output);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int point = continued.PointOf(i);
    if (point != ContinuedContacts::kNew) {
      writer.Update(contacts[i], continued.OnAInBody(i), manifold.getContactPoint(point));
    } else {
      writer.Add(contacts[i], continued.OnAInBody(i), has_stale ? 0 : manifold.getNumContacts());
      has_stale = false;
    }
  }
  CountStep(manifold);
}

/// Adds contacts through addContactPoint(), which updates the points that they continue.
void AddThroughBullet(std::span<const ManifoldContact> contacts, btManifoldResult& output) {
  if (!AreBodiesRepresentable(output)) return;
  const btCollisionObjectWrapper* mesh = output.getBody0Wrap();
  if (mesh->getCollisionObject() != output.getPersistentManifold()->getBody1()) mesh = output.getBody1Wrap();
  for (const ManifoldContact& contact : contacts) {
    if (!IsRepresentable(contact.on_b, contact.separation)) continue;
    if (contact.triangle == nullptr) {
      output.addContactPoint(contact.normal_on_b, contact.on_b, contact.separation);
    } else {
      const TriangleBody triangle(*contact.triangle, *mesh);
      const BoundPart bound(output, triangle.wrapper());
      output.addContactPoint(contact.normal_on_b, contact.on_b, contact.separation);
    }
  }
}

void WriteThroughBullet(std::span<const ManifoldContact> contacts, bool drop_stale, btManifoldResult& output) {
  btPersistentManifold& manifold = *output.getPersistentManifold();
  std::optional<btVector3> stale;
  if (drop_stale && ContinuedContacts(contacts, manifold).DropStale(manifold)) {
    stale = manifold.getContactPoint(0).m_localPointA;
  }
  const RaisedThreshold threshold(contacts, manifold);
  AddThroughBullet(contacts, output);
  const int last = manifold.getNumContacts() - 1;
  if (stale && last > 0 && manifold.getContactPoint(0).m_localPointA == *stale) {
    for (int i = 0; i < last; ++i) std::swap(manifold.getContactPoint(i), manifold.getContactPoint(i + 1));
    manifold.removeContactPoint(last);
  }
  output.refreshContactPoints();
  DropPointsNotFinite(manifold);
}

/// A patch in Bullet's precision.
class BulletPatch {
 public:
  BulletPatch(const dgd::ContactPatch<double>& patch, const Vector3& normal)
      : size_(static_cast<std::size_t>(patch.size)) {
    DGD_ASSERT(patch.size >= 0 && size_ <= contacts_.size() && (size_ == 0 || IsUnit(normal)));
    const btVector3 normal_on_b = ToBullet(-normal);
    for (std::size_t i = 0; i < size_; ++i) {
      const dgd::ContactPoint<double>& point = patch.points[i];
      contacts_[i] = {normal_on_b, ToBullet(point.on_1), ToBullet(point.on_2), btScalar(point.separation)};
    }
  }

  std::span<const ManifoldContact> Contacts() const { return {contacts_.data(), size_}; }

 private:
  std::size_t size_;
  std::array<ManifoldContact, dgd::ContactPatch<double>::kMaxPoints> contacts_;
};

bool AreRepresentable(std::span<const ManifoldContact> contacts) {
  return std::all_of(contacts.begin(), contacts.end(),
                     [](const ManifoldContact& contact) { return IsRepresentable(contact.on_b, contact.separation); });
}

/// Whether points must pass through Bullet: a user's own result does what it likes with contacts, and Bullet anchors
/// the points of some bodies itself.
bool NeedsBulletPath(const btManifoldResult& output) {
  return IsUserQuery(output) ||
         HasFlag(*output.getBody0Internal(), *output.getBody1Internal(), btCollisionObject::CF_HAS_FRICTION_ANCHOR);
}

}  // namespace

ManifoldUpdate ManifoldUpdateOf(const Options& options, const btManifoldResult& output) {
  // A shape without faces has one contact a step: as with Bullet's own narrowphase, a patch is completed in steps.
  const bool has_patch = options.contact_patch && ShowsFaces(*output.getBody0Wrap()->getCollisionShape()) &&
                         ShowsFaces(*output.getBody1Wrap()->getCollisionShape());
  return {.drop_stale = has_patch,
          .use_friction_anchors = options.friction_anchors,
          .order_by_impulse = options.order_points_by_impulse};
}

void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output) {
  AddThroughBullet(BulletPatch(patch, normal).Contacts(), output);
}

void UpdateManifold(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                    const ManifoldUpdate& update, btManifoldResult& output) {
  UpdateManifold(BulletPatch(patch, normal).Contacts(), motion, update, output);
}

void UpdateManifold(std::span<const ManifoldContact> contacts, const PairMotion& motion, const ManifoldUpdate& update,
                    btManifoldResult& output) {
  btPersistentManifold& manifold = *output.getPersistentManifold();
  DGD_ASSERT(contacts.size() <= MANIFOLD_CACHE_SIZE);
  const bool was_loaded = IsLoaded(manifold);
  if (update.drop_stale && !NeedsBulletPath(output) && AreRepresentable(contacts) && AreBodiesRepresentable(output)) {
    WriteInPlace(contacts, update.use_friction_anchors ? btScalar(motion.TimeStep()) : 0, output);
  } else {
    WriteThroughBullet(contacts, update.drop_stale, output);
  }
  FinishContacts(was_loaded, motion, update.order_by_impulse, manifold);
}

void CountStep(btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    DGD_ASSERT(point.m_lifeTime >= 0);
    ++point.m_lifeTime;
    if (gContactProcessedCallback == nullptr) continue;
    gContactProcessedCallback(point, const_cast<btCollisionObject*>(manifold.getBody0()),
                              const_cast<btCollisionObject*>(manifold.getBody1()));
  }
}

void DropPointsNotFinite(btPersistentManifold& manifold) {
  for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
    if (!std::isfinite(manifold.getContactPoint(i).getDistance())) manifold.removeContactPoint(i);
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
