#include "motion/motion_scene.h"

#include <algorithm>
#include <numbers>
#include <set>
#include <sstream>

#include "scene/json_reader.h"
#include "scene/read_shape.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// Wide enough for anything sensible, narrow enough to catch slips such as degrees for radians.
constexpr Range kAngle = {-4 * std::numbers::pi, 4 * std::numbers::pi};
constexpr Range kAcceleration = {-1e3, 1e3};                     // m/s^2
constexpr Range kMass = {0, 1e6, /*low_is_allowed=*/false};      // kg
constexpr Range kInertia = {0, 1e9, /*low_is_allowed=*/false};   // kg m^2
constexpr Range kCoordinate = {-1e4, 1e4};                       // m
constexpr Range kVelocity = {0, 1e3, /*low_is_allowed=*/false};  // rad/s
constexpr Range kEffort = {0, 1e6, /*low_is_allowed=*/false};    // N m
constexpr Range kAxis = {-1, 1};

// A name that is new among those of its kind.
std::string ReadName(const JsonReader& object, std::set<std::string>& names) {
  const JsonReader name = object.At("name");
  if (!names.insert(name.Text()).second) name.Fail("is the name of an earlier one, too: " + name.Dump());
  // Names head the columns of CSV files, and stand in sentences.
  const auto is_special = [](char letter) { return letter == ',' || letter == '"' || (letter >= 0 && letter < ' '); };
  if (std::ranges::any_of(name.Text(), is_special)) {
    name.Fail("must have no comma, quotation mark or control character: " + name.Dump());
  }
  return name.Text();
}

std::vector<LinkShape> ReadLinkShapes(const JsonReader& shapes, const std::filesystem::path& folder) {
  std::vector<LinkShape> link_shapes;
  for (std::size_t i = 0; i < shapes.Size(); ++i) {
    const JsonReader shape = shapes.At(i);
    link_shapes.push_back({ReadShape(shape, folder, {"position", "rotation"}), ReadPose(shape)});
  }
  return link_shapes;
}

Joint ReadJoint(const JsonReader& object, std::set<std::string>& names) {
  object.AllowOnly({"name", "position", "rotation", "axis", "lower", "upper", "max_velocity", "max_effort"});
  Joint joint;
  joint.name = ReadName(object, names);
  joint.origin = ReadPose(object);
  joint.axis = object.At("axis").Vector(kAxis);
  if (joint.axis.isZero()) object.At("axis").Fail("must be a direction, not " + object.At("axis").Dump());
  joint.axis.normalize();
  joint.lower = object.At("lower").Number(kAngle);
  joint.upper = object.At("upper").Number({joint.lower, kAngle.high, /*low_is_allowed=*/false});
  joint.max_velocity = object.At("max_velocity").Number(kVelocity);
  joint.max_effort = object.At("max_effort").Number(kEffort);
  return joint;
}

Link ReadLink(const JsonReader& object, bool is_base, std::set<std::string>& names,
              const std::filesystem::path& folder) {
  Link link;
  link.name = ReadName(object, names);
  if (object.Has("shapes")) link.shapes = ReadLinkShapes(object.At("shapes"), folder);
  if (is_base) {
    object.AllowOnly({"name", "shapes"});  // It does not move, so its mass does not matter.
    return link;
  }
  object.AllowOnly({"name", "shapes", "joint", "mass", "centre_of_mass", "inertia"});
  link.mass = object.At("mass").Number(kMass);
  link.centre_of_mass = object.At("centre_of_mass").Vector(kCoordinate);
  if (object.Has("inertia")) link.inertia = object.At("inertia").Vector(kInertia);
  return link;
}

// Joints are named wherever something is said of them, so that none is mistaken for another.
void AllowOnlyJoints(const JsonReader& object, const Arm& arm) {
  std::string known;
  for (const Joint& joint : arm.joints) known += (known.empty() ? "" : ", ") + joint.name;
  for (const std::string& name : object.Keys()) {
    const auto has_name = [&](const Joint& joint) { return joint.name == name; };
    if (std::ranges::none_of(arm.joints, has_name)) {
      object.At(name).Fail("the arm " + arm.name + " has no joint \"" + name + "\"; its joints: " + known);
    }
  }
}

Configuration ReadConfiguration(const JsonReader& angles, const Arm& arm) {
  AllowOnlyJoints(angles, arm);
  Configuration configuration(static_cast<Eigen::Index>(arm.joints.size()));
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    configuration[static_cast<Eigen::Index>(i)] = angles.At(arm.joints[i].name).Number(kAngle);
  }
  if (const std::optional<std::size_t> beyond = FindJointBeyondLimits(arm, configuration)) {
    const Joint& joint = arm.joints[*beyond];
    std::ostringstream complaint;
    complaint << "exceeds the limits of joint " << joint.name << ", " << joint.lower << " to " << joint.upper
              << " rad, with " << angles.At(joint.name).Dump();
    angles.At(joint.name).Fail(complaint.str());
  }
  return configuration;
}

SceneArm ReadArm(const JsonReader& object, std::set<std::string>& names, const std::filesystem::path& folder) {
  object.AllowOnly({"name", "base", "links", "flange", "rest", "unchecked"});
  SceneArm scene_arm;
  Arm& arm = scene_arm.arm;
  arm.name = ReadName(object, names);
  object.At("base").AllowOnly({"position", "rotation"});
  arm.base = ReadPose(object.At("base"));

  const JsonReader links = object.At("links");
  if (links.Size() < 2) links.Fail("must be the base and at least one link with a joint, not " + links.Dump());
  std::set<std::string> link_names, joint_names;
  for (std::size_t i = 0; i < links.Size(); ++i) {
    const JsonReader link = links.At(i);
    arm.links.push_back(ReadLink(link, i == 0, link_names, folder));
    if (i > 0) arm.joints.push_back(ReadJoint(link.At("joint"), joint_names));
  }
  object.At("flange").AllowOnly({"position", "rotation"});
  arm.flange = ReadPose(object.At("flange"));
  scene_arm.rest = object.Has("rest") ? ReadConfiguration(object.At("rest"), arm)
                                      : Configuration::Zero(static_cast<Eigen::Index>(arm.joints.size()));
  return scene_arm;
}

std::vector<Obstacle> ReadObstacles(const JsonReader& list, const std::filesystem::path& folder) {
  std::set<std::string> names;
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < list.Size(); ++i) {
    const JsonReader object = list.At(i);
    const Shape shape = ReadShape(object, folder, {"name", "position", "rotation"});
    obstacles.push_back({ReadName(object, names), shape, ReadPose(object)});
  }
  return obstacles;
}

// Pairs of names: a link of this arm, then another of them, or an obstacle.
void ReadUnchecked(const JsonReader& list, const std::vector<Obstacle>& obstacles, SceneArm& scene_arm) {
  const auto is_link = [&](const std::string& name) {
    return std::ranges::any_of(scene_arm.arm.links, [&](const Link& link) { return link.name == name; });
  };
  const auto is_obstacle = [&](const std::string& name) {
    return std::ranges::any_of(obstacles, [&](const Obstacle& obstacle) { return obstacle.name == name; });
  };
  for (std::size_t i = 0; i < list.Size(); ++i) {
    const JsonReader pair = list.At(i);
    if (pair.Size() != 2) pair.Fail("must be two names, not " + pair.Dump());
    const std::string first = pair.At(std::size_t{0}).Text(), second = pair.At(1).Text();
    if (!is_link(first))
      pair.At(std::size_t{0}).Fail("the arm " + scene_arm.arm.name + " has no link \"" + first + "\"");
    if (!is_link(second) && !is_obstacle(second)) {
      pair.At(1).Fail("there is no link of the arm " + scene_arm.arm.name + " and no obstacle \"" + second + "\"");
    }
    scene_arm.unchecked.emplace_back(first, second);
  }
}

// Two angles for some of the joints; the others' limits are those of the arm.
void ReadSearch(const JsonReader& plan, const Arm& arm, MotionScene& scene) {
  scene.search_lower = scene.search_upper = scene.start;
  if (plan.Has("search")) AllowOnlyJoints(plan.At("search"), arm);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const auto index = static_cast<Eigen::Index>(i);
    double &lower = scene.search_lower[index], &upper = scene.search_upper[index];
    lower = joint.lower;
    upper = joint.upper;
    if (!plan.Has("search") || !plan.At("search").Has(joint.name)) continue;
    const JsonReader limits = plan.At("search").At(joint.name);
    if (limits.Size() != 2) limits.Fail("must be two angles, not " + limits.Dump());
    lower = limits.At(std::size_t{0}).Number({joint.lower, joint.upper});
    upper = limits.At(1).Number({lower, joint.upper, /*low_is_allowed=*/false});
    for (const double angle : {scene.start[index], scene.goal[index]}) {
      if (angle >= lower && angle <= upper) continue;
      limits.Fail("must hold start and goal of joint " + joint.name + ", which " + limits.Dump() + " does not");
    }
  }
}

void ReadPlan(const JsonReader& plan, MotionScene& scene) {
  plan.AllowOnly({"arm", "start", "goal", "search"});
  const std::string name = plan.At("arm").Text();
  const auto has_name = [&](const SceneArm& scene_arm) { return scene_arm.arm.name == name; };
  const auto found = std::ranges::find_if(scene.arms, has_name);
  if (found == scene.arms.end()) plan.At("arm").Fail("there is no arm \"" + name + "\" in this scene");
  scene.planned_arm = static_cast<std::size_t>(found - scene.arms.begin());
  scene.start = ReadConfiguration(plan.At("start"), found->arm);
  scene.goal = ReadConfiguration(plan.At("goal"), found->arm);
  ReadSearch(plan, found->arm, scene);
}

}  // namespace

MotionScene LoadMotionScene(const std::filesystem::path& file) {
  const nlohmann::json document = ParseJsonFile(file);
  MotionScene scene;
  scene.file = file.string();
  const JsonReader root(scene.file, document);
  if (root.Has("bodies")) root.At("bodies").Fail("is of a scene for headless_sim, where bodies fall and no arm moves");
  root.AllowOnly({"about", "gravity", "arms", "obstacles", "plan"});
  scene.about = root.At("about").Text();
  scene.gravity = root.At("gravity").Vector(kAcceleration);

  scene.obstacles = ReadObstacles(root.At("obstacles"), file.parent_path());
  const JsonReader arms = root.At("arms");
  std::set<std::string> names;
  for (std::size_t i = 0; i < arms.Size(); ++i) {
    const JsonReader arm = arms.At(i);
    scene.arms.push_back(ReadArm(arm, names, file.parent_path()));
    if (arm.Has("unchecked")) ReadUnchecked(arm.At("unchecked"), scene.obstacles, scene.arms.back());
  }
  ReadPlan(root.At("plan"), scene);
  return scene;
}

}  // namespace dgd_demos
