// What the queries of a mesh's triangles leave from one step to the next.
//
// Bullet begins from scratch with each triangle in every step. With the last normal, two in three triangles that a
// body's bounding box reaches are found to be still apart, and the others' contacts are updated.
#pragma once

#include <vector>

#include "ahead/meeting.h"
#include "dgd/assert.h"
#include "dgd/query_types.h"
#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What the query of a triangle leaves for the next one.
struct TriangleState {
  dgd::WarmStart<double> warm_start;  ///< That of the body and the triangle.
  bool had_contact = false;           ///< Whether the last query has found contacts,
  Moment moment;                      ///< and at which moment of the step: PairContacts::moment.
};

/// The states of the triangles of this step, taken over from those of the last one by a hash table: the cost is that of
/// the triangles, whichever way the body goes. One that is taken for another's costs time and no more: it is a hint.
class TriangleStates {
 public:
  /// Makes this step's states the last one's. Throws std::bad_alloc, as all that adds.
  void Begin();

  /// Adds a triangle's state: that of the last step, or a new one.
  /// @param part, index  Bullet's numbers of the triangle. The halves of a heightfield's squares share them.
  /// @return its number.
  int Add(int part, int index);

  TriangleState& operator[](int number) {
    DGD_ASSERT(number >= 0 && static_cast<std::size_t>(number) < entries_.size());
    return entries_[static_cast<std::size_t>(number)].state;
  }

 private:
  static constexpr int kNone = -1;

  struct Entry {
    int part, index;
    int next;  // The next entry of the last step in the same bucket.
    TriangleState state;
  };

  int& BucketOf(int part, int index);

  std::vector<Entry> entries_, last_;
  std::vector<int> buckets_;  // First entry of the last step in each bucket; a power of two of them.
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
