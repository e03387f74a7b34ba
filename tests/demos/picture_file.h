// Pictures that a program has written, read back.
#pragma once

#include <png.h>

#include <filesystem>
#include <stdexcept>

#include "render/image.h"

namespace dgd_demos {

/// @throws std::runtime_error if it is no picture.
inline Image ReadPng(const std::filesystem::path& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, file.c_str()) == 0) throw std::runtime_error(file.string());
  header.format = PNG_FORMAT_RGB;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  if (png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(file.string());
  return image;
}

}  // namespace dgd_demos
