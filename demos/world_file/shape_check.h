// Checks the collision shapes of a .bullet file: whether Bullet's importer can make them, and without harm.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "world_file/record.h"

namespace dgd_demos {

/// Bullet's numbers of the shapes (BroadphaseNativeTypes), which are the same in all versions that are read.
enum class ShapeType {
  kBox = 0,
  kHull = 4,
  kSphere = 8,
  kMultiSphere = 9,
  kCapsule = 10,
  kCone = 11,
  kCylinder = 13,
  kTriangleMesh = 21,
  kScaledTriangleMesh = 22,
  kPlane = 28,
  kCompound = 31,
};

class ShapeCheck {
 public:
  explicit ShapeCheck(Blocks& blocks) : blocks_(&blocks) {}

  /// @return whether the importer makes the shape; if not, MissingShapes() says which.
  /// @throws SceneError if it would read outside of the file, or make an invalid shape.
  bool IsRestored(Block& shape);

  /// Kinds of shapes that cannot be made, each with the number of shapes.
  const std::map<std::string, int>& MissingShapes() const { return missing_; }
  /// Triangle info maps (of internal edges), which are left out.
  int info_maps() const { return info_maps_; }

 private:
  // Shapes are made once for themselves and once for each compound that has them.
  struct Cost {
    bool is_restored;
    std::size_t depth = 1;  // Depth of compounds in compounds.
    double made = 1;        // Number of shapes, with all children.
  };

  Cost Check(Block& shape);
  Cost CheckNew(Block& shape);
  Cost CheckCompound(const Record& compound);
  void CheckConvex(const Record& convex, ShapeType type);
  void CheckDimensions(const Record& convex, ShapeType type, double margin);
  void CheckHull(const Record& hull);
  void CheckMultiSphere(const Record& spheres);
  void CheckPlane(const Record& plane);
  void CheckMesh(const Record& mesh);
  void CheckMeshPart(const Record& part);
  void CheckIndices(const Record& part, int triangles, int vertices);

  Blocks* blocks_;
  std::map<const Block*, Cost> known_;
  std::set<const Block*> begun_;
  std::map<std::string, int> missing_;
  int info_maps_ = 0;
};

}  // namespace dgd_demos
