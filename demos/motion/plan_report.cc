#include "motion/plan_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "motion/plane_cache.h"

namespace dgd_demos {
namespace {

// One figure of a run with a plan.
struct PlanFigure {
  const char* key;  // In the CSV file, in SI units.
  const char* title;
  double unit;  // Of what is printed, in SI units.
  int decimals;
  double (*value)(const PlanRun&);
};

double Count(std::int64_t count) { return static_cast<double>(count); }

// NaN if the path was not carried out.
template <class Figure>
double OfExecution(const PlanRun& run, const Figure& figure) {
  return run.execution ? double(figure(*run.execution)) : std::numeric_limits<double>::quiet_NaN();
}

constexpr std::array kFigures = {
    PlanFigure{"search_s", "search and simplification (ms)", 1e-3, 2, [](const PlanRun& r) { return r.search_time; }},
    PlanFigure{"recheck_s", "certified re-check (ms)", 1e-3, 0, [](const PlanRun& r) { return r.recheck_time; }},
    PlanFigure{"planning_s", "planning time, both (s)", 1, 3,
               [](const PlanRun& r) { return r.search_time + r.recheck_time; }},
    PlanFigure{"attempts", "paths searched for until one passed", 1, 0,
               [](const PlanRun& r) { return Count(r.attempts); }},
    PlanFigure{"states", "states checked", 1, 0, [](const PlanRun& r) { return Count(r.counts.states); }},
    PlanFigure{"pair_checks", "pair checks", 1, 0, [](const PlanRun& r) { return Count(r.counts.pairs); }},
    PlanFigure{"pair_checks_per_s", "pair checks, with kinematics (1e6/s)", 1e6, 2,
               [](const PlanRun& r) { return Count(r.counts.pairs) / r.check_time; }},
    PlanFigure{"share_by_cached_plane", "decided by a cached plane (%)", 0.01, 1,
               [](const PlanRun& r) { return Count(r.counts.pairs_by_plane) / Count(r.counts.pairs); }},
    PlanFigure{"length_found_rad", "path length as found (rad)", 1, 3,
               [](const PlanRun& r) { return Length(r.found); }},
    PlanFigure{"length_before_rad", "path length before smoothing (rad)", 1, 3,
               [](const PlanRun& r) { return Length(r.simplified); }},
    PlanFigure{"length_after_rad", "path length after smoothing (rad)", 1, 3,
               [](const PlanRun& r) { return Length(r.smoothed); }},
    PlanFigure{"length_ratio", "after / before", 1, 3,
               [](const PlanRun& r) { return Length(r.smoothed) / Length(r.simplified); }},
    PlanFigure{"signed_distance_before_m", "clearance before smoothing (mm)", 1e-3, 2,
               [](const PlanRun& r) { return r.before.signed_distance.value; }},
    PlanFigure{"signed_distance_after_m", "clearance after smoothing (mm)", 1e-3, 2,
               [](const PlanRun& r) { return r.after.signed_distance.value; }},
    PlanFigure{"signed_distance_ratio", "after / before", 1, 2,
               [](const PlanRun& r) { return r.after.signed_distance.value / r.before.signed_distance.value; }},
    PlanFigure{"growth_distance_before", "least growth distance before smoothing", 1, 4,
               [](const PlanRun& r) { return r.before.growth_distance.value; }},
    PlanFigure{"growth_distance_after", "least growth distance after smoothing", 1, 4,
               [](const PlanRun& r) { return r.after.growth_distance.value; }},
    PlanFigure{"smoothing_s", "smoothing and its re-check (ms)", 1e-3, 0,
               [](const PlanRun& r) { return r.smoothing_time; }},
    PlanFigure{"rechecked_states", "states with certificates, final path", 1, 0,
               [](const PlanRun& r) { return Count(r.rechecked_states); }},
    PlanFigure{"execution_s", "duration of the execution (s)", 1, 2,
               [](const PlanRun& r) { return OfExecution(r, [](const auto& e) { return e.duration; }); }},
    PlanFigure{"tracking_error_m", "flange's tracking error, greatest (um)", 1e-6, 3,
               [](const PlanRun& r) { return OfExecution(r, [](const auto& e) { return e.greatest_error; }); }},
    PlanFigure{"rms_tracking_error_m", "flange's tracking error, rms (um)", 1e-6, 3,
               [](const PlanRun& r) { return OfExecution(r, [](const auto& e) { return e.rms_error; }); }},
    PlanFigure{
        "velocity_share", "of a joint's velocity limit, at most (%)", 0.01, 1,
        [](const PlanRun& r) { return OfExecution(r, [](const auto& e) { return e.greatest_velocity_share; }); }},
    PlanFigure{"effort_share", "of a joint's effort limit, at most (%)", 0.01, 1,
               [](const PlanRun& r) { return OfExecution(r, [](const auto& e) { return e.greatest_effort_share; }); }},
    PlanFigure{
        "contacts", "contacts during the execution", 1, 0,
        [](const PlanRun& r) { return OfExecution(r, [](const auto& e) { return double(e.contacts.size()); }); }},
};

std::string Line(const std::string& title, const std::vector<std::string>& values) {
  constexpr std::size_t kTitleWidth = 43, kValueWidth = 15;
  std::string line = title + std::string(kTitleWidth - std::min(kTitleWidth, title.size()), ' ');
  for (const std::string& value : values) {
    line += std::string(kValueWidth - std::min(kValueWidth, value.size()), ' ') + value;
  }
  return line + '\n';
}

std::string Format(double value, int decimals) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string Place(const CollisionModel& model, const LeastDistance& least) {
  return model.NameOf(model.pairs()[least.pair]) + ", " + Format(least.place, 2) + " rad from the start";
}

}  // namespace

std::string FormatRuns(const std::vector<PlanRun>& runs) {
  std::vector<const PlanRun*> planned;
  for (const PlanRun& run : runs) {
    if (!run.failure) planned.push_back(&run);
  }
  std::string table = Line("plans", {std::to_string(planned.size()) + " of " + std::to_string(runs.size())});
  if (planned.empty()) return table;
  const bool is_single = runs.size() == 1;
  if (!is_single) table += Line("", {"median", "least", "greatest"});
  for (const PlanFigure& figure : kFigures) {
    std::vector<double> values;
    for (const PlanRun* run : planned) values.push_back(figure.value(*run) / figure.unit);
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    std::vector<std::string> texts = {Format(median, figure.decimals)};
    if (!is_single) {
      texts.push_back(Format(values.front(), figure.decimals));
      texts.push_back(Format(values.back(), figure.decimals));
    }
    table += Line(figure.title, texts);
  }
  return table;
}

std::string FormatPlaces(const CollisionModel& model, const PlanRun& run) {
  if (model.pairs().empty()) return "no pair of bodies can meet: nothing was checked\n";
  return "clearance before: " + Place(model, run.before.signed_distance) +
         "\nclearance after: " + Place(model, run.after.signed_distance) +
         "\nleast growth distance before: " + Place(model, run.before.growth_distance) +
         "\nleast growth distance after: " + Place(model, run.after.growth_distance) + "\n";
}

std::string FormatContacts(const ExecutionResult& execution) {
  std::string text;
  for (const ExecutionContact& contact : execution.contacts) {
    text += "contact: " + contact.first + " and " + contact.second + ", " + Format(contact.begin, 2) + " to " +
            Format(contact.end, 2) + " s, least distance " + Format(1e3 * contact.least_distance, 2) + " mm, up to " +
            Format(contact.greatest_force, 1) + " N\n";
  }
  return text;
}

std::string FormatComparison(const std::vector<CheckTimes>& times) {
  std::string table = Line("checks of the states that planning visited",
                           {"ns a pair", "1e6 pairs/s", "cold / this", "cached / this", "differing", "beyond band"});
  const double cold = times[1].seconds, cached = times[2].seconds;
  for (const CheckTimes& row : times) {
    const double pairs = Count(row.pairs);
    table += Line(row.name, {Format(1e9 * row.seconds / pairs, 1), Format(pairs / row.seconds / 1e6, 2),
                             Format(cold / row.seconds, 3), Format(cached / row.seconds, 3),
                             std::to_string(row.differing), std::to_string(row.beyond_band)});
  }
  std::array<char, 128> note;
  std::snprintf(note.data(), note.size(), "%lld pairs; band around touching: %g m\n",
                static_cast<long long>(times[0].pairs), kTouchingBand);
  return table + note.data();
}

RunsCsv::RunsCsv(const std::filesystem::path& file) : csv_(file) {
  csv_ << "seed,has_plan";
  for (const PlanFigure& figure : kFigures) csv_ << ',' << figure.key;
  csv_ << '\n';
  csv_.Flush();
}

void RunsCsv::Write(const PlanRun& run) {
  csv_ << run.seed << ',' << (run.failure ? 0 : 1);
  for (const PlanFigure& figure : kFigures) {
    csv_ << ',';
    if (!run.failure) csv_ << figure.value(run);
  }
  csv_ << '\n';
  csv_.Flush();
}

void WritePathCsv(const std::filesystem::path& file, const CollisionModel& model, const JointPath& path) {
  CsvFile csv(file);
  csv << "place_rad";
  for (const Joint& joint : model.arm().joints) csv << ',' << joint.name << "_rad";
  csv << ",flange_x_m,flange_y_m,flange_z_m,clearance_m\n";
  double place = 0;
  PlaneCache planes(model);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) place += (path[i] - path[i - 1]).norm();
    csv << place;
    for (const double angle : path[i]) csv << ',' << angle;
    const Eigen::Vector3d flange = FlangePose(model.arm(), path[i]).position;
    csv << ',' << flange.x() << ',' << flange.y() << ',' << flange.z() << ','
        << LeastSignedDistance(model, {path[i]}, 1, planes) << '\n';
  }
  csv.Flush();
}

}  // namespace dgd_demos
