#include "dgd_bullet/statistics.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <locale>
#include <sstream>

namespace dgd_bullet {
namespace {

std::string NameOf(int type) {
  switch (type) {
    case BOX_SHAPE_PROXYTYPE:
      return "BOX";
    case TRIANGLE_SHAPE_PROXYTYPE:
      return "TRIANGLE";
    case TETRAHEDRAL_SHAPE_PROXYTYPE:
      return "TETRAHEDRAL";
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
      return "CONVEX_TRIANGLEMESH";
    case CONVEX_HULL_SHAPE_PROXYTYPE:
      return "CONVEX_HULL";
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
      return "CONVEX_POINT_CLOUD";
    case CUSTOM_POLYHEDRAL_SHAPE_TYPE:
      return "CUSTOM_POLYHEDRAL";
    case SPHERE_SHAPE_PROXYTYPE:
      return "SPHERE";
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      return "MULTI_SPHERE";
    case CAPSULE_SHAPE_PROXYTYPE:
      return "CAPSULE";
    case CONE_SHAPE_PROXYTYPE:
      return "CONE";
    case CONVEX_SHAPE_PROXYTYPE:
      return "CONVEX";
    case CYLINDER_SHAPE_PROXYTYPE:
      return "CYLINDER";
    case UNIFORM_SCALING_SHAPE_PROXYTYPE:
      return "UNIFORM_SCALING";
    case MINKOWSKI_SUM_SHAPE_PROXYTYPE:
      return "MINKOWSKI_SUM";
    case MINKOWSKI_DIFFERENCE_SHAPE_PROXYTYPE:
      return "MINKOWSKI_DIFFERENCE";
    case CUSTOM_CONVEX_SHAPE_TYPE:
      return "CUSTOM_CONVEX";
    default:
      return std::to_string(type);
  }
}

void WriteFallbacks(const FallbackCounts& counts, std::ostream& json) {
  json << "\"fallbacks_not_converged\": " << counts.fallbacks_not_converged
       << ", \"fallbacks_no_interior\": " << counts.fallbacks_no_interior
       << ", \"fallbacks_invalid\": " << counts.fallbacks_invalid;
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
       << ", \"followed\": " << pair.followed << ", \"solved\": " << pair.solved << ", ";
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

}  // namespace dgd_bullet
