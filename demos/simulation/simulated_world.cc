#include "simulation/simulated_world.h"

#include <sstream>

namespace dgd_demos {
namespace {

bool IsFinite(const Pose& pose, const Motion& motion) {
  return pose.position.allFinite() && pose.rotation.allFinite() && motion.velocity.allFinite() &&
         motion.angular_velocity.allFinite();
}

}  // namespace

std::vector<double> SpeedsOf(const std::vector<Motion>& motions) {
  std::vector<double> speeds;
  speeds.reserve(motions.size());
  for (const Motion& motion : motions) speeds.push_back(motion.velocity.norm());
  return speeds;
}

std::optional<std::string> SimulatedWorld::FindLostBody(const std::vector<Motion>& motions) const {
  const std::vector<SimulatedBody>& bodies = Bodies();
  const std::vector<Pose> poses = Poses();
  const Eigen::AlignedBox3d room = Room();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].moves) continue;
    if (!IsFinite(poses[i], motions[i])) return bodies[i].name + " has a pose or a velocity that is not finite";
    const Eigen::Vector3d& position = poses[i].position;
    if (room.contains(position)) continue;
    std::ostringstream sentence;
    sentence << bodies[i].name << " left the world at (" << position.x() << ", " << position.y() << ", " << position.z()
             << ") m";
    return sentence.str();
  }
  return std::nullopt;
}

}  // namespace dgd_demos
