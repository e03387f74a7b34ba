#include "render/gl.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "render/off_screen.h"

// Read by the sanitizers, if there are any. Mesa 22.3 keeps the frame buffers of a context that is destroyed; and its
// threads, which are compiled without the thread sanitizer, look to that as if they did not wait for each other.
// NOLINTBEGIN(bugprone-reserved-identifier): the names are theirs.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
extern "C" const char* __tsan_default_suppressions() { return "race:libOSMesa.so\nrace:libLLVM\n"; }
// NOLINTEND(bugprone-reserved-identifier)

namespace dgd_demos {
namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";  // Its interface's version; so since 2013.

template <class Function>
void Find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) {
    throw std::runtime_error("no pictures can be drawn: " + std::string(kLibrary) + " has no " + name);
  }
}

bool LoadAll() {
  void* const library = dlopen(kLibrary, RTLD_LAZY | RTLD_LOCAL);  // Until the program ends.
  if (library == nullptr) {
    throw std::runtime_error("no pictures can be drawn: " + std::string(dlerror()) +
                             " (Debian's package is libosmesa6; runs without pictures do without it)");
  }
#define DGD_FIND_GL_FUNCTION(name) Find(library, #name, name);
  DGD_GL_FUNCTIONS(DGD_FIND_GL_FUNCTION)
#undef DGD_FIND_GL_FUNCTION
  return true;
}

}  // namespace

#define DGD_DEFINE_GL_FUNCTION(name) decltype(&::name) name = nullptr;
DGD_GL_FUNCTIONS(DGD_DEFINE_GL_FUNCTION)
#undef DGD_DEFINE_GL_FUNCTION

void LoadOsMesa() { [[maybe_unused]] static const bool is_loaded = LoadAll(); }

}  // namespace dgd_demos
