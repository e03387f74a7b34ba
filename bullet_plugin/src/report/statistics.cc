#include "dgd_bullet/statistics.h"

#include <locale>
#include <sstream>

#include "shape_type_name.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

std::string NameOf(int type) {
  const char* name = ShapeTypeName(type);
  return name != nullptr ? name : std::to_string(type);
}

void WriteFallbacks(const FallbackCounts& counts, std::ostream& json) {
  json << "\"fallbacks_not_converged\": " << counts.fallbacks_not_converged
       << ", \"fallbacks_no_interior\": " << counts.fallbacks_no_interior
       << ", \"fallbacks_invalid\": " << counts.fallbacks_invalid
       << ", \"fallbacks_no_memory\": " << counts.fallbacks_no_memory;
}

template <class Numbers>
void WriteList(const Numbers& numbers, std::ostream& json) {
  const char* separator = "[";
  for (const auto number : numbers) {
    json << separator << number;
    separator = ", ";
  }
  json << ']';
}

void Write(const PairStatistics& pair, std::ostream& json) {
  json << "{\"type_0\": \"" << NameOf(pair.type_0) << "\", \"type_1\": \"" << NameOf(pair.type_1)
       << "\", \"calls\": " << pair.calls << ", \"separated\": " << pair.separated << ", \"resting\": " << pair.resting
       << ", \"solved\": " << pair.solved << ", \"deep\": " << pair.deep << ", ";
  WriteFallbacks(pair, json);
  json << ", \"iterations\": ";
  WriteList(pair.iterations, json);
  json << ", \"worst_gap\": " << pair.worst_gap << ", \"patch_sizes\": ";
  WriteList(pair.patch_sizes, json);
  json << '}';
}

}  // namespace

std::string ToJson(const Statistics& statistics) {
  std::ostringstream json;
  json.imbue(std::locale::classic());
  json << '{';
  WriteFallbacks(statistics, json);
  json << ", \"pairs\": [";
  const char* separator = "\n  ";
  for (const PairStatistics& pair : statistics.pairs) {
    json << separator;
    Write(pair, json);
    separator = ",\n  ";
  }
  json << "]}\n";
  return json.str();
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
