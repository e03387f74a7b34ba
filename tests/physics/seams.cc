#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/edges.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

constexpr double kSettleTime = 0.5;  // s

struct Ride {
  double speed;            // m/s
  double distance;         // m, shorter if that takes longer than kLongestRide.
  double heading;          // rad
  double roll_radius = 0;  // Of a body that rolls, m; 0 if it slides.
};
constexpr double kLongestRide = 4;  // s

/// Velocity along the heading after the ride, over that before.
double SpeedKept(Lab& lab, btRigidBody& body, const Ride& ride) {
  lab.Run(kSettleTime);
  if (ride.roll_radius > 0) {
    SetRolling(body, ride.roll_radius, ride.speed, ride.heading);
  } else {
    body.setLinearVelocity(Direction(ride.heading) * btScalar(ride.speed));
  }
  lab.Run(std::min(kLongestRide, ride.distance / ride.speed));
  return Along(body.getLinearVelocity(), ride.heading) / ride.speed;
}

struct BoxSeams {
  double tile;       // Side of a tile, m.
  double thickness;  // m
  double half;       // Of the box that slides, or the radius of what rolls, m.
  double margin;     // m
  Ride ride;
  int index;
  Form form = Form::kBox;    // Boxes slide; balls, and capsules that lie across their way, roll.
  bool is_compound = false;  // Whether the tiles are children of one body.
};

std::vector<BoxSeams> BoxSeamsCases() {
  constexpr std::array<double, 6> kSpeeds = {0.5, 5, 1, 20, 2, 10};  // m/s
  constexpr std::array<double, 4> kHeadings = {0, 0.4, 0.02, 1.1};   // Along seams, and across.
  constexpr std::array<std::array<double, 3>, 3> kSizes = {{{2, 2, 0.25}, {1, 0.5, 0.4}, {2, 1, 0.1}}};
  std::vector<BoxSeams> cases;
  for (const double margin : {0.04, 0.001}) {
    for (const double speed : kSpeeds) {
      for (int round = 0; round < 4; ++round) {
        const std::size_t i = cases.size();
        const auto& [tile, thickness, half] = kSizes[i % 3];
        // Seams are met at other moments of a step each time.
        const double varied = speed * (1 + 0.02 * PhaseOf(static_cast<int>(i)));
        const Ride ride = {varied, 18, kHeadings[(i + i / 4) % 4]};
        cases.push_back({tile, thickness, half, margin, ride, static_cast<int>(i)});
      }
    }
  }
  return cases;
}

std::vector<BoxSeams> RollingSeamsCases() {
  constexpr std::array<double, 4> kSpeeds = {0.7, 3, 1.5, 6};          // m/s
  constexpr std::array<double, 5> kHeadings = {0, 0.4, 0.02, 1.1, 0};  // Along seams, and across.
  constexpr std::array<double, 3> kRadii = {0.15, 0.06, 0.3};          // m
  constexpr std::array<double, 3> kTiles = {0.6, 2, 1};                // m
  std::vector<BoxSeams> cases;
  for (int i = 0; i < 24; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    const double radius = kRadii[(j + j / 3) % 3], speed = kSpeeds[(j + j / 4) % 4] * (1 + 0.02 * PhaseOf(i));
    const Ride ride = {speed, 12, kHeadings[j % 5], radius};
    cases.push_back(
        {kTiles[j % 3], 0.5, radius, 0.04, ride, i, i % 3 == 2 ? Form::kCapsule : Form::kSphere, i / 2 % 2 == 1});
  }
  return cases;
}

/// As many tiles as the body comes by.
void AddTiles(Lab& lab, const BoxSeams& it, double distance) {
  constexpr Surface kTile = {.friction = 1, .restitution = 0};
  btCompoundShape* compound = it.is_compound ? &lab.Make<btCompoundShape>() : nullptr;
  auto& tile = lab.Make<btBoxShape>(Vec(it.tile / 2, it.tile / 2, it.thickness / 2));
  tile.setMargin(btScalar(it.margin));
  const int along = static_cast<int>(distance / it.tile) + 3;
  for (int i = -2; i < along; ++i) {
    for (int j = -2; j < along; ++j) {
      const double x = (i + 0.5) * it.tile, y = (j + 0.5) * it.tile;
      // The way from the origin along the heading, with what the box and the tile reach beside it.
      const double beside = std::abs(y * std::cos(it.ride.heading) - x * std::sin(it.ride.heading));
      if (beside > 1.5 * it.half + 1.5 * it.tile) continue;
      const btTransform pose = At(Vec(x, y, -it.thickness / 2));
      if (compound == nullptr) {
        lab.AddStatic(tile, pose, kTile);
      } else {
        compound->addChildShape(pose, &tile);
      }
    }
  }
  if (compound != nullptr) lab.AddStatic(*compound, btTransform::getIdentity(), kTile);
}

btConvexShape& MakeRider(Lab& lab, const BoxSeams& it) {
  if (it.form == Form::kSphere) return lab.Make<btSphereShape>(btScalar(it.half));
  if (it.form == Form::kCapsule) return lab.Make<btCapsuleShape>(btScalar(it.half), btScalar(3 * it.half));
  auto& box = lab.Make<btBoxShape>(Vec(it.half, it.half, it.half));
  box.setMargin(btScalar(it.margin));
  return box;
}

Sample MeasureBoxSeams(const Conditions& conditions, const BoxSeams& it) {
  Lab lab(conditions);
  AddTiles(lab, it, std::min(kLongestRide * it.ride.speed, it.ride.distance));
  const bool rolls = it.form != Form::kBox;
  // Aligned with the seams, or with its way.
  const btTransform pose =
      At(Vec(0.1 + 0.3 * PhaseOf(it.index), 0.2, it.half), Yaw(it.index % 2 == 0 && !rolls ? 0 : it.ride.heading));
  btRigidBody& body = lab.AddBody(MakeRider(lab, it), 1, pose, Surface{.friction = rolls ? 0.5 : 0});
  const double kept = SpeedKept(lab, body, it.ride);
  return RelativeToTheory(NameOf(it.form) + " " + Text(it.half) + " m over " +
                              (it.is_compound ? "a compound of " : "") + "boxes of " + Text(it.tile) + " m, margin " +
                              Text(it.margin) + ", " + Text(it.ride.speed) + " m/s, heading " + Text(it.ride.heading),
                          kept, 1, rolls ? "rolling" : "sliding");
}

struct MeshSeams {
  Ground ground;
  Grid grid;
  Form form;
  double half;  // m
  Ride ride;
  int index;
};

std::vector<MeshSeams> MeshSeamsCases() {
  constexpr std::array kForms = {Form::kBox, Form::kSphere, Form::kHull};
  constexpr std::array<double, 3> kPitches = {0.1, 1, 0.3};
  constexpr std::array<double, 4> kSpeeds = {1, 5, 2, 3};  // m/s
  constexpr std::array<double, 3> kHalves = {0.25, 0.5, 0.1};
  std::vector<MeshSeams> cases;
  for (int round = 0; round < 4; ++round) {
    for (const Ground ground : {Ground::kMesh, Ground::kHeightfield}) {
      for (const double pitch : kPitches) {
        for (const Form form : kForms) {
          const std::size_t i = cases.size();
          const Grid grid = {.cells = 2 * static_cast<int>(5 / pitch), .pitch = pitch, .alternates = round % 2 == 1};
          const double speed = kSpeeds[(i + i / 4) % 4] * (1 + 0.02 * PhaseOf(static_cast<int>(i)));
          const Ride ride = {speed, 7, HeadingOf(static_cast<int>(i + i / 4))};
          cases.push_back({ground, grid, form, kHalves[(i + i / 3 + i / 9) % 3], ride, static_cast<int>(i)});
        }
      }
    }
  }
  return cases;
}

Sample MeasureMeshSeams(const Conditions& conditions, const MeshSeams& it) {
  Lab lab(conditions);
  lab.AddGround(it.ground, btTransform::getIdentity(), it.grid, Surface{.friction = 0, .restitution = 0});
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double distance = std::min(it.ride.distance, kLongestRide * it.ride.speed);
  const btVector3 start = Direction(it.ride.heading) * btScalar(-0.5 * distance) + Vec(0.03, 0.02, FootOf(shape));
  const btTransform pose = At(start, Yaw(it.index % 2 == 0 ? 0.3 : it.ride.heading));
  btRigidBody& body = lab.AddBody(shape, 1, pose, Surface{.friction = 0});
  const double kept = SpeedKept(lab, body, it.ride);
  return RelativeToTheory(NameOf(it.form) + " " + Text(it.half) + " m over " + NameOf(it.ground) + " of " +
                              Text(it.grid.pitch) + " m, " + Text(it.ride.speed) + " m/s, heading " +
                              Text(it.ride.heading),
                          kept, 1, NameOf(it.form));
}

}  // namespace

Samples MeasureBoxSeams(const Conditions& conditions) {
  const auto measure = [](const Conditions& under, const BoxSeams& it) { return MeasureBoxSeams(under, it); };
  Samples samples = MeasureCases(conditions, BoxSeamsCases(), 7, measure);
  AddTo(samples, MeasureCases(conditions, RollingSeamsCases(), 7, measure));
  return samples;
}

Samples MeasureMeshSeams(const Conditions& conditions) {
  return MeasureCases(conditions, MeshSeamsCases(), 11,
                      [](const Conditions& under, const MeshSeams& it) { return MeasureMeshSeams(under, it); });
}

}  // namespace dgd_physics
