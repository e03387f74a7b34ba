// Index of the point farthest along a direction, among points stored by coordinate.
#pragma once

#include <cstddef>
#include <vector>

#include "dgd/shapes/vertex_scan_kernels.h"
#include "dgd/types.h"

namespace dgd {

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
  VertexId Farthest(const Vector3<S>& direction) const {
    return vertex_scan::Farthest(coordinates_.data(), padded_, direction.x(), direction.y(), direction.z());
  }

 private:
  std::size_t size_;
  std::size_t padded_;
  std::vector<S> coordinates_;
};

}  // namespace dgd
