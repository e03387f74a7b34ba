#include "world_file/world_bytes.h"

#include <stdexcept>
#include <type_traits>

#include "scene/scene_error.h"
#include "simulation/narrowphase.h"
#include "world_file/imported_world.h"

namespace dgd_test {
namespace {

constexpr std::size_t kChunkHeader = 24;

}  // namespace

WorldBytes::WorldBytes(BulletWorld& world)
    : bytes_(world.Serialize()), file_(dgd_demos::ParseBulletFile("world", bytes_)) {}

std::size_t WorldBytes::DnaPosition() const {
  const dgd_demos::FileChunk& last = file_.chunks.back();
  return last.position + kChunkHeader + last.data.size();
}

std::size_t WorldBytes::Chunk(std::string_view code, std::string_view structure, int number) const {
  for (const dgd_demos::FileChunk& chunk : file_.chunks) {
    const bool is_of = structure.empty() || (chunk.structure >= 0 &&
                                             file_.dna.At(static_cast<std::size_t>(chunk.structure)).name == structure);
    if (chunk.code == code && is_of && number-- == 0) return chunk.position;
  }
  throw std::invalid_argument(std::string(code));
}

const dgd_demos::FileChunk& WorldBytes::At(std::size_t position) const {
  for (const dgd_demos::FileChunk& chunk : file_.chunks) {
    if (chunk.position == position) return chunk;
  }
  throw std::invalid_argument("no chunk begins there");
}

std::uint64_t WorldBytes::PointerOf(std::size_t chunk) const { return At(chunk).pointer; }

std::size_t WorldBytes::FieldPosition(std::size_t position, std::string_view path, std::size_t element) const {
  const dgd_demos::FileChunk& chunk = At(position);
  const auto& structure = file_.dna.At(static_cast<std::size_t>(chunk.structure));
  return position + kChunkHeader + element * structure.size + file_.dna.Locate(structure, path).offset;
}

std::optional<std::string> WorldBytes::Error() const {
  try {
    dgd_demos::ImportedWorld(dgd_demos::LoadWorldBytes("world", bytes_), dgd_demos::Narrowphase::kDgd);
    return std::nullopt;
  } catch (const dgd_demos::SceneError& error) {
    return error.what();
  }
}

std::string PrecisionWord() { return std::is_same_v<btScalar, double> ? "Double" : "Float"; }

}  // namespace dgd_test
