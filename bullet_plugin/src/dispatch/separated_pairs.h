// Pairs that are certainly still apart, decided from compact arrays.
//
// In a heap most pairs of the broadphase stay apart along the axis that separated them in the last step. To find that,
// the pair's own algorithm reads the pair, its manifold, two bodies, two proxies and two shapes: in a world of
// thousands, it waits for memory. Here a pair is one entry in the order of Bullet's pairs, and a body one record.
//
// The axis is fixed in body A's frame, as in the pair's cache, so that A's support value is a constant. B's changes by
// no more than the radius of its core times the change of the direction in its own frame. Where the bound suffices, the
// pair's algorithm would find the pair apart as well and change nothing (SeparationReport): leaving out its call leaves
// the same world to the last bit. Where not, it is called, and reports a new bound.
#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btVector3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dgd_bullet/linkage.h"
#include "separation_report.h"

class btCollisionObject;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class SeparatedPairs {
 public:
  /// Begins a dispatch, and reads its bodies.
  /// @param pairs      All pairs of the cache, in the order in which they are visited. Each must be passed to
  ///                   IsApart(), and then to Update() where that is false.
  /// @param time_step  Seconds; not positive where there is none.
  void BeginDispatch(const std::vector<btBroadphasePair*>& pairs, btScalar time_step);

  /// Drops all entries: others may have dispatched the pairs.
  void Clear() { entries_.clear(); }

  /// Whether a pair is the one that was at this place in the last dispatch, and of two convex shapes that this library
  /// solves.
  bool IsKnown(std::size_t place) const { return entries_[place].algorithm != nullptr; }

  // The following may be called by several threads, for one place each.

  /// Whether the pair is certainly apart, so that its algorithm need not be called.
  bool IsApart(std::size_t place) const;
  /// Stores what the pair's algorithm has reported.
  void Update(std::size_t place, const btBroadphasePair& pair, const SeparationReport& report);

 private:
  /// A body in this dispatch.
  struct Body {
    btMatrix3x3 basis;
    btVector3 origin;
    btVector3 path;              // Way of the centre of mass in the time step, before constraints; metres.
    btScalar turn;               // No point goes farther by rotation; metres.
    btScalar extent;             // Sum of the lengths whose roundoff counts; metres.
    btScalar core_radius = 0;    // That of `shape`; metres.
    btScalar order;              // Coordinate by which bodies of one type are ordered; metres.
    std::uint64_t shape = 0;     // Hash of its content; 0 if its pairs are not decided here.
    std::uint32_t dispatch = 0;  // The last one in which it was read.
    const btBroadphaseProxy* proxy = nullptr;
  };

  struct Entry {
    btVector3 normal_in_a;      // Normal from A to B in A's frame; unit.
    btVector3 normal_in_b;      // The same in B's frame when the bound was found.
    btScalar support;           // Sum of the support values of A and B along it then, margins included; metres.
    btScalar contact_distance;  // See SeparationReport; metres.
    std::uint64_t shape_0, shape_1;
    std::uint32_t body_0, body_1;                     // Indices of the pair's bodies, in its order.
    const btCollisionAlgorithm* algorithm = nullptr;  // The pair's; null if that is unknown.
    bool is_apart = false;                            // Whether what is above the bodies is valid.
    bool is_swapped = false, is_ordered_by_place = false;
  };

  /// Whether an entry is the pair's; its bodies are read then.
  bool IsOf(const Entry& entry, const btBroadphasePair& pair);
  /// Reads a body, once a dispatch.
  /// @return whether it has this index.
  bool ReadBody(std::uint32_t index, const btBroadphaseProxy& proxy);
  void Read(const btCollisionObject& object, Body& body);

  std::vector<Entry> entries_;
  std::vector<Body> bodies_;  // Bodies by their index in the world.
  btScalar time_step_ = 0;
  std::uint32_t dispatch_ = 0;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
