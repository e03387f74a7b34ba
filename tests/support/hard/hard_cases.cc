#include <array>
#include <string_view>

#include "support/hard/draw.h"

namespace dgd_test {
namespace {

constexpr std::array kClasses = {
    HardClass{"needles-and-sheets", "skew up to 1e4: the facets of the difference are slivers",
              hard::DrawNeedlesAndSheets, 0, 1, 0.97},
    HardClass{"size-ratios", "up to 1e6 to one: the small one is the rounding of the large one", hard::DrawSizeRatios,
              0, 1, 0.97},
    HardClass{"micrometres", "absolute tolerances are larger than the sets", hard::DrawMicrometres, 0, 1, 0.97},
    HardClass{"kilometres", "absolute tolerances are below rounding", hard::DrawKilometres},
    HardClass{"far-away", "1e3 to 1e6 m from the origin: coordinates have few digits left", hard::DrawFarFromTheOrigin},
    HardClass{"nearly-coincident", "the ray between the centres is short, down to 1e-20 m", hard::DrawNearlyCoincident},
    HardClass{"coincident", "there is no ray", hard::DrawCoincident},
    HardClass{"identical", "the same set in the same pose", hard::DrawIdentical},
    HardClass{"deep-inside", "a small set near the centre of a large one", hard::DrawDeepInside},
    HardClass{"margins", "radii of zero, and from 1e-12 to 1e4 of the cores", hard::DrawMargins, 0, 1, 0.95},
    HardClass{"touching-features", "vertex, edge and face on vertex, edge and face: zero distance, many normals",
              hard::DrawTouchingFeatures},
    HardClass{"sliding-faces", "parallel faces, shifted: no vertex is the farthest", hard::DrawSlidingFaces},
    HardClass{"parallel-edges", "edges that cross at 1e-14 to 0.1 rad: their cross product is rounding",
              hard::DrawNearlyParallelEdges},
    HardClass{"flat-solid", "one set has no interior", hard::DrawFlatAgainstSolid},
    HardClass{"flat-flat", "neither has one, but for a radius down to 1e-6 m, or none; some in one plane",
              hard::DrawFlatAgainstFlat, 0, 0.8, 0.75},
    HardClass{"thin-triangles", "corners that coincide or are collinear, or all but", hard::DrawThinTriangles},
    HardClass{"degenerate-hulls", "coplanar, duplicate and nearly collinear points, all but flat hulls",
              hard::DrawDegenerateHulls, 0, 0.97, 0.97},
    HardClass{"cone-tips", "apex or side in touch: a kink, and a line of farthest points", hard::DrawConeTips},
    HardClass{"rims", "rim, cap or side of cylinders and frusta in touch", hard::DrawRims},
    HardClass{"rough-rotations", "rotation matrices 1e-6 off orthonormal", hard::DrawRoughRotations, 1e-5},
    HardClass{"subnormal-offsets", "coordinates whose products vanish", hard::DrawSubnormalOffsets},
    HardClass{"subnormal-sizes", "lengths whose squares vanish", hard::DrawSubnormalSizes, 0, 0.45, 0},
    HardClass{"in-the-plane", "2D: skew up to 1e4, size ratios up to 1e6", hard::DrawInThePlane, 0, 1, 0.97},
    HardClass{"known-failures", "what other engines' public issues report", hard::DrawKnownFailures},
};

}  // namespace

std::span<const HardClass> AllHardClasses() { return kClasses; }

HardCase MakeHardCase(const HardClass& hard_class, std::uint64_t seed, int index) {
  // FNV-1a: std::hash is the library's own.
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char letter : std::string_view(hard_class.name)) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  }
  Random random(hash + 0x9e3779b97f4a7c15U * (seed + 1) + static_cast<std::uint64_t>(index) * 0xbf58476d1ce4e5b9U);
  return hard_class.draw(random, index);
}

}  // namespace dgd_test
