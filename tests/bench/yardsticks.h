// The algorithms of bench/textbook/ on one pair of sets: each one's own view of them, and what it remembers.
#pragma once

#include <concepts>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

#include "bench/speed_pair.h"
#include "bench/stopwatch.h"
#include "bench/textbook/conic.h"
#include "bench/textbook/contact_features.h"
#include "bench/textbook/incremental.h"
#include "bench/textbook/internal_expanding.h"
#include "bench/textbook/plain_algorithm.h"

namespace dgd_bench {

/// One set, in double, as each algorithm wants it. Optional where it may not.
template <class Core>
struct YardstickSet {
  using Set = dgd::RoundedSet<Core>;

  explicit YardstickSet(const Set& set) : plain(set), mesh(MeshOf(set)), conic(ConicOf(set)) {
    if constexpr (kIsSmooth) smooth.emplace(set);
  }

  static constexpr bool kIsSmooth = [] {
    if constexpr (dgd::kDimension<Core> == 3) return DifferentiableCore<Core>;
    return false;
  }();
  struct Nothing {};
  using Smooth = typename decltype([] {
    if constexpr (kIsSmooth) {
      return std::type_identity<DifferentiableSupportFunctionOf<Core>>();
    } else {
      return std::type_identity<Nothing>();
    }
  }())::type;

  SupportFunctionOf<Core> plain;
  std::optional<HalfEdgeMesh> mesh;
  std::optional<ConicSet> conic;
  std::optional<Smooth> smooth;

 private:
  /// Of a core that is the hull of vertices in space.
  static std::optional<dgd::ConvexHull> SolidHullOf(const Core& core) {
    if constexpr (dgd::kDimension<Core> == 3 && dgd::VertexCore<Core>) {
      std::vector<Eigen::Vector3d> vertices;
      for (dgd::VertexId i = 0; i < core.VertexCount(); ++i) vertices.push_back(core.Vertex(i));
      dgd::ConvexHull hull = dgd::BuildConvexHull(vertices);
      if (hull.dimension == 3) return hull;
    }
    return std::nullopt;
  }

  static std::optional<HalfEdgeMesh> MeshOf(const Set& set) {
    if (set.radius > 0) return std::nullopt;
    const std::optional<dgd::ConvexHull> hull = SolidHullOf(set.core);
    if (!hull) return std::nullopt;
    return HalfEdgeMesh(*hull);
  }

  static std::optional<ConicSet> ConicOf(const Set& set) {
    if constexpr (ConicCore<Core>) {
      return ConicSetOf(set.core, set.radius);
    } else {
      const std::optional<dgd::ConvexHull> hull = SolidHullOf(set.core);
      if (!hull) return std::nullopt;
      return ConicSetOf(*hull, set.radius);
    }
  }
};

template <class Core1, class Core2>
class Yardsticks {
 public:
  static constexpr int L = dgd::kDimension<Core1>;
  using Pose = dgd::Pose<double, L>;
  using Result = dgd::Result<double, L>;

  Yardsticks(const dgd::RoundedSet<Core1>& set_1, const dgd::RoundedSet<Core2>& set_2) : set_1_(set_1), set_2_(set_2) {}

  /// Warm starts come from these poses.
  void Remember(const Pose& pose_1, const Pose& pose_2) {
    plain_state_ = {};
    PlainGrowthDistance(set_1_.plain, pose_1, set_2_.plain, pose_2, &plain_state_);
    if constexpr (L == 3) {
      incremental_state_ = {};
      if (HasMeshes()) IncrementalGrowthDistance(*set_1_.mesh, pose_1, *set_2_.mesh, pose_2, &incremental_state_);
    }
  }

  bool Takes(const SpeedQuestion& question) const {
    const bool is_cold_distance = !question.is_check && question.start == SpeedQuestion::Start::kCold;
    switch (question.method) {
      case SpeedMethod::kPlain:
        return true;
      case SpeedMethod::kInternalExpanding:
        return L == 3 && is_cold_distance;
      case SpeedMethod::kIncremental:
        return !question.is_check && HasMeshes();
      case SpeedMethod::kContactFeatures:
        return is_cold_distance && set_1_.smooth && set_2_.smooth;
      case SpeedMethod::kConic:
        return is_cold_distance && set_1_.conic && set_2_.conic;
      default:
        return false;
    }
  }

  /// @param use  Called with what asks the question, of a method that takes it.
  template <class Use>
  auto Ask(const SpeedQuestion& question, const Pose& pose_1, const Pose& pose_2, const Use& use) const {
    const double tolerance = question.tolerance > 0 ? question.tolerance : dgd::kSqrtEpsilon<double>;
    const bool is_warm = question.start == SpeedQuestion::Start::kWarm;
    if constexpr (L == 3) {
      switch (question.method) {
        case SpeedMethod::kInternalExpanding:
          return use(
              [&, tolerance] { return InternalExpanding(set_1_.plain, pose_1, set_2_.plain, pose_2, tolerance); });
        case SpeedMethod::kIncremental:
          return use([&, is_warm] {
            IncrementalState state;  // Each repeat is the second query again, not a third.
            if (is_warm) state = incremental_state_;
            const Result result =
                IncrementalGrowthDistance(*set_1_.mesh, pose_1, *set_2_.mesh, pose_2, is_warm ? &state : nullptr);
            Keep(state);
            return result;
          });
        case SpeedMethod::kContactFeatures:
          if constexpr (YardstickSet<Core1>::kIsSmooth && YardstickSet<Core2>::kIsSmooth) {
            return use([&, tolerance] {
              return ContactFeatureGrowthDistance(*set_1_.smooth, pose_1, *set_2_.smooth, pose_2, tolerance);
            });
          }
          break;
        case SpeedMethod::kConic:
          return use(
              [&, tolerance] { return ConicGrowthDistance(*set_1_.conic, pose_1, *set_2_.conic, pose_2, tolerance); });
        default:
          break;
      }
    }
    if (question.method != SpeedMethod::kPlain) throw std::logic_error("a question to a method that does not take it");
    if (question.is_check) return use([&] { return PlainCollision(set_1_.plain, pose_1, set_2_.plain, pose_2); });
    return use([&, tolerance, is_warm] {
      PlainState<L> state;
      if (is_warm) state = plain_state_;
      const Result result =
          PlainGrowthDistance(set_1_.plain, pose_1, set_2_.plain, pose_2, is_warm ? &state : nullptr, tolerance);
      Keep(state);
      return result;
    });
  }

 private:
  bool HasMeshes() const { return set_1_.mesh && set_2_.mesh; }

  YardstickSet<Core1> set_1_;
  YardstickSet<Core2> set_2_;
  PlainState<L> plain_state_;
  IncrementalState incremental_state_;
};

}  // namespace dgd_bench
