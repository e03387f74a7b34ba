// An app on both narrowphases at one rate, and how that is judged and printed. Knows no Bullet.
#pragma once

#include <string>
#include <vector>

#include "apps/app.h"

namespace dgd_apps {

/// Both runs of an app.
struct Runs {
  const App* app = nullptr;
  double rate = 0;  ///< Hz
  Cases builtin, ours;
};

/// One figure of both.
struct Verdict {
  const App* app = nullptr;
  const Figure* figure = nullptr;
  std::string group;  ///< Empty for all cases.
  double rate = 0;    ///< Hz
  double builtin = 0, ours = 0;

  /// The largest value of ours that passes.
  double Bound() const { return builtin * (1 + figure->band) + figure->floor; }
  /// False for infinity, even where the built-in breaks down as well.
  bool Passes() const;
};

Runs RunBoth(const App& app, double rate, bool is_quick);
/// For each group of cases one verdict a figure: first for all cases, then, if there are several groups, for each.
std::vector<Verdict> Judge(const Runs& runs);

/// A heading for rows at these rates, and the row of a figure, with one verdict a rate.
std::string FormatHeading(const std::vector<double>& rates);
std::string FormatRow(const std::vector<Verdict>& verdicts);
/// A line per case, with both values of each figure.
std::string FormatCases(const Runs& runs);
/// A line per verdict that fails; empty if none do.
std::string FormatFailures(const std::vector<Verdict>& verdicts);
/// A line per case and figure, with 17 significant digits, and a line of column names first.
std::string FormatCsv(const std::vector<Runs>& all, const std::string& precision);

}  // namespace dgd_apps
