// Crates at ledges: they stand while their centre is over the ledge, and fall when it is not.
#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Crate {
  Form form;
  Ground ground;
  double half;    // m
  double inside;  // Of the centre from the edge, over half the width.
  int index;
};

std::vector<Crate> Crates() {
  constexpr std::array<double, 8> kInside = {0.02, 0.01, -0.01, 0.04, 0.076, -0.04, 0.03, 0.05};
  std::vector<Crate> crates;
  for (const Ground ground : {Ground::kBox, Ground::kMesh}) {
    for (const Form form : {Form::kBox, Form::kHull, Form::kCylinder}) {
      for (const double half : {0.5, 0.1}) {
        for (const double inside : kInside) crates.push_back({form, ground, half, inside, int(crates.size())});
      }
    }
  }
  return crates;
}

Case RunCrate(const Conditions& conditions, const Crate& it) {
  constexpr double kDuration = 2.5;  // s: what is out by a hundredth of its half takes a second to fall.
  Lab lab(conditions);
  const Grid grid = {.cells = 8, .pitch = it.half};
  const double heading = it.index % 3 == 0 ? 0 : HeadingOf(it.index), edge = 4 * it.half;
  const btTransform frame = At(Vec(0, 0, 0), Yaw(heading));
  lab.AddGround(it.ground, frame, grid);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double foot = FootOf(shape);
  const btTransform pose = frame * At(Vec(edge - it.inside * it.half, 0.13 * it.half, foot));
  btRigidBody& body = lab.AddBody(shape, 1, pose, Surface{.friction = 1});
  lab.Run(kDuration);
  const bool falls = !(HeightOf(body) > foot - 0.1 * it.half);
  const double way = falls ? 0 : double((PositionOf(body) - pose.getOrigin()).length());
  return {NameOf(it.form) + " on " + NameOf(it.ground),
          NameOf(it.form) + " " + Text(it.half) + " m on " + NameOf(it.ground) + ", " +
              Text(1000 * it.inside * it.half) + " mm inside" + (falls ? ": falls" : ": stands"),
          {it.inside > 0 && falls ? 1.0 : 0.0, it.inside < 0 && !falls ? 1.0 : 0.0, 1000 * way}};
}

Cases RunLedge(const Conditions& conditions) { return RunCases(conditions, Crates(), 3, RunCrate); }

}  // namespace

App Ledge() {
  return {"ledge",
          "crates at the edge of a box or mesh: wrong falls, and how far those that stand creep",
          {{"falls though its centre is inside", Combine::kTotal, 0, 0, "one is one too many"},
           {"stands though its centre is outside", Combine::kTotal, 0, 0, "the same"},
           {"creep of those that stand, mm", Combine::kMean, 0.1, 0.5, "half a millimetre in 2.5 s is not seen"}},
          RunLedge};
}

}  // namespace dgd_apps
