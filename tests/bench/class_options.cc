#include "bench/class_options.h"

#include <algorithm>

namespace dgd_bench {

bool ClassOptions::Wants(const PairClass& each) const {
  return classes.empty() || std::ranges::count(classes, each.name) > 0;
}

void AddClassOptions(dgd_demos::CommandLine& line, ClassOptions& options) {
  constexpr int kMost = 10'000'000;
  std::vector<std::string> names;
  for (const PairClass& each : AllPairClasses()) names.emplace_back(each.name);
  line.AddNumber("--pairs", "N", options.pairs, {1, kMost}, "Pairs of sets of each class");
  line.AddNumber("--poses", "N", options.poses, {1, kMost}, "Poses of each pair");
  line.AddSeed(options.seed, "Seed of the sets and poses");
  line.AddChoices("--classes", "A,B", options.classes, names, "Some of the classes below");
  line.AddText("--meshes", "DIR", options.meshes, "Folder of .obj files for the class meshes");
  line.AddNumber("--repeats", "N", options.repeats, {1, kMost}, "Queries in a row, of which the mean is taken");
  line.AddNumber("--rounds", "N", options.rounds, {1, kMost},
                 "Turns of all methods, of which each one's least mean counts");
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
