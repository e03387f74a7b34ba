// A robot pushes a carton over: it tips when the push is strong enough, not before, and slides where it is too smooth.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Carton {
  Form form;
  Ground ground;
  double half_width, half_height;  // m
  double push;                     // Over the force that tips it.
  int index;
};

std::vector<Carton> Cartons() {
  constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane, Ground::kMesh, Ground::kHeightfield};
  constexpr std::array<double, 4> kPushes = {0.97, 1.04, 0.93, 1.08};
  constexpr std::array<std::array<double, 2>, 3> kHalves = {{{0.25, 0.5}, {0.05, 0.15}, {0.4, 0.5}}};
  std::vector<Carton> cartons;
  for (int i = 0; i < 48; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    const auto& [half_width, half_height] = kHalves[(j / 4 + j / 16) % 3];
    cartons.push_back({(i / 8) % 2 == 0 ? Form::kBox : Form::kHull, kGrounds[(j / 4) % 4], half_width, half_height,
                       kPushes[j % 4], i});
  }
  return cartons;
}

btConvexShape& MakeCarton(Lab& lab, const Carton& it) {
  const btVector3 half = Vec(it.half_width, 0.8 * it.half_width, it.half_height);
  if (it.form == Form::kBox) return lab.Make<btBoxShape>(half);
  auto& hull = lab.Make<btConvexHullShape>();
  const double margin = 0.02 * it.half_width;
  for (int corner = 0; corner < 8; ++corner) {
    const btVector3 sign = Vec((corner & 1) == 0 ? -1 : 1, (corner & 2) == 0 ? -1 : 1, (corner & 4) == 0 ? -1 : 1);
    hull.addPoint((half - Vec(margin, margin, margin)) * sign, false);
  }
  hull.recalcLocalAabb();
  hull.setMargin(btScalar(margin));
  return hull;
}

/// A steady horizontal push at two thirds of the height, along x of the carton.
Case RunCarton(const Conditions& conditions, const Carton& it) {
  constexpr double kSettleTime = 0.3, kPushTime = 1.2;  // s
  Lab lab(conditions);
  lab.AddGround(it.ground);
  const double heading = HeadingOf(it.index + it.index / 4);
  btRigidBody& body =
      lab.AddBody(MakeCarton(lab, it), 2, At(Vec(0.23, 0.31, it.half_height), Yaw(heading)), Surface{.friction = 2});
  lab.Run(kSettleTime);
  const double above_centre = it.half_height / 3;
  // A hull's edge is rounded by its margin: it turns about a line so much farther in.
  const double lever = it.half_width - (it.form == Form::kHull ? 0.02 * it.half_width : 0);
  const double force = it.push * 2 * kGravity * lever / (it.half_height + above_centre);
  double tilt = 0;
  for (int step = lab.StepsIn(kPushTime); step > 0; --step) {
    body.applyForce(Direction(heading) * btScalar(force), Vec(0, 0, above_centre));
    lab.Step();
    tilt = std::max(tilt, TiltOf(body));
  }
  const bool tips = !(tilt < 0.03);
  return {NameOf(it.form),
          NameOf(it.form) + " " + Text(it.half_width) + " x " + Text(it.half_height) + " m on " + NameOf(it.ground) +
              ", push " + Text(it.push),
          {it.push < 1 && tips ? 1.0 : 0.0, it.push > 1 && !tips ? 1.0 : 0.0, it.push < 1 ? 1000 * tilt : 0}};
}

Cases RunTips(const Conditions& conditions) { return RunCases(conditions, Cartons(), 1, RunCarton); }

}  // namespace

App Tips() {
  return {"tips",
          "cartons that are pushed with a little less or more than what tips them",
          {{"tips too early", Combine::kTotal, 0, 0, "one is one too many"},
           {"tips too late", Combine::kTotal, 0, 0, "the same"},
           {"tilt of those that stand, mrad", Combine::kMean, 0.2, 0.5, "half a millimetre at the top of a metre"}},
          RunTips};
}

}  // namespace dgd_apps
