// The figures of a run by name, unit and format: the one list that every table and CSV of runs follows.
#pragma once

#include <span>

#include "simulation/run_summary.h"

namespace dgd_demos {

struct Figure {
  /// How several runs of a scene, one a seed, become one figure.
  enum class Over { kMedian, kSum };

  const char* title;   ///< For people, with the unit in which the figure is shown.
  const char* key;     ///< For programs, with the SI unit of the figure.
  const char* format;  ///< Of the figure in the title's unit.
  double unit;         ///< Title's unit in the key's.
  double (*of)(const RunSummary&);
  Over over = Over::kMedian;
};

/// All of them, in the order in which they are shown.
std::span<const Figure> Figures();

/// Of all runs together, in the key's unit. Runs without the figure (NaN) are left out of the median; it is NaN if none
/// has it. Of an even number of runs, it is the mean of the two in the middle.
/// @pre runs is not empty.
double FigureOf(const Figure& figure, std::span<const RunSummary> runs);

}  // namespace dgd_demos
