// Ground as a mesh, for worlds of tests and benchmarks.
#pragma once

#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include "plugin/rigid_body.h"

namespace dgd_test {

/// Adds a square of `cells` by `cells` squares about the origin, of two triangles each.
/// @param pitch   Side of a square, metres.
/// @param height  double(double x, double y): z of the corner at (x, y), metres.
template <class Height>
void AddGrid(btTriangleMesh& mesh, int cells, double pitch, const Height& height) {
  const auto corner = [&](int i, int j) {
    const double x = (i - 0.5 * cells) * pitch, y = (j - 0.5 * cells) * pitch;
    return Vec(x, y, height(x, y));
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      mesh.addTriangle(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
      mesh.addTriangle(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
}

}  // namespace dgd_test
