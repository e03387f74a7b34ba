// Invariants: checked in builds that check, and free in those that do not.
#include "dgd/assert.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "dgd/contact/facing_faces.h"

namespace dgd_test {
namespace {

TEST(Assert, FullList_CallsTheHandlerWhereItIsChecked) {
#ifdef NDEBUG
  GTEST_SKIP() << "this build does not check";
#else
  const dgd::AssertionHandler throws = [](const char* condition, const char*, int) {
    throw std::logic_error(condition);
  };
  const dgd::AssertionHandler before = dgd::SetAssertionHandler(throws);
  dgd::SupportingFace<double> face;
  const auto add = [&face] { face.Add(dgd::Vector3<double>::Zero()); };
  for (int i = 0; i < dgd::SupportingFace<double>::kMaxPoints; ++i) add();
  EXPECT_THROW(add(), std::logic_error);
  EXPECT_EQ(dgd::SetAssertionHandler(before), throws);
#endif
}

TEST(Assert, Handler_IsGivenTheConditionAndThePlace) {
  static std::string failure;
  const dgd::AssertionHandler before = dgd::SetAssertionHandler([](const char* condition, const char* file, int line) {
    failure = std::string(file) + ":" + std::to_string(line) + ": " + condition;
    throw std::logic_error("handled");
  });
  EXPECT_THROW(dgd::FailAssertion("size < 4", "list.h", 12), std::logic_error);
  EXPECT_EQ(failure, "list.h:12: size < 4");
  dgd::SetAssertionHandler(before);
}

TEST(AssertDeathTest, DefaultHandler_PrintsAndAborts) {
  EXPECT_DEATH(dgd::FailAssertion("size < 4", "list.h", 12), "list.h:12: dgd: does not hold: size < 4");
}

TEST(Assert, Condition_IsNotEvaluatedWhereItIsNotChecked) {
  [[maybe_unused]] int evaluated = 0;
  DGD_ASSERT(++evaluated == 1);
#ifdef NDEBUG
  EXPECT_EQ(evaluated, 0);
#else
  EXPECT_EQ(evaluated, 1);
#endif
}

}  // namespace
}  // namespace dgd_test
