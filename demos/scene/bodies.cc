#include "scene/bodies.h"

#include <algorithm>
#include <utility>

#include "scene/overloaded.h"
#include "scene/random.h"
#include "scene/random_polytope.h"
#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr int kPlacementAttempts = 10'000;

Body MakeBody(std::string name, Shape shape, double margin, const BodyProperties& properties, const Pose& pose,
              const Motion& motion = {}) {
  return {std::move(name),        std::move(shape),   margin, properties.mass, properties.inertia, properties.friction,
          properties.restitution, properties.damping, pose,   motion};
}

Body GroundBody(const Scene& scene) {
  const Ground& ground = scene.ground;
  Pose pose;
  pose.position.z() = -ground.half_extents.z();
  return {"/ground", Box{ground.half_extents}, scene.margin, 0, std::nullopt, ground.friction, 0, 0, pose, {}};
}

// Centres and radii of balls around the bodies placed so far.
class OccupiedSpace {
 public:
  void Add(const Body& body) { balls_.push_back({body.pose.position, BoundingRadius(body.shape, body.margin)}); }

  bool IsFree(const Vector3d& centre, double radius) const {
    const bool above_ground = centre.z() > radius;
    return above_ground && std::ranges::all_of(balls_, [&](const Ball& ball) {
             return (ball.centre - centre).norm() > ball.radius + radius;
           });
  }

 private:
  struct Ball {
    Vector3d centre;
    double radius;
  };
  std::vector<Ball> balls_;
};

// Makes the bodies of one group of random polytopes.
class PolytopePlacement {
 public:
  PolytopePlacement(const RandomPolytopes& group, const Scene& scene, std::string group_name, Random random)
      : group_(group), scene_(scene), group_name_(std::move(group_name)), random_(random) {}

  void AppendTo(std::vector<Body>& bodies, OccupiedSpace& occupied) {
    for (int i = 0; i < group_.count; ++i) {
      const int vertices = random_.Integer(group_.min_vertices, group_.max_vertices);
      Shape shape = Hull{RandomPolytope(random_, vertices, group_.diameter)};
      const std::string name = "polytope " + std::to_string(i) + " of " + group_name_;
      const double radius = BoundingRadius(shape, scene_.margin);
      const Pose pose{random_.Rotation(), FreePosition(i, radius, occupied, name)};
      bodies.push_back(MakeBody(name, std::move(shape), scene_.margin, group_.properties, pose));
      occupied.Add(bodies.back());
    }
  }

 private:
  // Each body has its own layer of the region, so that the potential energy hardly depends on the seed.
  Vector3d FreePosition(int index, double radius, const OccupiedSpace& occupied, const std::string& name) {
    const double layer = (group_.region_max.z() - group_.region_min.z()) / group_.count;
    Vector3d low = group_.region_min, high = group_.region_max;
    low.z() = group_.region_min.z() + layer * index;
    high.z() = low.z() + layer;
    for (int attempt = 0; attempt < kPlacementAttempts; ++attempt) {
      const Vector3d position = random_.InBox(low, high);
      if (occupied.IsFree(position, radius)) return position;
    }
    throw SceneError(scene_.file + ": " + group_name_ + "/region: no room for " + name + " after " +
                     std::to_string(kPlacementAttempts) + " attempts; make the region larger or the count smaller");
  }

  const RandomPolytopes& group_;
  const Scene& scene_;
  std::string group_name_;
  Random random_;
};

}  // namespace

std::vector<Body> MakeBodies(const Scene& scene, std::uint64_t seed) {
  std::vector<Body> bodies = {GroundBody(scene)};
  OccupiedSpace occupied;
  for (std::size_t g = 0; g < scene.bodies.size(); ++g) {
    const std::string group_name = "/bodies/" + std::to_string(g);
    std::visit(Overloaded{[&](const SingleBody& single) {
                            bodies.push_back(MakeBody(single.kind + " at " + group_name, single.shape, scene.margin,
                                                      single.properties, single.pose, single.motion));
                            occupied.Add(bodies.back());
                          },
                          [&](const RandomPolytopes& group) {
                            // A stream of its own: another group in the file leaves this one as it is.
                            Random random(seed, static_cast<std::uint32_t>(g));
                            PolytopePlacement(group, scene, group_name, random).AppendTo(bodies, occupied);
                          }},
               scene.bodies[g]);
  }
  return bodies;
}

}  // namespace dgd_demos
