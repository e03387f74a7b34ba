// An app whose plugin brings Bullet, for itself alone (RTLD_LOCAL). Usage: loading_app PLUGIN ARRANGEMENT (worlds.h)
#include <dlfcn.h>

#include <cstdio>

#include "worlds.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  void* plugin = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (plugin == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 2;
  }
  auto* run = reinterpret_cast<decltype(&RunWorlds)>(dlsym(plugin, "RunWorlds"));
  return run != nullptr ? run(argv[2]) : 2;
}
