#include "audit_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "shape_type_name.h"

namespace dgd_preload {
namespace {

std::string NameOf(int type) {
  const char* name = dgd_bullet::ShapeTypeName(type);
  return name != nullptr ? name : std::to_string(type);
}

std::string Format(const char* format, double number) {
  char text[32];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}

std::string Short(double number) { return Format("%.2g", number); }
std::string Signed(double number) { return Format("%+.3g", number); }

}  // namespace

void Magnitudes::Add(double magnitude) {
  ++count_;
  const double place = (std::log10(magnitude) - kLowestDecade) * kBinsPerDecade;
  const double last = static_cast<double>(bins_.size()) - 1;
  const double bin =
      place > 0 ? std::min(std::ceil(place), last) : 0;  // The first one for 0, whose place is -infinity.
  ++bins_[static_cast<std::size_t>(bin)];
}

double Magnitudes::Percentile(double fraction) const {
  const double wanted = fraction * double(count_);
  std::uint64_t reached = bins_[0];
  std::size_t bin = 0;
  while (double(reached) < wanted && bin + 1 < bins_.size()) reached += bins_[++bin];
  return bin == 0 ? 0 : std::pow(10, kLowestDecade + double(bin) / kBinsPerDecade);
}

void AuditReport::OneSided::Add(double separation) {
  deepest = calls == 0 ? separation : std::min(deepest, separation);
  ++calls;
}

std::string AuditReport::PartOf(std::uint64_t calls, const Row& row) {
  return Format("%.3f %%", 100 * double(calls) / double(row.calls));
}

void AuditReport::Add(int type_0, int type_1, const Deepest& builtin, const Deepest& ours) {
  const std::lock_guard lock(mutex_);
  Row& row = rows_[std::minmax({type_0, type_1})];
  ++row.calls;
  if (builtin.is_contact && ours.is_contact) {
    ++row.both;
    const double difference = ours.separation - builtin.separation;
    row.differences.Add(std::abs(difference));
    if (std::abs(difference) > std::abs(row.worst)) row.worst = difference;
  } else if (builtin.is_contact) {
    row.builtin_only.Add(builtin.separation);
  } else if (ours.is_contact) {
    row.ours_only.Add(ours.separation);
  } else {
    ++row.neither;
  }
}

std::string AuditReport::TextOf(const std::pair<int, int>& types, const Row& row) {
  std::string text = NameOf(types.first) + " and " + NameOf(types.second) + ", " + std::to_string(row.calls) +
                     " calls; contact in neither: " + PartOf(row.neither, row) + '\n';
  const auto add_one_sided = [&](const char* name, const OneSided& side) {
    if (side.calls > 0) text += name + PartOf(side.calls, row) + ", deepest " + Signed(side.deepest) + '\n';
  };
  if (row.both > 0) {
    const Magnitudes& differences = row.differences;
    text += "  in both: " + PartOf(row.both, row) + ", which differ by up to " + Short(differences.Percentile(0.5)) +
            " (half of them), " + Short(differences.Percentile(0.9)) + " (90 %), " +
            Short(differences.Percentile(0.99)) + " (99 %); worst, ours less the built-in's, " + Signed(row.worst) +
            '\n';
  }
  add_one_sided("  in the built-in only: ", row.builtin_only);
  add_one_sided("  in ours only: ", row.ours_only);
  return text;
}

std::string AuditReport::ToText() const {
  const std::lock_guard lock(mutex_);
  std::string text;
  for (const auto& [types, row] : rows_) text += TextOf(types, row);
  return text;
}

}  // namespace dgd_preload
