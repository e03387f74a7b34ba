#include "world_file/shape_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace dgd_demos {
namespace {

constexpr std::size_t kDeepestCompound = 16;
constexpr int kMostShapes = 100'000;     // Shapes with all children, since each compound has its own.
constexpr int kMostHullPoints = 10'000;  // The importer takes the bounds of all points for each one: 10^8 steps.
constexpr int kMostSpheres = 1000;
constexpr int kMostMeshParts = 1 << 10;  // Bullet's tree of boxes has ten bits for the part
constexpr int kMostTriangles = 1 << 21;  // and 21 for the triangle.

struct Kind {
  ShapeType type;
  std::string_view structure;
};

constexpr std::array kKinds = {
    Kind{ShapeType::kBox, "btConvexInternalShapeData"},
    Kind{ShapeType::kSphere, "btConvexInternalShapeData"},
    Kind{ShapeType::kHull, "btConvexHullShapeData"},
    Kind{ShapeType::kMultiSphere, "btMultiSphereShapeData"},
    Kind{ShapeType::kCapsule, "btCapsuleShapeData"},
    Kind{ShapeType::kCone, "btConeShapeData"},
    Kind{ShapeType::kCylinder, "btCylinderShapeData"},
    Kind{ShapeType::kTriangleMesh, "btTriangleMeshShapeData"},
    Kind{ShapeType::kScaledTriangleMesh, "btScaledTriangleMeshShapeData"},
    Kind{ShapeType::kPlane, "btStaticPlaneShapeData"},
    Kind{ShapeType::kCompound, "btCompoundShapeData"},
};

// Bullet's other shapes, by number: its importer makes none of them. Those without a name are internal ones.
std::string NameOfMissing(std::int32_t type) {
  switch (type) {
    case 1:
      return "triangle";
    case 2:
      return "tetrahedron";
    case 3:
      return "convex triangle mesh";
    case 5:
      return "convex point cloud";
    case 14:
      return "uniformly scaled shape";
    case 15:
      return "Minkowski sum";
    case 17:
      return "2D box";
    case 18:
      return "2D convex shape";
    case 24:
      return "heightfield";
    case 25:
      return "GImpact mesh";
    case 26:
      return "multi-material mesh";
    case 27:
      return "empty shape";
    case 29:
      return "signed distance field";
    case 32:
      return "soft body";
    default:
      return "shape of type " + std::to_string(type);
  }
}

}  // namespace

bool ShapeCheck::IsRestored(Block& shape) { return Check(shape).is_restored; }

ShapeCheck::Cost ShapeCheck::Check(Block& shape) {
  const auto known = known_.find(&shape);
  if (known != known_.end()) return known->second;
  if (shape.chunk->code != "SHAP") blocks_->Fail(shape, "a shape is asked for by its pointer, and it is none");
  if (!begun_.insert(&shape).second) blocks_->Fail(shape, "it contains itself");
  if (begun_.size() > kDeepestCompound)
    blocks_->Fail(shape, "it is more than " + std::to_string(kDeepestCompound) + " compounds deep");

  const Cost cost = CheckNew(shape);
  begun_.erase(&shape);
  known_.emplace(&shape, cost);
  return cost;
}

ShapeCheck::Cost ShapeCheck::CheckNew(Block& shape) {
  const std::int32_t type = blocks_->Kind(shape, "btCollisionShapeData", "m_shapeType");
  const auto kind = std::ranges::find(kKinds, type, [](const Kind& k) { return static_cast<std::int32_t>(k.type); });
  if (kind == kKinds.end()) {
    ++missing_[NameOfMissing(type)];
    return {false};
  }
  const Record record = blocks_->Single(shape, kind->structure);
  switch (kind->type) {
    case ShapeType::kBox:
    case ShapeType::kSphere:
      CheckConvex(record, kind->type);
      break;
    case ShapeType::kHull:
      CheckConvex(record.Inner("m_convexInternalShapeData"), kind->type);
      CheckHull(record);
      break;
    case ShapeType::kMultiSphere:
      CheckConvex(record.Inner("m_convexInternalShapeData"), kind->type);
      CheckMultiSphere(record);
      break;
    case ShapeType::kCapsule:
    case ShapeType::kCylinder:
    case ShapeType::kCone:
      CheckConvex(record.Inner("m_convexInternalShapeData"), kind->type);
      record.Integer(kind->type == ShapeType::kCone ? "m_upIndex" : "m_upAxis", 0, 2);
      break;
    case ShapeType::kPlane:
      CheckPlane(record);
      break;
    case ShapeType::kTriangleMesh:
      CheckMesh(record);
      break;
    case ShapeType::kScaledTriangleMesh:
      record.Numbers("m_localScaling", Limit::kPositive);
      CheckMesh(record.Inner("m_trimeshShapeData"));
      break;
    case ShapeType::kCompound:
      return CheckCompound(record);
  }
  return {true};
}

ShapeCheck::Cost ShapeCheck::CheckCompound(const Record& compound) {
  compound.Inner("m_collisionShapeData").LinkName("m_name");
  const int count = compound.Integer("m_numChildShapes", 0, kMostShapes);
  compound.Numbers("m_collisionMargin", Limit::kNotNegative);
  Cost cost{true};
  if (count == 0) return cost;
  Block& children = compound.Array("m_childShapePtr", "btCompoundShapeChildData", static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Record child(*blocks_, children, static_cast<std::size_t>(i));
    child.CheckPose("m_transform");
    Block* child_shape = child.Target("m_childShape");
    if (child_shape == nullptr) child.Fail("m_childShape", "names no chunk");
    // A compound that is its own child is found here, before it is made.
    const Cost of_child = Check(*child_shape);
    child.Link("m_childShape", child_shape);
    cost.is_restored = cost.is_restored && of_child.is_restored;
    cost.depth = std::max(cost.depth, of_child.depth + 1);
    cost.made += of_child.made;
  }
  if (cost.depth > kDeepestCompound)
    compound.Fail("it is more than " + std::to_string(kDeepestCompound) + " compounds deep");
  if (cost.made > kMostShapes)
    compound.Fail("it has more than " + std::to_string(kMostShapes) + " shapes, with all of its children's");
  if (!cost.is_restored) ++missing_["compound with one of these"];
  return cost;
}

void ShapeCheck::CheckConvex(const Record& convex, ShapeType type) {
  convex.Inner("m_collisionShapeData").LinkName("m_name");
  const double margin = convex.Numbers("m_collisionMargin", Limit::kNotNegative).at(0);
  // Bullet mirrors hulls by a negative scale; elsewhere it makes a size negative.
  const std::vector<double> scaling =
      convex.Numbers("m_localScaling", type == ShapeType::kHull ? Limit::kFinite : Limit::kPositive);
  if (std::ranges::find(scaling, 0.0) != scaling.end()) convex.Fail("m_localScaling", "is 0 along an axis");
  // Hulls and multi-spheres do not use their dimensions, for which Bullet writes uninitialized memory.
  if (type != ShapeType::kHull && type != ShapeType::kMultiSphere) CheckDimensions(convex, type, margin);
}

void ShapeCheck::CheckDimensions(const Record& convex, ShapeType type, double margin) {
  const std::vector<double> sizes = convex.Numbers("m_implicitShapeDimensions", Limit::kFinite);
  const double within = type == ShapeType::kBox || type == ShapeType::kCylinder ? margin : 0;
  const std::size_t used = type == ShapeType::kSphere ? 1 : sizes.size();
  for (std::size_t i = 0; i < used; ++i) {
    if (sizes[i] + within < 0) {
      convex.Fail("m_implicitShapeDimensions", "is " + std::to_string(sizes[i]) + " along an axis");
    }
  }
}

void ShapeCheck::CheckHull(const Record& hull) {
  const int count = hull.Integer("m_numUnscaledPoints", 1, kMostHullPoints);
  const bool in_float = hull.Target("m_unscaledPointsFloatPtr") != nullptr;
  if (in_float && hull.Target("m_unscaledPointsDoublePtr") != nullptr) hull.Fail("it has points of both precisions");
  const char* path = in_float ? "m_unscaledPointsFloatPtr" : "m_unscaledPointsDoublePtr";
  Block& points =
      hull.Array(path, in_float ? "btVector3FloatData" : "btVector3DoubleData", static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    Record(*blocks_, points, static_cast<std::size_t>(i)).Numbers("m_floats", Limit::kFinite);
}

void ShapeCheck::CheckMultiSphere(const Record& spheres) {
  const int count = spheres.Integer("m_localPositionArraySize", 1, kMostSpheres);
  Block& array = spheres.Array("m_localPositionArrayPtr", "btPositionAndRadius", static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Record sphere(*blocks_, array, static_cast<std::size_t>(i));
    sphere.Numbers("m_pos", Limit::kFinite);
    sphere.Numbers("m_radius", Limit::kNotNegative);
  }
}

void ShapeCheck::CheckPlane(const Record& plane) {
  plane.Inner("m_collisionShapeData").LinkName("m_name");
  plane.Numbers("m_localScaling", Limit::kFinite);
  plane.Numbers("m_planeConstant", Limit::kFinite);
  const std::vector<double> normal = plane.Numbers("m_planeNormal", Limit::kFinite);
  // Bullet makes it a unit vector.
  if (!(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] > 1e-6)) {
    plane.Fail("m_planeNormal", "is no direction");
  }
}

void ShapeCheck::CheckMesh(const Record& mesh) {
  mesh.Inner("m_collisionShapeData").LinkName("m_name");
  mesh.Numbers("m_collisionMargin", Limit::kNotNegative);
  const Record parts = mesh.Inner("m_meshInterface");
  const std::vector<double> scaling = parts.Numbers("m_scaling", Limit::kFinite);
  if (std::ranges::find(scaling, 0.0) != scaling.end()) parts.Fail("m_scaling", "is 0 along an axis");
  const int count = parts.Integer("m_numMeshParts", 1, kMostMeshParts);
  Block& array = parts.Array("m_meshPartsPtr", "btMeshPartData", static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) CheckMeshPart(Record(*blocks_, array, static_cast<std::size_t>(i)));
  // The tree of boxes is left out, of which the importer trusts every index: Bullet builds it from the triangles. The
  // angles of internal edges are left out as well, for they are in a hash table.
  if (mesh.Target("m_triangleInfoMap") != nullptr) ++info_maps_;
}

void ShapeCheck::CheckMeshPart(const Record& part) {
  const int triangles = part.Integer("m_numTriangles", 1, kMostTriangles);
  const int vertices = part.Integer("m_numVertices", 1, 3 * kMostTriangles);
  const bool in_float = part.Target("m_vertices3f") != nullptr;
  if (in_float && part.Target("m_vertices3d") != nullptr) part.Fail("it has vertices of both precisions");
  Block& array = in_float ? part.Array("m_vertices3f", "btVector3FloatData", static_cast<std::size_t>(vertices))
                          : part.Array("m_vertices3d", "btVector3DoubleData", static_cast<std::size_t>(vertices));
  for (int i = 0; i < vertices; ++i) {
    Record(*blocks_, array, static_cast<std::size_t>(i)).Numbers("m_floats", Limit::kFinite);
  }
  CheckIndices(part, triangles, vertices);
}

void ShapeCheck::CheckIndices(const Record& part, int triangles, int vertices) {
  struct Form {
    const char* path;
    const char* structure;
    const char* numbers;
    int elements;     // Number of elements of a triangle.
    bool is_wrapped;  // Indices above 32767 are read as negative.
  };
  constexpr std::array kForms = {Form{"m_indices32", "btIntIndexData", "m_value", 3, false},
                                 Form{"m_3indices16", "btShortIntIndexTripletData", "m_values", 1, true},
                                 Form{"m_indices16", "btShortIntIndexData", "m_value", 3, true},
                                 Form{"m_3indices8", "btCharIndexTripletData", "m_values", 1, false}};
  // The first that is there: Bullet before 2.83 left the last one as it found it.
  const auto form = std::ranges::find_if(kForms, [&](const Form& f) { return part.Target(f.path) != nullptr; });
  if (form == kForms.end()) part.Fail("it has no indices of vertices");
  const int elements = triangles * form->elements;
  Block& array = part.Array(form->path, form->structure, static_cast<std::size_t>(elements));
  for (int i = 0; i < elements; ++i) {
    const Record element(*blocks_, array, static_cast<std::size_t>(i));
    for (const double number : element.Numbers(form->numbers)) {
      // Bullet takes the sixteen bits of a short as unsigned.
      const double index = form->is_wrapped && number < 0 ? number + (1 << 16) : number;
      if (index < 0 || index >= vertices) {
        element.Fail(form->numbers, "is " + std::to_string(static_cast<std::int64_t>(index)) + ", and there are " +
                                        std::to_string(vertices) + " vertices");
      }
    }
  }
}

}  // namespace dgd_demos
