// Invariants that are checked where NDEBUG is not defined, as assert() does, and the handler of one that does not hold.
#pragma once

#include "dgd/export.h"

namespace dgd {

/// Called for an invariant that does not hold; may throw or end the program. If it returns, the program is aborted.
/// @param condition   The source text of the invariant.
/// @param file, line  Its place.
using AssertionHandler = void (*)(const char* condition, const char* file, int line);

/// Replaces the handler, for all threads. The default one prints a line to the standard error stream.
/// @param handler  Null for the default one. @return the one before.
DGD_EXPORT AssertionHandler SetAssertionHandler(AssertionHandler handler);

/// What DGD_ASSERT calls.
DGD_EXPORT [[noreturn]] void FailAssertion(const char* condition, const char* file, int line);

}  // namespace dgd

#ifdef NDEBUG
#define DGD_ASSERT(condition) static_cast<void>(0)
#else
#define DGD_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::dgd::FailAssertion(#condition, __FILE__, __LINE__))
#endif
