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
#include "dgd/assert.h"
#include "dispatch/separated_pairs.h"
#include "dispatch/thread_team.h"
#include "separation_report.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Place of the pair that the thread solves, in Bullet's order.
thread_local std::size_t current_pair = 0;

const btCollisionObject& ObjectOf(const btBroadphaseProxy& proxy) {
  return *static_cast<const btCollisionObject*>(proxy.m_clientObject);
}
const btCollisionShape& ShapeOf(const btBroadphaseProxy& proxy) { return *ObjectOf(proxy).getCollisionShape(); }

/// A manifold that has been made or given back. It is no member of Pairs, since clang exports what the standard library
/// makes of an exported class's members.
struct ManifoldChange {
  std::size_t pair;  // Place of the pair that did so.
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

  /// Whether a dispatch is going on.
  bool AreBeingSolved() const { return are_being_solved_; }

  /// @return false if the pairs are few next to those of another cache: entries belong to one cache.
  bool Solve(btOverlappingPairCache& pair_cache, const btDispatcherInfo& info, btDispatcher* dispatcher);
  /// Invalidates the entries of a cache's pairs, which others solve.
  void Forget(const btOverlappingPairCache& pair_cache) {
    if (&pair_cache == pair_cache_) are_known_ = false;
  }

  /// Locks Bullet's pools and the list of manifolds, while threads are at work; else owns no lock.
  std::unique_lock<std::mutex> Lock() {
    return are_shared_ ? std::unique_lock(mutex_) : std::unique_lock<std::mutex>();
  }
  // Both need the lock.
  void NoteNew(btPersistentManifold* manifold);
  void NoteReleased(btPersistentManifold* manifold) { manifolds_.push_back({current_pair, manifold, false}); }

 private:
  void SolvePair(std::size_t place, const btDispatcherInfo& info);
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
  std::mutex mutex_;                       // Guards Bullet's pools, the list of manifolds, and the changes.
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
  are_known_ = true;  // A callback that dispatches the same pairs resets it.
  separated_.BeginDispatch(pairs_, info.m_timeStep);
  are_being_solved_ = true;
  if (team_) {
    SolveShared(info);
  } else {
    SolveInOrder(info);
  }
  are_being_solved_ = false;
  return true;
}

void CollisionDispatcher::Pairs::SolveInOrder(const btDispatcherInfo& info) try {
  for (std::size_t place = 0; place < pairs_.size(); ++place) SolvePair(place, info);
} catch (...) {
  are_known_ = are_being_solved_ = false;  // A callback has thrown: the other pairs are as they were.
  throw;
}

void CollisionDispatcher::Pairs::SolveShared(const btDispatcherInfo& info) noexcept {
  are_shared_ = true;
  concurrent_.clear();
  for (std::size_t place = 0; place < pairs_.size(); ++place) {
    const btBroadphasePair& pair = *pairs_[place];
    if (separated_.IsKnown(place) ||
        IsConcurrent(dispatcher_.m_doubleDispatchContactPoints, ShapeOf(*pair.m_pProxy0), ShapeOf(*pair.m_pProxy1))) {
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
  if (separated_.IsApart(place)) return;
  btBroadphasePair& pair = *pairs_[place];
  SeparationReport report;
  current_pair = place;
  {
    const ReportScope scope(report);
    dispatcher_.getNearCallback()(pair, dispatcher_, info);
  }
  separated_.Update(place, pair, report);
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

void CollisionDispatcher::Pairs::NoteNew(btPersistentManifold* manifold) {
  DGD_ASSERT(manifold->m_index1a == dispatcher_.m_manifoldsPtr.size() - 1);
  dispatcher_.m_manifoldsPtr.pop_back();
  manifolds_.push_back({current_pair, manifold, true});
}

CollisionDispatcher::CollisionDispatcher(btCollisionConfiguration* configuration, const DispatcherOptions& options,
                                         int bullet_version)
    : btCollisionDispatcher(Checked(configuration, options, bullet_version)),
      default_near_callback_(getNearCallback()) {
  pairs_.reset(new Pairs(*this, options.threads));
}

CollisionDispatcher::~CollisionDispatcher() = default;

bool CollisionDispatcher::IsPlainDispatch(const btDispatcherInfo& info) const {
  // A callback of a pair that is being solved may dispatch others, such as a ghost's.
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
  const auto lock = pairs_->Lock();
  btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(body_0, body_1);
  if (lock && manifold != nullptr) pairs_->NoteNew(manifold);
  return manifold;
}

void CollisionDispatcher::releaseManifold(btPersistentManifold* manifold) {
  const auto lock = pairs_->Lock();
  if (lock) return pairs_->NoteReleased(manifold);
  btCollisionDispatcher::releaseManifold(manifold);
}

void* CollisionDispatcher::allocateCollisionAlgorithm(int size) {
  const auto lock = pairs_->Lock();
  return btCollisionDispatcher::allocateCollisionAlgorithm(size);
}

void CollisionDispatcher::freeCollisionAlgorithm(void* algorithm) {
  const auto lock = pairs_->Lock();
  btCollisionDispatcher::freeCollisionAlgorithm(algorithm);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
