// The state of a program as bytes. One function of each class lists its members for writing and for reading alike, so
// that the two cannot differ.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace dgd_demos {

class StateArchive {
 public:
  /// Writes: the values that are passed to it are appended to bytes().
  StateArchive() = default;
  /// Reads: the values that are passed to it are overwritten.
  /// @param place  begins the message of an error, as the name of a file.
  StateArchive(std::string bytes, std::string place)
      : bytes_(std::move(bytes)), place_(std::move(place)), is_reading_(true) {}

  bool is_reading() const { return is_reading_; }
  const std::string& bytes() const { return bytes_; }

  /// @throws std::runtime_error when reading beyond the end.
  template <class Value>
  requires std::is_trivially_copyable_v<Value>
  void Serialize(Value& value) { SerializeBytes(&value, sizeof value); }
  /// @throws std::runtime_error also for a byte that is no value of bool.
  void Serialize(bool& value);
  template <int kRows, int kColumns>
  void Serialize(Eigen::Matrix<double, kRows, kColumns>& matrix) {
    static_assert(kRows > 0 && kColumns > 0);
    SerializeBytes(matrix.data(), sizeof(double) * kRows * kColumns);
  }
  /// A value of Bullet's, which is plain memory, though C++ does not count it as such.
  template <class Value>
  requires std::is_standard_layout_v<Value>
  void SerializePlain(Value& value) { SerializeBytes(&value, sizeof value); }
  /// The number of elements, and each of them by `serialize(element)`.
  template <class Value, class SerializeElement>
  void Serialize(std::vector<Value>& values, const SerializeElement& serialize) {
    const std::size_t count = SerializeCount(values.size());
    if (is_reading_) values.clear();
    for (std::size_t i = 0; i < count; ++i) {
      if (is_reading_) values.emplace_back();  // No more of them than there are bytes for.
      serialize(values[i]);
    }
  }
  void Serialize(std::string& text);

  /// Checks that the state that is read is of the same kind as the one at hand.
  /// @param what  completes "it has 3 ..., not 4".
  /// @throws std::runtime_error if the number that was written is another one.
  void Expect(std::uint64_t number, const char* what);
  /// Checks a value that was read, before anything depends on it: whoever wrote the bytes may have meant harm.
  /// @param what  a sentence about a value that is not sound: "the index of a body is out of range".
  /// @throws std::runtime_error unless it is sound.
  void Require(bool is_sound, const char* what) const {
    if (!is_sound) Fail(std::string("is damaged: ") + what);
  }
  /// @throws std::runtime_error if there are bytes that were not read.
  void ExpectEnd() const;
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  void SerializeBytes(void* value, std::size_t size);
  std::size_t SerializeCount(std::size_t count);

  std::string bytes_;
  std::string place_;
  bool is_reading_ = false;
  std::size_t read_ = 0;  // Bytes.
};

}  // namespace dgd_demos
