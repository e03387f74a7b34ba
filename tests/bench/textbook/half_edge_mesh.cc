#include "bench/textbook/half_edge_mesh.h"

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace dgd_bench {

HalfEdgeMesh::HalfEdgeMesh(const dgd::ConvexHull& hull) : center_(hull.center) {
  if (hull.dimension != 3) {
    throw std::invalid_argument("the incremental algorithm walks on solid hulls; got one of dimension " +
                                std::to_string(hull.dimension));
  }
  for (const Eigen::Vector3d& vertex : hull.vertices) vertices_.push_back(vertex - center_);
  edge_of_vertex_.resize(vertices_.size());
  std::map<std::pair<int, int>, int> by_ends;
  const auto corner = [&](int i) { return static_cast<int>(hull.facet_vertices[static_cast<std::size_t>(i)]); };
  for (std::size_t f = 0; f < hull.normals.size(); ++f) {
    const int begin = hull.facet_start[f], end = hull.facet_start[f + 1];
    polars_.push_back(hull.normals[f] / hull.normals[f].dot(Vertex(corner(begin))));
    edge_of_facet_.push_back(begin);
    for (int i = begin; i < end; ++i) {
      const int next = i + 1 < end ? i + 1 : begin;
      edges_.push_back({.origin = corner(i), .facet = static_cast<int>(f), .next = next});
      edge_of_vertex_[static_cast<std::size_t>(corner(i))] = i;
      by_ends[{corner(i), corner(next)}] = i;
    }
  }
  for (const auto& [ends, edge] : by_ends) {
    edges_[static_cast<std::size_t>(edge)].twin = by_ends.at({ends.second, ends.first});
  }
}

}  // namespace dgd_bench
