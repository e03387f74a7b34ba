#include "run/trajectory.h"

#include <btBulletDynamicsCommon.h>

#include <Eigen/Geometry>

#include "report/csv_file.h"
#include "run/trajectory_reader.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

void Add(NpyFile& file, const Eigen::Vector3d& vector) { file.Add({vector.x(), vector.y(), vector.z()}); }

}  // namespace

TrajectoryFile::TrajectoryFile(const std::filesystem::path& file, const SimulatedWorld& world, OpenMode mode)
    : file_(file, TrajectoryColumns(), world.Bodies().size(), mode) {}

void TrajectoryFile::Add(double time, const SimulatedWorld& world) {
  const std::vector<Pose> poses = world.Poses();
  const std::vector<Motion> motions = world.Motions();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Quaterniond q(poses[i].rotation);
    file_.Add(time);
    dgd_demos::Add(file_, poses[i].position);
    file_.Add({q.x(), q.y(), q.z(), q.w()});
    dgd_demos::Add(file_, motions[i].velocity);
    dgd_demos::Add(file_, motions[i].angular_velocity);
  }
  file_.FlushIfDue();
}

ContactFile::ContactFile(const std::filesystem::path& file, OpenMode mode)
    : file_(file,
            {{"time"},
             {"body_a", true},
             {"body_b", true},
             {"position_a", false, 3},
             {"position_b", false, 3},
             {"normal", false, 3},
             {"distance"},
             {"impulse"}},
            0, mode) {}

void ContactFile::Add(double time, SimulatedWorld& world) {
  btDispatcher& dispatcher = *world.Bullet().getDispatcher();
  for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
    for (int c = 0; c < manifold.getNumContacts(); ++c) {
      const btManifoldPoint& point = manifold.getContactPoint(c);
      file_.Add(time);
      file_.AddInteger(manifold.getBody0()->getUserIndex());
      file_.AddInteger(manifold.getBody1()->getUserIndex());
      dgd_demos::Add(file_, FromBullet(point.getPositionWorldOnA()));
      dgd_demos::Add(file_, FromBullet(point.getPositionWorldOnB()));
      dgd_demos::Add(file_, FromBullet(point.m_normalWorldOnB));
      file_.Add({point.getDistance(), point.getAppliedImpulse()});
    }
  }
  file_.FlushIfDue();
}

void WriteBodyList(const std::filesystem::path& file, const SimulatedWorld& world) {
  CsvFile csv(file);
  csv << "body,name,moves\n";
  const std::vector<SimulatedBody>& bodies = world.Bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    csv << i << ",\"" << bodies[i].name << "\"," << (bodies[i].moves ? 1 : 0) << '\n';
  }
  csv.Flush();
}

}  // namespace dgd_demos
