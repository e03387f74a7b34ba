#include "sweep/study_report.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "report/comparison_table.h"
#include "report/csv_file.h"

namespace dgd_demos {
namespace {

// A cell of a CSV, quoted by RFC 4180 where it has to be.
std::string Quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

// The run's value at the path; empty where it is the world's own.
std::string ValueAt(const SceneChanges& changes, const std::string& path) {
  const auto change = std::ranges::find(changes, path, &SceneChanges::value_type::first);
  return change == changes.end() ? "" : change->second.dump();
}

// "tower_20.json, /time_step 0.004, Bullet in float": the world as the study names it, which no other one has.
std::string TitleOf(const RunSpec& run) {
  std::string title = run.world;
  for (const auto& [path, value] : run.changes) title += ", " + path + " " + value.dump();
  return title + ", Bullet in " + run.precision;
}

// The runs that share a table.
struct Group {
  std::string title;
  std::vector<TableColumn> columns;
  std::string remarks;
  std::size_t missing = 0;
};

TableColumn& ColumnOf(Group& group, const std::string& narrowphase) {
  const auto column = std::ranges::find(group.columns, narrowphase, &TableColumn::narrowphase);
  return column != group.columns.end() ? *column : group.columns.emplace_back(TableColumn{narrowphase, {}});
}

std::vector<Group> GroupsOf(const Study& study, const std::map<int, RunRecord>& records) {
  std::vector<Group> groups;
  std::map<std::string, std::size_t> by_title;
  for (const RunSpec& run : study.runs) {
    const auto [place, is_new] = by_title.emplace(TitleOf(run), groups.size());
    if (is_new) groups.push_back({place->first, {}, "", 0});
    Group& group = groups[place->second];
    TableColumn& column = ColumnOf(group, run.narrowphase);
    const auto record = records.find(run.number);
    if (record == records.end()) {
      ++group.missing;
      continue;
    }
    if (record->second.status != RunRecord::Status::kFailed) column.runs.push_back(record->second.figures);
    if (record->second.status != RunRecord::Status::kDone) {
      group.remarks += "run " + std::to_string(run.number) + ", seed " + std::to_string(run.seed) + ", " +
                       run.narrowphase + ": " + NameOf(record->second.status) + ": " + record->second.message + "\n";
    }
  }
  return groups;
}

// Names that do not fit over a column are explained in a line of their own.
std::string ShortenNames(std::vector<TableColumn>& columns) {
  constexpr std::size_t kLongest = 11;
  std::string legend;
  for (TableColumn& column : columns) {
    if (column.narrowphase.size() <= kLongest) continue;
    std::string mark = std::to_string(std::ranges::count(legend, '\n') + 1);
    mark.insert(0, 1, '[').push_back(']');
    legend += mark + " " + column.narrowphase + "\n";
    column.narrowphase = mark;
  }
  return legend;
}

std::string Plural(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace

std::string StudyCsv(const Study& study, const std::map<int, RunRecord>& records) {
  std::ostringstream csv;
  csv << "run,world";
  for (const std::string& path : study.varied) csv << ',' << Quoted(path);
  csv << ",seed,narrowphase,precision,build_type,status,message";
  for (const Figure& figure : Figures()) csv << ',' << figure.key;
  csv << '\n';
  for (const auto& [number, record] : records) {
    const RunSpec& run = study.runs.at(static_cast<std::size_t>(number));
    csv << number << ',' << Quoted(run.world);
    for (const std::string& path : study.varied) csv << ',' << Quoted(ValueAt(run.changes, path));
    csv << ',' << run.seed << ',' << Quoted(run.narrowphase) << ',' << run.precision << ',' << record.build_type << ','
        << NameOf(record.status) << ',' << Quoted(record.message);
    for (std::size_t i = 0; i < Figures().size(); ++i) {
      csv << ',';
      if (i < record.figures.size() && std::isfinite(record.figures[i])) csv << TextOf(record.figures[i]);
    }
    csv << '\n';
  }
  return csv.str();
}

std::string StudyTables(const Study& study, const std::map<int, RunRecord>& records) {
  std::string text;
  for (Group& group : GroupsOf(study, records)) {
    std::erase_if(group.columns, [](const TableColumn& column) { return column.runs.empty(); });
    std::size_t most = 0;
    for (const TableColumn& column : group.columns) most = std::max(most, column.runs.size());
    text += group.title;
    if (most == 1) text += ", one run";
    if (most > 1) text += ", median of " + Plural(most, "run");
    if (group.missing > 0) text += ", " + Plural(group.missing, "run") + " not done yet";
    text += "\n";
    const std::string legend = ShortenNames(group.columns);
    if (!group.columns.empty()) text += FormatTable(group.columns) + legend;
    text += group.remarks + "\n";
  }
  return text;
}

}  // namespace dgd_demos
