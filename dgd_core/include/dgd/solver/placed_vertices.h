// The vertices of two cores as they lie in the world, for a query along many directions: rotated once, so that no
// direction and no support point has to be. Cold queries of hulls of 8 to 20 vertices, which take six directions, take
// 0.85 of the time.
#pragma once

#include <array>
#include <cstddef>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/vertex_scan.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// Vertices of the two cores, as they take part in the Minkowski difference about its centre.
template <class S>
class PlacedVertices {
 public:
  using Points = PointArrays<S>;

  bool AreThere() const { return padded_1_ > 0; }

  /// @param points_1, points_2  In the cores' frames; null for no vertices, and then there are none.
  void Place(const Points* points_1, const Vector3<S>& center_1, const Matrix3<S>& rotation_1, const Points* points_2,
             const Vector3<S>& center_2, const Matrix3<S>& rotation_2) {
    if (points_1 == nullptr || points_2 == nullptr) return;
    if (points_1->PaddedSize() > kCapacity || points_2->PaddedSize() > kCapacity) return;
    padded_1_ = points_1->PaddedSize();
    padded_2_ = points_2->PaddedSize();
    points_1->PlaceInto(of_1_.data(), center_1, rotation_1);
    points_2->PlaceInto(of_2_.data(), center_2, -rotation_2);
  }

  /// Farthest along a direction. @pre AreThere().
  /// @tparam Corner  Made of the point and of both vertices.
  template <class Corner>
  Corner Farthest(const Vector3<S>& direction) const {
    DGD_ASSERT(AreThere());
    const VertexId i = Points::Farthest(of_1_.data(), padded_1_, direction);
    const VertexId j = Points::Farthest(of_2_.data(), padded_2_, direction);
    return {{of_1_[i] + of_2_[j], of_1_[padded_1_ + i] + of_2_[padded_2_ + j],
             of_1_[2 * padded_1_ + i] + of_2_[2 * padded_2_ + j]},
            i,
            j};
  }

 private:
  /// Whole blocks. Hulls that are scanned have no more, but for flat ones.
  static constexpr std::size_t kCapacity = kMostScannedVertices;
  static_assert(kCapacity % Points::kBlock == 0);

  std::size_t padded_1_ = 0, padded_2_ = 0;   // Length of each coordinate's array.
  std::array<S, 3 * kCapacity> of_1_, of_2_;  // Those of set 2 are negated.
};

}  // namespace dgd::solver_internal
