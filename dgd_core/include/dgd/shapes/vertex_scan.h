// Points stored by coordinate: which one is farthest along a direction, and all of them elsewhere.
#pragma once

#include <cstddef>
#include <vector>

#include "dgd/shapes/vertex_scan_kernels.h"
#include "dgd/types.h"

namespace dgd {

/// Hulls of up to so many vertices are scanned, larger ones climbed. With AVX2, 16
/// vertices take 10 ns by the scan and 25 by the climb, 64 take 24 and 28, 256 take 82 and 30.
inline constexpr VertexId kMostScannedVertices = 64;

/// Points as three arrays, padded with copies of the first point to whole blocks, so that a scan needs no remainder.
template <class S>
class PointArrays {
 public:
  static constexpr std::size_t kBlock = vertex_scan::kBlockBytes / sizeof(S);

  template <class Range>
  explicit PointArrays(const Range& points)
      : size_(points.size()), padded_((size_ + kBlock - 1) / kBlock * kBlock), coordinates_(3 * padded_) {
    for (std::size_t i = 0; i < padded_; ++i) {
      const auto& point = points[i < size_ ? i : 0];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        coordinates_[axis * padded_ + i] = static_cast<S>(point[static_cast<Eigen::Index>(axis)]);
      }
    }
  }

  std::size_t size() const { return size_; }

  Vector3<S> operator[](std::size_t i) const {
    return {coordinates_[i], coordinates_[padded_ + i], coordinates_[2 * padded_ + i]};
  }

  /// A point of largest <direction, x>; some point if the direction is NaN. The same one on every processor.
  VertexId Farthest(const Vector3<S>& direction) const { return Farthest(coordinates_.data(), padded_, direction); }

  /// Length of each of the three arrays.
  std::size_t PaddedSize() const { return padded_; }
  /// The points less `center`, times `matrix`, in the same order.
  /// @param placed  Out: three arrays of PaddedSize() each, one after the other.
  void PlaceInto(S* placed, const Vector3<S>& center, const Matrix3<S>& matrix) const {
    vertex_scan::Place(coordinates_.data(), padded_, center.data(), matrix.data(), placed);
  }
  /// The same among points that have been placed.
  static VertexId Farthest(const S* placed, std::size_t padded, const Vector3<S>& direction) {
    return vertex_scan::Farthest(placed, padded, direction.x(), direction.y(), direction.z());
  }

 private:
  std::size_t size_;
  std::size_t padded_;
  std::vector<S> coordinates_;
};

}  // namespace dgd
