#include "simulation/feature_distance.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// Parameter in [0, 1] of the point of the segment a + t * direction that is nearest to `point`.
double NearestParameter(const Vector3d& a, const Vector3d& direction, const Vector3d& point) {
  const double length_sq = direction.squaredNorm();
  if (length_sq == 0) return 0;
  return std::clamp(direction.dot(point - a) / length_sq, 0.0, 1.0);
}

Connection Between(const Vector3d& on_first, const Vector3d& on_second) {
  return {(on_second - on_first).norm(), on_first, on_second};
}

const Connection& Shorter(const Connection& a, const Connection& b) { return b.distance < a.distance ? b : a; }

// The connection of the inner points of two segments, if the lines are not parallel and it falls on both.
std::optional<Connection> ConnectInsides(const Segment& first, const Segment& second) {
  const Vector3d u = first[1] - first[0];
  const Vector3d v = second[1] - second[0];
  const Vector3d offset = second[0] - first[0];
  const Vector3d normal = u.cross(v);
  const double normal_sq = normal.squaredNorm();
  if (normal_sq == 0) return std::nullopt;
  // By Cramer's rule on offset = s u - t v + r normal.
  const double s = offset.cross(v).dot(normal) / normal_sq;
  const double t = offset.cross(u).dot(normal) / normal_sq;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return Between(first[0] + s * u, second[0] + t * v);
}

}  // namespace

Connection Connect(const Segment& first, const Segment& second) {
  // Either an inner connection, or one that ends in one of the four end points: all five are cheap, and taking the
  // shortest needs no case distinction for parallel lines, where rounding would decide it.
  const Vector3d u = first[1] - first[0];
  const Vector3d v = second[1] - second[0];
  Connection best = Between(first[0], second[0] + NearestParameter(second[0], v, first[0]) * v);
  best = Shorter(best, Between(first[1], second[0] + NearestParameter(second[0], v, first[1]) * v));
  best = Shorter(best, Between(first[0] + NearestParameter(first[0], u, second[0]) * u, second[0]));
  best = Shorter(best, Between(first[0] + NearestParameter(first[0], u, second[1]) * u, second[1]));
  if (const auto inner = ConnectInsides(first, second)) best = Shorter(best, *inner);
  return best;
}

std::optional<Connection> ConnectToInside(const Vector3d& point, const Triangle& triangle, const Vector3d& normal) {
  // A point in touch with the triangle must not count as below it by rounding, nor must one above the diagonal of a
  // flat face fall between its two triangles. Relative to the coordinates and to the area; a double's rounding is
  // 2e-16.
  constexpr double kTolerance = 1e-13;
  const double height = normal.dot(point - triangle[0]);
  if (height < -kTolerance * (point.norm() + triangle[0].norm())) return std::nullopt;
  const double twice_area = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).dot(normal);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d edge = triangle[(i + 1) % 3] - triangle[i];
    if (edge.cross(point - triangle[i]).dot(normal) < -kTolerance * twice_area) return std::nullopt;
  }
  return Connection{std::max(height, 0.0), point, point - height * normal};
}

}  // namespace dgd_demos
