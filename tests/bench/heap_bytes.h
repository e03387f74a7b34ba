// What C++ objects hold of the heap, in a program of one thread that links heap_bytes.cc.
#pragma once

#include <cstddef>

namespace dgd_bench {

/// Bytes that operator new has handed out and not got back, rounded up as the heap does.
std::ptrdiff_t HeapBytes();

}  // namespace dgd_bench
