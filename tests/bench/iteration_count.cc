#include "bench/iteration_count.h"

#include <algorithm>
#include <memory>

#include "bench/class_walk.h"
#include "bench/percentile.h"
#include "bench/stopwatch.h"
#include "support/pairs/random_pair.h"

namespace dgd_bench {
namespace {

using dgd_test::AnyPair;
using dgd_test::PairNumbers;
using dgd_test::Which;

constexpr int kTimeRepeats = 3;

/// One pair in one pose, asked in one way.
template <int L>
void Ask(AnyPair<double, L>& pair, const IterationVariant& variant, const dgd::WarmStart<double, L>& start,
         std::int64_t index, dgd_test::Tally& tally, std::vector<double>& times) {
  dgd::Result<double, L> result;
  times.push_back(MeanMicroseconds(kTimeRepeats, [&] {
    dgd::WarmStart<double, L> warm_start = start;
    result = pair.GrowthDistance(variant.settings, &warm_start);
    Keep(result);
  }));
  const dgd::Certificate certificate = pair.Certify(result);
  const double size = pair.Extent() + (pair.Center(Which::kSecond) - pair.Center(Which::kFirst)).norm();
  ++tally.pairs;
  tally.CountIterations(result.iterations);
  if (result.status != dgd::Status::kOptimal) ++tally.non_optimal;
  tally.relative_gap.Take(certificate.relative_gap, index);
  tally.primal_infeasibility.Take(certificate.primal_infeasibility / size, index);
}

/// One pair in its poses, asked in every way.
template <int L>
void AskAll(AnyPair<double, L>& pair, const PairPoses& poses, std::int64_t index, std::vector<IterationRow>& rows,
            std::vector<std::vector<double>>& times) {
  for (std::size_t v = 0; v < rows.size(); ++v) {
    const IterationVariant& variant = IterationVariants()[v];
    dgd::WarmStart<double, L> start;
    if (variant.start != Start::kCold) {
      pair.MoveTo(poses.pose_1, poses.last_pose_2);
      pair.GrowthDistance(variant.settings, &start);
    }
    if (variant.start == Start::kLastNormal) start.size = start.known_size = 0;
    pair.MoveTo(poses.pose_1, poses.pose_2);
    Ask(pair, variant, start, index, rows[v].tally, times[v]);
  }
}

template <int L>
std::vector<IterationRow> Count(const PairClass& pair_class, const Meshes& meshes, const ClassOptions& options) {
  std::vector<IterationRow> rows;
  for (const IterationVariant& variant : IterationVariants()) rows.push_back({variant.title, {}, 0});
  std::vector<std::vector<double>> times(rows.size());
  WalkClass<L>(
      pair_class, meshes, options,
      [](const PairNumbers& numbers) { return std::make_unique<AnyPair<double, L>>(numbers); },
      [&](AnyPair<double, L>& pair, const PairPoses& poses, std::int64_t index) {
        AskAll(pair, poses, index, rows, times);
      });
  for (std::size_t v = 0; v < rows.size(); ++v) {
    std::ranges::sort(times[v]);
    rows[v].microseconds_p50 = Percentile(times[v], 0.5);
  }
  return rows;
}

}  // namespace

const std::vector<IterationVariant>& IterationVariants() {
  static const std::vector<IterationVariant> variants = [] {
    const dgd::Settings<double> usual;
    dgd::Settings<double> exact;
    exact.relative_tolerance = 1e-12;
    // What else is left out, the walk does without.
    dgd::Settings<double> no_walk;
    no_walk.facet_walk = false;
    dgd::Settings<double> first_order = no_walk;
    first_order.second_order = false;
    dgd::Settings<double> unrounded = no_walk;
    unrounded.rounding = false;
    dgd::Settings<double> summed = no_walk;
    summed.known_points = false;
    dgd::Settings<double> creeping = no_walk;
    creeping.half_way_cuts = false;
    dgd::Settings<double> along_ray;
    along_ray.likely_start = false;
    return std::vector<IterationVariant>{{"cold", usual, Start::kCold, true},
                                         {"warm", usual, Start::kWarm, true},
                                         {"warm, by the normal alone", no_walk, Start::kLastNormal, true},
                                         {"no walk to the facet, cold", no_walk, Start::kCold, true},
                                         {"no guess of the first, cold", along_ray, Start::kCold, false},
                                         {"no second-order steps, cold", first_order, Start::kCold, false},
                                         {"no radii apart from cores, cold", unrounded, Start::kCold, false},
                                         {"no combined points, cold", summed, Start::kCold, false},
                                         {"no half-way cuts, cold", creeping, Start::kCold, false},
                                         {"tolerance 1e-12, cold", exact, Start::kCold, false}};
  }();
  return variants;
}

std::vector<IterationRow> CountIterations(const PairClass& pair_class, const Meshes& meshes,
                                          const ClassOptions& options) {
  return pair_class.dimension == 2 ? Count<2>(pair_class, meshes, options) : Count<3>(pair_class, meshes, options);
}

}  // namespace dgd_bench
