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
#include "contact_range.h"
#include "dgd/assert.h"
#include "manifold/just_touching.h"
#include "manifold/manifold_writer.h"
#include "manifold/mesh_triangle.h"
#include "mesh/contact_reduction.h"
#include "mesh/mesh_contacts.h"
#include "mesh/triangle_pairs.h"
#include "pair/pair_patch.h"
#include "pair/separating_axis.h"
#include "pair_motion.h"
#include "report/contact_drawer.h"
#include "swept_box.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The state of a pair from step to step: algorithms, and memory.
struct MeshStep {
  explicit MeshStep(btDispatcher& dispatcher) : pairs(dispatcher) {}

  void Begin(const btTransform& mesh) {
    contacts.Begin(mesh);
    triangles.clear();
  }

  TrianglePairs pairs;
  MeshContacts contacts;
  /// A triangle's part in finding its face contacts.
  struct Solved {
    ConvexConvexAlgorithm* algorithm = nullptr;  // Null where an app's own algorithm has solved it.
    Moment moment;                               // PairContacts::moment.
    bool has_patch = false;                      // Whether it has contacts with the body, ghosts or not.
  };
  std::vector<Solved> triangles;  // The contacts' triangles.
  PairContacts found;             // The last triangle's.
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

/// Gathers the contacts of each triangle that the convex body's bounding box reaches.
class TriangleVisit final : public btTriangleCallback {
 public:
  TriangleVisit(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& mesh,
                const btDispatcherInfo& info, const TriangleQuery& query, btDispatcher& dispatcher, MeshStep& step,
                btManifoldResult& output)
      : convex_(convex),
        mesh_(mesh),
        bounded_convex_(*convex.getCollisionObject()),
        bounded_mesh_(*mesh.getCollisionObject()),
        info_(info),
        query_(query),
        dispatcher_(dispatcher),
        step_(step),
        output_(output) {}

  /// All contacts that count. Throws std::bad_alloc.
  void Gather() {
    const auto& mesh = static_cast<const btConcaveShape&>(*mesh_.getCollisionShape());
    box_ = SweptBox(convex_, mesh_.getWorldTransform(), query_.motion,
                    double(mesh.getMargin()) + query_.limits.patch_settings.contact_distance);
    mesh.processAllTriangles(this, box_.low, box_.high);
    if (is_out_of_memory_) throw std::bad_alloc();
    step_.contacts.RemoveGhosts();
    if (query_.motion.MaxApproach() > query_.limits.range.touching) {
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
      Visit(corners, part, index);
    } catch (const std::bad_alloc&) {
      is_out_of_memory_ = true;  // An app's mesh may have to be unlocked: nothing is thrown through it.
    }
  }

 private:
  void Visit(const btVector3* corners, int part, int index) {
    const int i = step_.contacts.AddTriangle(corners, part, index);
    step_.triangles.emplace_back();
    DGD_ASSERT(step_.triangles.size() == static_cast<std::size_t>(step_.contacts.triangles()));
    const TriangleBody triangle(step_.contacts.triangle(i), mesh_);
    if (auto* cached = static_cast<ConvexConvexAlgorithm*>(step_.pairs.Find(part, index))) {
      step_.triangles.back().algorithm = cached;
      return AddContacts(*cached, triangle.wrapper(), i);
    }
    if (IsOutOfPlane(triangle)) return;
    // The dispatcher's table decides: an app may have an algorithm of its own for triangles.
    btCollisionAlgorithm* algorithm = dispatcher_.findAlgorithm(
        &convex_, &triangle.wrapper(), output_.getPersistentManifold(), BT_CONTACT_POINT_ALGORITHMS);
    if (algorithm == nullptr) return;
    const auto destroy = [&](btCollisionAlgorithm* owned) { Destroy(dispatcher_, owned); };
    std::unique_ptr<btCollisionAlgorithm, decltype(destroy)> owner(algorithm, destroy);
    if (auto* ours = dynamic_cast<ConvexConvexAlgorithm*>(algorithm)) {
      if (step_.pairs.Insert(part, index, ours))
        step_.triangles.back().algorithm = static_cast<ConvexConvexAlgorithm*>(owner.release());
      AddContacts(*ours, triangle.wrapper(), i);
    } else {
      // An app's own algorithm may rely on being new in each step.
      has_foreign_ = true;
      const BoundPart bound(output_, triangle.wrapper());
      algorithm->processCollision(&convex_, &triangle.wrapper(), info_, &output_);
    }
  }

  void AddContacts(ConvexConvexAlgorithm& algorithm, const btCollisionObjectWrapper& triangle, int index) {
    PairContacts& found = step_.found;
    const std::optional<Fallback> failure =
        algorithm.FindTriangleContacts({convex_, triangle}, step_.contacts.NormalOf(index), query_, found);
    step_.triangles.back().moment = found.moment;
    step_.triangles.back().has_patch = found.patch.size > 0;
    if (!failure) return step_.contacts.Add(index, found.patch, found.normal);
    if (!IsSolvedByBullet(*failure)) return;
    const BoundPart bound(output_, triangle);
    GatheringResult result(output_, query_.limits.range.touching, index, step_.contacts);
    algorithm.FallBack({convex_, triangle}, info_, result);
  }

  /// The contacts of a triangle along its own normal.
  void AddFaceContacts(int index) {
    DGD_ASSERT(index >= 0 && static_cast<std::size_t>(index) < step_.triangles.size());
    const auto [algorithm, moment, has_patch] = step_.triangles[static_cast<std::size_t>(index)];
    const Vector3 normal = step_.contacts.NormalOf(index);
    if (algorithm == nullptr || !has_patch || normal.isZero(0)) return;
    const TriangleBody triangle(step_.contacts.triangle(index), mesh_);
    const FaceContacts found =
        algorithm->FindTriangleFaceContacts({convex_, triangle.wrapper()}, normal, moment, query_);
    step_.contacts.Add(index, found.patch, found.normal);
  }

  /// Whether the convex body is on one side of the triangle's plane and does not come near it in the step.
  bool IsOutOfPlane(const TriangleBody& triangle) const {
    const btVector3* corners = triangle.shape().m_vertices1;
    const btVector3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const btScalar length = area.length();
    if (!(length > 0)) return false;
    const btVector3 normal = mesh_.getWorldTransform().getBasis() * (area / length);
    const auto is_apart = [&](const btVector3& direction) {
      const double separation =
          SeparationAlong({convex_, bounded_convex_}, {triangle.wrapper(), bounded_mesh_}, direction);
      return separation > query_.limits.range.touching &&
             !query_.motion.MayApproachBy(separation, FromBullet(direction));
    };
    return is_apart(normal) || is_apart(-normal);
  }

  const btCollisionObjectWrapper &convex_, &mesh_;
  const BoundedBody bounded_convex_, bounded_mesh_;
  const btDispatcherInfo& info_;
  const TriangleQuery& query_;
  btDispatcher& dispatcher_;
  MeshStep& step_;
  btManifoldResult& output_;
  bool has_foreign_ = false, is_out_of_memory_ = false;
  Box box_;  // The convex body's on its way, in the mesh's frame.
};

}  // namespace

ConvexMeshAlgorithm::ConvexMeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                         const Narrowphase& narrowphase, const btCollisionObjectWrapper* body_0,
                                         const btCollisionObjectWrapper* body_1, bool is_swapped)
    : btConvexConcaveCollisionAlgorithm(info, body_0, body_1, is_swapped),
      narrowphase_(narrowphase),
      step_(new (std::nothrow) MeshStep(*m_dispatcher)) {
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
  const PairMotion reverse = motion.Reversed();
  const ContactRange range = RangeOfContacts(options, shared, motion, info, output);
  const TriangleQuery query{.motion = motion,
                            .reverse_motion = reverse,
                            .limits = {range, PatchSettingsOf(options, shared, range, is_user_query), is_user_query},
                            .flush = NegligibleDistance(shared.BreakingThreshold())};
  TriangleVisit visit(convex, mesh, info, query, *m_dispatcher, *step_, output);
  visit.Gather();
  step_->pairs.EndStep();
  Write(query, visit.HasForeign(), info, output);
  return true;
} catch (const std::bad_alloc&) {
  step_->pairs.EndStep();
  return false;
}

void ConvexMeshAlgorithm::Write(const TriangleQuery& query, bool has_foreign, const btDispatcherInfo& info,
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
