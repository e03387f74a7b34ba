// The options that the benchmarks over classes of random pairs have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/pair_class.h"
#include "command_line.h"

namespace dgd_bench {

struct ClassOptions {
  int pairs = 1000;
  int poses = 100;
  std::uint64_t seed = 1;
  std::vector<std::string> classes;  ///< Empty for all.
  std::string meshes;                ///< Folder; empty for generated ones.

  bool Wants(const PairClass& each) const;
};

/// Adds --pairs, --poses, --seed, --classes and --meshes, whose defaults `options` holds.
void AddClassOptions(dgd_demos::CommandLine& line, ClassOptions& options);

/// Of the programs that time several methods.
struct TimedClassOptions : ClassOptions {
  TimedClassOptions() {
    pairs = 200;
    poses = 20;
  }

  int repeats = 10;  ///< Queries in a row, of which the mean is taken.
  int rounds = 3;    ///< Turns of all methods, of which each one's least mean counts.
};

/// Adds --repeats and --rounds to the above.
void AddTimedClassOptions(dgd_demos::CommandLine& line, TimedClassOptions& options);

/// What the classes are, for a program's help.
std::string ClassesInWords();

/// As the options say. Throws std::runtime_error if a mesh cannot be read.
Meshes MakeMeshes(const ClassOptions& options, dgd_test::Random& random);

}  // namespace dgd_bench
