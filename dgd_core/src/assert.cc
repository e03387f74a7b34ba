#include "dgd/assert.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace dgd {
namespace {

void Print(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: dgd: does not hold: %s\n", file, line, condition);
}

std::atomic<AssertionHandler> handler = Print;

}  // namespace

AssertionHandler SetAssertionHandler(AssertionHandler next) { return handler.exchange(next != nullptr ? next : Print); }

void FailAssertion(const char* condition, const char* file, int line) {
  handler.load()(condition, file, line);
  std::abort();
}

}  // namespace dgd
