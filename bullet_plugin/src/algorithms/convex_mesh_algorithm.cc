#include "algorithms/convex_mesh_algorithm.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/convex_convex_algorithm.h"
#include "bound_part.h"
#include "compound/child_pairs.h"
#include "contact_range.h"
#include "dgd/assert.h"
#include "manifold/just_touching.h"
#include "manifold/manifold_writer.h"
#include "manifold/mesh_triangle.h"
#include "mesh/contact_reduction.h"
#include "mesh/mesh_contacts.h"
#include "mesh/triangle_query.h"
#include "mesh/triangle_states.h"
#include "pair/pair_patch.h"
#include "pair/separating_axis.h"
#include "pair/shared_stages.h"
#include "pair_motion.h"
#include "report/contact_drawer.h"
#include "swept_box.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The state of a pair from step to step, and memory.
struct MeshStep {
  void Begin(const btTransform& mesh) {
    contacts.Begin(mesh);
    states.Begin();
    solved.clear();
  }

  TriangleStates states;
  MeshContacts contacts;
  std::vector<int> solved;                 // Number of the state of each triangle; negative if it is out of reach.
  PairContacts found;                      // The last triangle's.
  PairCache::Hull hull;                    // The body's.
  int our_type = INVALID_SHAPE_PROXYTYPE;  // Type of shape whose triangles the dispatcher leaves to us.
};

namespace {

/// Adds what Bullet's own algorithm finds for a triangle to the mesh's contacts.
class GatheringResult final : public btManifoldResult {
 public:
  GatheringResult(btManifoldResult& output, double contact_distance, int triangle, MeshContacts& contacts)
      : btManifoldResult(output.getBody0Wrap(), output.getBody1Wrap()),
        contact_distance_(contact_distance),
        triangle_(triangle),
        contacts_(contacts) {
    setPersistentManifold(output.getPersistentManifold());
  }

  void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar separation) override {
    if (!(double(separation) <= contact_distance_)) return;
    DGD_ASSERT(triangle_ >= 0 && IsUnit(FromBullet(normal_on_b)));
    const Vector3 normal = -FromBullet(normal_on_b), on_b = FromBullet(point);
    dgd::ContactPatch<double> patch;
    patch.size = 1;
    patch.points[0] = {on_b - double(separation) * normal, on_b, double(separation)};
    contacts_.Add(triangle_, patch, normal);
  }

 private:
  const double contact_distance_;  // Metres.
  const int triangle_;
  MeshContacts& contacts_;
};

/// Gathers the contacts of the triangles that the convex body's bounding box reaches.
class ContactGathering final : public btTriangleCallback {
 public:
  /// Throws what AdaptShape() does.
  ContactGathering(const PairBodies& bodies, const btDispatcherInfo& info, const MeshQuery& query,
                   SharedState& narrowphase, btDispatcher& dispatcher, MeshStep& step, btManifoldResult& output)
      : convex_(bodies.first),
        mesh_(bodies.second),
        info_(info),
        query_(query),
        narrowphase_(narrowphase),
        dispatcher_(dispatcher),
        step_(step),
        output_(output),
        triangle_query_(narrowphase, bodies, query, step.hull) {}

  /// All contacts that count. Throws std::bad_alloc.
  void Gather() {
    const auto& mesh = static_cast<const btConcaveShape&>(*mesh_.getCollisionShape());
    box_ = SweptBox(convex_, mesh_.getWorldTransform(), query_.motion,
                    double(mesh.getMargin()) + query_.limits.patch_settings.contact_distance);
    mesh.processAllTriangles(this, box_.low, box_.high);
    if (is_out_of_memory_) throw std::bad_alloc();
    for (int i = 0; i < step_.contacts.triangles(); ++i) step_.solved.push_back(Solve(i));
    step_.contacts.RemoveGhosts();
    if (triangle_query_.IsOfBall()) {
      // It has no face.
    } else if (query_.motion.MaxApproach() > query_.limits.range.touching) {
      // What meets an internal edge first may have no other contact before it has passed.
      for (int i = 0; i < step_.contacts.triangles(); ++i) {
        if (!step_.contacts.HasContacts(i)) AddFaceContacts(i);
      }
    } else {
      for (const int triangle : step_.contacts.ToTurn()) AddFaceContacts(triangle);
    }
    if (query_.limits.range.is_rebound) step_.contacts.DropSeamPoints(query_.limits.patch_settings.equal_depth);
  }

  /// Whether contacts of an app's own algorithm are in the manifold.
  bool HasForeign() const { return has_foreign_; }

  void processTriangle(btVector3* corners, int part, int index) override {
    if (is_out_of_memory_ || !TestTriangleAgainstAabb2(corners, box_.low, box_.high)) return;
    try {
      step_.contacts.AddTriangle(corners, part, index);
    } catch (const std::bad_alloc&) {
      is_out_of_memory_ = true;  // An app's mesh may have to be unlocked: nothing is thrown through it.
    }
  }

 private:
  static constexpr int kOutOfReach = -1;

  /// Adds a triangle's contacts. Returns the number of its state.
  int Solve(int index) {
    const MeshTriangle& triangle = step_.contacts.triangle(index);
    const Vector3& normal = step_.contacts.NormalOf(index);
    if (triangle_query_.IsOutOfPlane(triangle, normal)) return kOutOfReach;
    if (!IsOurs(triangle)) return kOutOfReach;
    const int number = step_.states.Add(triangle.part, triangle.index);
    PairContacts& found = step_.found;
    const PairOutcome outcome = CatchFailures([&] {
      triangle_query_.Place(triangle, normal);
      return triangle_query_.FindContacts(step_.states[number], found);
    });
    narrowphase_.Count(convex_.getCollisionShape()->getShapeType(), TRIANGLE_SHAPE_PROXYTYPE, outcome);
    if (!outcome.fallback) {
      step_.contacts.Add(index, found.patch, found.normal);
      return number;
    }
    if (IsSolvedByBullet(*outcome.fallback)) {
      const TriangleBody body(triangle, mesh_);
      const BoundPart bound(output_, body.wrapper());
      GatheringResult result(output_, query_.limits.range.touching, index, step_.contacts);
      narrowphase_.FallBack(dispatcher_, &convex_, &body.wrapper(), info_, result);
    }
    return kOutOfReach;
  }

  /// Whether a triangle is ours to solve, as the dispatcher's table has it; if an app has an algorithm of its own, that
  /// has solved it then.
  bool IsOurs(const MeshTriangle& triangle) {
    const int type = convex_.getCollisionShape()->getShapeType();
    PairObserver* observer = narrowphase_.options().pair_observer;
    if (step_.our_type == type && observer == nullptr) return true;
    const TriangleBody body(triangle, mesh_);
    if (step_.our_type != type) {
      const auto destroy = [&](btCollisionAlgorithm* algorithm) { Destroy(dispatcher_, algorithm); };
      // An app's own algorithm may rely on being new in each step.
      const std::unique_ptr<btCollisionAlgorithm, decltype(destroy)> algorithm(
          dispatcher_.findAlgorithm(&convex_, &body.wrapper(), output_.getPersistentManifold(),
                                    BT_CONTACT_POINT_ALGORITHMS),
          destroy);
      if (algorithm == nullptr) return false;
      if (dynamic_cast<ConvexConvexAlgorithm*>(algorithm.get()) == nullptr) {
        has_foreign_ = true;
        const BoundPart bound(output_, body.wrapper());
        algorithm->processCollision(&convex_, &body.wrapper(), info_, &output_);
        return false;
      }
      step_.our_type = type;
    }
    if (observer != nullptr) observer->OnPair(convex_, body.wrapper());
    return true;
  }

  /// The contacts of a triangle along its own normal.
  void AddFaceContacts(int index) {
    const int number = step_.solved[static_cast<std::size_t>(index)];
    const Vector3& normal = step_.contacts.NormalOf(index);
    if (number == kOutOfReach || !step_.states[number].had_contact || normal.isZero(0)) return;
    triangle_query_.Place(step_.contacts.triangle(index), normal);
    triangle_query_.FindFaceContacts(step_.states[number], step_.found);
    step_.contacts.Add(index, step_.found.patch, step_.found.normal);
  }

  const btCollisionObjectWrapper &convex_, &mesh_;
  const btDispatcherInfo& info_;
  const MeshQuery& query_;
  SharedState& narrowphase_;
  btDispatcher& dispatcher_;
  MeshStep& step_;
  btManifoldResult& output_;
  TriangleQuery triangle_query_;
  bool has_foreign_ = false, is_out_of_memory_ = false;
  Box box_;  // The convex body's on its way, in the mesh's frame.
};

}  // namespace

ConvexMeshAlgorithm::ConvexMeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase,
                                         const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                                         bool is_swapped)
    : btConvexConcaveCollisionAlgorithm(info, body_0, body_1, is_swapped),
      narrowphase_(narrowphase),
      step_(new (std::nothrow) MeshStep) {
  btManifoldArray manifolds;
  getAllContactManifolds(manifolds);
  if (manifolds.size() > 0) manifold_ = manifolds[0];
}

ConvexMeshAlgorithm::~ConvexMeshAlgorithm() = default;

void ConvexMeshAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                           const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                           btManifoldResult* output) {
  const bool is_swapped = body_0->getCollisionShape()->isConcave();
  const btCollisionObjectWrapper &convex = is_swapped ? *body_1 : *body_0, &mesh = is_swapped ? *body_0 : *body_1;
  if (manifold_ != nullptr) ForgetTouching(*manifold_);
  // A body's shape may have been exchanged for one of another type.
  const bool are_ours =
      Narrowphase::HandlesMesh(convex.getCollisionShape()->getShapeType(), mesh.getCollisionShape()->getShapeType());
  // Triangles have manifolds of their own in a query of how far apart bodies are.
  const bool can_gather =
      are_ours && step_ != nullptr && manifold_ != nullptr && !(output->m_closestPointDistanceThreshold > 0);
  if (can_gather && FindContacts(convex, mesh, info, *output)) return;
  btConvexConcaveCollisionAlgorithm::processCollision(body_0, body_1, info, output);
}

bool ConvexMeshAlgorithm::FindContacts(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& mesh,
                                       const btDispatcherInfo& info, btManifoldResult& output) try {
  output.setPersistentManifold(manifold_);
  const btCollisionObject &body = *convex.getCollisionObject(), &ground = *mesh.getCollisionObject();
  manifold_->setBodies(&body, &ground);
  const Options& options = narrowphase_.options();
  step_->Begin(mesh.getWorldTransform());
  // The triangles share the manifold; the contacts are written into it as the pair's own.
  const PairManifold shared(manifold_);
  const bool is_user_query = IsUserQuery(output);
  const bool uses_motion = narrowphase_.UsesMotion() && info.m_timeStep > 0 && !is_user_query;
  const PairMotion motion =
      uses_motion ? PairMotion(BoundedBody(body), BoundedBody(ground), double(info.m_timeStep)) : PairMotion();
  const ContactRange range = RangeOfContacts(options, shared, motion, info, output);
  const MeshQuery query{.motion = motion,
                        .limits = {range, PatchSettingsOf(options, shared, range, is_user_query), is_user_query},
                        .flush = NegligibleDistance(shared.BreakingThreshold())};
  ContactGathering gathering({convex, mesh}, info, query, narrowphase_, *m_dispatcher, *step_, output);
  gathering.Gather();
  Write(query, gathering.HasForeign(), info, output);
  return true;
} catch (const std::bad_alloc&) {
  return false;
} catch (const std::exception&) {
  // The convex body's shape is none.
  narrowphase_.CountFallback(convex.getCollisionShape()->getShapeType(), TRIANGLE_SHAPE_PROXYTYPE, Fallback::kInvalid);
  manifold_->clearManifold();
  return true;
}

void ConvexMeshAlgorithm::Write(const MeshQuery& query, bool has_foreign, const btDispatcherInfo& info,
                                btManifoldResult& output) {
  DGD_ASSERT(manifold_ == output.getPersistentManifold());
  const ReducedContacts reduced =
      ReduceContacts(step_->contacts.contacts(), query.limits.patch_settings, query.motion, *manifold_);
  std::array<ManifoldContact, MANIFOLD_CACHE_SIZE> chosen;
  for (int i = 0; i < reduced.size; ++i) {
    const MeshContact& contact = reduced.contacts[static_cast<std::size_t>(i)];
    chosen[static_cast<std::size_t>(i)] = {ToBullet(contact.normal_on_b), ToBullet(contact.on_a),
                                           ToBullet(contact.on_b), btScalar(contact.separation),
                                           &step_->contacts.triangle(contact.triangle)};
  }
  const Options& options = narrowphase_.options();
  // Points of an app's own algorithm cannot be distinguished from ours: none are dropped then.
  ManifoldUpdate update = ManifoldUpdateOf(options, output);
  update.drop_stale = update.drop_stale && !has_foreign;
  UpdateManifold({chosen.data(), static_cast<std::size_t>(reduced.size)}, query.motion, update, output);
  DrawContacts(*manifold_, info.m_debugDraw);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
