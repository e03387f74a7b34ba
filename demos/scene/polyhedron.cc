#include "scene/polyhedron.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// Sine of the angle below which two neighbouring faces count as one plane. Qhull's own normals of one merged facet are
// equal to the bit; this only has to absorb rounding in facets that Qhull did not merge (about 1e-15 for unit sizes).
constexpr double kCoplanarSine = 1e-9;

// Runs Qhull and owns what it allocates: its context, and the text of its complaints.
class Qhull {
 public:
  explicit Qhull(std::vector<double>& coordinates) : complaints_(open_memstream(&text_, &text_size_)) {
    qh_zero(&context_, complaints_);
    // Qt: triangulated output. Pp: no advice about narrow hulls, the caller only needs to know whether it worked.
    char command[] = "qhull Qt Pp";
    const int count = static_cast<int>(coordinates.size() / 3);
    const int status = qh_new_qhull(&context_, 3, count, coordinates.data(), False, command, nullptr, complaints_);
    if (status != qh_ERRnone) {
      std::fflush(complaints_);
      // Qhull explains at length; its first line says what is wrong.
      const std::string reason = std::string(text_).substr(0, std::string(text_).find('\n'));
      Free();
      throw std::invalid_argument("no convex hull of " + std::to_string(count) + " points: " + reason);
    }
  }
  ~Qhull() { Free(); }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  qhT* context() { return &context_; }

 private:
  void Free() {
    int long_blocks = 0, long_bytes = 0;
    qh_freeqhull(&context_, !qh_ALL);
    qh_memfreeshort(&context_, &long_blocks, &long_bytes);
    std::fclose(complaints_);
    std::free(text_);
  }

  char* text_ = nullptr;
  std::size_t text_size_ = 0;
  FILE* complaints_;
  qhT context_;
};

// Triangles of the hull, as indices into the input points.
std::vector<Polyhedron::Face> HullFaces(qhT* qh, const std::vector<Vector3d>& points) {
  std::vector<Polyhedron::Face> faces;
  facetT* facet;
  vertexT *vertex, **vertexp;
  FORALLfacets {
    Polyhedron::Face face;
    std::size_t corner = 0;
    FOREACHvertex_(facet->vertices) face.vertices.at(corner++) = qh_pointid(qh, vertex->point);
    face.normal = Vector3d(facet->normal[0], facet->normal[1], facet->normal[2]);
    // Qhull lists the corners in either sense; its normal always points outward.
    const Vector3d& a = points[face.vertices[0]];
    if ((points[face.vertices[1]] - a).cross(points[face.vertices[2]] - a).dot(face.normal) < 0) {
      std::swap(face.vertices[1], face.vertices[2]);
    }
    faces.push_back(face);
  }
  return faces;
}

// Renumbers the faces' corners to the vertices in use, and returns these in input order.
std::vector<Vector3d> KeepUsedVertices(const std::vector<Vector3d>& points, std::vector<Polyhedron::Face>& faces) {
  constexpr int kUnused = -1, kUsed = 0;
  std::vector<int> new_index(points.size(), kUnused);
  for (const Polyhedron::Face& face : faces) {
    for (const int v : face.vertices) new_index[v] = kUsed;
  }
  std::vector<Vector3d> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (new_index[i] == kUnused) continue;
    new_index[i] = static_cast<int>(vertices.size());
    vertices.push_back(points[i]);
  }
  for (Polyhedron::Face& face : faces) {
    for (int& v : face.vertices) v = new_index[v];
  }
  return vertices;
}

std::vector<Polyhedron::Edge> EdgesBetween(const std::vector<Polyhedron::Face>& faces) {
  std::vector<Polyhedron::Edge> edges;
  std::map<std::pair<int, int>, int> first_face;
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ends = std::minmax({faces[f].vertices[i], faces[f].vertices[(i + 1) % 3]});
      const auto [known, is_new] = first_face.emplace(std::pair(ends.first, ends.second), f);
      if (is_new) continue;
      const int other = known->second;
      const bool flat = faces[f].normal.cross(faces[other].normal).norm() < kCoplanarSine;
      if (!flat) edges.push_back({{ends.first, ends.second}, {other, f}});
    }
  }
  return edges;
}

}  // namespace

Polyhedron ConvexHull(const std::vector<Vector3d>& points) {
  if (points.size() < 4) {
    throw std::invalid_argument("no convex hull of " + std::to_string(points.size()) + " points: 4 are needed");
  }
  std::vector<double> coordinates;
  for (const Vector3d& point : points) coordinates.insert(coordinates.end(), {point.x(), point.y(), point.z()});

  Qhull qhull(coordinates);
  Polyhedron hull;
  hull.faces = HullFaces(qhull.context(), points);
  hull.vertices = KeepUsedVertices(points, hull.faces);
  hull.edges = EdgesBetween(hull.faces);
  return hull;
}

Polyhedron PointPolyhedron() {
  return {{Vector3d::Zero()}, {}, {{{0, 0}, {Polyhedron::kNoFace, Polyhedron::kNoFace}}}};
}

Polyhedron SegmentPolyhedron(double half_length) {
  return {{Vector3d(0, 0, -half_length), Vector3d(0, 0, half_length)},
          {},
          {{{0, 1}, {Polyhedron::kNoFace, Polyhedron::kNoFace}}}};
}

Vector3d Centroid(const Polyhedron& polyhedron) {
  // Sum over the tetrahedra from one vertex to each face. Six times their volume cancels in the quotient.
  const Vector3d& apex = polyhedron.vertices.front();
  Vector3d moment = Vector3d::Zero();
  double volume = 0;
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const Vector3d a = polyhedron.vertices[face.vertices[0]] - apex;
    const Vector3d b = polyhedron.vertices[face.vertices[1]] - apex;
    const Vector3d c = polyhedron.vertices[face.vertices[2]] - apex;
    const double tetrahedron = a.dot(b.cross(c));
    moment += tetrahedron * (a + b + c) / 4;
    volume += tetrahedron;
  }
  return apex + moment / volume;
}

double DistanceToBoundary(const Polyhedron& polyhedron, const Vector3d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polyhedron::Face& face : polyhedron.faces) {
    nearest = std::min(nearest, face.normal.dot(polyhedron.vertices[face.vertices[0]] - point));
  }
  return nearest;
}

double BoundingRadius(const Polyhedron& polyhedron) {
  double radius = 0;
  for (const Vector3d& vertex : polyhedron.vertices) radius = std::max(radius, vertex.norm());
  return radius;
}

}  // namespace dgd_demos
