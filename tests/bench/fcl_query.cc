#include "bench/fcl_query.h"

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>

#include <exception>
#include <optional>

#include "bench/stopwatch.h"

namespace dgd_bench {
namespace {

fcl::Convexd MakeHull(const dgd_demos::Polyhedron& core) {
  constexpr int kCornersOfFace = 3;
  const auto faces = std::make_shared<std::vector<int>>();
  for (const dgd_demos::Polyhedron::Face& face : core.faces) {
    faces->push_back(kCornersOfFace);
    faces->insert(faces->end(), face.vertices.begin(), face.vertices.end());
  }
  fcl::Convexd hull(std::make_shared<std::vector<Eigen::Vector3d>>(core.vertices), static_cast<int>(core.faces.size()),
                    faces);
  hull.computeLocalAABB();
  return hull;
}

fcl::Transform3d ToFcl(const dgd_demos::Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = pose.rotation;
  transform.translation() = pose.position;
  return transform;
}

class FclQuery : public Query {
 public:
  explicit FclQuery(const HullPair& pair)
      : hull_1_(MakeHull(pair.core_1)),
        hull_2_(MakeHull(pair.core_2)),
        pose_1_(ToFcl(pair.pose_1)),
        pose_2_(ToFcl(pair.pose_2)) {}

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }

  Judgement Judge(const HullPair& pair) const override {
    const std::optional<fcl::DistanceResultd> result = Ask();
    Judgement judgement;
    judgement.is_missing = true;
    if (!result) return judgement;
    // From the first hull's nearest point to the second's; the other way where they overlap.
    Eigen::Vector3d normal = result->nearest_points[1] - result->nearest_points[0];
    if (result->min_distance < 0) normal = -normal;
    judgement.is_missing = !(normal.squaredNorm() > 0);
    if (!judgement.is_missing) judgement.normal_error = NormalError(pair, normal);
    return judgement;
  }

 private:
  // None where FCL gives up: its EPA throws.
  std::optional<fcl::DistanceResultd> Ask() const try {
    constexpr bool kNearestPoints = true, kSignedDistance = true;
    fcl::DistanceResultd result;
    fcl::distance(&hull_1_, pose_1_, &hull_2_, pose_2_, fcl::DistanceRequestd(kNearestPoints, kSignedDistance), result);
    return result;
  } catch (const std::exception&) {
    return std::nullopt;
  }

  fcl::Convexd hull_1_, hull_2_;
  fcl::Transform3d pose_1_, pose_2_;
};

}  // namespace

std::unique_ptr<Query> MakeFclQuery(const HullPair& pair) { return std::make_unique<FclQuery>(pair); }

}  // namespace dgd_bench
