#include "bench/class_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "seed_option.h"

namespace dgd_bench {
namespace {

void AddCount(CLI::App& app, const char* name, int& value, const char* what) {
  constexpr int kMost = 10'000'000;
  app.add_option(name, value, what)->type_name("N")->check(CLI::Range(1, kMost).description(""))->capture_default_str();
}

}  // namespace

bool ClassOptions::Wants(const PairClass& each) const {
  return classes.empty() || std::ranges::count(classes, each.name) > 0;
}

void AddClassOptions(CLI::App& app, ClassOptions& options) {
  std::vector<std::string> names;
  for (const PairClass& each : AllPairClasses()) names.emplace_back(each.name);
  app.get_formatter()->column_width(30);
  AddCount(app, "--pairs", options.pairs, "Pairs of sets of each class");
  AddCount(app, "--poses", options.poses, "Poses of each pair");
  dgd_demos::AddSeedOption(app, options.seed, "Seed of the sets and poses");
  app.add_option("--classes", options.classes, "Some of the classes below")
      ->type_name("A,B")
      ->delimiter(',')
      ->check(CLI::IsMember(names).description(""));
  app.add_option("--meshes", options.meshes, "Folder of .obj files for the class meshes")->type_name("DIR");
}

void AddTimedClassOptions(CLI::App& app, TimedClassOptions& options) {
  AddClassOptions(app, options);
  AddCount(app, "--repeats", options.repeats, "Queries in a row, of which the mean is taken");
  AddCount(app, "--rounds", options.rounds, "Turns of all methods, of which each one's least mean counts");
}

std::string ClassesInWords() {
  return R"(
Classes:  curved: sphere, capsule, box, cylinder, cone, frustum, ellipsoid, one of each pair not the
          box, every size log-uniform from 0.25 to 25 cm. rounded-hulls, sharp-hulls: 8 to 20
          vertices, 1 m across, margin 4 cm or none. meshes: hulls of 241 to 4516 points on ellipsoids
          of aspect ratio 10; dsf: differentiable support functions of 4 to 30 points; of these two,
          fewer pairs in more poses. 2d: circle, stadium, rectangle, ellipse, polygon. vertices-8 to
          vertices-4096: hulls of so many points on a sphere 1 m across, the same solver type for all.
Poses:    random orientations, both centres in a cube of 1.4 times the pair's extent.
)";
}

Meshes MakeMeshes(const ClassOptions& options, dgd_test::Random& random) {
  return options.meshes.empty() ? EllipsoidMeshes(random) : ReadMeshes(options.meshes);
}

}  // namespace dgd_bench
