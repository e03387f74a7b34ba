// The types of sets that the soak and the iteration benchmark draw their pairs from, as one table.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace dgd_test {

/// By core; a radius is no type of its own. Three dimensions first.
enum class SetType : std::uint8_t {
  kPoint,
  kSegment,
  kTriangle,
  kBox,
  kCylinder,
  kCone,
  kFrustum,
  kEllipsoid,
  kPolytope,
  kMesh,
  kDsf,
  kAffineBox,
  kAffineCylinder,
  kPlainBox,
  kSuperellipsoid,
  kCircle,
  kStadium,
  kRectangle,
  kEllipse,
  kPolygon,
  kSuperellipse,
};

struct SetTypeInfo {
  SetType type;
  const char* name;  ///< On the command line and in tables.
  int dimension;
  bool is_curved;  ///< The core is no polytope: the solver takes steps without end.
  bool is_solid;   ///< The core has an interior.
};

/// In the order of SetType.
inline constexpr std::array kSetTypes = {
    SetTypeInfo{SetType::kPoint, "point", 3, false, false},
    SetTypeInfo{SetType::kSegment, "segment", 3, false, false},
    SetTypeInfo{SetType::kTriangle, "triangle", 3, false, false},
    SetTypeInfo{SetType::kBox, "box", 3, false, true},
    SetTypeInfo{SetType::kCylinder, "cylinder", 3, true, true},
    SetTypeInfo{SetType::kCone, "cone", 3, true, true},
    SetTypeInfo{SetType::kFrustum, "frustum", 3, true, true},
    SetTypeInfo{SetType::kEllipsoid, "ellipsoid", 3, true, true},
    SetTypeInfo{SetType::kPolytope, "polytope", 3, false, true},
    SetTypeInfo{SetType::kMesh, "mesh", 3, false, true},
    SetTypeInfo{SetType::kDsf, "dsf", 3, true, true},
    SetTypeInfo{SetType::kAffineBox, "affine-box", 3, false, true},
    SetTypeInfo{SetType::kAffineCylinder, "affine-cylinder", 3, true, true},
    SetTypeInfo{SetType::kPlainBox, "plain-box", 3, false, true},
    SetTypeInfo{SetType::kSuperellipsoid, "superellipsoid", 3, true, true},
    SetTypeInfo{SetType::kCircle, "circle", 2, false, false},
    SetTypeInfo{SetType::kStadium, "stadium", 2, false, false},
    SetTypeInfo{SetType::kRectangle, "rectangle", 2, false, true},
    SetTypeInfo{SetType::kEllipse, "ellipse", 2, true, true},
    SetTypeInfo{SetType::kPolygon, "polygon", 2, false, true},
    SetTypeInfo{SetType::kSuperellipse, "superellipse", 2, true, true},
};
inline constexpr std::size_t kSetTypeCount = kSetTypes.size();

constexpr const SetTypeInfo& InfoOf(SetType type) { return kSetTypes[static_cast<std::size_t>(type)]; }

constexpr std::optional<SetType> SetTypeNamed(std::string_view name) {
  for (const SetTypeInfo& info : kSetTypes) {
    if (info.name == name) return info.type;
  }
  return std::nullopt;
}

static_assert(
    [] {
      for (std::size_t i = 0; i < kSetTypeCount; ++i) {
        if (static_cast<std::size_t>(kSetTypes[i].type) != i) return false;
      }
      return true;
    }(),
    "kSetTypes is in the order of SetType");

}  // namespace dgd_test
