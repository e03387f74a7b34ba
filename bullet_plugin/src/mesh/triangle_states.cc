#include "mesh/triangle_states.h"

#include <bit>
#include <cstdint>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

void TriangleStates::Begin() {
  last_.swap(entries_);
  entries_.clear();
  buckets_.assign(std::bit_ceil(2 * last_.size() + 1), kNone);
  // The first of those that share a name comes first.
  for (std::size_t i = last_.size(); i-- > 0;) {
    int& bucket = BucketOf(last_[i].part, last_[i].index);
    last_[i].next = bucket;
    bucket = static_cast<int>(i);
  }
}

int TriangleStates::Add(int part, int index) {
  entries_.push_back({part, index, kNone, {}});
  for (int* link = &BucketOf(part, index); *link != kNone;) {
    Entry& entry = last_[static_cast<std::size_t>(*link)];
    if (entry.index == index && entry.part == part) {
      entries_.back().state = entry.state;
      *link = entry.next;
      break;
    }
    link = &entry.next;
  }
  return static_cast<int>(entries_.size()) - 1;
}

int& TriangleStates::BucketOf(int part, int index) {
  DGD_ASSERT(std::has_single_bit(buckets_.size()));
  // Neighbours in a grid are spread by odd multipliers.
  const std::uint32_t hash =
      static_cast<std::uint32_t>(part) * 0x9e3779b1U + static_cast<std::uint32_t>(index) * 0x85ebca77U;
  return buckets_[(hash ^ (hash >> 15)) & (buckets_.size() - 1)];
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
