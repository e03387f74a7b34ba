#include "bench/textbook/comparators.h"

#include <concepts>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bench/solver_set.h"
#include "bench/stopwatch.h"
#include "bench/textbook/conic.h"
#include "bench/textbook/contact_features.h"
#include "bench/textbook/incremental.h"
#include "bench/textbook/internal_expanding.h"

namespace dgd_bench {
namespace {

using Pose = dgd::Pose<double>;

/// One set as each algorithm takes it; null or nothing where it does not.
struct ComparedSet {
  std::shared_ptr<const void> core;  ///< That the others may refer to.
  std::unique_ptr<SupportFunction<3>> points;
  std::unique_ptr<DifferentiableSupportFunction> smooth;
  std::optional<HalfEdgeMesh> mesh;
  std::optional<ConicSet> conic;
};

template <class Core>
std::optional<HalfEdgeMesh> MeshOf(const dgd::RoundedSet<Core>& set) {
  if constexpr (dgd::VertexCore<Core>) {
    if (set.radius > 0) return std::nullopt;
    std::vector<Eigen::Vector3d> vertices;
    for (dgd::VertexId i = 0; i < set.core.VertexCount(); ++i) vertices.push_back(set.core.Vertex(i));
    const dgd::ConvexHull hull = dgd::BuildConvexHull(vertices);
    if (hull.dimension == 3) return HalfEdgeMesh(hull);
  }
  return std::nullopt;
}

ComparedSet MakeComparedSet(const dgd_test::SetNumbers& numbers) {
  return WithStoredSet<3>(numbers, []<class Core, class Set>(const std::shared_ptr<const Core>& core, const Set& set) {
    ComparedSet made{core, std::make_unique<SupportFunctionOf<typename Set::Core>>(set), nullptr, MeshOf(set), {}};
    if constexpr (ConicCore<Core>) made.conic = ConicSetOf(*core, set.radius);
    if constexpr (DifferentiableCore<typename Set::Core>) {
      made.smooth = std::make_unique<DifferentiableSupportFunctionOf<typename Set::Core>>(set);
    }
    return made;
  });
}

class ComparedPair final : public GrowthPair {
  static bool IsColdDistance(const GrowthQuery& query) { return !query.is_check && !query.is_warm; }
  bool HasMeshes() const { return set_1_.mesh && set_2_.mesh; }

  /// @param use  Called with a function that solves the query.
  template <class Use>
  auto Run(const GrowthQuery& query, const Use& use) const {
    const double tolerance = query.tolerance > 0 ? query.tolerance : dgd::kSqrtEpsilon<double>;
    if (!Takes(query)) throw std::logic_error("a query to an algorithm that does not take it");
    switch (query.algorithm) {
      case GrowthAlgorithm::kInternalExpanding:
        return use([this, tolerance] {
          return InternalExpanding(*set_1_.points, pose_1_, *set_2_.points, pose_2_, tolerance);
        });
      case GrowthAlgorithm::kContactFeatures:
        return use([this, tolerance] {
          return ContactFeatureGrowthDistance(*set_1_.smooth, pose_1_, *set_2_.smooth, pose_2_, tolerance);
        });
      case GrowthAlgorithm::kConic:
        return use([this, tolerance] {
          return ConicGrowthDistance(*set_1_.conic, pose_1_, *set_2_.conic, pose_2_, tolerance);
        });
      default:
        return use([this, is_warm = query.is_warm] {
          IncrementalState state;  // Each repeat is the second query again, not a third.
          if (is_warm) state = incremental_state_;
          const dgd::Result<double> result =
              IncrementalGrowthDistance(*set_1_.mesh, pose_1_, *set_2_.mesh, pose_2_, is_warm ? &state : nullptr);
          Keep(state);
          return result;
        });
    }
  }

 public:
  ComparedPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2)
      : solver_pair_(MakeGrowthPair(set_1, set_2)),
        set_1_(MakeComparedSet(set_1)),
        set_2_(MakeComparedSet(set_2)),
        judge_({set_1, set_2, {}, {}}) {}

  double Extent() const override { return solver_pair_->Extent(); }

  void MoveTo(const PairPoses& poses) override {
    solver_pair_->MoveTo(poses);
    const auto pose_from = [](const dgd_test::PoseNumbers& pose) { return Pose{pose.rotation, pose.translation}; };
    pose_1_ = pose_from(poses.pose_1);
    incremental_state_ = {};
    if (HasMeshes()) {
      IncrementalGrowthDistance(*set_1_.mesh, pose_1_, *set_2_.mesh, pose_from(poses.last_pose_2), &incremental_state_);
    }
    pose_2_ = pose_from(poses.pose_2);
    judge_.MoveTo(poses.pose_1, poses.pose_2);
  }

  bool Takes(const GrowthQuery& query) const override {
    switch (query.algorithm) {
      case GrowthAlgorithm::kInternalExpanding:
        return IsColdDistance(query);
      case GrowthAlgorithm::kIncremental:
        return !query.is_check && HasMeshes();
      case GrowthAlgorithm::kContactFeatures:
        return IsColdDistance(query) && set_1_.smooth && set_2_.smooth;
      case GrowthAlgorithm::kConic:
        return IsColdDistance(query) && set_1_.conic && set_2_.conic;
      default:
        return solver_pair_->Takes(query);
    }
  }

  double Time(const GrowthQuery& query, int repeats) const override {
    if (query.algorithm <= GrowthAlgorithm::kPlain) return solver_pair_->Time(query, repeats);
    return Run(query, [repeats](const auto& solve) { return MeanMicroseconds(repeats, [&] { Keep(solve()); }); });
  }
  GrowthAnswer Solve(const GrowthQuery& query) const override {
    if (query.algorithm <= GrowthAlgorithm::kPlain) return solver_pair_->Solve(query);
    return Run(query, [this](const auto& solve) { return CertifiedAnswer(judge_, solve()); });
  }

  std::optional<double> ExactGrowthDistance() const override { return solver_pair_->ExactGrowthDistance(); }

 private:
  std::unique_ptr<GrowthPair> solver_pair_;
  ComparedSet set_1_, set_2_;
  Pose pose_1_, pose_2_;
  IncrementalState incremental_state_;
  dgd_test::AnyPair<double, 3> judge_;
};

}  // namespace

std::unique_ptr<GrowthPair> MakeComparedPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  if (dgd_test::InfoOf(set_1.type).dimension == 2) return MakeGrowthPair(set_1, set_2);
  return std::make_unique<ComparedPair>(set_1, set_2);
}

}  // namespace dgd_bench
