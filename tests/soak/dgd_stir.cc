// dgd_stir: a heap that is stirred while its bodies come and go, for as long as one likes. See --help.
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <variant>
#include <vector>

#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"
#include "soak/stirred_heap.h"

namespace dgd_soak {
namespace {

constexpr const char* kDescription =
    R"(Stirs a heap of bodies of all convex types with a paddle; ten times a second one of them is removed, its shape freed,
and another falls in. Memory and manifolds in use must not grow, and nothing may be anything but finite.)";

constexpr const char* kFooter = R"(
The run is told in ten parts: bytes in use on the heap, manifolds in use and contacts, the mean over each part.

Exit status: 0; 1 something grew, or was not finite, or a body left the pit; 2 wrong command line.)";

enum ExitStatus { kSuccess = 0, kFailed = 1, kBadInput = 2 };

struct Options {
  double minutes = 30;
  int bodies = 200;
  std::uint64_t seed = 1;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  Options options;
  dgd_demos::CommandLine line("dgd_stir", kDescription, kFooter);
  line.AddNumber("--minutes", "M", options.minutes, {0.05, 1e5}, "Simulated minutes");
  line.AddNumber("--bodies", "N", options.bodies, {1, 1000}, "In the pit at a time");
  line.AddSeed(options.seed, "Of the bodies that come and go");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

/// What a part of the run came to.
struct Part {
  double bytes = 0, manifolds = 0, contacts = 0;  ///< Sums over the steps.
  int most_escaped = 0;
  long steps = 0;

  double Mean(double sum) const { return sum / double(std::max(steps, 1L)); }
};
constexpr std::size_t kParts = 10;
using Parts = std::array<Part, kParts>;

void Take(StirredHeap& heap, Part& part) {
  ++part.steps;
  part.bytes += double(mallinfo2().uordblks);
  part.manifolds += heap.Manifolds();
  part.most_escaped = std::max(part.most_escaped, heap.Escaped());
  part.contacts += heap.Contacts();
}

/// The last half against the first, which has the heap's settling in it. The first part, of a heap in the air, is left
/// out. Some percent are chance: of each half, the highest of four or five means counts.
template <class Figure>
bool Grew(const Parts& parts, Figure&& figure) {
  constexpr double kChance = 1.1;
  constexpr std::size_t kMiddle = kParts / 2;
  double before = 0, after = 0;
  for (std::size_t i = 1; i < kParts; ++i) {
    double& most = i < kMiddle ? before : after;
    most = std::max(most, parts[i].Mean(figure(parts[i])));
  }
  return after > kChance * before;
}

ExitStatus Judge(const Options& options, const StirredHeap& heap, const Parts& parts, bool is_finite) {
  std::printf("%d bodies, %.4g simulated minutes, %d replaced, seed %llu\n", options.bodies, options.minutes,
              heap.Replaced(), static_cast<unsigned long long>(options.seed));
  std::printf("part   heap in use, MB   manifolds   contacts   out of the pit\n");
  for (std::size_t i = 0; i < kParts; ++i) {
    const Part& part = parts[i];
    std::printf("%4zu %17.3f %11.1f %10.0f %16d\n", i + 1, part.Mean(part.bytes) / 1e6, part.Mean(part.manifolds),
                part.Mean(part.contacts), part.most_escaped);
  }
  const dgd_bullet::Statistics counts = heap.statistics();
  std::printf("fallbacks: %llu not converged, %llu without interior, %llu invalid, %llu without memory\n",
              static_cast<unsigned long long>(counts.fallbacks_not_converged),
              static_cast<unsigned long long>(counts.fallbacks_no_interior),
              static_cast<unsigned long long>(counts.fallbacks_invalid),
              static_cast<unsigned long long>(counts.fallbacks_no_memory));
  const bool is_flat = !Grew(parts, [](const Part& part) { return part.bytes; }) &&
                       !Grew(parts, [](const Part& part) { return part.manifolds; });
  const bool is_kept = std::ranges::all_of(parts, [](const Part& part) { return part.most_escaped == 0; });
  std::printf("%s; %s; %s\n", is_finite ? "all finite" : "NOT FINITE", is_flat ? "nothing grew" : "GREW",
              is_kept ? "no body left the pit" : "A BODY LEFT THE PIT");
  return is_finite && is_flat && is_kept ? kSuccess : kFailed;
}

ExitStatus Run(const Options& options) {
  StirredHeap heap(options.bodies, options.seed);
  const long steps = std::max(1L, std::lround(60 * options.minutes / StirredHeap::kTimeStep));
  dgd_demos::ProgressBar progress("stirring", double(steps));
  Parts parts{};
  bool is_finite = true;
  for (long step = 0; step < steps && is_finite; ++step) {
    heap.Step();
    is_finite = heap.IsFinite();
    Take(heap, parts[static_cast<std::size_t>(step) * kParts / static_cast<std::size_t>(steps)]);
    progress.Update(double(step + 1));
  }
  return Judge(options, heap, parts, is_finite);
}

}  // namespace
}  // namespace dgd_soak

int main(int argc, char** argv) { return dgd_demos::RunProgram(dgd_soak::ParseCommandLine(argc, argv), dgd_soak::Run); }
