#include "report/run_csv.h"

#include <cmath>

#include "report/figures.h"

namespace dgd_demos {

RunCsv::RunCsv(const std::filesystem::path& file) : csv_(file) {
  csv_.stream() << "scene,seed,narrowphase,precision,build_type";
  for (const Figure& figure : Figures()) csv_.stream() << ',' << figure.key;
  csv_.stream() << '\n';
  csv_.Flush();
}

void RunCsv::Write(const RunInfo& info, const RunSummary& summary) {
  std::ostream& stream = csv_.stream();
  stream << info.scene << ',' << info.seed << ',' << info.narrowphase << ',' << info.precision << ','
         << info.build_type;
  for (const Figure& figure : Figures()) {
    stream << ',';
    const double value = figure.of(summary);
    if (std::isfinite(value)) stream << value;
  }
  stream << '\n';
  csv_.Flush();
}

}  // namespace dgd_demos
