#include "run/render_options.h"

#include <charconv>
#include <iostream>
#include <string>

#include "command_line.h"
#include "run/run_options.h"
#include "scene_options.h"

namespace dgd_demos {
namespace {

constexpr const char* kDescription =
    R"(Draws pictures of a trajectory that `headless_sim run WORLD --trajectory` has written, or the frames of a film. Shapes
are those of WORLD, poses those of the trajectory. All pictures are seen from the same place.)";

constexpr const char* kFooter = R"(
Examples:
  headless_sim run tower_20 --trajectory --sample-every 0.04
  headless_sim render tower_20 out/dgd_trajectory.npy                       at the scene's times
  headless_sim render tower_20 out/dgd_trajectory.npy --times 0,12.5,60     at others
  headless_sim render my_app.bullet out/dgd_trajectory.npy --size 1920x1080
  headless_sim render tower_20 out/dgd_trajectory.npy --every 0.04 --out frames    a film in real time:
  ffmpeg -framerate 25 -i frames/frame_%05d.png -pix_fmt yuv420p film.mp4

Bodies are blue where they are still and red where they are fast. Static bodies of world files are grey; up is opposite
gravity there, and z in scenes.

Written into DIR:
  t00.50s.png, ...              one for each time, named after the sample that is nearest to it
  frame_00000.png, ...          with --every; those of an earlier film with more are not removed
  render.json                   what the pictures are of. Those of another trajectory in DIR are refused, or removed
                                with --overwrite, and always in the folder "pictures", unless you name it

Exit status: 0 all is drawn; 2 wrong command line, world or trajectory, such as one of another world, or of another
seed; or a picture cannot be written.)";

constexpr const char* kPicturesFolder = "pictures";

constexpr Limits<double> kTimes = {0, 1e9};  // s
constexpr Limits<int> kPixels = {64, 4096};  // For width and height.

// "1280x720".
bool ParseSize(const std::string& text, RenderOptions& options) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return false;
  const auto height = std::from_chars(width.ptr + 1, end, options.height);
  const auto is_allowed = [](int pixels) { return pixels >= kPixels.least && pixels <= kPixels.most; };
  return height.ec == std::errc() && height.ptr == end && is_allowed(options.width) && is_allowed(options.height);
}

// A sentence about options that do not go together, or have a value that they cannot have; empty if there is none.
std::string Complaint(const std::string& size, RenderOptions& options) {
  if (!ParseSize(size, options)) {
    return "--size: must be WIDTHxHEIGHT, as 1280x720, each from " + std::to_string(kPixels.least) + " to " +
           std::to_string(kPixels.most) + " pixels, not " + size;
  }
  if (!options.every) return "";
  if (!options.times.empty()) return "--times and --every: give one of them";
  if (*options.every <= 0) {
    return "--every: must be above 0 s";
  }
  return "";
}

}  // namespace

std::variant<RenderOptions, ExitStatus> ParseRenderOptions(int argc, const char* const* argv) {
  RenderOptions options;
  std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
  CommandLine line("headless_sim render", kDescription, kFooter);
  line.AddArgument("world", "WORLD", options.world,
                   "What was run: scene (.json or the name of one), or Bullet's world file");
  line.AddArgument("trajectory", "TRAJECTORY", options.trajectory, "What the run has left of it (.npy)");
  line.AddNumbers("--times", "LIST", options.times, kTimes,
                  "Times of the pictures in s. Default: the scene's; of a world file begin,\nmiddle and end");
  line.AddNumber("--every", "S", options.every, kAnyNumber, "Frames of a film, one each S seconds of the simulation");
  AddOutOption(line, options.out, options.overwrite, kPicturesFolder);
  line.AddText("--size", "WxH", size, "Width and height of the pictures in pixels");
  line.AddSeed(options.seed, "Seed of the random bodies, as in the run");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  if (const std::string complaint = Complaint(size, options); !complaint.empty()) {
    std::cerr << complaint << '\n';
    return kBadInput;
  }
  CompleteOut(options.out, options.overwrite, kPicturesFolder);
  options.world = WorldFileNamed(options.world);
  return options;
}

}  // namespace dgd_demos
