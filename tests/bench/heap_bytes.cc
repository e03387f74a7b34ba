#include "bench/heap_bytes.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

std::ptrdiff_t heap_bytes = 0;

void Free(void* memory) {
  heap_bytes -= static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  heap_bytes += static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  return memory;
}
void operator delete(void* memory) noexcept { Free(memory); }
void operator delete(void* memory, std::size_t) noexcept { Free(memory); }

namespace dgd_bench {

std::ptrdiff_t HeapBytes() { return heap_bytes; }

}  // namespace dgd_bench
