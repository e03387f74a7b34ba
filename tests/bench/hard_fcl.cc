#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>

#include <exception>
#include <vector>

#include "bench/hard_method.h"
#include "dgd/convex_hull.h"

namespace dgd_bench {
namespace {

using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;
using Geometry = fcl::CollisionGeometry<double>;

/// FCL wants faces; flat hulls have two, back to back.
std::unique_ptr<Geometry> HullOf(const std::vector<Vector3d>& points) {
  const dgd::ConvexHull hull = dgd::BuildConvexHull(points);
  if (hull.dimension < 2) return nullptr;
  const auto faces = std::make_shared<std::vector<int>>();
  const int count = static_cast<int>(hull.normals.size());
  for (std::size_t face = 0; face < hull.normals.size(); ++face) {
    const int begin = hull.facet_start[face], end = hull.facet_start[face + 1];
    faces->push_back(end - begin);
    for (int i = begin; i < end; ++i)
      faces->push_back(static_cast<int>(hull.facet_vertices[static_cast<std::size_t>(i)]));
  }
  return std::make_unique<fcl::Convexd>(std::make_shared<std::vector<Vector3d>>(hull.vertices), count, faces);
}

/// @param radius  What the geometry leaves out of the set's radius, metres.
/// @return null for a type that FCL has not.
std::unique_ptr<Geometry> GeometryOf(const SetNumbers& set, double& radius) {
  const Vector3d& lengths = set.lengths;
  radius = set.radius;
  switch (set.type) {
    case SetType::kPoint:
      radius = 0;
      return std::make_unique<fcl::Sphered>(set.radius);
    case SetType::kSegment:
      radius = 0;
      return std::make_unique<fcl::Capsuled>(set.radius, 2 * lengths[0]);
    case SetType::kTriangle:
    case SetType::kPolytope:
    case SetType::kMesh:
      return HullOf(set.points);
    case SetType::kBox:
    case SetType::kPlainBox:
      return std::make_unique<fcl::Boxd>(Vector3d(2 * lengths));
    case SetType::kCylinder:
      return std::make_unique<fcl::Cylinderd>(lengths[0], 2 * lengths[1]);
    case SetType::kCone:
      return std::make_unique<fcl::Coned>(lengths[0], lengths[1]);
    case SetType::kEllipsoid:
      return std::make_unique<fcl::Ellipsoidd>(lengths);
    default:
      return nullptr;
  }
}

fcl::Transform3d ToFcl(const dgd_test::PoseNumbers& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = pose.rotation;
  transform.translation() = pose.translation;
  return transform;
}

class FclHardQuery : public HardQuery {
 public:
  FclHardQuery(std::unique_ptr<Geometry> geometry_1, std::unique_ptr<Geometry> geometry_2, double radii,
               const dgd_test::PairNumbers& pair)
      : geometry_1_(std::move(geometry_1)),
        geometry_2_(std::move(geometry_2)),
        radii_(radii),
        pose_1_(ToFcl(pair.pose_1)),
        pose_2_(ToFcl(pair.pose_2)) {
    geometry_1_->computeLocalAABB();
    geometry_2_->computeLocalAABB();
  }

  // FCL's EPA throws where it gives up.
  HardAnswer Ask() const override try {
    constexpr bool kNearestPoints = true, kSignedDistance = true;
    fcl::DistanceResultd result;
    fcl::distance(geometry_1_.get(), pose_1_, geometry_2_.get(), pose_2_,
                  fcl::DistanceRequestd(kNearestPoints, kSignedDistance), result);
    // From set 1's nearest point to set 2's; the other way where they overlap.
    Vector3d way = result.nearest_points[1] - result.nearest_points[0];
    if (result.min_distance < 0) way = -way;
    return {.distance = result.min_distance - radii_, .normal = way.stableNormalized()};
  } catch (const std::exception& error) {
    return {.reason = error.what()};
  }

 private:
  std::unique_ptr<Geometry> geometry_1_, geometry_2_;
  double radii_;
  fcl::Transform3d pose_1_, pose_2_;
};

}  // namespace

std::unique_ptr<HardQuery> MakeFclHardQuery(const dgd_test::PairNumbers& pair) {
  double radius_1 = 0, radius_2 = 0;
  std::unique_ptr<Geometry> geometry_1 = GeometryOf(pair.set_1, radius_1);
  std::unique_ptr<Geometry> geometry_2 = GeometryOf(pair.set_2, radius_2);
  if (geometry_1 == nullptr || geometry_2 == nullptr) return nullptr;
  return std::make_unique<FclHardQuery>(std::move(geometry_1), std::move(geometry_2), radius_1 + radius_2, pair);
}

}  // namespace dgd_bench
