// The figures of a whole run, free of Bullet.
#pragma once

#include <cstdint>

namespace dgd_demos {

struct RunSummary {
  int steps = 0;
  double deepest_reported = 0;    ///< m, over all steps.
  double deepest_true = 0;        ///< m, over the steps at which the oracle was asked.
  double mean_true = 0;           ///< m, mean over those steps of the deepest in each.
  double kinetic_energy_end = 0;  ///< J
  double dissipated_share = 0;    ///< Of the initial potential energy; counts both energies at the end.
  std::uint64_t pairs = 0;        ///< Over all steps.
  std::uint64_t queries = 0;      ///< Over all steps.
  double narrowphase_us = 0;      ///< Over all steps.
  std::uint64_t contacts = 0;     ///< Over all steps.
  std::uint64_t fallbacks = 0;    ///< Over all steps.
  double wall_time = 0;           ///< Of Bullet's steps alone, s: without the oracle, files and pictures.
};

}  // namespace dgd_demos
