// A .bullet file that was damaged: a world that steps, or a SceneError that says what is wrong.
//
// Such files end with 14 kB of DNA, and are hit at random by nothing. So an input is a world of Bullet's own and a list
// of changes to its file: to a number in a chunk, a pointer to another chunk, a chunk that is gone or twice, a byte of
// the DNA, the end of the file. Or it is the file's chunks themselves, between a header and Bullet's DNA.
#include <LinearMath/btSerializer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.h"
#include "fuzz/fuzz_target.h"
#include "scene/scene_error.h"
#include "world_file/bullet_file.h"
#include "world_file/bullet_worlds.h"
#include "world_file/imported_world.h"

namespace dgd_fuzz {
namespace {

using File = std::vector<std::byte>;

constexpr std::size_t kFileHeader = 12, kChunkHeader = 24;
constexpr int kMostChanges = 40;
constexpr int kSteps = 3;

const std::vector<File>& WrittenWorlds() {
  static const std::vector<File> files = [] {
    std::vector<File> made = {dgd_test::MakeFallingSphere()->Serialize()};
    for (const dgd_test::WorldCase& world : dgd_test::AllWorldCases()) made.push_back(world.make()->Serialize());
    return made;
  }();
  return files;
}

/// A file in pieces: what can be changed without losing the places of the rest.
struct Pieces {
  File header;
  std::vector<File> chunks;  ///< With their headers; the DNA's is the last.
};

Pieces TakeApart(const File& file) {
  Pieces pieces;
  pieces.header.assign(file.begin(), file.begin() + kFileHeader);
  for (std::size_t begin = kFileHeader; begin < file.size();) {
    std::int32_t length = 0;
    std::memcpy(&length, file.data() + begin + 4, sizeof(length));
    const auto first = file.begin() + static_cast<std::ptrdiff_t>(begin);
    pieces.chunks.emplace_back(first, first + static_cast<std::ptrdiff_t>(kChunkHeader) + length);
    begin += pieces.chunks.back().size();
  }
  return pieces;
}

File PutTogether(const Pieces& pieces) {
  File file = pieces.header;
  for (const File& chunk : pieces.chunks) file.insert(file.end(), chunk.begin(), chunk.end());
  return file;
}

template <class T>
void Write(File& file, std::size_t position, T value) {
  if (position + sizeof(T) <= file.size()) std::memcpy(file.data() + position, &value, sizeof(T));
}

// What is too large for a float is infinite in one.
float ToFloat(double number) {
  constexpr double kGreatest = std::numeric_limits<float>::max();
  return std::abs(number) <= kGreatest || std::isnan(number)
             ? static_cast<float>(number)
             : std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(number > 0 ? 1 : -1));
}

void Change(FuzzInput& input, Pieces& pieces) {
  const int kind = input.Below(8);
  const auto chosen = input.Bits<std::uint16_t>();
  const auto place = input.Bits<std::uint16_t>();
  const double number = input.Number();
  File& chunk = pieces.chunks[chosen % pieces.chunks.size()];
  // Most numbers begin at a multiple of four.
  const std::size_t position = place % chunk.size() / 4 * 4;
  switch (kind) {
    case 0:
      Write(chunk, position, ToFloat(number));
      break;
    case 1:
      Write(chunk, position, std::isnan(number) ? -1 : static_cast<std::int32_t>(std::clamp(number, -2e9, 2e9)));
      break;
    case 2:
      Write(chunk, position, number);
      break;
    case 3: {  // A pointer to another chunk.
      const File& target = pieces.chunks[static_cast<std::size_t>(place >> 8) % pieces.chunks.size()];
      std::array<std::byte, 8> pointer;
      std::memcpy(pointer.data(), target.data() + 8, pointer.size());
      Write(chunk, kChunkHeader + static_cast<std::size_t>(place & 0xff) * 8, pointer);
      break;
    }
    case 4:
      if (pieces.chunks.size() > 1) pieces.chunks.erase(pieces.chunks.begin() + chosen % std::ssize(pieces.chunks));
      break;
    case 5:
      pieces.chunks.insert(pieces.chunks.begin() + place % std::ssize(pieces.chunks), File(chunk));
      break;
    case 6: {  // Of the DNA.
      File& dna = pieces.chunks.back();
      dna[(static_cast<std::size_t>(place) << 1) % dna.size()] ^= static_cast<std::byte>(chosen);
      break;
    }
    default:
      chunk[place % chunk.size()] ^= static_cast<std::byte>(1 << (chosen >> 13));
      break;
  }
}

File ReadFile(FuzzInput& input, const std::uint8_t* data, std::size_t size) {
  const std::vector<File>& worlds = WrittenWorlds();
  const int number = input.Below(static_cast<int>(worlds.size()) + 1);
  if (number == static_cast<int>(worlds.size())) {
    Pieces pieces = TakeApart(worlds.front());
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    pieces.chunks = {File(bytes + std::min<std::size_t>(1, size), bytes + size), pieces.chunks.back()};
    return PutTogether(pieces);
  }
  Pieces pieces = TakeApart(worlds[static_cast<std::size_t>(number)]);
  for (int i = 0; i < kMostChanges && !input.IsOver(); ++i) Change(input, pieces);
  return PutTogether(pieces);
}

}  // namespace
}  // namespace dgd_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dgd_fuzz;
  FuzzInput input({data, size});
  try {
    dgd_demos::CheckedWorld checked = dgd_demos::LoadWorldBytes("world", ReadFile(input, data, size));
    const std::size_t bodies = checked.bodies.size() + checked.objects.size() + checked.colliders.size();
    dgd_demos::ImportedWorld world(std::move(checked), dgd_demos::Narrowphase::kDgd);
    if (world.Bodies().size() != bodies) Fail("a world with other bodies than its file has");
    for (int step = 0; step < kSteps && !world.FindLostBody(world.Motions()); ++step) world.Step();
    world.TotalEnergy();
    world.OverlappingPairs();
  } catch (const dgd_demos::SceneError& error) {
    if (!std::string(error.what()).starts_with("world: ")) Fail(error.what());
  }
  return 0;
}
