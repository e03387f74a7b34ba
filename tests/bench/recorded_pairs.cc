#include "bench/recorded_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace dgd_bench {
namespace {

using dgd_bullet::RecordedShape;
using dgd_test::SetType;

SetType TypeOf(RecordedShape::Core core) {
  switch (core) {
    case RecordedShape::Core::kPoint:
      return SetType::kPoint;
    case RecordedShape::Core::kSegment:
      return SetType::kSegment;
    case RecordedShape::Core::kTriangle:
      return SetType::kTriangle;
    case RecordedShape::Core::kBox:
      return SetType::kBox;
    case RecordedShape::Core::kCylinder:
      return SetType::kCylinder;
    case RecordedShape::Core::kCone:
      return SetType::kCone;
    case RecordedShape::Core::kHull:
      break;
  }
  return SetType::kPolytope;
}

}  // namespace

dgd_test::SetNumbers SetFrom(const RecordedShape& shape) {
  dgd_test::SetNumbers set{.type = TypeOf(shape.core), .radius = shape.radius};
  if (shape.core == RecordedShape::Core::kTriangle || shape.core == RecordedShape::Core::kHull) {
    for (std::size_t i = 0; i < shape.numbers.size(); i += 3) {
      set.points.emplace_back(shape.numbers[i], shape.numbers[i + 1], shape.numbers[i + 2]);
    }
  } else {
    std::ranges::copy(shape.numbers, set.lengths.begin());
  }
  return set;
}

dgd_test::PoseNumbers PoseFrom(const dgd_bullet::RecordedPose& pose) {
  dgd_test::PoseNumbers numbers;
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Matrix3d rotation = Eigen::Map<const RowMajor>(pose.rotation.data());
  numbers.rotation = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  numbers.translation = Eigen::Map<const Eigen::Vector3d>(pose.translation.data());
  return numbers;
}

}  // namespace dgd_bench
