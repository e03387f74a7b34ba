// Bytes to numbers: what a fuzzer mutates, read as the values that a target asks for, one after another.
//
// Every byte string is some input, and one that is too short goes on with zeros. Whoever reads two values in one
// expression leaves their order to the compiler, and a corpus means something else to each: one value a statement. Each
// value has a fixed length, so that a byte that changes changes one value and leaves the others where they were.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace dgd_fuzz {

class FuzzInput {
 public:
  explicit FuzzInput(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool IsOver() const { return bytes_.empty(); }

  std::uint8_t Byte() { return Take<std::uint8_t>(); }
  bool Flip() { return (Byte() & 1) != 0; }
  /// 0 ... count - 1, for a count of at most 256.
  int Below(int count) { return Byte() % count; }

  /// The bits as they come.
  template <class T>
  T Bits() {
    return Take<T>();
  }

  /// A number of any size and kind, by its first byte: most often one of a few metres, on a grid that makes sets touch
  /// and centres coincide; else a float's or a double's bits; else one of those that arithmetic is known to trip over.
  double Number() {
    const std::uint8_t kind = Byte();
    std::array<std::uint8_t, 8> payload{};
    for (std::uint8_t& byte : payload) byte = Byte();
    if (kind < 128) return Read<std::int16_t>(payload) / 4096.0;  // [-8, 8) m
    if (kind < 176) return double(Read<float>(payload));
    if (kind < 224) return Read<double>(payload);
    return kSpecial[kind % kSpecial.size()];
  }
  /// As Number(), of the moderate ones only: what an app without errors asks for.
  double ModerateNumber() { return Bits<std::int16_t>() / 4096.0; }

  Eigen::Vector3d Vector() {
    const double x = Number(), y = Number(), z = Number();
    return {x, y, z};
  }

  Eigen::Vector3d ModerateVector() {
    const double x = ModerateNumber(), y = ModerateNumber(), z = ModerateNumber();
    return {x, y, z};
  }

  /// A rotation of the space or, for dimension 2, about z; or, one time in four, nine numbers that need not be one.
  Eigen::Matrix3d Rotation(int dimension) {
    const int kind = Below(4);
    const Eigen::Vector3d turn = ModerateVector();
    switch (kind) {
      case 0:
        return Eigen::Matrix3d::Identity();
      case 1: {  // A quarter turn: boxes face on face.
        Eigen::Matrix3d quarter;
        quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        return quarter;
      }
      case 2: {
        const Eigen::Vector3d axis = dimension == 2 ? Eigen::Vector3d(0, 0, 1) : turn;
        if (!(axis.norm() > 0)) return Eigen::Matrix3d::Identity();
        return Eigen::AngleAxisd(dimension == 2 ? turn.z() : turn.norm(), axis.normalized()).toRotationMatrix();
      }
      default: {
        Eigen::Matrix3d any;
        for (int column = 0; column < 3; ++column) any.col(column) = Vector();
        return any;
      }
    }
  }

 private:
  static constexpr std::array kSpecial = {0.0,
                                          -0.0,
                                          1.0,
                                          -1.0,
                                          0.5,
                                          std::numeric_limits<double>::quiet_NaN(),
                                          std::numeric_limits<double>::infinity(),
                                          -std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::denorm_min(),
                                          std::numeric_limits<double>::min(),
                                          std::numeric_limits<double>::max(),
                                          -std::numeric_limits<double>::max(),
                                          std::numeric_limits<double>::epsilon(),
                                          1 + std::numeric_limits<double>::epsilon(),
                                          double(std::numeric_limits<float>::max()),
                                          double(std::numeric_limits<float>::denorm_min()),
                                          1e-160,  // Its square is denormal,
                                          1e160,   // and this one's too large.
                                          1e-20,
                                          1e20};  // So in float.

  template <class T>
  T Take() {
    std::array<std::uint8_t, sizeof(T)> taken{};
    const std::size_t count = std::min(sizeof(T), bytes_.size());
    std::memcpy(taken.data(), bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
    return Read<T>(taken);
  }

  template <class T, std::size_t kSize>
  static T Read(const std::array<std::uint8_t, kSize>& bytes) {
    static_assert(sizeof(T) <= kSize);
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  std::span<const std::uint8_t> bytes_;
};

}  // namespace dgd_fuzz
