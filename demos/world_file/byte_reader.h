// Reading numbers out of bytes that may end at any place.
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

namespace dgd_demos {

using Bytes = std::span<const std::byte>;

/// The number at an offset, in this machine's byte order. @pre offset + sizeof(T) <= bytes.size().
template <class T>
T NumberAt(Bytes bytes, std::size_t offset) {
  static_assert(std::is_trivially_copyable_v<T>);
  T number;
  std::memcpy(&number, bytes.data() + offset, sizeof(T));
  return number;
}

/// Reads front to back. A read that needs more bytes than are left returns nothing and reads none.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }

  template <class T>
  std::optional<T> Number() {
    if (left() < sizeof(T)) return std::nullopt;
    position_ += sizeof(T);
    return NumberAt<T>(bytes_, position_ - sizeof(T));
  }

  std::optional<Bytes> Take(std::size_t count) {
    if (left() < count) return std::nullopt;
    position_ += count;
    return bytes_.subspan(position_ - count, count);
  }

  /// The text up to a zero byte, which is read as well.
  std::optional<std::string> Text() {
    const Bytes rest = bytes_.subspan(position_);
    const void* end = rest.empty() ? nullptr : std::memchr(rest.data(), 0, rest.size());
    if (end == nullptr) return std::nullopt;
    const std::size_t length = static_cast<std::size_t>(static_cast<const std::byte*>(end) - rest.data());
    position_ += length + 1;
    return std::string(reinterpret_cast<const char*>(rest.data()), length);
  }

 private:
  Bytes bytes_;
  std::size_t position_ = 0;
};

}  // namespace dgd_demos
