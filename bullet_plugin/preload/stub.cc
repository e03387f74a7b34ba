// What LD_PRELOAD puts before Bullet: the two getters by which a dispatcher fills its tables. Bullet's vtables name
// them as symbols, so that the dynamic linker finds these first. The stub is free of Bullet and of the C++ library: it
// detects the precision of the process's Bullet, and forwards each call to the backend of that precision.
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <link.h>
#include <pthread.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "backend.h"
#include "environment.h"

/// Bullet's class, as far as a linker sees it: methods are named alike whether they are virtual or not.
class [[gnu::visibility("default")]] btDefaultCollisionConfiguration {
 public:
  void* getCollisionAlgorithmCreateFunc(int type_0, int type_1);
  void* getClosestPointsAlgorithmCreateFunc(int type_0, int type_1);
};

namespace dgd_preload {
namespace {

/// A method called as a function: Bullet's platforms pass the object as the first argument.
using Getter = void*(void* configuration, int type_0, int type_1);

constexpr const char* kGetterNames[kTables] = {
    "_ZN31btDefaultCollisionConfiguration31getCollisionAlgorithmCreateFuncEii",
    "_ZN31btDefaultCollisionConfiguration35getClosestPointsAlgorithmCreateFuncEii"};

/// A function of Bullet's that takes its numbers by pointer, and so is named by their precision.
constexpr const char kFloatHull[] = "_ZN17btConvexHullShapeC1EPKfii";
constexpr const char kDoubleHull[] = "_ZN17btConvexHullShapeC1EPKdii";

/// How the getters of a class of configurations are replaced: of Bullet's default or one derived from it. Never freed.
struct ConfigurationClass {
  const void* vtable;
  Getter* originals[kTables];
  ChooseCreateFunc* choose_create_func;  ///< Null where Bullet's own narrowphase is used.
  ConfigurationClass* next;
};

/// Read without a lock, and only ever added to.
std::atomic<ConfigurationClass*> g_classes = nullptr;
pthread_mutex_t g_mutex = PTHREAD_MUTEX_INITIALIZER;

template <class Function>
Function* FindFunction(void* library, const char* name) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

/// The path of the shared library that has this address in it; empty for the program itself.
const char* PathOfLibrary(const void* address) {
  Dl_info info;
  void* map = nullptr;
  if (dladdr1(address, &info, &map, RTLD_DL_LINKMAP) == 0) return "";
  return static_cast<const link_map*>(map)->l_name;
}

/// A handle of the shared library that has this address in it, by which names are found in it and in what it needs,
/// also if it is opened with RTLD_LOCAL; null for the program itself. Never closed: what is found must stay.
void* LibraryOf(const void* address) {
  const char* path = PathOfLibrary(address);
  return *path == '\0' ? nullptr : dlopen(path, RTLD_LAZY | RTLD_NOLOAD);
}

/// Bullet's own getter, as the class with this vtable would have found it without the stub. The vtable of Bullet's
/// class is in Bullet's library, that of a derived one in a library that needs Bullet, or in the program.
Getter* FindOriginal(const void* vtable, Table table) {
  void* library = LibraryOf(vtable);
  Getter* of_library = library != nullptr ? FindFunction<Getter>(library, kGetterNames[table]) : nullptr;
  return of_library != nullptr ? of_library : FindFunction<Getter>(RTLD_NEXT, kGetterNames[table]);
}

void PrintFallback(const char* subject, const char* reason) {
  std::fprintf(stderr, "dgd-bullet: %s: %s%sBullet's own narrowphase is used.\n", program_invocation_name, subject,
               reason);
}

/// Opens the backend next to this library that goes with a Bullet library.
/// @return null if there is none, which has been reported.
void* OpenBackend(void* bullet, const char* bullet_path) {
  const bool is_float = dlsym(bullet, kFloatHull) != nullptr;
  if (!is_float && dlsym(bullet, kDoubleHull) == nullptr) {
    PrintFallback(bullet_path, " is Bullet neither in float nor in double; ");
    return nullptr;
  }
  const char* own_path = PathOfLibrary(&g_classes);
  const auto folder_length = static_cast<int>(std::strrchr(own_path, '/') - own_path);
  char path[PATH_MAX];
  std::snprintf(path, sizeof(path), "%.*s/libdgd_bullet_preload_%s.so", folder_length, own_path,
                is_float ? "float" : "float64");
  void* backend = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (backend == nullptr) PrintFallback(dlerror(), "; ");
  return backend;
}

/// @return null where Bullet's own narrowphase must be used, which has been reported.
ChooseCreateFunc* FindBackend(Getter* original) {
  const auto* in_bullet = reinterpret_cast<const void*>(original);
  const char* bullet_path = PathOfLibrary(in_bullet);
  void* bullet = LibraryOf(in_bullet);
  void* backend = OpenBackend(bullet != nullptr ? bullet : RTLD_DEFAULT, bullet_path);
  if (backend == nullptr) return nullptr;

  // The backend needs the version of Bullet that it is compiled for. If that is not the library in use, it has brought
  // another one along.
  if (FindFunction<Getter>(backend, kGetterNames[kContacts]) != original) {
    dlclose(backend);
    PrintFallback(bullet_path, " is not the Bullet library that dgd_bullet is compiled for; ");
    return nullptr;
  }
  auto* start = FindFunction<Start>(backend, kStartName);
  const char* reason = start != nullptr ? start() : "its backend is of another version";
  if (reason != nullptr) {
    PrintFallback(reason, "; ");
    return nullptr;
  }
  return FindFunction<ChooseCreateFunc>(backend, kChooseCreateFuncName);
}

ConfigurationClass* FindKnown(const void* vtable) {
  for (ConfigurationClass* known = g_classes.load(std::memory_order_acquire); known != nullptr; known = known->next) {
    if (known->vtable == vtable) return known;
  }
  return nullptr;
}

ConfigurationClass* MakeClass(const void* vtable) {
  auto* made = static_cast<ConfigurationClass*>(std::calloc(1, sizeof(ConfigurationClass)));
  if (made == nullptr) std::abort();
  made->vtable = vtable;
  for (const Table table : {kContacts, kClosestPoints}) {
    made->originals[table] = FindOriginal(vtable, table);
    if (made->originals[table] != nullptr) continue;
    std::fprintf(stderr, "dgd-bullet: %s: Bullet's own %s is not found.\n", program_invocation_name,
                 kGetterNames[table]);
    std::abort();
  }
  if (!IsOn(kOff)) made->choose_create_func = FindBackend(made->originals[kContacts]);
  return made;
}

const ConfigurationClass& ClassOf(const void* vtable) {
  if (const ConfigurationClass* known = FindKnown(vtable)) return *known;
  pthread_mutex_lock(&g_mutex);
  ConfigurationClass* found = FindKnown(vtable);
  if (found == nullptr) {
    found = MakeClass(vtable);
    found->next = g_classes.load(std::memory_order_relaxed);
    g_classes.store(found, std::memory_order_release);
  }
  pthread_mutex_unlock(&g_mutex);
  return *found;
}

void* CreateFuncOf(void* configuration, Table table, int type_0, int type_1) {
  const ConfigurationClass& of = ClassOf(*static_cast<const void* const*>(configuration));
  void* create_func = of.originals[table](configuration, type_0, type_1);
  if (of.choose_create_func != nullptr) {
    create_func = of.choose_create_func(configuration, table, type_0, type_1, create_func);
  }
  return create_func;
}

/// Reports at the process's end that nothing was counted.
[[gnu::destructor]] void ReportNoBullet() {
  if (!(IsOn(kStatistics) || IsOn(kAudit)) || IsOn(kOff) || g_classes.load(std::memory_order_acquire) != nullptr)
    return;
  std::fprintf(stderr,
               "dgd-bullet: %s: no Bullet was reached in this process: no dispatcher was made, or Bullet is linked in "
               "statically.\n",
               program_invocation_name);
}

}  // namespace
}  // namespace dgd_preload

void* btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(int type_0, int type_1) {
  return dgd_preload::CreateFuncOf(this, dgd_preload::kContacts, type_0, type_1);
}

void* btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(int type_0, int type_1) {
  return dgd_preload::CreateFuncOf(this, dgd_preload::kClosestPoints, type_0, type_1);
}
