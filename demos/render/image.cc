#include "render/image.h"

#include <algorithm>

namespace dgd_demos {

namespace {

constexpr int kGap = 4;  // Pixels.
constexpr std::uint8_t kWhite = 255;

}  // namespace

Image Stacked(const Image& top, const Image& bottom) {
  Image both(top.width, top.height + kGap + bottom.height);
  std::ranges::fill(both.rgb, kWhite);
  std::ranges::copy(top.rgb, both.rgb.begin());
  std::copy_n(bottom.rgb.data(), bottom.rgb.size(), both.Pixel(0, top.height + kGap));
  return both;
}

Image SideBySide(const Image& left, const Image& right) {
  Image both(left.width + kGap + right.width, left.height);
  std::ranges::fill(both.rgb, kWhite);
  for (int row = 0; row < both.height; ++row) {
    std::copy_n(left.Pixel(0, row), 3 * left.width, both.Pixel(0, row));
    std::copy_n(right.Pixel(0, row), 3 * right.width, both.Pixel(left.width + kGap, row));
  }
  return both;
}

}  // namespace dgd_demos
