#include "plugin/bullet_oracle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dgd_test {
namespace {

/// Some points of a convex set: at most four, the corners of a simplex.
struct Simplex {
  std::array<Vector, 4> points;
  int size = 0;

  const Vector& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
  void Add(const Vector& point) { points[static_cast<std::size_t>(size++)] = point; }
};

/// The point of the affine hull nearest to the origin; false if it lies outside the simplex or the simplex is flat.
bool NearestInside(const Simplex& simplex, Vector& nearest) {
  const int edges = simplex.size - 1;
  nearest = simplex[0];
  if (edges == 0) return true;
  Eigen::MatrixXd directions(3, edges);
  for (int i = 0; i < edges; ++i) directions.col(i) = simplex[i + 1] - simplex[0];
  const auto factors = directions.colPivHouseholderQr();
  if (factors.rank() < edges) return false;
  const Eigen::VectorXd weights = factors.solve(-simplex[0]);
  if (weights.minCoeff() < 0 || weights.sum() > 1) return false;
  nearest += directions * weights;
  return true;
}

/// The point of the simplex nearest to the origin, by trying every face of it; keeps that face.
Vector NearestPoint(Simplex& simplex) {
  Simplex best_face;
  Vector best;
  double best_norm = std::numeric_limits<double>::infinity();
  for (unsigned mask = 1; mask < (1U << simplex.size); ++mask) {
    Simplex face;
    for (int i = 0; i < simplex.size; ++i) {
      if ((mask >> i & 1U) != 0) face.Add(simplex[i]);
    }
    Vector nearest;
    if (!NearestInside(face, nearest) || !(nearest.norm() < best_norm)) continue;
    best = nearest;
    best_norm = nearest.norm();
    best_face = face;
  }
  simplex = best_face;
  return best;
}

/// Distance of the origin to the convex set with this support function.
template <class Support>
CoreDistance DistanceToOrigin(const Support& support) {
  constexpr int kMaxSteps = 300;
  constexpr double kNegligible = 1e-14;
  CoreDistance distance;
  Simplex simplex;
  simplex.Add(support(Vector(0, 0, 1)));
  double lower = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Vector nearest = NearestPoint(simplex);
    const double norm = nearest.norm();
    distance.upper = norm;
    if (simplex.size == 4 || norm <= kNegligible) return {0, 0, Vector::Zero()};
    const Vector farthest = support(-nearest);
    const double proven = farthest.dot(nearest) / norm;
    if (step == 0 || proven > lower) {
      lower = proven;
      distance.normal_b_to_a = nearest / norm;
    }
    if (norm - proven <= kNegligible * (1 + farthest.norm())) break;
    const auto end = simplex.points.begin() + simplex.size;
    if (std::find(simplex.points.begin(), end, farthest) != end) break;
    simplex.Add(farthest);
  }
  distance.lower = std::max(0.0, lower);
  return distance;
}

}  // namespace

btTransform MakeTransform(const Eigen::Matrix3d& rotation, const Vector& translation) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) {
    basis[row].setValue(btScalar(rotation(row, 0)), btScalar(rotation(row, 1)), btScalar(rotation(row, 2)));
  }
  return btTransform(basis, ToBullet(translation));
}

Vector PosedConvex::CoreSupport(const Vector& direction) const {
  Eigen::Matrix3d rotation;
  for (int row = 0; row < 3; ++row) rotation.row(row) = ToEigen(pose.getBasis()[row]);
  const Vector local = rotation.transpose() * direction.normalized();
  return rotation * ToEigen(shape.localGetSupportVertexWithoutMarginNonVirtual(ToBullet(local))) +
         ToEigen(pose.getOrigin());
}

double PosedConvex::SupportValue(const Vector& direction) const {
  return direction.dot(CoreSupport(direction)) + Margin();
}

double PlaneSeparation(const PosedConvex& a, const PosedConvex& b, const Vector& normal_b_to_a) {
  return -a.SupportValue(-normal_b_to_a) - b.SupportValue(normal_b_to_a);
}

CoreDistance DistanceOfCores(const PosedConvex& a, const PosedConvex& b) {
  return DistanceToOrigin(
      [&](const Vector& direction) -> Vector { return a.CoreSupport(direction) - b.CoreSupport(-direction); });
}

SignedDistance DistanceOfShapes(const PosedConvex& a, const PosedConvex& b) {
  const CoreDistance cores = DistanceOfCores(a, b);
  SignedDistance distance;
  distance.exact = cores.lower > 0;
  distance.value = cores.lower - a.Margin() - b.Margin();
  distance.normal_b_to_a = cores.normal_b_to_a;
  return distance;
}

double Outside(const PosedConvex& shape, const Vector& point) {
  const auto support = [&](const Vector& direction) -> Vector { return shape.CoreSupport(direction) - point; };
  return DistanceToOrigin(support).upper - shape.Margin();
}

}  // namespace dgd_test
