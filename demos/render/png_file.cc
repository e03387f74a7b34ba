#include "render/png_file.h"

#include <png.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "report/whole_file.h"

namespace dgd_demos {

void WritePng(const std::filesystem::path& file, const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  constexpr int kKeep8Bit = 0, kRowsWithoutPadding = 0;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  png_image_write_to_memory(&header, bytes.data(), &size, kKeep8Bit, image.rgb.data(), kRowsWithoutPadding, nullptr);
  if (PNG_IMAGE_FAILED(header)) throw std::runtime_error(file.string() + ": cannot be written: " + header.message);
  WriteWholeFile(file, std::string_view(bytes).substr(0, size));
}

}  // namespace dgd_demos
