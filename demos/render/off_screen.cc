#include "render/off_screen.h"

#include <GL/osmesa.h>

#include <stdexcept>
#include <string>

// Read by the sanitizers, if there are any. Mesa 22.3 keeps the frame buffers of a context that is destroyed; and its
// threads, which are compiled without the thread sanitizer, look to that as if they did not wait for each other.
// NOLINTBEGIN(bugprone-reserved-identifier): the names are theirs.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
extern "C" const char* __tsan_default_suppressions() { return "race:libOSMesa.so\nrace:libLLVM\n"; }
// NOLINTEND(bugprone-reserved-identifier)

namespace dgd_demos {

OffScreen::OffScreen(int width, int height)
    : width_(width),
      height_(height),
      rgba_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      context_(nullptr, OSMesaDestroyContext) {
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
