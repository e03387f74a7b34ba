// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dgd_demos {

/// Rows from top to bottom, pixels from left to right, red-green-blue bytes in sRGB.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Image(int w, int h) : width(w), height(h), rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::uint8_t* Pixel(int column, int row) { return &rgb[Offset(column, row)]; }
  const std::uint8_t* Pixel(int column, int row) const { return &rgb[Offset(column, row)]; }

 private:
  std::size_t Offset(int column, int row) const {
    return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
  }
};

/// The two pictures with a thin white line between them. @pre equal widths.
Image Stacked(const Image& top, const Image& bottom);

/// The two pictures with a thin white line between them. @pre equal heights.
Image SideBySide(const Image& left, const Image& right);

}  // namespace dgd_demos
