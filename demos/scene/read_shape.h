// The parts that all kinds of scene files have in common: a shape and its pose.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/json_reader.h"
#include "scene/pose.h"
#include "scene/shape.h"

namespace dgd_demos {

/// The shape of an object with a "type" and that type's own keys. A mesh's path is relative to the folder.
/// @param other_keys   Which the object may have besides "type" and the shape's.
/// @param other_types  Which the caller reads by itself, for the message about an unknown one: "random_polytopes, ".
/// @throws SceneError for unknown types and keys, sizes out of range, and meshes that give no convex hull.
Shape ReadShape(const JsonReader& object, const std::filesystem::path& folder, std::vector<std::string_view> other_keys,
                const std::string& other_types = "");

/// "position", and optionally "rotation": roll, pitch and yaw; about the fixed x, then y, then z axis.
Pose ReadPose(const JsonReader& object);

}  // namespace dgd_demos
