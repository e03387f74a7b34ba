#include "scene/read_shape.h"

#include <Eigen/Geometry>
#include <exception>
#include <numbers>

#include "scene/mesh_file.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// Wide enough for anything sensible, narrow enough to catch slips: degrees for radians, a lost decimal point.
constexpr Range kSize = {0, 1e3, /*low_is_allowed=*/false};  // m
constexpr Range kCoordinate = {-1e4, 1e4};                   // m
constexpr Range kAngle = {-2 * std::numbers::pi, 2 * std::numbers::pi};
constexpr Range kScale = {0, 1e6, /*low_is_allowed=*/false};

Shape ReadMesh(const JsonReader& object, const std::filesystem::path& folder) {
  const JsonReader file = object.At("file");
  const std::filesystem::path path = folder / file.Text();
  const double scale = object.Has("scale") ? object.At("scale").Number(kScale) : 1;
  try {
    return Hull{LoadConvexMesh(path, scale)};
  } catch (const std::exception& error) {
    file.Fail("\"" + path.string() + "\" gives no convex mesh: " + error.what());
  }
}

}  // namespace

Shape ReadShape(const JsonReader& object, const std::filesystem::path& folder, std::vector<std::string_view> other_keys,
                const std::string& other_types) {
  const std::string type = object.At("type").Text();
  const auto allow = [&](auto... own_keys) {
    other_keys.push_back("type");
    (other_keys.push_back(own_keys), ...);
    object.AllowOnly(other_keys);
  };
  const auto size = [&](const char* key) { return object.At(key).Number(kSize); };
  if (type == "sphere") {
    allow("radius");
    return Sphere{size("radius")};
  }
  if (type == "capsule") {
    allow("radius", "length");
    return Capsule{size("radius"), size("length")};
  }
  if (type == "box") {
    allow("half_extents");
    return Box{object.At("half_extents").Vector(kSize)};
  }
  if (type == "cylinder") {
    allow("radius", "height");
    return Cylinder{size("radius"), size("height")};
  }
  if (type == "cone") {
    allow("radius", "height");
    return Cone{size("radius"), size("height")};
  }
  if (type != "mesh") {
    object.At("type").Fail("must be " + other_types + "sphere, capsule, box, cylinder, cone or mesh, not \"" + type +
                           "\"");
  }
  allow("file", "scale");
  return ReadMesh(object, folder);
}

Pose ReadPose(const JsonReader& object) {
  Pose pose;
  pose.position = object.At("position").Vector(kCoordinate);
  if (object.Has("rotation")) {
    const Vector3d angles = object.At("rotation").Vector(kAngle);
    pose.rotation =
        (Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Vector3d::UnitX()))
            .toRotationMatrix();
  }
  return pose;
}

}  // namespace dgd_demos
