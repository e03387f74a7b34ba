#include "apps/app.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dgd_apps {

void AddTo(Cases& cases, Cases more) {
  for (Case& it : more) cases.push_back(std::move(it));
}

double CombineValues(const Figure& figure, const Cases& cases, std::size_t index) {
  double total = 0, worst = 0;
  for (const Case& it : cases) {
    const double value = it.values.at(index);
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
    total += value;
    worst = std::max(worst, value);
  }
  switch (figure.combine) {
    case Combine::kMean:
      return cases.empty() ? 0 : total / double(cases.size());
    case Combine::kWorst:
      return worst;
    default:
      return total;
  }
}

}  // namespace dgd_apps
