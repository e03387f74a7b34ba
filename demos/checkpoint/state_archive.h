// The state of a program as bytes. One function of each class lists its members for writing and for reading alike, so
// that the two cannot differ.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
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
  void Add(Value& value) { AddBytes(&value, sizeof value); }
  template <int kRows, int kColumns>
  void Add(Eigen::Matrix<double, kRows, kColumns>& matrix) {
    static_assert(kRows > 0 && kColumns > 0);
    AddBytes(matrix.data(), sizeof(double) * kRows * kColumns);
  }
  /// A value of Bullet's, which is plain memory, though C++ does not count it as such.
  template <class Value>
  requires std::is_standard_layout_v<Value>
  void AddPlain(Value& value) { AddBytes(&value, sizeof value); }
  /// The elements are added by `add`, each by itself.
  template <class Value, class AddElement>
  void Add(std::vector<Value>& values, const AddElement& add) {
    values.resize(AddCount(values.size()));
    for (Value& value : values) add(value);
  }
  void Add(std::string& text);

  /// Checks that the state that is read is of the same kind as the one at hand.
  /// @param what  completes "it has 3 ..., not 4".
  /// @throws std::runtime_error if the number that was written is another one.
  void Expect(std::uint64_t number, const char* what);
  /// @throws std::runtime_error if there are bytes that were not read.
  void ExpectEnd() const;
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  void AddBytes(void* value, std::size_t size);
  std::size_t AddCount(std::size_t count);

  std::string bytes_;
  std::string place_;
  bool is_reading_ = false;
  std::size_t read_ = 0;  // Bytes.
};

}  // namespace dgd_demos
