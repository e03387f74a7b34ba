#include "apps/report_options.h"

#include <optional>

#include "apps/apps.h"
#include "command_line.h"

namespace dgd_apps {
namespace {

constexpr const char* kDescription =
    R"(Runs small programs as users of Bullet write them, on the built-in narrowphase and on the plugin, and prints what
such a program sees of either. apps_report runs Bullet in float, apps_report_float64 in double.)";

constexpr const char* kFooter = R"(
Examples:
  apps_report                                all apps at 60, 240 and 1000 Hz: minutes
  apps_report --quick                        some cases of each, as the tests run them: a minute
  apps_report --apps events,rolling --cases  two apps, with each case's figures
  apps_report --quick --bands                also says how much worse ours may be, and why
  apps_report_float64 --rates 240 --csv f.csv  one rate, Bullet in double; every case to a file

Figures:  of all, less is better and 0 is best: what is lost, missed, late, too deep, or moves though it
          should not. A figure is the mean, the worst or the total over the cases of its app.
Verdict:  ours fails above the built-in's value * (1 + band) + floor; --bands lists both.

Exit status: 0 no figure fails; 1 some do, which are listed; 2 wrong command line, or the file cannot be
written.

Apps:
)";

constexpr double kMaxRate = 100'000;  // Hz

std::string AppsInWords() {
  constexpr std::size_t kColumn = 16;
  std::string text;
  for (const App& app : Apps()) {
    std::string name(app.name);
    name.resize(kColumn, ' ');
    text += "  " + name + std::string(app.summary) + "\n";
  }
  return text;
}

}  // namespace

std::variant<ReportOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  ReportOptions options;
  std::vector<std::string> names;
  for (const App& app : Apps()) names.emplace_back(app.name);
  dgd_demos::CommandLine line("apps_report", kDescription, kFooter + AppsInWords());
  line.AddChoices("--apps", "A,B", options.apps, names, "Some of the apps below; default: all");
  line.AddNumbers("--rates", "HZ", options.rates, {1, kMaxRate}, "Steps per second");
  line.AddFlag("--quick", options.is_quick, "Only some cases of each app");
  line.AddFlag("--cases", options.lists_cases, "Also prints each case");
  line.AddFlag("--bands", options.lists_bands, "Also prints by how much ours may be worse, and why");
  line.AddPath("--csv", "FILE", options.csv, "File for one row per case and figure");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

}  // namespace dgd_apps
