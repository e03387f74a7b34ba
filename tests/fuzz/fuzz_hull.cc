// Convex hulls of any points: no exception but std::invalid_argument, and else a hull that is one, by its own lists and
// by the points.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/shapes/polytope.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/fuzz_target.h"

namespace dgd_fuzz {
namespace {

using dgd::ConvexHull;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

/// Of the points' extent: what Qhull's rounding leaves outside of a facet that it merged from several.
constexpr double kTolerance = 1e-9;
/// Metres: a set so small is a point, for the squares of its lengths are none.
constexpr double kTiniest = 1e-150;

Points ReadPoints(FuzzInput& input) {
  constexpr std::size_t kMost = 200;
  Points points;
  const bool is_moderate = input.Flip(), is_flat = input.Flip();
  const double shrink = std::ldexp(1.0, -input.Below(64));  // Of one axis: nearly flat sets.
  while (!input.IsOver() && points.size() < kMost) {
    Vector3d point =
        is_moderate ? Vector3d(input.ModerateNumber(), input.ModerateNumber(), input.ModerateNumber()) : input.Vector();
    if (is_flat) point.z() *= shrink;
    points.push_back(point);
  }
  return points;
}

class HullCheck {
 public:
  HullCheck(const Points& points, const ConvexHull& hull) : points_(points), hull_(hull) {
    Vector3d low = points[0], high = points[0];
    for (const Vector3d& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    extent_ = (high - low).cwiseAbs().maxCoeff();
    reach_ = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  }

  void Run() const {
    CheckVertices();
    CheckLists();
    if (hull_.dimension == 3) CheckEuler();
    CheckPlanes();
    CheckCenter();
    CheckSupport();
  }

 private:
  void CheckVertices() const {
    Require(!hull_.vertices.empty() && hull_.vertices.size() <= points_.size(), "number of vertices");
    for (const Vector3d& vertex : hull_.vertices) {
      Require(std::ranges::find(points_, vertex) != points_.end(), "a vertex that is no point");
    }
    const std::size_t least[] = {1, 2, 3, 4};
    Require(hull_.dimension >= 0 && hull_.dimension <= 3, "dimension");
    Require(hull_.vertices.size() >= least[hull_.dimension], "too few vertices for the dimension");
  }

  /// Each list of lists is within its array, and the two say the same.
  void CheckLists() const {
    const auto is_list = [&](const std::vector<int>& start, std::size_t count, std::size_t size) {
      return start.size() == count + 1 && start.front() == 0 && std::ranges::is_sorted(start) &&
             start.back() == static_cast<int>(size);
    };
    if (hull_.dimension < 2) {
      Require(hull_.normals.empty(), "facets of what has none");
      return;
    }
    Require(is_list(hull_.facet_start, hull_.normals.size(), hull_.facet_vertices.size()), "the facets' vertices");
    Require(is_list(hull_.vertex_start, hull_.vertices.size(), hull_.vertex_facets.size()), "the vertices' facets");
    std::set<std::pair<int, int>> of_facets, of_vertices;
    for (std::size_t facet = 0; facet < hull_.normals.size(); ++facet) {
      Require(hull_.facet_start[facet + 1] - hull_.facet_start[facet] >= 3, "a facet of fewer than three vertices");
      for (int i = hull_.facet_start[facet]; i < hull_.facet_start[facet + 1]; ++i) {
        const dgd::VertexId vertex = hull_.facet_vertices[static_cast<std::size_t>(i)];
        Require(vertex < hull_.vertices.size(), "a vertex that is not there");
        Require(of_facets.insert({static_cast<int>(facet), static_cast<int>(vertex)}).second, "a vertex twice");
      }
    }
    for (std::size_t vertex = 0; vertex < hull_.vertices.size(); ++vertex) {
      for (int i = hull_.vertex_start[vertex]; i < hull_.vertex_start[vertex + 1]; ++i) {
        of_vertices.insert({hull_.vertex_facets[static_cast<std::size_t>(i)], static_cast<int>(vertex)});
      }
    }
    Require(of_facets == of_vertices, "facets and vertices disagree");
  }

  /// As many edges as a closed surface has: each is a side of two facets.
  void CheckEuler() const {
    const auto vertices = static_cast<int>(hull_.vertices.size()), facets = static_cast<int>(hull_.normals.size()),
               sides = static_cast<int>(hull_.facet_vertices.size());
    Require(sides % 2 == 0 && vertices - sides / 2 + facets == 2, "not a closed surface");
  }

  void CheckPlanes() const {
    for (std::size_t facet = 0; facet < hull_.normals.size(); ++facet) {
      const Vector3d& normal = hull_.normals[facet];
      Require(std::abs(normal.norm() - 1) <= 1e-9, "a normal that is none");
      const dgd::VertexId first = hull_.facet_vertices[static_cast<std::size_t>(hull_.facet_start[facet])];
      for (const Vector3d& point : points_) {
        const double height = normal.dot(point - hull_.vertices[first]);
        Require(height <= kTolerance * extent_ + kTiniest, "a point outside of a facet", height);
      }
    }
  }

  void CheckCenter() const {
    Require(hull_.center.allFinite() && hull_.inradius >= 0 && std::isfinite(hull_.inradius), "the centre");
    Require(hull_.dimension == 3 || hull_.inradius == 0, "an inradius of what is flat");
    if (!(hull_.inradius > 0)) return;
    for (std::size_t facet = 0; facet < hull_.normals.size(); ++facet) {
      // The plane of no point's but the nearest's: a safe bound is below all of them.
      const dgd::VertexId first = hull_.facet_vertices[static_cast<std::size_t>(hull_.facet_start[facet])];
      const double height = hull_.normals[facet].dot(hull_.vertices[first] - hull_.center);
      Require(hull_.inradius <= height + kTolerance * extent_, "an inradius that is too large", hull_.inradius);
    }
  }

  /// By the scan and by the climb, against all points.
  void CheckSupport() const {
    const dgd::Polytope<double> polytope(hull_);
    const dgd::Mesh<double> mesh(hull_);
    const Vector3d directions[] = {{1, 0, 0}, {0, 0, -1}, {1, 1, 1}, {-0.3, 0.5, 0.1}, {1e-9, -1, 1e-9}};
    dgd::FeatureId hint = dgd::kNoFeature;
    for (const Vector3d& direction : directions) {
      double highest = -std::numeric_limits<double>::infinity();
      for (const Vector3d& point : points_) highest = std::max(highest, direction.dot(point));
      const auto scanned = polytope.Support(direction), climbed = mesh.Support(direction, hint);
      hint = climbed.feature;
      for (const auto& support : {scanned, climbed}) {
        Require(support.feature < hull_.vertices.size() && support.point == hull_.vertices[support.feature],
                "a support point that is no vertex");
        const double missing = highest - direction.dot(support.point);
        Require(missing <= kTolerance * extent_ + 1e-14 * reach_ + kTiniest, "a support point that is not the farthest",
                missing);
      }
    }
  }

  void Require(bool holds, const char* what, double figure = 0) const {
    if (holds) return;
    std::ostringstream message;
    message.precision(17);
    message << what << " (" << figure << "); dimension " << hull_.dimension << ", " << hull_.vertices.size()
            << " vertices of " << points_.size() << " points:\n";
    for (const Vector3d& point : points_) message << point.transpose() << "\n";
    Fail(message.str());
  }

  const Points& points_;
  const ConvexHull& hull_;
  double extent_, reach_;
};

}  // namespace
}  // namespace dgd_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dgd_fuzz;
  FuzzInput input({data, size});
  const Points points = ReadPoints(input);
  std::optional<dgd::ConvexHull> hull;
  try {
    hull = dgd::BuildConvexHull(points);
  } catch (const std::invalid_argument&) {
    return 0;  // None, one that is not finite, or Qhull's own reason.
  }
  HullCheck(points, *hull).Run();
  return 0;
}
