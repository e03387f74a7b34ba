// contact_parity: every pair of Bullet's convex types in random poses, asked of the plugin and of Bullet's built-in
// narrowphase, and both judged. See --help.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "command_line.h"
#include "parity/judge.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_test {
namespace {

constexpr bool kIsDouble = sizeof(btScalar) == sizeof(double);
/// What is asked for.
constexpr double kTolerance = kIsDouble ? 1e-9 : 1e-5;

constexpr const char* kDescription =
    R"(Puts shapes of every pair of Bullet's convex types into random poses, apart, touching and overlapping, and asks
the plugin and Bullet's built-in narrowphase for their closest points and their contacts. A referee that
shares no code with either, Bullet's own support functions between planes and points, judges both. Boxes
have the margin that the plugin takes for the radius of their edges, so that all see the same.)";

constexpr const char* kFooter = R"(
Examples:
  contact_parity                               a thousand poses a pair of types: under a minute
  contact_parity_float64 --poses 100000        Bullet in double, and all that was asked for
  contact_parity --poses 5000 --only CONE      pairs with a cone

Columns, of the plugin and of the built-in: pairs of shapes without an answer; wrong yes/no; depths that the planes
along the answer's own normal do not bear out; distances or least translations off by more than 1e-9
(Bullet in float: 1e-5) of the pair's size or distance; worst of these errors, apart and overlapping.
Rows "contacts": what contactTest() gets; there only yes/no and normals are judged.

Exit status: 0; 1 the plugin gave no answer, a wrong one, one that its normal does not bear out, or one that is off
by a hundredth; 2 wrong command line.)";

struct Options {
  int poses = 1000;
  std::uint64_t seed = 1;
  std::string only;
};

enum ExitStatus { kSuccess = 0, kFailedPair = 1, kBadInput = 2 };

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMostPoses = 100'000'000;
  Options options;
  dgd_demos::CommandLine line("contact_parity", kDescription, kFooter);
  line.AddNumber("--poses", "N", options.poses, {1, kMostPoses}, "Random poses of each pair of types");
  line.AddSeed(options.seed, "Seed of the poses");
  line.AddText("--only", "TYPE", options.only, "Only pairs with this type, by its name in the table");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

/// All shapes of one type, of several sizes.
struct Family {
  std::string name;
  std::vector<ZooShape> members;
};

std::vector<Family> MakeFamilies() {
  const std::map<int, const char*> names = {{BOX_SHAPE_PROXYTYPE, "BOX"},
                                            {TRIANGLE_SHAPE_PROXYTYPE, "TRIANGLE"},
                                            {TETRAHEDRAL_SHAPE_PROXYTYPE, "TETRAHEDRAL"},
                                            {CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE, "TRIANGLEMESH"},
                                            {CONVEX_HULL_SHAPE_PROXYTYPE, "HULL"},
                                            {CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE, "POINT_CLOUD"},
                                            {SPHERE_SHAPE_PROXYTYPE, "SPHERE"},
                                            {MULTI_SPHERE_SHAPE_PROXYTYPE, "MULTI_SPHERE"},
                                            {CAPSULE_SHAPE_PROXYTYPE, "CAPSULE"},
                                            {CONE_SHAPE_PROXYTYPE, "CONE"},
                                            {CYLINDER_SHAPE_PROXYTYPE, "CYLINDER"},
                                            {UNIFORM_SCALING_SHAPE_PROXYTYPE, "SCALED_CONE"},
                                            // Bullet's own type for btMinkowskiSumShape.
                                            {MINKOWSKI_DIFFERENCE_SHAPE_PROXYTYPE, "MINKOWSKI_SUM"},
                                            {CUSTOM_CONVEX_SHAPE_TYPE, "CUSTOM"}};
  std::map<int, Family> families;
  for (const double size : {0.2, 1.0, 4.0}) {
    for (ZooShape& shape : MakeShapeZoo(size)) {
      const int type = shape.shape->getShapeType();
      if (type == BOX_SHAPE_PROXYTYPE) {
        // The built-in rounds boxes by their margin: with this one, both see the same.
        auto& box = static_cast<btBoxShape&>(*shape.shape);
        box.setMargin(0);
      }
      families[type].name = names.at(type);
      families[type].members.push_back(std::move(shape));
    }
  }
  std::vector<Family> list;
  for (auto& [type, family] : families) list.push_back(std::move(family));
  return list;
}

struct BoundingSphere {
  Vector center;
  double radius;
};

BoundingSphere BoundingSphereOf(const btConvexShape& shape) {
  btVector3 center;
  btScalar radius = 0;
  shape.getBoundingSphere(center, radius);
  return {ToEigen(center), double(radius)};
}

/// Half of the pairs anywhere from one inside the other to a little apart; the others apart, or overlapping, by a
/// millionth to a tenth of their size.
void Place(Random& random, PairQuery& pair, double size) {
  const Vector center_a = BoundingSphereOf(pair.A().shape).center, center_b = BoundingSphereOf(pair.B().shape).center;
  const Eigen::Matrix3d rotation_a = random.Rotation(), rotation_b = random.Rotation();
  const Vector position_a = size * random.InCube();
  const bool is_near = random.Flip();
  const Vector way = (is_near ? 2 : random.Uniform(0, 1.2)) * size * random.UnitVector();
  Vector position_b = position_a + rotation_a * center_a + way - rotation_b * center_b;
  const btTransform pose_a = MakeTransform(rotation_a, position_a);
  pair.SetPoses(pose_a, MakeTransform(rotation_b, position_b));
  if (!is_near) return;
  const SignedDistance far = DistanceOfShapes(pair.A(), pair.B());
  const double gap = (random.Flip() ? 1 : -1) * size * random.LogUniform(1e-6, 0.1);
  position_b += (far.value - gap) * far.normal_b_to_a;
  pair.SetPoses(pose_a, MakeTransform(rotation_b, position_b));
}

constexpr std::array kRoutes = {Route::kConfiguration, Route::kBuiltin};

/// Of one pair of types, or all.
struct Verdicts {
  std::array<Verdict, kRoutes.size()> closest_points, contacts;
  int undecided = 0;  // Poses in which the referee's own bounds are not within the tolerance.

  void Add(const Verdicts& other) {
    for (std::size_t i = 0; i < kRoutes.size(); ++i) {
      closest_points[i] += other.closest_points[i];
      contacts[i] += other.contacts[i];
    }
    undecided += other.undecided;
  }
};

Verdicts Judge(Random& random, const Family& family_a, const Family& family_b, int poses,
               std::array<Dispatching, kRoutes.size()>& dispatchings) {
  constexpr double kAnyDistance = 100;  // m
  const auto pick = [&random](const Family& family) -> btConvexShape& {
    return *family.members[static_cast<std::size_t>(random.Below(static_cast<int>(family.members.size())))].shape;
  };
  Verdicts verdicts;
  for (int pose = 0; pose < poses; ++pose) {
    btConvexShape *a = &pick(family_a), *b = &pick(family_b);
    if (random.Flip()) std::swap(a, b);
    const double size = BoundingSphereOf(*a).radius + BoundingSphereOf(*b).radius;
    PairQuery ours(dispatchings[0].dispatcher(), *a, *b), builtin(dispatchings[1].dispatcher(), *a, *b);
    Place(random, ours, size);
    builtin.SetPoses(ours.body_a().getWorldTransform(), ours.body_b().getWorldTransform());
    Truth truth{DistanceOfShapes(ours.A(), ours.B()), size, kTolerance};
    truth.scale = std::max(size, truth.distance.upper);
    if (truth.distance.upper - truth.distance.value > kTolerance * truth.scale) ++verdicts.undecided;
    for (std::size_t i = 0; i < kRoutes.size(); ++i) {
      PairQuery& pair = i == 0 ? ours : builtin;
      JudgeClosestPoints(truth, pair, pair.ClosestPoints(kAnyDistance), verdicts.closest_points[i]);
      JudgeContacts(truth, pair, pair.ContactTest(), verdicts.contacts[i]);
    }
  }
  return verdicts;
}

void PrintRow(const std::string& name, int undecided, const std::array<Verdict, kRoutes.size()>& verdicts) {
  std::printf("%-30s%10d%10d", name.c_str(), verdicts[0].answers, undecided);
  for (const Verdict& verdict : verdicts) {
    std::printf(" |%9d%9d%9d%9d%9.1e%9.1e", verdict.missing, verdict.wrong, verdict.not_certified, verdict.inexact,
                verdict.worst_apart, verdict.worst_overlap);
  }
  std::printf("\n");
}

void PrintHeader() {
  std::printf("Bullet in %s; errors relative to the pair's size or distance, tolerance %g\n",
              kIsDouble ? "double" : "float", kTolerance);
  std::printf("%-50s |%-54s |%s\n", "", " plugin", " built-in");
  std::printf("%-30s%10s%10s", "pair of types", "poses", "undecided");
  for (std::size_t i = 0; i < kRoutes.size(); ++i) {
    std::printf(" |%9s%9s%9s%9s%9s%9s", "missing", "wrong", "normals", "inexact", "apart", "overlap");
  }
  std::printf("\n");
}

ExitStatus Run(const Options& options) {
  const std::vector<Family> families = MakeFamilies();
  std::array<Dispatching, kRoutes.size()> dispatchings{Dispatching(kRoutes[0]), Dispatching(kRoutes[1])};
  std::vector<std::pair<const Family*, const Family*>> pairs;
  for (std::size_t i = 0; i < families.size(); ++i) {
    for (std::size_t j = i; j < families.size(); ++j) {
      const bool is_wanted =
          options.only.empty() || options.only == families[i].name || options.only == families[j].name;
      if (is_wanted) pairs.emplace_back(&families[i], &families[j]);
    }
  }
  if (pairs.empty()) {
    std::cerr << "--only: no type is called " << options.only << '\n';
    return kBadInput;
  }
  PrintHeader();
  dgd_demos::ProgressBar progress("judging", 1);
  Verdicts all;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [a, b] = pairs[i];
    Random random(options.seed + 1000 * i);
    const Verdicts verdicts = Judge(random, *a, *b, options.poses, dispatchings);
    PrintRow(a->name + " - " + b->name, verdicts.undecided, verdicts.closest_points);
    if (!verdicts.contacts[0].Holds()) PrintRow("  contacts", verdicts.undecided, verdicts.contacts);
    std::fflush(stdout);
    all.Add(verdicts);
    progress.Update(double(i + 1) / double(pairs.size()));
  }
  PrintRow("all", all.undecided, all.closest_points);
  PrintRow("all, contacts", all.undecided, all.contacts);
  const dgd_bullet::Statistics statistics = dispatchings[0].statistics();
  std::printf("fallbacks of the plugin: %llu\n", static_cast<unsigned long long>(statistics.Fallbacks()));
  return all.closest_points[0].Holds() && all.contacts[0].Holds() ? kSuccess : kFailedPair;
}

}  // namespace
}  // namespace dgd_test

int main(int argc, char** argv) { return dgd_demos::RunProgram(dgd_test::ParseCommandLine(argc, argv), dgd_test::Run); }
