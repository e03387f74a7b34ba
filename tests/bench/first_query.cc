// first_query: what new hulls cost, on Bullet's built-in narrowphase and on the plugin in turns. See --help.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/bench_world.h"
#include "bench/exit_status.h"
#include "bench/percentile.h"
#include "bench/stopwatch.h"
#include "command_line.h"
#include "program_main.h"
#include "support/random.h"

namespace {

/// Bytes that operator new has handed out and not got back, rounded up as the heap does.
std::ptrdiff_t heap_bytes = 0;

void Free(void* memory) {
  heap_bytes -= static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  heap_bytes += static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  return memory;
}
void operator delete(void* memory) noexcept { Free(memory); }
void operator delete(void* memory, std::size_t) noexcept { Free(memory); }

namespace dgd_bench {
namespace {

using dgd_demos::Narrowphase;
using dgd_test::Random;
using Points = std::vector<btVector3>;

constexpr const char* kDescription =
    R"(Times the first queries of hulls that no query has seen before, as debris and the shapes of an app's own queries
are, on Bullet's built-in narrowphase and on the plugin in turns.)";

constexpr const char* kFooter = R"(
Examples:
  first_query                          Bullet in float
  first_query_float64 --pairs 1000     in double

The first table is of two new hulls of random points on a ball 1 m across that overlap by up to 2 cm, queried by
contactPairTest() again and again: us, p50 over the pairs, of the first query, of the second, and of those after a
thousand; the ratios are the plugin's time to the built-in's. Then what the plugin keeps of a hull, in bytes of the heap,
after the first query and after the last.

The second is of 250 new hulls, of 20 points by default, that are put on a ground in one frame, in contact with each
other: ms of the narrowphase in the first frame, in the costliest of those after it, and in all. Each frame's time is
the least of all rounds, for each of which all is made again.

Exit status: 0; 2 wrong command line.)";

constexpr std::array kNarrowphases = {Narrowphase::kBuiltin, Narrowphase::kDgd};
constexpr std::size_t kMethods = kNarrowphases.size();

struct Options {
  int pairs = 1000;
  int frames = 300;
  int rounds = 5;
  int points = 20;
  std::uint64_t seed = 1;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  Options options;
  dgd_demos::CommandLine line("first_query", kDescription, kFooter);
  line.AddNumber("--pairs", "N", options.pairs, {1, 100000}, "Pairs of each size");
  line.AddNumber("--frames", "N", options.frames, {2, 100000}, "Frames of a sixtieth of a second");
  line.AddNumber("--points", "N", options.points, {4, 10000}, "Points of the hulls of the frames");
  line.AddNumber("--rounds", "N", options.rounds, {1, 1000}, "Times that the frames are simulated");
  line.AddSeed(options.seed, "Random seed");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

Points OnBall(Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d point = 0.5 * random.UnitVector();
    points.push_back(Vec(point.x(), point.y(), point.z()));
  }
  return points;
}

btConvexHullShape& MakeHull(BenchWorld& world, const Points& points) {
  auto& hull = world.Make<btConvexHullShape>();
  for (const btVector3& point : points) hull.addPoint(point, false);
  hull.recalcLocalAabb();
  return hull;
}

/// Two new hulls in touch.
class NewPair {
 public:
  NewPair(BenchWorld& world, const Points& points_a, const Points& points_b, const btVector3& direction)
      : world_(world.world()), shape_a_(ShapeOf(points_a)), shape_b_(ShapeOf(points_b)) {
    constexpr double kOverlap = 0.02;
    a_.setCollisionShape(&shape_a_);
    b_.setCollisionShape(&shape_b_);
    a_.setWorldTransform(btTransform::getIdentity());
    const btScalar distance =
        direction.dot(shape_a_.localGetSupportingVertex(direction) - shape_b_.localGetSupportingVertex(-direction));
    b_.setWorldTransform(At((distance - btScalar(kOverlap)) * direction));
  }

  /// Mean of some queries in a row, us.
  double Time(int queries) {
    return MeanMicroseconds(queries, [&] { world_.contactPairTest(&a_, &b_, callback_); });
  }

 private:
  static btConvexHullShape ShapeOf(const Points& points) {
    return {points[0].m_floats, static_cast<int>(points.size()), static_cast<int>(sizeof(btVector3))};
  }

  struct Callback : btCollisionWorld::ContactResultCallback {
    btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      return 0;
    }
  };

  btCollisionWorld& world_;
  btConvexHullShape shape_a_, shape_b_;
  btCollisionObject a_, b_;
  Callback callback_;
};

/// Of each narrowphase.
template <class T>
using OfEach = std::array<T, kMethods>;

/// Calls back with pairs of new hulls, in a world of each narrowphase.
template <class Measure>
void ForNewPairs(const Options& options, int pairs, int points, const Measure& measure) {
  std::array<BenchWorld, kMethods> worlds{BenchWorld(kNarrowphases[0]), BenchWorld(kNarrowphases[1])};
  Random random(options.seed);
  for (int i = 0; i < pairs; ++i) {
    const Points a = OnBall(random, points), b = OnBall(random, points);
    const Eigen::Vector3d direction = random.UnitVector();
    for (std::size_t m = 0; m < kMethods; ++m) {
      NewPair pair(worlds[m], a, b, Vec(direction.x(), direction.y(), direction.z()));
      measure(pair, m);
    }
  }
}

void PrintMedians(OfEach<std::vector<double>>& times) {
  for (std::vector<double>& of_method : times) std::ranges::sort(of_method);
  const double builtin = Percentile(times[0], 0.5), dgd = Percentile(times[1], 0.5);
  std::printf("%10.2f%9.2f%7.2f", builtin, dgd, dgd / builtin);
}

/// What the plugin keeps of a hull, in bytes of the heap.
struct HullBytes {
  std::ptrdiff_t first, later;
};

HullBytes MeasureBytes(const Options& options, int points, int later) {
  constexpr int kPairs = 10;
  BenchWorld world(Narrowphase::kDgd);
  Random random(options.seed);
  std::deque<NewPair> pairs;  // Alive together: a shape takes the place of one that is gone, and its hull's.
  for (int i = 0; i < kPairs; ++i) {
    pairs.emplace_back(world, OnBall(random, points), OnBall(random, points), Vec(1, 0, 0));
  }
  const std::ptrdiff_t before = heap_bytes;
  const auto bytes_after = [&](int queries) {
    for (NewPair& pair : pairs) pair.Time(queries);
    return (heap_bytes - before) / (2 * kPairs);
  };
  const std::ptrdiff_t first = bytes_after(1);
  return {first, bytes_after(later)};
}

void CompareQueries(const Options& options) {
  constexpr int kWarm = 1000, kLater = 100, kLaterPairs = 20;
  std::printf("%-8s%26s%26s%26s%22s\n", "us", "first query", "second", "later", "bytes a hull");
  std::printf("%-8s", "points");
  for (int i = 0; i < 3; ++i) std::printf("%10s%9s%7s", "built-in", "dgd", "ratio");
  std::printf("%11s%11s\n", "first", "later");
  for (const int points : {8, 20, 100, 1000}) {
    OfEach<std::vector<double>> first, second, later;
    ForNewPairs(options, options.pairs, points, [&](NewPair& pair, std::size_t m) {
      first[m].push_back(pair.Time(1));
      second[m].push_back(pair.Time(1));
    });
    ForNewPairs(options, std::min(options.pairs, kLaterPairs), points, [&](NewPair& pair, std::size_t m) {
      pair.Time(kWarm);
      later[m].push_back(pair.Time(kLater));
    });
    std::printf("%-8d", points);
    for (OfEach<std::vector<double>>* times : {&first, &second, &later}) PrintMedians(*times);
    const HullBytes bytes = MeasureBytes(options, points, kWarm);
    std::printf("%11td%11td\n", bytes.first, bytes.later);
    std::fflush(stdout);
  }
}

/// A block of hulls, each with a shape of its own, that touch each other and the ground.
void BuildDebris(BenchWorld& world, const Options& options) {
  constexpr int kSide = 5, kLevels = 10;
  constexpr double kPitch = 0.95, kMass = 100;
  Random random(options.seed);
  world.AddGround(50);
  for (int level = 0; level < kLevels; ++level) {
    for (int i = 0; i < kSide * kSide; ++i) {
      const btVector3 place = Vec(kPitch * (i % kSide), kPitch * (i / kSide), kPitch * (level + 0.5));
      world.Add(MakeHull(world, OnBall(random, options.points)), kMass, At(place));
    }
  }
}

void CompareFrames(const Options& options) {
  const auto frames = static_cast<std::size_t>(options.frames);
  OfEach<std::vector<double>> least;
  for (auto& of_method : least) of_method.assign(frames, std::numeric_limits<double>::infinity());
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t m = 0; m < kMethods; ++m) {
      BenchWorld world(kNarrowphases[m]);
      BuildDebris(world, options);
      for (double& frame : least[m]) frame = std::min(frame, world.Step().narrowphase_ms);
    }
  }
  std::printf("\n%-18s%14s%24s%14s\n", "250 hulls, ms", "first frame", "costliest after it", "all frames");
  for (std::size_t m = 0; m < kMethods; ++m) {
    double all = 0;
    for (const double frame : least[m]) all += frame;
    std::printf("%-18s%14.2f%24.2f%14.1f\n", std::string(NameOf(kNarrowphases[m])).c_str(), least[m][0],
                *std::max_element(least[m].begin() + 1, least[m].end()), all);
  }
}

ExitStatus Run(const Options& options) {
  std::printf("Bullet in %s\n", sizeof(btScalar) == sizeof(double) ? "double" : "float");
  CompareQueries(options);
  CompareFrames(options);
  return kSuccess;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
