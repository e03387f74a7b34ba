// The options that the benchmarks over classes of random pairs have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/pair_class.h"
#include "command_line.h"

namespace dgd_bench {

struct ClassOptions {
  int pairs = 200;
  int poses = 20;
  std::uint64_t seed = 1;
  std::vector<std::string> classes;  ///< Empty for all.
  std::string meshes;                ///< Folder; empty for generated ones.
  int repeats = 10;                  ///< Queries in a row; their mean counts.
  int rounds = 3;                    ///< Turns of all methods; the least mean of each counts.

  bool Wants(const PairClass& each) const;
};

/// Adds an option for each, whose defaults `options` holds.
void AddClassOptions(dgd_demos::CommandLine& line, ClassOptions& options);

/// What the classes are, for a program's help.
std::string ClassesInWords();

/// As the options say. Throws std::runtime_error if a mesh cannot be read.
Meshes MakeMeshes(const ClassOptions& options, dgd_test::Random& random);

}  // namespace dgd_bench
