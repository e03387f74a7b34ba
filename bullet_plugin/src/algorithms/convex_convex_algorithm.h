// The algorithm object of one pair of convex shapes: Bullet's contract on the outside, the growth distance inside.
//
// The contract (read from Bullet 3.24, btConvexConvexAlgorithm and btManifoldResult), besides that of pair_algorithm.h:
// points leave through addContactPoint(), and those of the pair's own manifold are written as that would leave them
// (manifold_writer.h); the normal points from B to A, A and B in the order of the call; the depth is the signed
// distance after margins.
#pragma once

#include <memory>
#include <optional>

#include "algorithms/pair_algorithm.h"
#include "algorithms/visiting_order.h"
#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "dgd/held_face.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/face_contacts.h"
#include "pipeline/pair_contacts.h"
#include "pipeline/pair_motion.h"
#include "shapes/hull_cache.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The contacts of a solved pair, which have not been written anywhere.
struct PairContacts {
  dgd::ContactPatch<double> patch;
  dgd::Result<double> result;  ///< Its normal points from the call's first body to the second.
  PairMotion motion;           ///< That the patch was found with, in the order that the shapes are solved in.
  bool lets_pass = false;      ///< The patch's separations are not the shapes' (LetPass()).
};

class ConvexConvexAlgorithm final : public PairAlgorithm {
 public:
  /// @param is_for_step  Whether its contacts are a step's, and may be ahead of the bodies' motion in it.
  ConvexConvexAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase, bool is_for_step);

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override;

  /// The contacts with a triangle of a mesh, in the place of processCollision(): the mesh chooses among all triangles',
  /// and writes them.
  /// @return why the pair is not solved, if it is not; that has been counted.
  std::optional<Fallback> FindTriangleContacts(const btCollisionObjectWrapper& convex,
                                               const btCollisionObjectWrapper& triangle, const TriangleQuery& query,
                                               PairContacts& contacts);

  /// Solves a pair that FindTriangleContacts() has not with Bullet's own algorithm, into the result.
  void FallBack(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& triangle,
                const btDispatcherInfo& info, btManifoldResult& output) {
    narrowphase_.FallBack(*m_dispatcher, &convex, &triangle, info, output);
  }

  /// FindFaceContacts() of the two. After FindTriangleContacts() in the same step; does not throw.
  /// @param normal  Of the triangle, on either side.
  FaceContacts FindTriangleFaceContacts(const btCollisionObjectWrapper& convex,
                                        const btCollisionObjectWrapper& triangle, const Vector3& normal,
                                        const TriangleQuery& query);

  /// The part of the bodies' way from their transforms to their interpolation transforms that they go before they
  /// touch, or 1: by a sweep of the shapes themselves, never late. Only an app that dispatches continuously asks. As in
  /// Bullet, bodies whose ways are both below their CCD motion thresholds are not swept, and the bodies' hit fractions
  /// are lowered. Children of compounds and meshes answer 1: Bullet does not say where they are.
  btScalar calculateTimeOfImpact(btCollisionObject* body_0, btCollisionObject* body_1, const btDispatcherInfo& info,
                                 btManifoldResult* output) override;

 private:
  /// Has memory bring the algorithm that Bullet will most likely call next, and what that will read. In a world of
  /// thousands of pairs it is nowhere near, and to wait for it takes as long as to tell that a pair is apart.
  void PrefetchNext(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1);

  std::optional<Fallback> FindContacts(const Bodies& bodies, const btDispatcherInfo& info,
                                       btManifoldResult& output) override;
  bool UpdateRecycledContacts(const Bodies& bodies, double anchor_time_step, btManifoldResult& output) override;

  static Bodies InOrder(const Bodies& bodies, bool is_swapped) {
    return is_swapped ? Bodies{bodies.second, bodies.first} : bodies;
  }

  /// What a step asks of the pair, and the answer so far.
  struct Query;

  /// Solves the pair for its contacts. If that failed: why.
  /// @param prepare  void(Query& query, bool is_swapped): sets the motion and the distances; the shapes are
  ///                 solved in the other order than the call's if swapped.
  template <class Prepare>
  std::optional<Fallback> SolveContacts(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                                        bool is_asked, const Prepare& prepare, PairContacts& contacts);

  /// The pair's normal, and the separation along it: by the last normal where that still tells, else by a search.
  void FindNormal(Query& query);
  /// By the contact's face or edges, FollowContact(); or by the last nearest simplex, FollowDistance().
  bool FollowLastContact(Query& query);
  bool FollowLastSimplex(Query& query);

  /// The contacts along the normal, which turns to that of least translation where there are any and that is wanted.
  dgd::ContactPatch<double> FindContactPatch(Query& query);

  /// Turns the normal to that of least translation, if it is not, and that is wanted.
  void TurnNormal(Query& query);

  /// What the shapes show each other along the normal.
  void FindFacing(Query& query);

  /// Which contacts bodies have that are apart, or overlap by less than counts: none, those of their faces, the same
  /// that let them pass (LetPass()), or one at the points that will meet, to whose normal the result is turned then.
  enum class ContactKind { kNone, kPatch, kPassingPatch, kPoint };
  ContactKind ClassifySpeculative(Query& query);

  /// Whether a pair without contact is still farther apart along the last normal than it may approach in the step.
  bool StaysApart(const Bodies& bodies, const btDispatcherInfo& info, const btManifoldResult& output);

  /// The same.
  /// @param contact_distance  Nearer, that has to be found out; metres.
  /// @param get_motion  PairMotion(const BodyReach& a, const BodyReach& b), in the order that the shapes are solved in.
  template <class GetMotion>
  bool StaysApartBy(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                    double contact_distance, const GetMotion& get_motion);

  /// Whether a triangle's normal is from the body to the triangle: by the pair's last normal, or by the body's centre
  /// where that is along the triangle.
  bool IsTowards(const Vector3& normal, const PosedShape& convex, const PosedShape& triangle) const;

  /// The face that the contacts' normal turns with, if any.
  /// @param bodies  In the order that the shapes are solved in.
  Footing FootingOfContacts(const Bodies& bodies) const;

  /// Makes the last query's state this one's start: none if the options say so, else in the order that the shapes are
  /// solved in now.
  void Recall(bool is_other_order, const Pose& pose_a, const Pose& pose_b);

  // What a pair that stays apart needs comes first, up to the last normal: with the base, two lines of the cache.
  bool may_be_apart_ = true;                              // The cores, by all that is known: FollowDistance() is tried.
  bool follows_distance_ = false;                         // FollowDistance() had the last answer.
  bool was_swapped_ = false;                              // The order of the hulls below is not Bullet's.
  dgd::FaceHolder face_holder_ = dgd::FaceHolder::kNone;  // Of the last contact.
  VisitingOrder::Place place_ = 0;                        // Of the last call.
  std::shared_ptr<const CachedHull> hull_0_, hull_1_;     // In the order that the shapes are solved in (pair_order.h).
  dgd::WarmStart<double> warm_start_;
};

// The pool hands out slots without looking at the size: 184 bytes is the largest algorithm of Bullet's own, so every
// pool that works with Bullet holds it. The soft-body configuration's slots are 8-byte aligned.
static_assert(sizeof(ConvexConvexAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(ConvexConvexAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
