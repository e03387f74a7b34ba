// What writing and reading a record have in common; dgd_bullet/record_file.h describes the format.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace dgd_bullet::record {

static_assert(std::endian::native == std::endian::little, "records are written as numbers lie in memory");

inline constexpr std::string_view kMagic = "DGDRECRD";
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::uint32_t kShapeBlock = 1, kStepBlock = 2;
inline constexpr std::uint64_t kNotClosed = ~std::uint64_t{0};

struct Counts {
  std::uint64_t shapes = kNotClosed, steps = kNotClosed, pairs = kNotClosed, left_out = kNotClosed;
};
static_assert(std::has_unique_object_representations_v<Counts>);

using Checksum = std::uint64_t;
inline constexpr std::size_t kHeaderSize =
    kMagic.size() + 2 * sizeof(std::uint32_t) + sizeof(Counts) + sizeof(Checksum);
inline constexpr std::size_t kBlockHeadSize = 2 * sizeof(std::uint32_t);
inline constexpr std::size_t kNumbersOfPose = 12;

/// Size of one pair in a step's block, in bytes.
constexpr std::size_t PairSize(std::size_t real_bytes) {
  return 3 * sizeof(std::uint32_t) + 2 * kNumbersOfPose * real_bytes;
}

/// FNV-1a.
inline Checksum ChecksumOf(std::string_view bytes) {
  Checksum hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

template <class Number>
void Append(std::string& bytes, const Number& number) {
  static_assert(std::is_trivially_copyable_v<Number>);
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof(Number));
  std::memcpy(bytes.data() + end, &number, sizeof(Number));
}

/// Takes the first number off the bytes, which must hold it.
template <class Number>
Number Take(std::string_view& bytes) {
  Number number;
  // cppcheck-suppress invalidLifetime ; the number is no view of the bytes
  std::memcpy(&number, bytes.data(), sizeof(Number));
  bytes.remove_prefix(sizeof(Number));
  return number;
}

}  // namespace dgd_bullet::record
