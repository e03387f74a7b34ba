// The chunks of a .bullet file as memory that Bullet's importer may read: every pointer null but for those that were
// set to memory of the size that is read through them.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "world_file/bullet_file.h"

namespace dgd_demos {

/// A chunk and its copy, in which pointers are addresses.
struct Block {
  const FileChunk* chunk;
  std::size_t index;                    ///< Index of the chunk in the file.
  const Dna::Structure* structure;      ///< Structure of its elements; null for plain letters.
  std::unique_ptr<std::byte[]> memory;  ///< Copy of the chunk, aligned as by new.
};

/// Range of a number.
enum class Limit {
  kNumber,       ///< Any number but NaN: Bullet's limits and thresholds are infinite where there are none.
  kFinite,       ///< Finite, and so is its square.
  kNotNegative,  ///< At least 0, and finite as above.
  kPositive,     ///< Above 0, and finite as above.
};

class Blocks;

/// One structure in a block, which may be an element of an array and lie in another structure. A view.
class Record {
 public:
  Record(const Blocks& blocks, Block& block, std::size_t element);

  Block& block() const { return *block_; }
  void* address() const { return block_->memory.get() + offset_; }
  std::string_view structure() const { return structure_->name; }

  Record Inner(std::string_view path) const;  ///< A structure in this one.
  std::int32_t Integer(std::string_view path) const;
  std::int32_t Integer(std::string_view path, std::int32_t low, std::int32_t high) const;  ///< In [low, high].
  std::vector<double> Numbers(std::string_view path) const;  ///< All elements; the fourth of a vector is left out.
  std::vector<double> Numbers(std::string_view path, Limit limit) const;
  /// A quaternion that turns, by its four numbers.
  void CheckQuaternion(std::string_view path) const;
  /// A transform whose matrix is a rotation.
  void CheckPose(std::string_view path) const;

  /// The chunk that a pointer names, or null.
  Block* Target(std::string_view path) const;
  /// An array of at least so many elements of a structure; it becomes the pointer's target.
  Block& Array(std::string_view path, std::string_view structure, std::size_t count) const;
  /// A string that ends, or null: Bullet names an empty one and does not write it.
  void LinkName(std::string_view path) const;
  void Link(std::string_view path, const Block* target) const;

  [[noreturn]] void Fail(const std::string& what) const;
  [[noreturn]] void Fail(std::string_view path, const std::string& what) const;

 private:
  Record(const Blocks& blocks, Block& block, std::size_t offset, const Dna::Structure& structure)
      : blocks_(&blocks), block_(&block), offset_(offset), structure_(&structure) {}

  std::uint64_t Pointer(std::string_view path) const;

  const Blocks* blocks_;
  Block* block_;
  std::size_t offset_;  // Offset in the block, bytes.
  const Dna::Structure* structure_;
};

/// All blocks of a file, which can be found by the pointers that the file has for them.
class Blocks {
 public:
  /// @param reference  the DNA of the Bullet whose importer will read: structures that differ from its are refused.
  /// @throws SceneError if two different chunks have the same pointer.
  Blocks(const BulletFile& file, const Dna& reference);

  const BulletFile& file() const { return *file_; }
  std::deque<Block>& all() { return blocks_; }
  Block* Find(std::uint64_t pointer) const;

  /// Checks that a block's elements are of this structure, and that the reference has the same.
  /// @throws SceneError if not, or if the block is not as long as its elements.
  void Expect(Block& block, std::string_view structure) const;
  /// A field by which the block's structure can be identified, in the base that all structures of its kind begin with.
  std::int32_t Kind(const Block& block, std::string_view base, std::string_view field) const;
  /// The only element of a block.
  Record Single(Block& block, std::string_view structure) const;

  [[noreturn]] void Fail(const Block& block, const std::string& what) const;
  std::string PlaceOf(const Block& block) const;  ///< File, chunk, byte offset, code and structure.

 private:
  void ExpectSame(const Block& block, std::string_view structure) const;

  const BulletFile* file_;
  const Dna* reference_;
  std::deque<Block> blocks_;
  std::map<std::uint64_t, Block*> by_pointer_;
};

}  // namespace dgd_demos
