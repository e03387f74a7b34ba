#include "algorithms/compound_algorithm.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <Eigen/Core>
#include <optional>

#include "algorithms/narrowphase.h"
#include "bound_part.h"
#include "contact_range.h"
#include "pair_motion.h"
#include "prefetch.h"
#include "swept_box.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

const btCompoundShape* AsCompound(const btCollisionShape& shape) {
  return shape.isCompound() ? static_cast<const btCompoundShape*>(&shape) : nullptr;
}

/// The product of two poses, to the last bit as Bullet computes it.
btTransform Product(const btTransform& a, const btTransform& b) {
  // Each row has four scalars, so that the compiler computes it at once. Bullet aligns poses to a scalar only.
  using Rows = Eigen::Matrix<btScalar, 4, 3>;
  const auto rows = [](const btTransform& pose) { return Eigen::Map<const Rows>(pose.getBasis()[0].m_floats); };
  btTransform product;
  Eigen::Map<Rows>(product.getBasis()[0].m_floats).noalias() = rows(b).lazyProduct(rows(a).topRows<3>());
  product.setOrigin(a(b.getOrigin()));
  return product;
}

/// A child as a shape of its own, in its place.
class ChildBody {
 public:
  ChildBody(const btCompoundShape& compound, int index, const btCollisionObjectWrapper& body)
      : pose_(Product(body.getWorldTransform(), compound.getChildTransform(index))),
        wrapper_(&body, compound.getChildShape(index), body.getCollisionObject(), pose_, kNoPart, index) {}
  ChildBody(const ChildBody&) = delete;
  ChildBody& operator=(const ChildBody&) = delete;

  const btCollisionObjectWrapper& wrapper() const { return wrapper_; }

 private:
  static constexpr int kNoPart = -1;  // As Bullet has it.

  const btTransform pose_;
  const btCollisionObjectWrapper wrapper_;
};

/// Calls visit(int index) for each child whose bounding box overlaps a box in the compound's frame. An only child fills
/// the body's own bounding box, by which the broadphase has found the pair.
/// @param find_box  Box().
template <class FindBox, class Visit>
void ForEachChildIn(const FindBox& find_box, const btCompoundShape& compound, const Visit& visit) {
  if (compound.getNumChildShapes() == 1) return visit(0);
  const Box box = find_box();
  if (const btDbvt* tree = compound.getDynamicAabbTree()) {
    struct Leaf : btDbvt::ICollide {
      explicit Leaf(const Visit& to_call) : call(to_call) {}
      void Process(const btDbvtNode* leaf) override { call(leaf->dataAsInt); }
      const Visit& call;
    } leaf(visit);
    return tree->collideTV(tree->m_root, btDbvtVolume::FromMM(box.low, box.high), leaf);
  }
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    btVector3 low, high;
    compound.getChildShape(i)->getAabb(compound.getChildTransform(i), low, high);
    if (TestAabbAgainstAabb2(low, high, box.low, box.high)) visit(i);
  }
}

/// Solves the pairs of children that may be in contact within the step.
class ChildrenVisit {
 public:
  ChildrenVisit(const Narrowphase& narrowphase, btDispatcher& dispatcher, const btDispatcherInfo& info,
                btPersistentManifold* shared_manifold, ChildPairs& pairs, btManifoldResult& output)
      : narrowphase_(narrowphase),
        dispatcher_(dispatcher),
        info_(info),
        shared_manifold_(shared_manifold),
        pairs_(pairs),
        output_(output) {}

  void Solve(const btCollisionObjectWrapper& compound_body, const btCollisionObjectWrapper& other) {
    const auto& compound = static_cast<const btCompoundShape&>(*compound_body.getCollisionShape());
    const auto box_of_other = [&] { return BoxOf(other, compound_body); };
    ForEachChildIn(box_of_other, compound, [&](int index) {
      const ChildBody child(compound, index, compound_body);
      const BoundPart bound(output_, child.wrapper());
      if (const btCompoundShape* other_compound = AsCompound(*other.getCollisionShape())) {
        SolveChildren(child.wrapper(), *other_compound, other);
      } else if (Allows(gCompoundChildShapePairCallback, other, child.wrapper()) &&
                 (compound.getNumChildShapes() == 1 || IsNear(child.wrapper(), other))) {
        SolvePair(child.wrapper(), other, 0);
      }
    });
  }

  void SolvePair(const btCollisionObjectWrapper& child, const btCollisionObjectWrapper& other, int other_index) {
    // In a query of how far apart bodies are, each pair has an algorithm for that.
    const bool is_step = !(output_.m_closestPointDistanceThreshold > 0);
    btCollisionAlgorithm* algorithm = is_step ? pairs_.Find(child.m_index, other_index) : nullptr;
    const bool is_new = algorithm == nullptr;
    if (is_new) {
      algorithm = is_step ? dispatcher_.findAlgorithm(&child, &other, shared_manifold_, BT_CONTACT_POINT_ALGORITHMS)
                          : dispatcher_.findAlgorithm(&child, &other, nullptr, BT_CLOSEST_POINT_ALGORITHMS);
    }
    if (algorithm == nullptr) return;
    algorithm->processCollision(&child, &other, info_, &output_);
    if (is_new && !(is_step && pairs_.Insert(child.m_index, other_index, algorithm))) Destroy(dispatcher_, algorithm);
  }

 private:
  void SolveChildren(const btCollisionObjectWrapper& child, const btCompoundShape& compound,
                     const btCollisionObjectWrapper& compound_body) {
    const auto box_of_child = [&] { return BoxOf(child, compound_body); };
    ForEachChildIn(box_of_child, compound, [&](int index) {
      const ChildBody other_child(compound, index, compound_body);
      const BoundPart bound(output_, other_child.wrapper());
      if (Allows(gCompoundCompoundChildShapePairCallback, child, other_child.wrapper())) {
        SolvePair(child, other_child.wrapper(), index);
      }
    });
  }

  bool IsNear(const btCollisionObjectWrapper& child, const btCollisionObjectWrapper& other) {
    btVector3 low, high;
    other.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
    const Box box = BoxOf(child, other);
    return TestAabbAgainstAabb2(low, high, box.low, box.high);
  }

  /// The box of all places where a shape may touch another body within the step, in that body's frame.
  Box BoxOf(const btCollisionObjectWrapper& shape, const btCollisionObjectWrapper& other) {
    const btCollisionObject &body = *shape.getCollisionObject(), &other_body = *other.getCollisionObject();
    const bool uses_motion = narrowphase_.UsesMotion() && info_.m_timeStep > 0 && !IsUserQuery(output_);
    if (&body != of_ && uses_motion) {
      motion_.emplace(BoundedBody(body), BoundedBody(other_body), double(info_.m_timeStep));
      of_ = &body;
    }
    const double distance = ContactDistance(narrowphase_.options(), double(gContactBreakingThreshold), output_);
    return SweptBox(shape, other.getWorldTransform(), uses_motion ? *motion_ : PairMotion(), distance);
  }

  static bool Allows(btShapePairCallback callback, const btCollisionObjectWrapper& a,
                     const btCollisionObjectWrapper& b) {
    return callback == nullptr || callback(a.getCollisionShape(), b.getCollisionShape());
  }

  const Narrowphase& narrowphase_;
  btDispatcher& dispatcher_;
  const btDispatcherInfo& info_;
  btPersistentManifold* const shared_manifold_;
  ChildPairs& pairs_;
  btManifoldResult& output_;
  std::optional<PairMotion> motion_;       // Of the last box.
  const btCollisionObject* of_ = nullptr;  // Its body A.
};

}  // namespace

CompoundAlgorithm::Content::Content(const btCollisionShape& shape)
    : compound(AsCompound(shape)),
      version(compound != nullptr ? compound->getUpdateRevision() : shape.getShapeType()) {}

void CompoundAlgorithm::processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                                         const btDispatcherInfo& info, btManifoldResult* output) {
  if (const void* next = VisitingOrder::OfThisThread().Visit(this, place_)) Prefetch(next, sizeof(CompoundAlgorithm));
  const Content content_0(*body_0->getCollisionShape()), content_1(*body_1->getCollisionShape());
  if (content_0 != content_0_ || content_1 != content_1_) pairs_.Clear();
  content_0_ = content_0;
  content_1_ = content_1;
  const bool is_swapped = content_0.compound == nullptr;
  const btCollisionObjectWrapper &compound = is_swapped ? *body_1 : *body_0, &other = is_swapped ? *body_0 : *body_1;
  ChildrenVisit visit(narrowphase_, *m_dispatcher, info, shared_manifold_, pairs_, *output);
  if (content_0.compound != nullptr || content_1.compound != nullptr) {
    visit.Solve(compound, other);
  } else {
    visit.SolvePair(compound, other, 0);  // A body's shape has been exchanged for one of another type.
  }
  if (!(output->m_closestPointDistanceThreshold > 0)) pairs_.EndStep();
}

btScalar CompoundAlgorithm::calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                                  btManifoldResult*) {
  return 1;
}

void CompoundAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) { pairs_.AppendManifolds(manifolds); }

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
