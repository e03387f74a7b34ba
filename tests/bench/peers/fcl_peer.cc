#include "bench/peers/fcl_peer.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>

#include <exception>
#include <utility>
#include <vector>

#include "bench/stopwatch.h"
#include "dgd/convex_hull.h"

namespace dgd_bench {
namespace {

using dgd_test::SetNumbers;
using dgd_test::SetType;

/// FCL wants faces; a flat hull has two, back to back. Null for segments and points.
std::unique_ptr<fcl::CollisionGeometryd> MakeHull(const std::vector<Eigen::Vector3d>& points) {
  const dgd::ConvexHull hull = dgd::BuildConvexHull(points);
  if (hull.dimension < 2) return nullptr;
  const auto faces = std::make_shared<std::vector<int>>();
  for (std::size_t face = 0; face < hull.normals.size(); ++face) {
    const int begin = hull.facet_start[face], end = hull.facet_start[face + 1];
    faces->push_back(end - begin);
    for (int i = begin; i < end; ++i) {
      faces->push_back(static_cast<int>(hull.facet_vertices[static_cast<std::size_t>(i)]));
    }
  }
  return std::make_unique<fcl::Convexd>(std::make_shared<std::vector<Eigen::Vector3d>>(hull.vertices),
                                        static_cast<int>(hull.normals.size()), faces);
}

/// @param radius  Of what is left to be rounded.
std::unique_ptr<fcl::CollisionGeometryd> MakeGeometry(const SetNumbers& set, double& radius) {
  const auto& lengths = set.lengths;
  radius = set.radius;
  switch (set.type) {
    case SetType::kPoint:
      radius = 0;
      return std::make_unique<fcl::Sphered>(set.radius);
    case SetType::kSegment:
      radius = 0;
      return std::make_unique<fcl::Capsuled>(set.radius, 2 * lengths[0]);
    case SetType::kBox:
    case SetType::kPlainBox:
      return std::make_unique<fcl::Boxd>(2 * lengths);
    case SetType::kCylinder:
      return std::make_unique<fcl::Cylinderd>(lengths[0], 2 * lengths[1]);
    case SetType::kCone:
      return std::make_unique<fcl::Coned>(lengths[0], lengths[1]);
    case SetType::kEllipsoid:
      return std::make_unique<fcl::Ellipsoidd>(lengths);
    case SetType::kTriangle:
    case SetType::kPolytope:
    case SetType::kMesh:
      return MakeHull(set.points);
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

class FclPeer : public Peer {
 public:
  FclPeer(std::unique_ptr<fcl::CollisionGeometryd> geometry_1, double radius_1,
          std::unique_ptr<fcl::CollisionGeometryd> geometry_2, double radius_2)
      : geometry_1_(std::move(geometry_1)),
        geometry_2_(std::move(geometry_2)),
        radius_1_(radius_1),
        radius_2_(radius_2) {
    geometry_1_->computeLocalAABB();
    geometry_2_->computeLocalAABB();
  }

  void MoveTo(const PairTurn& turn) override {
    pose_1_ = ToFcl(turn.pose_1);
    pose_2_ = ToFcl(turn.pose_2);
  }

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Compute()); });
  }

  std::optional<SeparationAnswer> Ask() const override {
    const std::optional<fcl::DistanceResultd> result = Compute();
    if (!result) return std::nullopt;
    // From the first set's nearest point to the second's; the other way where they overlap.
    const Eigen::Vector3d between = result->nearest_points[1] - result->nearest_points[0];
    const Eigen::Vector3d normal = (result->min_distance < 0 ? -between : between).stableNormalized();
    return SeparationAnswer{normal, result->min_distance - radius_1_ - radius_2_,
                            result->nearest_points[0] + radius_1_ * normal,
                            result->nearest_points[1] - radius_2_ * normal};
  }

 private:
  /// Nothing where FCL gives up: its EPA throws.
  std::optional<fcl::DistanceResultd> Compute() const try {
    constexpr bool kNearestPoints = true, kSignedDistance = true;
    fcl::DistanceResultd result;
    fcl::distance(geometry_1_.get(), pose_1_, geometry_2_.get(), pose_2_,
                  fcl::DistanceRequestd(kNearestPoints, kSignedDistance), result);
    return result;
  } catch (const std::exception&) {
    return std::nullopt;
  }

  std::unique_ptr<fcl::CollisionGeometryd> geometry_1_, geometry_2_;
  double radius_1_, radius_2_;
  fcl::Transform3d pose_1_, pose_2_;
};

}  // namespace

std::unique_ptr<Peer> MakeFclPeer(const SetNumbers& set_1, const SetNumbers& set_2) {
  double radius_1 = 0, radius_2 = 0;
  auto geometry_1 = MakeGeometry(set_1, radius_1), geometry_2 = MakeGeometry(set_2, radius_2);
  if (geometry_1 == nullptr || geometry_2 == nullptr) return nullptr;
  return std::make_unique<FclPeer>(std::move(geometry_1), radius_1, std::move(geometry_2), radius_2);
}

}  // namespace dgd_bench
