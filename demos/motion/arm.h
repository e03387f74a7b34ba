// A serial robot arm as a value: links, the joints between them, and where they are in a configuration.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/pose.h"
#include "scene/shape.h"

namespace dgd_demos {

/// Joint angles in the order of the arm's joints, rad.
using Configuration = Eigen::VectorXd;

/// A convex collision shape, fixed to a link.
struct LinkShape {
  Shape shape;
  Pose pose;  ///< In the link's frame.
};

struct Link {
  std::string name;
  double mass = 0;                                           ///< kg; 0 for the base only, which is fixed to the world.
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< In the link's frame, m.
  /// Principal moments about the centre of mass, along the link's axes, kg m^2; without them, whoever simulates the arm
  /// estimates them from the shapes.
  std::optional<Eigen::Vector3d> inertia;
  std::vector<LinkShape> shapes;  ///< May be empty: such a link collides with nothing.
};

/// A revolute joint. It turns its child link about `axis`, and at angle 0 the child's frame is `origin`.
struct Joint {
  std::string name;
  Pose origin;           ///< Of the child link in the parent link's frame, at angle 0.
  Eigen::Vector3d axis;  ///< Unit vector in the child link's frame, through its origin.
  double lower, upper;   ///< Limits of the angle, rad.
  double max_velocity;   ///< rad/s
  double max_effort;     ///< N m
};

struct Arm {
  std::string name;
  Pose base;                  ///< Of the first link in the world.
  std::vector<Link> links;    ///< From the base to the last one: one more than joints.
  std::vector<Joint> joints;  ///< Joint i connects links[i] to its child links[i + 1].
  Pose flange;                ///< Where tools are mounted, in the last link's frame.
};

/// Poses of all links in the world, in their order, base first.
/// @param configuration  As many angles as the arm has joints.
/// @param poses          Out; resized to the number of links, so that a loop allocates only once.
void ComputeLinkPoses(const Arm& arm, const Configuration& configuration, std::vector<Pose>& poses);
std::vector<Pose> LinkPoses(const Arm& arm, const Configuration& configuration);

/// Pose of the flange in the world.
Pose FlangePose(const Arm& arm, const Configuration& configuration);

/// The first joint whose angle is outside its limits by more than `tolerance`, in rad, or nothing. NaN is outside.
std::optional<std::size_t> FindJointBeyondLimits(const Arm& arm, const Configuration& configuration,
                                                 double tolerance = 0);

}  // namespace dgd_demos
