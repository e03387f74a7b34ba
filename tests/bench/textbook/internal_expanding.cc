#include "bench/textbook/internal_expanding.h"

#include <Eigen/Geometry>
#include <limits>

#include "bench/textbook/ray_query.h"

namespace dgd_bench {
namespace {

using Eigen::Vector3d;
using Ray = RayQuery<3>;

/// The simplex of the origin and the first facet, or of the last facet and a support point: what of it matters is the
/// facet through which the ray leaves it.
class ExpandingSimplex {
 public:
  explicit ExpandingSimplex(const Ray& ray)
      : p_(ray.P()),
        exit_(ray.InitialFacet()),
        normal_(NormalOf(exit_.of_c.col(0), exit_.of_c.col(1), exit_.of_c.col(2))) {
    lower_ = normal_.dot(exit_.of_c.col(0)) / normal_.dot(p_);
  }

  /// Outward normal of the facet through which the ray leaves, of any length.
  const Vector3d& Normal() const { return normal_; }
  /// The ray's length up to there over |p|.
  double Lower() const { return lower_; }

  /// To the simplex of this facet and a point beyond it. False if the ray leaves through none of its other facets, as
  /// happens by rounding.
  bool ExpandTo(const Ray::Point& apex) {
    int replaced = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      // Without corner i, in the old facet's sense: the apex takes its place.
      const Vector3d& from = exit_.of_c.col((i + 1) % 3);
      const Vector3d normal = NormalOf(from, exit_.of_c.col((i + 2) % 3), apex.of_c);
      const double along_ray = normal.dot(p_);
      if (!(along_ray > 0)) continue;  // The ray can only enter here.
      const double length = normal.dot(apex.of_c) / along_ray;
      if (!(length < least)) continue;
      least = length;
      normal_ = normal;
      replaced = i;
    }
    if (replaced < 0) return false;
    lower_ = least;
    exit_.SetCorner(replaced, apex);
    return true;
  }

  const Ray::Facet& Exit() const { return exit_; }
  /// Conic, of p in the facet's corners: barycentric ones of the point where the ray leaves, by areas around it.
  Vector3d Weights() const {
    const Eigen::Matrix3d around = exit_.of_c.colwise() - lower_ * p_;
    Vector3d areas;
    for (int i = 0; i < 3; ++i) areas[i] = normal_.dot(around.col((i + 1) % 3).cross(around.col((i + 2) % 3)));
    return areas / (areas.sum() * lower_);
  }

 private:
  static Vector3d NormalOf(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return (b - a).cross(c - a); }

  const Vector3d& p_;
  Ray::Facet exit_;
  Vector3d normal_;
  double lower_;
};

}  // namespace

dgd::Result<double> InternalExpanding(const SupportFunction<3>& set_1, const dgd::Pose<double>& pose_1,
                                      const SupportFunction<3>& set_2, const dgd::Pose<double>& pose_2,
                                      double tolerance) {
  Ray ray(set_1, pose_1, set_2, pose_2, tolerance);
  ExpandingSimplex simplex(ray);
  ray.SetLower(simplex.Lower());
  int iterations = 0;
  bool can_expand = true;
  while (can_expand && !ray.HasConverged() && iterations < kMaxIterations) {
    const Ray::Point support = ray.Support(simplex.Normal());
    ++iterations;
    // Where the facet is the border of C already, it stays.
    if (ray.HasConverged()) break;
    can_expand = simplex.ExpandTo(support);
    ray.SetLower(simplex.Lower());
  }
  return ray.MakeResult(simplex.Exit(), simplex.Weights(), iterations);
}

}  // namespace dgd_bench
