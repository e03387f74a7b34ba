// The contacts of a convex body with all triangles of a mesh that it is near, without ghosts at internal edges.
//
// A triangle on its own has edges and corners that a body can hang on to; in a mesh most of them are internal. A
// contact at an edge or corner counts only if that is exposed along the contact's normal, which is if none of the
// triangles that share it rises above it along the normal: the normal is in the feature's Voronoi region (Ericson,
// Real-Time Collision Detection, 5.1.5; the same condition as Bullet's btInternalEdgeUtility and Jolt's ActiveEdges,
// found from the triangles at hand in place of tables). It holds on either side of the surface.
//
// A ghost still means that the body is near the triangle, and may be over its face: one that comes from above is met
// along the triangle's normal in any case (ToTurn()), as the far side of a box that is tilted a little. One from aside,
// of a body so deep that a triangle's own way out is sideways, is only if nothing covers it: it is covered if the
// triangle that rises above it has a contact that counts, or a ghost that is covered.
#pragma once

#include <LinearMath/btTransform.h>

#include <array>
#include <span>
#include <vector>

#include "dgd/assert.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "manifold/mesh_triangle.h"
#include "solver_types.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A contact of a convex body, A, with a triangle of a mesh, B.
struct MeshContact {
  Vector3 normal_on_b;  ///< Normal from the mesh to the body, unit, world.
  Vector3 on_a, on_b;   ///< Places, world, metres.
  double separation;    ///< Separation in metres, negative for overlap.
  int triangle;         ///< Index among the step's triangles.

  // The rest is for the reduction (contact_reduction.h).
  bool touches = false;                           // Whether it touches now or at the end of the step.
  bool is_continued = false;                      // Whether the manifold has it already.
  bool is_new_direction = true, is_apart = true;  // Whether it differs from all that are kept.
};

/// The contacts of one step; their memory is reused in the next. All that adds may throw std::bad_alloc.
class MeshContacts {
 public:
  /// Leaves nothing.
  /// @param mesh  Pose of the mesh; outlives the step.
  void Begin(const btTransform& mesh);

  /// Adds a triangle that the body is near, with contacts or without: its index.
  int AddTriangle(const btVector3* corners, int part, int index);

  /// Adds the contacts that a triangle has along a normal, if there are any.
  /// @param normal  Unit, from the body to the mesh, world.
  void Add(int triangle, const dgd::ContactPatch<double>& patch, const Vector3& normal);

  /// Leaves the contacts of faces, with the faces' own normals, and of exposed edges and corners.
  void RemoveGhosts();

  /// Drops what the body's faces and edges have where they cross from one triangle to another in its plane, if a
  /// contact on that plane is deeper by more than a tolerance: on a plane it would be no contact, and of an impact each
  /// contact takes the whole rebound.
  void DropSeamPoints(double equal_depth);

  /// Triangles whose ghosts are to be met along the triangles' own normals, of the step up to RemoveGhosts().
  std::span<const int> ToTurn() const { return to_turn_; }

  /// Whether a triangle has contacts that count.
  bool HasContacts(int triangle) const;

  /// Unit normal of a triangle, world, on either side of it; zero if it has no area.
  const Vector3& NormalOf(int index) const {
    DGD_ASSERT(index >= 0 && static_cast<std::size_t>(index) < normals_.size());
    return normals_[static_cast<std::size_t>(index)];
  }

  int triangles() const { return static_cast<int>(triangles_.size()); }
  const MeshTriangle& triangle(int index) const {
    DGD_ASSERT(index >= 0 && static_cast<std::size_t>(index) < triangles_.size());
    return triangles_[static_cast<std::size_t>(index)];
  }
  std::vector<MeshContact>& contacts() { return contacts_; }

 private:
  enum class State { kNone, kCounts, kGhost, kCovered };

  /// A triangle's bounding box, in the mesh's frame.
  struct Box {
    bool Contains(const btVector3& place, btScalar tolerance) const {
      // One comparison saves branches.
      const btVector3 above = place - low, below = high - place;
      return btMin(btMin(btMin(above.x(), above.y()), above.z()), btMin(btMin(below.x(), below.y()), below.z())) >=
             -tolerance;
    }

    btVector3 low, high;
  };

  /// Contacts along one normal.
  struct Patch {
    int triangle;
    std::size_t begin, end;  // Range in the list of contacts.
    bool counts;
  };

  /// An edge or corner.
  struct Feature {
    std::array<int, 2> corners;
    int size;
  };

  /// Sorts the triangles into rows, and along these, by the two axes that they spread most on.
  void SortTriangles();
  int RowOf(btScalar place) const;
  void ClassifyFace(Patch& patch);
  bool IsOnSeam(const MeshContact& contact) const;
  void ClassifyFeature(std::size_t patch);
  Feature HighestFeature(const MeshTriangle& triangle, const Vector3& direction) const;
  void CoverGhosts();

  const btTransform* mesh_ = nullptr;
  Matrix3 rotation_;
  std::vector<MeshTriangle> triangles_;
  std::vector<Vector3> normals_;  // See NormalOf().
  std::vector<Box> boxes_;        // Boxes of the triangles.
  struct Sorted {
    int row;
    btScalar low;  // The box's lower end along the row.
    int triangle;
  };
  int row_axis_ = 0, along_axis_ = 0;       // Axes that count the rows, and that go along them.
  btScalar first_row_ = 0, row_width_ = 1;  // Metres.
  btVector3 widths_;                        // Largest widths of boxes.
  std::vector<Sorted> sorted_;
  std::vector<State> states_;  // States of the triangles.
  std::vector<Patch> patches_;
  std::vector<MeshContact> contacts_, kept_;
  struct Link {
    int ghost, above;  // Indices of triangles.
  };
  std::vector<Link> links_;
  std::vector<int> to_turn_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
