// Invariants that are checked where NDEBUG is not defined, as assert() does; and who is told of one that does not hold.
#pragma once

#include "dgd/export.h"

namespace dgd {

/// Told of an invariant that does not hold; may throw or end the program. If it returns, the program is aborted.
/// @param condition, file  Of the source, as the compiler has them.
using AssertionHandler = void (*)(const char* condition, const char* file, int line);

/// Puts a handler in the place of the default one, which prints a line to the standard error stream; null for that.
/// For all threads. @return the one before.
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
