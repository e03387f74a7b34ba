// OpenGL without a screen: a Mesa context that draws into memory of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

struct osmesa_context;

namespace dgd_demos {

/// Loads OSMesa, once a program. OffScreen does so as well: this is for a program that would draw only after long work.
/// @throws std::runtime_error if it is not installed, or is damaged.
void LoadOsMesa();

class OffScreen {
 public:
  /// Makes the context and binds it to the calling thread.
  /// @throws std::runtime_error if OSMesa cannot be loaded or gives no context.
  OffScreen(int width, int height);
  OffScreen(const OffScreen&) = delete;  // OSMesa keeps a pointer to the pixels.
  OffScreen& operator=(const OffScreen&) = delete;

  /// Binds the context to the calling thread, if another one has been bound since.
  void MakeCurrent();

  int width() const { return width_; }
  int height() const { return height_; }
  /// Red, green, blue, alpha bytes; rows from bottom to top, as OpenGL has them. Complete after glFinish().
  const std::vector<std::uint8_t>& rgba() const { return rgba_; }

 private:
  int width_, height_;
  std::vector<std::uint8_t> rgba_;
  std::unique_ptr<osmesa_context, void (*)(osmesa_context*)> context_;
};

}  // namespace dgd_demos
