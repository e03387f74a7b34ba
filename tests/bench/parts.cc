// parts: what a query is made of, and what surrounds it in a step, timed alone. A Google Benchmark program; its --help
// tells the options. Times here are of a loop that repeats one input after the other from a list, so that branches are
// predicted about as well as in an app.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "dgd/certificate.h"
#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "dgd/signed_distance.h"
#include "support/random.h"

// NOLINTBEGIN(clang-analyzer-deadcode.DeadStores): the library's loops count with a variable that nobody reads.
namespace dgd_bench {
namespace {

using dgd_test::Random;
using Eigen::Vector3d;
using Hull = dgd::Polytope<double>;
using Set = dgd::RoundedSet<dgd::CoreReference<Hull>>;
using Pose = dgd::Pose<double>;

constexpr std::uint64_t kSeed = 1;
constexpr int kUsualVertices = 14;
constexpr std::size_t kInputs = 256;
constexpr dgd::VertexId kAlwaysScanned = std::numeric_limits<dgd::VertexId>::max();

std::vector<Vector3d> PointsOnSphere(Random& random, std::int64_t count) {
  std::vector<Vector3d> points;
  for (std::int64_t i = 0; i < count; ++i) points.push_back(0.5 * random.UnitVector());
  return points;
}

/// Goes around a list of inputs.
template <class T>
class Inputs {
 public:
  template <class Make>
  explicit Inputs(const Make& make) {
    for (std::size_t i = 0; i < kInputs; ++i) inputs_.push_back(make());
  }
  T& Next() { return inputs_[next_++ % kInputs]; }

 private:
  std::vector<T> inputs_;
  std::size_t next_ = 0;
};

Inputs<Vector3d> Directions(Random& random) {
  return Inputs<Vector3d>([&] { return random.UnitVector(); });
}

// Support functions.

template <class Core>
void TimeSupport(benchmark::State& state, const Core& core) {
  Random random(kSeed);
  Inputs<Vector3d> directions = Directions(random);
  for (auto _ : state) benchmark::DoNotOptimize(core.Support(directions.Next()));
}

void SupportByScan(benchmark::State& state) {
  Random random(kSeed);
  TimeSupport(state, dgd::Polytope<double, kAlwaysScanned>(PointsOnSphere(random, state.range(0))));
}
BENCHMARK(SupportByScan)->ArgName("vertices")->RangeMultiplier(4)->Range(8, 512);

void SupportByClimb(benchmark::State& state) {
  Random random(kSeed);
  TimeSupport(state, dgd::Mesh<double>(PointsOnSphere(random, state.range(0))));
}
BENCHMARK(SupportByClimb)->ArgName("vertices")->RangeMultiplier(4)->Range(8, 8192);

/// From the vertex that was farthest along a direction 0.01 rad away.
void SupportByClimbFromHint(benchmark::State& state) {
  struct Input {
    Vector3d direction;
    dgd::VertexId hint;
  };
  Random random(kSeed);
  const dgd::Mesh<double> hull(PointsOnSphere(random, state.range(0)));
  Inputs<Input> inputs([&] {
    const Vector3d last = random.UnitVector();
    return Input{(last + 0.01 * random.UnitVector()).normalized(), hull.Support(last).feature};
  });
  for (auto _ : state) {
    const Input& input = inputs.Next();
    benchmark::DoNotOptimize(hull.Support(input.direction, input.hint));
  }
}
BENCHMARK(SupportByClimbFromHint)->ArgName("vertices")->RangeMultiplier(4)->Range(8, 8192);

BENCHMARK_CAPTURE(TimeSupport, box, dgd::Box<double>(Vector3d(0.3, 0.2, 0.1)));
BENCHMARK_CAPTURE(TimeSupport, cylinder, dgd::Cylinder<double>(0.3, 0.2));
BENCHMARK_CAPTURE(TimeSupport, cone, dgd::Cone<double>(0.3, 0.5));
BENCHMARK_CAPTURE(TimeSupport, frustum, dgd::Frustum<double>(0.3, 0.1, 0.5));
BENCHMARK_CAPTURE(TimeSupport, ellipsoid, dgd::Ellipsoid<double>(Vector3d(0.3, 0.2, 0.1)));

// Queries on two hulls, and what a step makes of their results.

/// Two hulls in many poses, and what one query after the other needs.
class Pair {
 public:
  struct Input {
    Pose pose_1, pose_2;
    dgd::WarmStart<double> last;  // Of set 2 at a pose 1 % and 0.01 rad away.
    dgd::Result<double> result;
    dgd::PatchFrame<double> frame;
  };

  /// @param distance  Of the centres, of all poses; metres.
  /// @param settings  Of the query before.
  Pair(double distance, double margin, const dgd::Settings<double>& settings = {})
      : margin_(margin), inputs_([&] { return MakeInput(distance, settings); }) {}

  Set set_1() const { return {hull_1_, margin_}; }
  Set set_2() const { return {hull_2_, margin_}; }
  Input& Next() { return inputs_.Next(); }

 private:
  Input MakeInput(double distance, const dgd::Settings<double>& settings) {
    const Pose pose_1{random_.Rotation(), random_.InCube()};
    const Pose pose_2{random_.Rotation(), pose_1.translation + distance * random_.UnitVector()};
    Pose last_2 = pose_2;
    last_2.translation += 0.01 * random_.UnitVector();
    last_2.rotation = Eigen::AngleAxisd(0.01, random_.UnitVector()) * last_2.rotation;
    dgd::WarmStart<double> last;
    dgd::GrowthDistance(set_1(), pose_1, set_2(), last_2, settings, &last);
    const auto result = dgd::GrowthDistance(set_1(), pose_1, set_2(), pose_2);
    return {pose_1, pose_2, last, result, dgd::PatchFrame<double>(result)};
  }

  Random random_{kSeed};
  Hull hull_1_{PointsOnSphere(random_, kUsualVertices)}, hull_2_{PointsOnSphere(random_, kUsualVertices)};
  double margin_;
  Inputs<Input> inputs_;
};

// Of the centres, where hulls of this size mostly overlap and never do; metres.
constexpr double kOverlapping = 0.85, kApart = 1.3;
constexpr double kMargin = 0.04;

void QueryCold(benchmark::State& state, double margin) {
  Pair pair(kOverlapping, margin);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    benchmark::DoNotOptimize(dgd::GrowthDistance(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2));
  }
}
BENCHMARK_CAPTURE(QueryCold, sharp, 0.0);
BENCHMARK_CAPTURE(QueryCold, margin_4_cm, kMargin);

void QueryWarm(benchmark::State& state, double margin) {
  Pair pair(kOverlapping, margin);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    dgd::WarmStart<double> warm_start = in.last;
    benchmark::DoNotOptimize(dgd::GrowthDistance(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2, {}, &warm_start));
  }
}
BENCHMARK_CAPTURE(QueryWarm, sharp, 0.0);
BENCHMARK_CAPTURE(QueryWarm, margin_4_cm, kMargin);

/// As the plugin asks: apart by more than a limit, as the last normal still proves.
void SeparatedAlongLastNormal(benchmark::State& state) {
  dgd::Settings<double> settings;
  settings.separation_limit = 0.02;
  Pair pair(kApart, 0, settings);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    dgd::WarmStart<double> warm_start = in.last;
    benchmark::DoNotOptimize(
        dgd::GrowthDistance(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2, settings, &warm_start));
  }
}
BENCHMARK(SeparatedAlongLastNormal);

void CollisionCheckCold(benchmark::State& state, double distance) {
  Pair pair(distance, 0);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    benchmark::DoNotOptimize(dgd::DetectCollision(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2));
  }
}
BENCHMARK_CAPTURE(CollisionCheckCold, apart, kApart);
BENCHMARK_CAPTURE(CollisionCheckCold, overlapping, kOverlapping);

/// From the growth distance to the least translation or the distance.
void SignedDistanceStep(benchmark::State& state) {
  Pair pair(kOverlapping, 0);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    benchmark::DoNotOptimize(dgd::SignedDistance(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2, in.result));
  }
}
BENCHMARK(SignedDistanceStep);

void Face(benchmark::State& state) {
  Pair pair(kOverlapping, 0);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    dgd::SupportingFace<double> face;
    dgd::FindFace(pair.set_1(), in.pose_1, in.result.normal, in.frame, face);
    benchmark::DoNotOptimize(face);
  }
}
BENCHMARK(Face);

void Patch(benchmark::State& state) {
  Pair pair(kOverlapping, 0);
  constexpr double kAngularTolerance = 1.47;
  const dgd::PatchSettings<double> settings{.contact_distance = 0.02, .spacing = 0.02, .equal_depth = 2e-5};
  const auto is_approaching = [](const Vector3d&, double) { return false; };
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    const auto facing =
        dgd::FindFacingFaces(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2, in.result, kAngularTolerance);
    benchmark::DoNotOptimize(dgd::FindContactPatch(in.result, facing, settings, is_approaching));
  }
}
BENCHMARK(Patch);

void Certificate(benchmark::State& state) {
  Pair pair(kOverlapping, 0);
  for (auto _ : state) {
    const Pair::Input& in = pair.Next();
    benchmark::DoNotOptimize(dgd::Certify(pair.set_1(), in.pose_1, pair.set_2(), in.pose_2, in.result));
  }
}
BENCHMARK(Certificate);

/// Once per shape.
void HullBuilding(benchmark::State& state) {
  Random random(kSeed);
  const std::vector<Vector3d> points = PointsOnSphere(random, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Hull(points));
}
BENCHMARK(HullBuilding)->ArgName("vertices")->RangeMultiplier(8)->Range(8, 4096)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace dgd_bench
// NOLINTEND(clang-analyzer-deadcode.DeadStores)

BENCHMARK_MAIN();
