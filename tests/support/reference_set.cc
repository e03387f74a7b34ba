#include "support/reference_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace dgd_test {
namespace {

using Eigen::Vector3d;

double HighestOf(const std::vector<Vector3d>& points, const Vector3d& direction) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Vector3d& point : points) highest = std::max(highest, direction.dot(point));
  return highest;
}

std::vector<Vector3d> Corners(const ReferenceSet& set) {
  std::vector<Vector3d> corners;
  switch (set.type) {
    case CoreType::kPoint:
      return {Vector3d::Zero()};
    case CoreType::kSegment:
      return {{0, 0, set.size[0]}, {0, 0, -set.size[0]}};
    case CoreType::kBox:
      for (const double x : {-set.size[0], set.size[0]}) {
        for (const double y : {-set.size[1], set.size[1]}) {
          for (const double z : {-set.size[2], set.size[2]}) corners.emplace_back(x, y, z);
        }
      }
      return corners;
    case CoreType::kTriangle:
    case CoreType::kPolytope:
    case CoreType::kMesh:
    case CoreType::kDsf:
      return set.points;
    default:
      throw std::logic_error("a curved set has no vertices");
  }
}

/// The p-norm of the heights above the centre, straight from the definition.
double DsfHeight(const ReferenceSet& set, const Vector3d& direction) {
  const double highest = HighestOf(set.points, direction) - direction.dot(set.center);
  double sum = 0;
  for (const Vector3d& point : set.points) {
    const double height = direction.dot(point - set.center);
    if (height > 0) sum += std::pow(height / highest, set.exponent);
  }
  return highest * std::pow(sum, 1 / set.exponent) + direction.dot(set.center);
}

void Print(std::ostream& out, const Vector3d& v) { out << "{" << v.x() << ", " << v.y() << ", " << v.z() << "}"; }

void Print(std::ostream& out, const char* name, const ReferenceSet& set, const ReferencePose& pose) {
  out << name << ": " << Name(set.type) << " size ";
  Print(out, set.size);
  out << " radius " << set.radius << "\n  points";
  for (const Vector3d& point : set.points) {
    out << " ";
    Print(out, point);
    out << ",";
  }
  if (set.type == CoreType::kDsf) {
    out << "\n  exponent " << set.exponent << " center ";
    Print(out, set.center);
  }
  out << "\n  rotation, by rows";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out << " " << pose.rotation(row, column) << ",";
  }
  out << "\n  translation ";
  Print(out, pose.translation);
  out << "\n";
}

}  // namespace

const char* Name(CoreType type) {
  static const char* const kNames[] = {"Point",    "Segment", "Triangle",  "Box",  "Cylinder", "Cone",
                                       "Polytope", "Frustum", "Ellipsoid", "Mesh", "Dsf"};
  return kNames[static_cast<int>(type)];
}

double ReferenceSet::Height(const Vector3d& direction) const {
  const double lateral = std::hypot(direction.x(), direction.y());
  switch (type) {
    case CoreType::kCylinder:
      return radius + size[0] * lateral + size[1] * std::abs(direction.z());
    case CoreType::kCone:
      return radius + std::max(size[1] / 2 * direction.z(), size[0] * lateral - size[1] / 2 * direction.z());
    case CoreType::kFrustum:
      return radius +
             std::max(size[0] * lateral - size[2] / 2 * direction.z(), size[1] * lateral + size[2] / 2 * direction.z());
    case CoreType::kEllipsoid:
      return radius + size.cwiseProduct(direction).norm();
    case CoreType::kDsf:
      return radius + DsfHeight(*this, direction);
    default:
      return radius + HighestOf(Corners(*this), direction);
  }
}

Vector3d ReferenceSet::Middle() const {
  Vector3d sum = Vector3d::Zero();
  if (points.empty()) return sum;
  for (const Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double ReferenceSet::Extent() const {
  double reach = 0;
  switch (type) {
    case CoreType::kCylinder:
      reach = std::hypot(size[0], size[1]);
      break;
    case CoreType::kCone:
      reach = std::max(std::hypot(size[0], size[1]) / 2, size[0]);
      break;
    case CoreType::kFrustum:
      reach = std::hypot(std::max(size[0], size[1]), size[2] / 2);
      break;
    case CoreType::kEllipsoid:
      reach = size.maxCoeff();
      break;
    default:
      for (const Vector3d& corner : Corners(*this)) reach = std::max(reach, (corner - Middle()).norm());
  }
  // The p-norm of n heights is so much larger than the largest of them at most.
  if (type == CoreType::kDsf) reach *= std::pow(static_cast<double>(points.size()), 1 / exponent);
  return 2 * (reach + radius);
}

double ReferencePair::SeparationAlong(const Vector3d& normal) const {
  // About set 1's origin: far from the world's, the heights' rounding would hide what is to be checked.
  const Vector3d& origin = pose_1.translation;
  const double top_1 = set_1.Height(pose_1.rotation.transpose() * normal);
  const double bottom_2 =
      normal.dot(pose_2.translation - origin) - set_2.Height(-(pose_2.rotation.transpose() * normal));
  return bottom_2 - top_1;
}

std::string ReferencePair::Dump() const {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  Print(out, "set 1", set_1, pose_1);
  Print(out, "set 2", set_2, pose_2);
  return out.str();
}

double Height(const ReferenceSet& set, const ReferencePose& pose, const Vector3d& direction) {
  return set.Height(pose.rotation.transpose() * direction) + direction.dot(pose.translation);
}

std::vector<Vector3d> WorldVertices(const ReferenceSet& set, const ReferencePose& pose) {
  std::vector<Vector3d> vertices = Corners(set);
  for (Vector3d& vertex : vertices) vertex = pose * vertex;
  return vertices;
}

ReferenceSet Scaled(const ReferenceSet& set, double scale) {
  ReferenceSet scaled = set;
  scaled.size *= scale;
  scaled.radius *= scale;
  scaled.center *= scale;
  for (Vector3d& point : scaled.points) point *= scale;
  return scaled;
}

}  // namespace dgd_test
