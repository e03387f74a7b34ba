#include "apps/verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "physics/format.h"

namespace dgd_apps {
namespace {

using dgd_physics::Format;

constexpr int kNameWidth = 60;
constexpr int kCaseWidth = 64;

/// A group's cases; all for an empty name.
Cases Select(const Cases& all, const std::string& group) {
  if (group.empty()) return all;
  Cases some;
  std::ranges::copy_if(all, std::back_inserter(some), [&group](const Case& it) { return it.group == group; });
  return some;
}

/// What a verdict is about.
std::string NameOf(const Verdict& it) {
  const std::string name = std::string(it.app->name) + ": " + std::string(it.figure->name);
  return it.group.empty() ? name : name + " (" + it.group + ")";
}

}  // namespace

bool Verdict::Passes() const { return std::isfinite(ours) && ours <= Bound(); }

Runs RunBoth(const App& app, double rate, bool is_quick) {
  return {&app, rate, app.run({Narrowphase::kBuiltin, rate, is_quick}), app.run({Narrowphase::kOurs, rate, is_quick})};
}

std::vector<Verdict> Judge(const Runs& runs) {
  std::vector<std::string> groups = {""};
  for (const Case& it : runs.ours) {
    if (std::ranges::count(groups, it.group) == 0) groups.push_back(it.group);
  }
  if (groups.size() == 2) groups.pop_back();
  std::vector<Verdict> verdicts;
  for (const std::string& group : groups) {
    const Cases builtin = Select(runs.builtin, group), ours = Select(runs.ours, group);
    for (std::size_t i = 0; i < runs.app->figures.size(); ++i) {
      const Figure& figure = runs.app->figures[i];
      verdicts.push_back(
          {runs.app, &figure, group, runs.rate, CombineValues(figure, builtin, i), CombineValues(figure, ours, i)});
    }
  }
  return verdicts;
}

std::string FormatHeading(const std::vector<double>& rates) {
  std::string rate_line = Format("%-*s", kNameWidth, ""), column_line = Format("%-*s", kNameWidth, "app: figure");
  for (const double rate : rates) {
    rate_line += Format(" | %8g Hz%14s", rate, "");
    column_line += Format(" |%10s%10s%5s", "built-in", "ours", "");
  }
  return rate_line + "\n" + column_line + "\n";
}

std::string FormatRow(const std::vector<Verdict>& verdicts) {
  std::string row = Format("%-*s", kNameWidth, NameOf(verdicts.front()).c_str());
  for (const Verdict& it : verdicts) row += Format(" |%10.3g%10.3g%5s", it.builtin, it.ours, it.Passes() ? "" : "FAIL");
  return row + "\n";
}

std::string FormatCases(const Runs& runs) {
  std::string text = Format("%s at %g Hz, built-in / ours:\n", std::string(runs.app->name).c_str(), runs.rate);
  for (std::size_t i = 0; i < runs.ours.size(); ++i) {
    text += Format("  %-*s", kCaseWidth, runs.ours[i].name.c_str());
    for (std::size_t j = 0; j < runs.app->figures.size(); ++j)
      text += Format(" | %10.3g / %-10.3g", runs.builtin[i].values[j], runs.ours[i].values[j]);
    text += "\n";
  }
  return text;
}

std::string FormatFailures(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const Verdict& it : verdicts) {
    if (it.Passes()) continue;
    text += Format("fails: %s at %g Hz: built-in %.3g, ours %.3g, bound %.3g\n", NameOf(it).c_str(), it.rate,
                   it.builtin, it.ours, it.Bound());
  }
  return text;
}

std::string FormatCsv(const std::vector<Runs>& all, const std::string& precision) {
  std::string text = "precision,app,rate_hz,case,figure,builtin,ours\n";
  for (const Runs& runs : all) {
    for (std::size_t i = 0; i < runs.ours.size(); ++i) {
      for (std::size_t j = 0; j < runs.app->figures.size(); ++j) {
        text += Format("%s,%s,%g,\"%s\",\"%s\",%.17g,%.17g\n", precision.c_str(), std::string(runs.app->name).c_str(),
                       runs.rate, runs.ours[i].name.c_str(), std::string(runs.app->figures[j].name).c_str(),
                       runs.builtin[i].values[j], runs.ours[i].values[j]);
      }
    }
  }
  return text;
}

}  // namespace dgd_apps
