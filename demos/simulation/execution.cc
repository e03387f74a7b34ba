#include "simulation/execution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "simulation/arm_world.h"

namespace dgd_demos {
namespace {

void Check(const ExecutionOptions& options) {
  // All are false for NaN.
  if (!(options.step_rate > 0 && std::isfinite(options.step_rate))) {
    throw std::invalid_argument("An execution needs a step rate above 0");
  }
  if (!(options.hold_time >= 0 && std::isfinite(options.hold_time))) {
    throw std::invalid_argument("An execution needs a hold time of 0 or more");
  }
  if (!(options.position_gain > 0 && options.position_gain <= 1)) {
    throw std::invalid_argument("An execution needs a position gain above 0 and up to 1");
  }
  if (options.solver_iterations < 1) throw std::invalid_argument("An execution needs a solver iteration at least");
}

// Adds what is in contact in the step from `begin` to the contacts so far.
void AddContacts(const ArmWorld& world, double begin, std::vector<ExecutionContact>& contacts) {
  for (const ArmWorld::Contact& contact : world.Contacts()) {
    const std::string &first = world.NameOf(contact.first), &second = world.NameOf(contact.second);
    const auto is_same = [&](const ExecutionContact& other) { return other.first == first && other.second == second; };
    const auto known = std::ranges::find_if(contacts, is_same);
    if (known == contacts.end()) {
      contacts.push_back({first, second, begin, begin, contact.distance, contact.force});
      continue;
    }
    known->end = begin;
    known->least_distance = std::min(known->least_distance, contact.distance);
    known->greatest_force = std::max(known->greatest_force, contact.force);
  }
}

void Summarise(const Arm& arm, ExecutionResult& result) {
  double sum_of_squares = 0;
  for (const ExecutionStep& step : result.steps) {
    sum_of_squares += step.tracking_error * step.tracking_error;
    if (step.tracking_error > result.greatest_error) {
      result.greatest_error = step.tracking_error;
      result.greatest_error_time = step.time;
      result.greatest_error_place = step.flange;
    }
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      const auto joint = static_cast<Eigen::Index>(i);
      const double velocity_share = std::abs(step.velocities[joint]) / arm.joints[i].max_velocity;
      result.greatest_velocity_share = std::max(result.greatest_velocity_share, velocity_share);
      const double effort_share = std::abs(step.efforts[joint]) / arm.joints[i].max_effort;
      if (effort_share <= result.greatest_effort_share) continue;
      result.greatest_effort_share = effort_share;
      result.greatest_effort_joint = arm.joints[i].name;
    }
  }
  if (result.steps.empty()) return;
  result.rms_error = std::sqrt(sum_of_squares / static_cast<double>(result.steps.size()));
  result.final_error = result.steps.back().tracking_error;
  result.duration = result.steps.back().time;
}

}  // namespace

ExecutionResult ExecutePath(const MotionScene& scene, const TimedPath& path, const ExecutionOptions& options,
                            const std::function<void(double)>& progress) {
  Check(options);
  const Arm& arm = scene.PlannedArm();
  ArmWorld world(scene, path.Sample(0).angles, options);
  ExecutionResult result;
  const auto steps = static_cast<std::size_t>(std::ceil((path.Duration() + options.hold_time) * options.step_rate));
  for (std::size_t i = 0; i < steps; ++i) {
    const double begin = static_cast<double>(i) / options.step_rate;
    const double end = static_cast<double>(i + 1) / options.step_rate;
    const Configuration planned = path.Sample(end).angles;
    world.Step(path.Sample(begin).angles, planned);

    const Configuration angles = world.JointAngles();
    const Eigen::Vector3d flange = world.FlangePoseNow().position;
    if (!angles.allFinite() || !flange.allFinite()) {
      result.failure = "The arm " + arm.name + " has a pose that is not finite after " + std::to_string(end) + " s";
      break;
    }
    const double tracking_error = (flange - FlangePose(arm, planned).position).norm();
    result.steps.push_back({end, planned, angles, world.JointVelocities(), world.MotorEfforts(), flange, tracking_error,
                            static_cast<int>(world.Contacts().size())});
    AddContacts(world, begin, result.contacts);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(steps));
  }
  Summarise(arm, result);
  return result;
}

}  // namespace dgd_demos
