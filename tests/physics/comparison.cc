#include "physics/comparison.h"

#include <algorithm>

#include "physics/format.h"

namespace dgd_physics {
namespace {

std::string Name(const Comparison& comparison) { return std::string(comparison.experiment->name); }

constexpr int kNameWidth = 22;

}  // namespace

Comparison Compare(const Experiment& experiment, Conditions conditions) {
  Comparison comparison{&experiment, conditions.rate, {}, {}, {}};
  conditions.narrowphase = Narrowphase::kBuiltin;
  comparison.builtin = experiment.measure(conditions);
  conditions.narrowphase = Narrowphase::kOurs;
  comparison.ours = experiment.measure(conditions);
  return comparison;
}

std::vector<Comparison> WithGroups(const Comparison& all) {
  std::vector<Comparison> groups;
  for (std::size_t i = 0; i < all.ours.size(); ++i) {
    const std::string& name = all.ours[i].group;
    const auto is_it = [&name](const Comparison& group) { return group.group == name; };
    auto group = std::ranges::find_if(groups, is_it);
    if (group == groups.end()) group = groups.insert(group, {all.experiment, all.rate, name, {}, {}});
    group->builtin.push_back(all.builtin[i]);
    group->ours.push_back(all.ours[i]);
  }
  if (groups.size() == 1) groups.clear();
  groups.insert(groups.begin(), all);
  return groups;
}

std::string FormatHeading(const std::vector<double>& rates) {
  std::string rate_line = Format("%-*s", kNameWidth + 6, ""),
              column_line = Format("%-*s%6s", kNameWidth, "class", "cases");
  for (const double rate : rates) {
    rate_line += Format(" | %8g Hz%14s", rate, "");
    column_line += Format(" |%10s%10s%5s", "built-in", "ours", "");
  }
  return rate_line + "\n" + column_line + "\n";
}

std::string FormatRow(const std::vector<Comparison>& comparisons) {
  const Comparison& first = comparisons.front();
  const std::string name = first.group.empty() ? Name(first) : "  " + first.group;
  std::string row = Format("%-*s%6zu", kNameWidth, name.c_str(), first.ours.size());
  for (const Comparison& comparison : comparisons) {
    row += Format(" |%10.2g%10.2g%5s", comparison.BuiltinError(), comparison.OurError(),
                  comparison.Passes() ? "" : "FAIL");
  }
  return row + "\n";
}

std::string FormatCases(const Comparison& comparison) {
  std::string text = Format("%s at %g Hz: %92s%11s%11s%9s%9s\n", Name(comparison).c_str(), comparison.rate, "built-in",
                            "ours", "theory", "error", "error");
  for (std::size_t i = 0; i < comparison.ours.size(); ++i) {
    const Sample &builtin = comparison.builtin[i], &ours = comparison.ours[i];
    text += Format("  %-90s%11.4g%11.4g%11.4g%9.2g%9.2g\n", ours.name.c_str(), builtin.measured, ours.measured,
                   ours.theory, RelativeError(builtin), RelativeError(ours));
  }
  return text;
}

std::string FormatFailures(const std::vector<Comparison>& comparisons) {
  std::string text;
  for (const Comparison& comparison : comparisons) {
    if (comparison.Passes()) continue;
    const std::string group = comparison.group.empty() ? "" : " (" + comparison.group + ")";
    text += Format("fails: %s%s at %g Hz: %.3g, bound %.3g\n", Name(comparison).c_str(), group.c_str(), comparison.rate,
                   comparison.OurError(), comparison.Bound());
  }
  return text;
}

std::string FormatCsv(const std::vector<Comparison>& comparisons, const std::string& precision) {
  std::string text = "precision,class,rate_hz,case,builtin,ours,theory,scale,builtin_error,our_error\n";
  for (const Comparison& comparison : comparisons) {
    for (std::size_t i = 0; i < comparison.ours.size(); ++i) {
      const Sample &builtin = comparison.builtin[i], &ours = comparison.ours[i];
      text += Format("%s,%s,%g,\"%s\",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", precision.c_str(),
                     Name(comparison).c_str(), comparison.rate, ours.name.c_str(), builtin.measured, ours.measured,
                     ours.theory, ours.scale, RelativeError(builtin), RelativeError(ours));
    }
  }
  return text;
}

}  // namespace dgd_physics
