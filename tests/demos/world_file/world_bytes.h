// A world file to be damaged: its bytes, and where in them a field of a chunk is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "world_file/bullet_file.h"
#include "world_file/bullet_worlds.h"

namespace dgd_test {

class WorldBytes {
 public:
  explicit WorldBytes(BulletWorld& world);

  std::vector<std::byte>& bytes() { return bytes_; }
  std::size_t DnaPosition() const;

  /// Where the n-th chunk begins that has the code and, unless it is empty, is of the structure.
  std::size_t Chunk(std::string_view code, std::string_view structure = "", int number = 0) const;
  std::uint64_t PointerOf(std::size_t chunk) const;

  /// Sets a field of an element of the chunk that begins there; `index` counts the numbers of an array.
  template <class T>
  void Set(std::size_t chunk, std::string_view path, T value, std::size_t element = 0, std::size_t index = 0) {
    Put(FieldPosition(chunk, path, element) + index * sizeof(T), value);
  }
  template <class T>
  void Put(std::size_t position, T value) {
    std::memcpy(bytes_.data() + position, &value, sizeof(T));
  }

  /// The number that the Bullet of this test takes for a btScalar: set it with this.
  void SetScalar(std::size_t chunk, std::string_view path, double value, std::size_t index = 0) {
    Set(chunk, path, btScalar(value), 0, index);
  }

  /// The sentence that loading ends in, or none.
  std::optional<std::string> Error() const;

 private:
  std::size_t FieldPosition(std::size_t chunk, std::string_view path, std::size_t element) const;
  const dgd_demos::FileChunk& At(std::size_t chunk) const;

  std::vector<std::byte> bytes_;
  dgd_demos::BulletFile file_;  // As it was before damage.
};

/// "Float" or "Double", as in the names of Bullet's structures.
std::string PrecisionWord();

}  // namespace dgd_test
