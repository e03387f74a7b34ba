#include "world_file/record.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <sstream>
#include <utility>

#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

// Squares of such numbers, and sums of them, are finite in single precision.
constexpr double kGreatest = 1e15;
// Tolerance of a rotation's entries and of a quaternion's length; bodies drift by a hundredth of it in float.
constexpr double kRotationTolerance = 1e-2;

bool IsWithin(double number, Limit limit) {
  switch (limit) {
    case Limit::kNumber:
      return !std::isnan(number);
    case Limit::kFinite:
      return std::abs(number) <= kGreatest;
    case Limit::kNotNegative:
      return number >= 0 && number <= kGreatest;
    case Limit::kPositive:
      return number > 0 && number <= kGreatest;
  }
  return false;
}

const char* NameOf(Limit limit) {
  switch (limit) {
    case Limit::kNumber:
      return "a number";
    case Limit::kFinite:
      return "a number of at most 1e15";
    case Limit::kNotNegative:
      return "a number from 0 to 1e15";
    case Limit::kPositive:
      return "a number above 0, of at most 1e15";
  }
  return "";
}

std::string Text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

double ReadNumber(Bytes bytes, std::size_t offset, std::string_view type) {
  if (type == "float") return double(NumberAt<float>(bytes, offset));
  if (type == "double") return NumberAt<double>(bytes, offset);
  if (type == "int") return double(NumberAt<std::int32_t>(bytes, offset));
  if (type == "short") return double(NumberAt<std::int16_t>(bytes, offset));
  return double(NumberAt<unsigned char>(bytes, offset));
}

/// Clears the pointers in all elements that are complete.
void ClearPointers(const Dna& dna, const Dna::Structure& structure, std::size_t length, std::byte* memory) {
  dna.ForEachPointer(structure, [&](std::size_t offset) {
    for (std::size_t begin = 0; begin + structure.size <= length; begin += structure.size) {
      std::fill_n(memory + begin + offset, sizeof(void*), std::byte(0));
    }
  });
}

/// @param m  rows of a matrix.
bool IsRotation(const std::vector<double>& m) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double product = m[3 * i] * m[3 * j] + m[3 * i + 1] * m[3 * j + 1] + m[3 * i + 2] * m[3 * j + 2];
      if (!(std::abs(product - (i == j ? 1 : 0)) <= kRotationTolerance)) return false;
    }
  }
  const double determinant =
      m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  return determinant > 0;
}

}  // namespace

Record::Record(const Blocks& blocks, Block& block, std::size_t element)
    : Record(blocks, block, element * block.structure->size, *block.structure) {}

Record Record::Inner(std::string_view path) const {
  const Dna& dna = blocks_->file().dna;
  const Dna::Location location = dna.Locate(*structure_, path);
  const Dna::Structure* inner = dna.Find(location.field->type);
  if (inner == nullptr) Fail(path, "is no structure");
  return {*blocks_, *block_, offset_ + location.offset, *inner};
}

std::vector<double> Record::Numbers(std::string_view path) const {
  const Dna& dna = blocks_->file().dna;
  const Dna::Location location = dna.Locate(*structure_, path);
  std::vector<double> numbers;
  dna.ForEachNumber(*location.field, [&](std::size_t offset, std::string_view type) {
    numbers.push_back(ReadNumber(block_->chunk->data, offset_ + location.offset + offset, type));
  });
  return numbers;
}

std::vector<double> Record::Numbers(std::string_view path, Limit limit) const {
  std::vector<double> numbers = Numbers(path);
  for (const double number : numbers) {
    if (!IsWithin(number, limit)) Fail(path, "is " + Text(number) + ", not " + NameOf(limit));
  }
  return numbers;
}

std::int32_t Record::Integer(std::string_view path) const { return static_cast<std::int32_t>(Numbers(path).at(0)); }

std::int32_t Record::Integer(std::string_view path, std::int32_t low, std::int32_t high) const {
  const std::int32_t number = Integer(path);
  if (number < low || number > high) {
    Fail(path, "is " + std::to_string(number) + ", not one of " + std::to_string(low) + " to " + std::to_string(high));
  }
  return number;
}

void Record::CheckQuaternion(std::string_view path) const {
  double squares = 0;
  for (const double number : Numbers(path)) squares += number * number;
  if (!(std::abs(squares - 1) <= kRotationTolerance))
    Fail(path, "is no rotation: its length is " + Text(std::sqrt(squares)));
}

void Record::CheckPose(std::string_view path) const {
  const std::string pose(path);
  Numbers(pose + ".m_origin", Limit::kFinite);
  if (!IsRotation(Numbers(pose + ".m_basis", Limit::kFinite))) Fail(path, "is no rotation");
}

std::uint64_t Record::Pointer(std::string_view path) const {
  const Dna::Location location = blocks_->file().dna.Locate(*structure_, path);
  if (!location.field->is_pointer) Fail(path, "is no pointer");
  return NumberAt<std::uint64_t>(block_->chunk->data, offset_ + location.offset);
}

Block* Record::Target(std::string_view path) const { return blocks_->Find(Pointer(path)); }

Block& Record::Array(std::string_view path, std::string_view structure, std::size_t count) const {
  Block* target = Target(path);
  if (target == nullptr) {
    Fail(path, Pointer(path) == 0
                   ? "is null where there should be " + std::to_string(count) + " of " + std::string(structure)
                   : "names no chunk");
  }
  if (target->structure == nullptr || target->structure->name != structure) {
    Fail(path, "names chunk " + std::to_string(target->index) + ", which is not of " + std::string(structure));
  }
  blocks_->Expect(*target, structure);
  if (target->chunk->count < count) {
    Fail(path, "names chunk " + std::to_string(target->index) + ", which has " + std::to_string(target->chunk->count) +
                   " elements where " + std::to_string(count) + " are counted on");
  }
  Link(path, target);
  return *target;
}

void Record::LinkName(std::string_view path) const {
  const Block* target = Target(path);
  if (target == nullptr) return;
  const Bytes letters = target->chunk->data;
  if (target->structure != nullptr || std::ranges::find(letters, std::byte{0}) == letters.end()) {
    Fail(path, "names chunk " + std::to_string(target->index) + ", which is no string that ends");
  }
  Link(path, target);
}

void Record::Link(std::string_view path, const Block* target) const {
  const Dna::Location location = blocks_->file().dna.Locate(*structure_, path);
  const std::byte* address = target == nullptr ? nullptr : target->memory.get();
  std::memcpy(block_->memory.get() + offset_ + location.offset, &address, sizeof(address));
}

void Record::Fail(const std::string& what) const { blocks_->Fail(*block_, what); }

void Record::Fail(std::string_view path, const std::string& what) const {
  const std::size_t element = offset_ / block_->structure->size;
  const std::string where = block_->chunk->count > 1 ? "[" + std::to_string(element) + "]." : "";
  Fail(where + std::string(path) + " " + what);
}

Blocks::Blocks(const BulletFile& file, const Dna& reference) : file_(&file), reference_(&reference) {
  for (std::size_t i = 0; i < file.chunks.size(); ++i) {
    const FileChunk& chunk = file.chunks[i];
    const Block* known = Find(chunk.pointer);
    if (known != nullptr) {
      // Bullet writes the shape twice that is a body's and a compound's child as well.
      const bool is_same = known->chunk->code == chunk.code && known->chunk->structure == chunk.structure &&
                           (chunk.code == "SHAP" || std::ranges::equal(known->chunk->data, chunk.data));
      if (is_same) continue;
    }
    const Dna::Structure* structure =
        chunk.structure < 0 ? nullptr : &file.dna.At(static_cast<std::size_t>(chunk.structure));
    auto memory = std::make_unique<std::byte[]>(chunk.data.size());
    std::ranges::copy(chunk.data, memory.get());
    if (structure != nullptr) ClearPointers(file.dna, *structure, chunk.data.size(), memory.get());
    blocks_.push_back({&chunk, i, structure, std::move(memory)});
    if (known != nullptr) {
      Fail(blocks_.back(), "its pointer, " + std::to_string(chunk.pointer) + ", is that of chunk " +
                               std::to_string(known->index) + " as well");
    }
    if (chunk.pointer != 0) by_pointer_[chunk.pointer] = &blocks_.back();
  }
}

Block* Blocks::Find(std::uint64_t pointer) const {
  const auto found = by_pointer_.find(pointer);
  return found == by_pointer_.end() ? nullptr : found->second;
}

void Blocks::ExpectSame(const Block& block, std::string_view structure) const {
  if (file_->dna.IsSameIn(*reference_, structure) && file_->dna.Find(structure) != nullptr) return;
  Fail(block, "Bullet " + VersionText(file_->version) + ", which wrote the file, has another " +
                  std::string(structure) + " than the one that reads it");
}

void Blocks::Expect(Block& block, std::string_view structure) const {
  if (block.structure == nullptr || block.structure->name != structure) {
    Fail(block, "it is not of " + std::string(structure) + ", as Bullet's are");
  }
  ExpectSame(block, structure);
  const std::size_t length = block.structure->size * block.chunk->count;
  if (block.chunk->data.size() != length) {
    Fail(block, "it has " + std::to_string(block.chunk->data.size()) + " bytes, and " +
                    std::to_string(block.chunk->count) + " elements take " + std::to_string(length));
  }
}

std::int32_t Blocks::Kind(const Block& block, std::string_view base, std::string_view field) const {
  ExpectSame(block, base);
  const Dna::Structure& structure = *file_->dna.Find(base);
  if (block.structure == nullptr || block.chunk->data.size() < structure.size) {
    Fail(block, "it is shorter than a " + std::string(base));
  }
  return NumberAt<std::int32_t>(block.chunk->data, file_->dna.Locate(structure, field).offset);
}

void Blocks::Fail(const Block& block, const std::string& what) const { throw SceneError(PlaceOf(block) + ": " + what); }

Record Blocks::Single(Block& block, std::string_view structure) const {
  Expect(block, structure);
  if (block.chunk->count != 1) Fail(block, "it has " + std::to_string(block.chunk->count) + " elements, not one");
  return {*this, block, 0};
}

std::string Blocks::PlaceOf(const Block& block) const {
  return file_->name + ": chunk " + std::to_string(block.index) + " at byte " + std::to_string(block.chunk->position) +
         " (" + block.chunk->code + (block.structure == nullptr ? "" : ", " + block.structure->name) + ")";
}

}  // namespace dgd_demos
