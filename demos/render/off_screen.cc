#include "render/off_screen.h"

#include <stdexcept>
#include <string>

#include "render/gl.h"

namespace dgd_demos {

OffScreen::OffScreen(int width, int height)
    : width_(width),
      height_(height),
      rgba_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      context_(nullptr, [](osmesa_context* context) { OSMesaDestroyContext(context); }) {
  LoadOsMesa();
  constexpr int kDepthBits = 24, kStencilBits = 0, kAccumulationBits = 0;
  context_.reset(OSMesaCreateContextExt(OSMESA_RGBA, kDepthBits, kStencilBits, kAccumulationBits, nullptr));
  if (context_ == nullptr) throw std::runtime_error("OSMesa gives no context for off-screen rendering");
  MakeCurrent();
}

void OffScreen::MakeCurrent() {
  if (OSMesaMakeCurrent(context_.get(), rgba_.data(), GL_UNSIGNED_BYTE, width_, height_) != GL_TRUE) {
    throw std::runtime_error("OSMesa cannot draw pictures of " + std::to_string(width_) + " x " +
                             std::to_string(height_));
  }
}

}  // namespace dgd_demos
