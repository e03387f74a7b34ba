#include "dgd_bullet/collision_dispatcher.h"

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <LinearMath/btIDebugDraw.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/bullet_check.h"
#include "algorithms/concurrent_pairs.h"
#include "algorithms/convex_convex_algorithm.h"
#include "dgd/assert.h"
#include "dispatch/separated_pairs.h"
#include "dispatch/thread_team.h"
#include "separation_report.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Place of the pair that the thread is solving, in Bullet's order.
thread_local std::size_t current_pair = 0;

const btCollisionObject& ObjectOf(const btBroadphaseProxy& proxy) {
  return *static_cast<const btCollisionObject*>(proxy.m_clientObject);
}
const btCollisionShape& ShapeOf(const btBroadphaseProxy& proxy) { return *ObjectOf(proxy).getCollisionShape(); }

/// A manifold that has been made or given back. Not a member of what it is for: of an exported class's members, clang
/// exports what the standard library makes.
struct ManifoldChange {
  std::size_t pair;  // Which did so.
  btPersistentManifold* manifold;
  bool is_new;
};

/// @return the configuration, if all that the dispatcher is made with is in order.
btCollisionConfiguration* Checked(btCollisionConfiguration* configuration, const DispatcherOptions& options,
                                  int bullet_version) {
  constexpr int kMaxThreads = 64;
  RequireMatchingBullet(bullet_version);
  if (options.threads < 1 || options.threads > kMaxThreads) {
    throw std::invalid_argument("dgd_bullet::DispatcherOptions::threads must be 1 to 64; got " +
                                std::to_string(options.threads));
  }
  if (configuration == nullptr) {
    throw std::invalid_argument("dgd_bullet::CollisionDispatcher needs a collision configuration; got null");
  }
  return configuration;
}

}  // namespace

/// The pairs of a dispatch; and, where several threads solve them, what they take and give back at the same time.
class CollisionDispatcher::Pairs {
 public:
  Pairs(CollisionDispatcher& dispatcher, int threads) : dispatcher_(dispatcher) {
    if (threads > 1) team_.emplace(threads);
  }

  /// Whether threads are at work.
  bool AreShared() const { return are_shared_; }
  /// Whether a dispatch is going on.
  bool AreBeingSolved() const { return are_being_solved_; }

  /// @return false if the pairs are few next to those of another cache: what is known of them is of one cache.
  bool Solve(btOverlappingPairCache& pair_cache, const btDispatcherInfo& info, btDispatcher* dispatcher);
  /// Forgets what is known of a cache's pairs, which others solve.
  void Forget(const btOverlappingPairCache& pair_cache) {
    if (&pair_cache == pair_cache_) are_known_ = false;
  }

  // While threads are at work: what the dispatcher's own members of these names do otherwise.
  btPersistentManifold* GetNewManifold(const btCollisionObject* body_0, const btCollisionObject* body_1);
  void ReleaseManifold(btPersistentManifold* manifold);
  void* AllocateCollisionAlgorithm(int size);
  void FreeCollisionAlgorithm(void* algorithm);

 private:
  /// Sets a flag as long as this lives.
  class FlagScope {
   public:
    explicit FlagScope(bool& flag) : flag_(flag) { flag_ = true; }
    ~FlagScope() { flag_ = false; }
    FlagScope(const FlagScope&) = delete;
    FlagScope& operator=(const FlagScope&) = delete;

   private:
    bool& flag_;
  };

  void SolvePair(std::size_t place, const btDispatcherInfo& info);
  void CountApart(btBroadphasePair& pair);
  void SolveInOrder(const btDispatcherInfo& info);
  void SolveShared(const btDispatcherInfo& info) noexcept;
  void SolveConcurrent(const btDispatcherInfo& info) noexcept;
  /// Makes the dispatcher's list of manifolds what it is where the pairs are solved one by one.
  void UpdateManifolds();

  CollisionDispatcher& dispatcher_;
  const btOverlappingPairCache* pair_cache_ = nullptr;  // The last one whose pairs were solved here.
  std::vector<btBroadphasePair*> pairs_;
  SeparatedPairs separated_;
  std::atomic<bool> are_known_ = false;  // Whether `separated_` is of the last dispatch.
  bool are_being_solved_ = false;
  std::vector<std::size_t> concurrent_;    // Places of the pairs that are shared.
  std::atomic<std::size_t> next_{0};       // The first of these that no thread has begun with.
  std::mutex mutex_;                       // For Bullet's pools, the list of manifolds, and the changes.
  std::vector<ManifoldChange> manifolds_;  // Changes in this step.
  bool are_shared_ = false;                // Written while one thread is at work.
  std::optional<ThreadTeam> team_;         // Destroyed first.
};

bool CollisionDispatcher::Pairs::Solve(btOverlappingPairCache& pair_cache, const btDispatcherInfo& info,
                                       btDispatcher* dispatcher) {
  if (&pair_cache != pair_cache_) {
    if (pair_cache.getNumOverlappingPairs() < static_cast<int>(pairs_.size())) return false;
    pair_cache_ = &pair_cache;
    are_known_ = false;
  }
  if (!are_known_) separated_.Clear();
  struct Collect : btOverlapCallback {
    explicit Collect(std::vector<btBroadphasePair*>& into) : pairs(into) {}
    bool processOverlap(btBroadphasePair& pair) override {
      pairs.push_back(&pair);
      return false;
    }
    std::vector<btBroadphasePair*>& pairs;
  };
  pairs_.clear();
  Collect collect(pairs_);
  pair_cache.processAllOverlappingPairs(&collect, dispatcher, info);
  are_known_ = true;  // Unless a callback dispatches the same pairs.
  const FlagScope scope(are_being_solved_);
  separated_.BeginDispatch(pairs_, info.m_timeStep);
  if (team_) {
    SolveShared(info);
  } else {
    SolveInOrder(info);
  }
  separated_.EndDispatch();
  return true;
}

void CollisionDispatcher::Pairs::SolveInOrder(const btDispatcherInfo& info) try {
  for (std::size_t place = 0; place < pairs_.size(); ++place) SolvePair(place, info);
} catch (...) {
  are_known_ = false;  // A callback has thrown: the other pairs are as they were.
  throw;
}

void CollisionDispatcher::Pairs::SolveShared(const btDispatcherInfo& info) noexcept {
  are_shared_ = true;
  concurrent_.clear();
  ConcurrentPairs concurrent(dispatcher_.m_doubleDispatchContactPoints);
  for (std::size_t place = 0; place < pairs_.size(); ++place) {
    const btBroadphasePair& pair = *pairs_[place];
    if (separated_.IsKnown(place) || concurrent.Contain(ShapeOf(*pair.m_pProxy0), ShapeOf(*pair.m_pProxy1))) {
      concurrent_.push_back(place);
    } else {
      SolvePair(place, info);
    }
  }
  next_ = 0;
  team_->Run([&] { SolveConcurrent(info); });
  are_shared_ = false;
  UpdateManifolds();
}

void CollisionDispatcher::Pairs::SolvePair(std::size_t place, const btDispatcherInfo& info) {
  btBroadphasePair& pair = *pairs_[place];
  if (separated_.IsApart(place)) {
    if (separated_.IsCounted(place)) CountApart(pair);
    return;
  }
  SeparationReport report;
  current_pair = place;
  {
    const ReportScope scope(report);
    dispatcher_.getNearCallback()(pair, dispatcher_, info);
  }
  separated_.Update(place, pair, report);
}

void CollisionDispatcher::Pairs::CountApart(btBroadphasePair& pair) {
  const btCollisionObject &body_0 = ObjectOf(*pair.m_pProxy0), &body_1 = ObjectOf(*pair.m_pProxy1);
  if (!dispatcher_.needsCollision(&body_0, &body_1)) return;
  static_cast<ConvexConvexAlgorithm*>(pair.m_algorithm)
      ->CountApart(*body_0.getCollisionShape(), *body_1.getCollisionShape());
}

void CollisionDispatcher::Pairs::SolveConcurrent(const btDispatcherInfo& info) noexcept {
  constexpr std::size_t kChunk = 64;  // Pairs: some tens of microseconds.
  for (std::size_t first = next_.fetch_add(kChunk); first < concurrent_.size(); first = next_.fetch_add(kChunk)) {
    const std::size_t last = std::min(first + kChunk, concurrent_.size());
    for (std::size_t i = first; i < last; ++i) SolvePair(concurrent_[i], info);
  }
}

void CollisionDispatcher::Pairs::UpdateManifolds() {
  // Those of one pair come from one thread, in their order.
  std::stable_sort(manifolds_.begin(), manifolds_.end(),
                   [](const ManifoldChange& a, const ManifoldChange& b) { return a.pair < b.pair; });
  auto& list = dispatcher_.m_manifoldsPtr;
  for (const ManifoldChange& change : manifolds_) {
    if (change.is_new) {
      change.manifold->m_index1a = list.size();
      list.push_back(change.manifold);
    } else {
      dispatcher_.btCollisionDispatcher::releaseManifold(change.manifold);
    }
  }
  manifolds_.clear();
}

btPersistentManifold* CollisionDispatcher::Pairs::GetNewManifold(const btCollisionObject* body_0,
                                                                 const btCollisionObject* body_1) {
  const std::lock_guard lock(mutex_);
  btPersistentManifold* manifold = dispatcher_.btCollisionDispatcher::getNewManifold(body_0, body_1);
  if (manifold == nullptr) return nullptr;
  DGD_ASSERT(manifold->m_index1a == dispatcher_.m_manifoldsPtr.size() - 1);
  dispatcher_.m_manifoldsPtr.pop_back();
  manifolds_.push_back({current_pair, manifold, true});
  return manifold;
}

void CollisionDispatcher::Pairs::ReleaseManifold(btPersistentManifold* manifold) {
  const std::lock_guard lock(mutex_);
  manifolds_.push_back({current_pair, manifold, false});
}

void* CollisionDispatcher::Pairs::AllocateCollisionAlgorithm(int size) {
  const std::lock_guard lock(mutex_);
  return dispatcher_.btCollisionDispatcher::allocateCollisionAlgorithm(size);
}

void CollisionDispatcher::Pairs::FreeCollisionAlgorithm(void* algorithm) {
  const std::lock_guard lock(mutex_);
  dispatcher_.btCollisionDispatcher::freeCollisionAlgorithm(algorithm);
}

CollisionDispatcher::CollisionDispatcher(btCollisionConfiguration* configuration, const DispatcherOptions& options,
                                         int bullet_version)
    : btCollisionDispatcher(Checked(configuration, options, bullet_version)),
      default_near_callback_(getNearCallback()) {
  pairs_.reset(new Pairs(*this, options.threads));
}

CollisionDispatcher::~CollisionDispatcher() = default;

bool CollisionDispatcher::IsPlainDispatch(const btDispatcherInfo& info) const {
  // A callback of a pair that is being solved may dispatch others, of a ghost's say.
  return pairs_->AreBeingSolved() || getNearCallback() != default_near_callback_ ||
         info.m_dispatchFunc != btDispatcherInfo::DISPATCH_DISCRETE ||
         (info.m_debugDraw != nullptr && info.m_debugDraw->getDebugMode() != btIDebugDraw::DBG_NoDebug) ||
         (getDispatcherFlags() & CD_DISABLE_CONTACTPOOL_DYNAMIC_ALLOCATION) != 0;
}

void CollisionDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pair_cache, const btDispatcherInfo& info,
                                                    btDispatcher* dispatcher) {
  if (!IsPlainDispatch(info) && pairs_->Solve(*pair_cache, info, dispatcher)) return;
  btCollisionDispatcher::dispatchAllCollisionPairs(pair_cache, info, dispatcher);
  pairs_->Forget(*pair_cache);
}

btPersistentManifold* CollisionDispatcher::getNewManifold(const btCollisionObject* body_0,
                                                          const btCollisionObject* body_1) {
  return pairs_->AreShared() ? pairs_->GetNewManifold(body_0, body_1)
                             : btCollisionDispatcher::getNewManifold(body_0, body_1);
}

void CollisionDispatcher::releaseManifold(btPersistentManifold* manifold) {
  if (pairs_->AreShared()) {
    pairs_->ReleaseManifold(manifold);
  } else {
    btCollisionDispatcher::releaseManifold(manifold);
  }
}

void* CollisionDispatcher::allocateCollisionAlgorithm(int size) {
  return pairs_->AreShared() ? pairs_->AllocateCollisionAlgorithm(size)
                             : btCollisionDispatcher::allocateCollisionAlgorithm(size);
}

void CollisionDispatcher::freeCollisionAlgorithm(void* algorithm) {
  if (pairs_->AreShared()) {
    pairs_->FreeCollisionAlgorithm(algorithm);
  } else {
    btCollisionDispatcher::freeCollisionAlgorithm(algorithm);
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
