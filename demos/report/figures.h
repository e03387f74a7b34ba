// The figures of a run by name, unit and format: the list that every table and CSV of runs has in common.
#pragma once

#include <span>
#include <vector>

#include "simulation/run_summary.h"

namespace dgd_demos {

struct Figure {
  /// How several runs of a scene, one a seed, become one figure.
  enum class Over { kMedian, kSum };

  const char* title;   ///< For people, with the unit in which the figure is shown.
  const char* key;     ///< For programs, with the SI unit of the figure.
  const char* format;  ///< Format of the figure in the title's unit.
  double unit;         ///< Title's unit in the key's.
  double (*of)(const RunSummary&);
  Over over = Over::kMedian;
};

/// All figures, in the order in which they are shown.
std::span<const Figure> Figures();

/// Figures of one run, in the order of Figures() and the keys' units: NaN for those that it does not have, infinity for
/// a time that never came.
using FigureValues = std::vector<double>;
FigureValues FiguresOf(const RunSummary& run);

/// A figure of several runs. Runs without it (NaN) are left out of median and range.
struct FigureOverRuns {
  double value;  ///< Their median (of an even number, the mean of the two in the middle) or sum; NaN if none has it.
  double interquartile_range;  ///< Linearly interpolated; NaN for a sum, and for fewer than two runs.
};

/// The figure of all runs together, in the key's unit.
/// @param figure  Its index in Figures().
/// @pre runs is not empty.
FigureOverRuns FigureOf(std::size_t figure, std::span<const FigureValues> runs);

}  // namespace dgd_demos
