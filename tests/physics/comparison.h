// An experiment on both narrowphases at one rate, and how it is judged and printed. Knows no Bullet.
#pragma once

#include <string>
#include <vector>

#include "physics/experiment.h"

namespace dgd_physics {

struct Comparison {
  const Experiment* experiment = nullptr;
  double rate = 0;        ///< Hz
  std::string group;      ///< Empty for all cases.
  Samples builtin, ours;  ///< The same cases in the same order.

  double BuiltinError() const { return RmsError(builtin); }
  double OurError() const { return RmsError(ours); }
  double Bound() const { return ErrorBound(*experiment, rate, BuiltinError()); }
  /// False for NaN.
  bool Passes() const { return OurError() <= Bound(); }
};

/// @param conditions  Those of either run but for the narrowphase.
Comparison Compare(const Experiment& experiment, Conditions conditions);

/// All cases, then each group's if there are several: an error of the built-in's in one does not excuse ours in
/// another.
std::vector<Comparison> WithGroups(const Comparison& all);

/// A heading for rows at these rates, and the row of one experiment or group, with one comparison a rate.
std::string FormatHeading(const std::vector<double>& rates);
std::string FormatRow(const std::vector<Comparison>& comparisons);
/// A line per case: its name, built-in, ours, theory, and both errors.
std::string FormatCases(const Comparison& comparison);
/// The classes, groups and rates that fail, a line each; empty if none do.
std::string FormatFailures(const std::vector<Comparison>& comparisons);
/// A line per case, with 17 significant digits, and a line of column names first.
std::string FormatCsv(const std::vector<Comparison>& comparisons, const std::string& precision);

}  // namespace dgd_physics
