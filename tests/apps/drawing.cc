// A debug drawer looks on: whether contacts are drawn must not change the simulation, to the last bit.
#include <LinearMath/btIDebugDraw.h>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

/// Draws nowhere.
class NullDrawer : public btIDebugDraw {
 public:
  explicit NullDrawer(int mode) : mode_(mode) {}
  void drawLine(const btVector3&, const btVector3&, const btVector3&) override {}
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
  void reportErrorWarning(const char*) override {}
  void draw3dText(const btVector3&, const char*) override {}
  void setDebugMode(int mode) override { mode_ = mode; }
  int getDebugMode() const override { return mode_; }

 private:
  int mode_;
};

/// Final positions of a heap.
std::vector<btVector3> Simulate(const Conditions& conditions, Form form, Ground ground, btIDebugDraw* drawer) {
  constexpr double kHalf = 0.4, kDuration = 1.2;  // m, s
  Lab lab(conditions);
  lab.world().setDebugDrawer(drawer);
  lab.AddGround(ground);
  btConvexShape& shape = lab.MakeForm(form, kHalf);
  std::vector<const btRigidBody*> bodies;
  for (int i = 0; i < 12; ++i) {
    const btVector3 position = Vec(0.6 * (i % 2), 0.6 * (i / 2 % 2), 0.6 + 0.6 * i);
    const btQuaternion turn(Vec(1, 2, 3).normalized(), btScalar(0.1 * i));
    bodies.push_back(&lab.AddBody(shape, 1, At(position, turn)));
  }
  for (int step = lab.StepsIn(kDuration); step > 0; --step) {
    lab.Step();
    if (drawer != nullptr) lab.world().debugDrawWorld();
  }
  std::vector<btVector3> positions;
  for (const btRigidBody* body : bodies) positions.push_back(PositionOf(*body));
  return positions;
}

Cases RunDrawing(const Conditions& conditions) {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder, Form::kSphere};
  constexpr std::array kGrounds = {Ground::kBox, Ground::kMesh, Ground::kPlane, Ground::kHeightfield};
  constexpr std::array kModes = {0, int(btIDebugDraw::DBG_DrawWireframe), int(btIDebugDraw::DBG_DrawContactPoints)};
  Cases cases;
  for (const int i : SelectIndices(conditions, 4, 2)) {
    const std::size_t j = static_cast<std::size_t>(i);
    const std::vector<btVector3> without = Simulate(conditions, kForms[j], kGrounds[j], nullptr);
    for (const int mode : kModes) {
      NullDrawer drawer(mode);
      const std::vector<btVector3> with = Simulate(conditions, kForms[j], kGrounds[j], &drawer);
      double differing = 0;
      for (std::size_t body = 0; body < with.size(); ++body) {
        if (!(with[body] == without[body])) ++differing;
      }
      cases.push_back({"", NameOf(kForms[j]) + " on " + NameOf(kGrounds[j]) + ", mode " + Text(mode), {differing}});
    }
  }
  return cases;
}

}  // namespace

App Drawing() {
  return {"drawing",
          "heaps with a debug drawer and without: bodies that end elsewhere by a bit",
          {{"bodies that end elsewhere", Combine::kTotal, 0, 0, "drawing is looking"}},
          RunDrawing};
}

}  // namespace dgd_apps
