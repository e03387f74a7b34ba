#include "bench/bullet_query.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <type_traits>

#include "bench/stopwatch.h"
#include "simulation/bullet_math.h"

namespace dgd_bench {
namespace {

// The last contact; Bullet reports one or none.
struct LastContact : btDiscreteCollisionDetectorInterface::Result {
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3&, btScalar) override {
    is_missing = false;
    normal_b_to_a = normal_on_b;
  }

  bool is_missing = true;
  btVector3 normal_b_to_a{0, 0, 0};
};

class BulletQuery : public Query {
 public:
  explicit BulletQuery(const HullPair& pair)
      : pose_a_(dgd_demos::ToBullet(pair.pose_1)), pose_b_(dgd_demos::ToBullet(pair.pose_2)) {
    Fill(hull_a_, pair.core_1, pair.margin);
    Fill(hull_b_, pair.core_2, pair.margin);
  }

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }

  Judgement Judge(const HullPair& pair) const override {
    const LastContact contact = Ask();
    Judgement judgement;
    // A normal that is none is no answer either.
    judgement.is_missing = contact.is_missing || !(contact.normal_b_to_a.length2() > 0);
    if (!judgement.is_missing) {
      judgement.normal_error = NormalError(pair, -dgd_demos::FromBullet(contact.normal_b_to_a));
    }
    return judgement;
  }

 private:
  static void Fill(btConvexHullShape& hull, const dgd_demos::Polyhedron& core, double margin) {
    constexpr bool kUpdateBoundingBox = false;  // At every point; once is enough.
    for (const Eigen::Vector3d& vertex : core.vertices) hull.addPoint(dgd_demos::ToBullet(vertex), kUpdateBoundingBox);
    hull.setMargin(btScalar(margin));
    hull.recalcLocalAabb();
  }

  LastContact Ask() const {
    btVoronoiSimplexSolver simplex_solver;
    btGjkPairDetector detector(&hull_a_, &hull_b_, &simplex_solver, &penetration_solver_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pose_a_;
    input.m_transformB = pose_b_;
    LastContact contact;
    detector.getClosestPoints(input, contact, nullptr);
    return contact;
  }

  btConvexHullShape hull_a_, hull_b_;
  btTransform pose_a_, pose_b_;
  mutable btGjkEpaPenetrationDepthSolver penetration_solver_;  // Stateless, but not const in Bullet.
};

}  // namespace

const char* BulletPrecision() { return std::is_same_v<btScalar, double> ? "double" : "float"; }

std::unique_ptr<Query> MakeBulletQuery(const HullPair& pair) { return std::make_unique<BulletQuery>(pair); }

}  // namespace dgd_bench
