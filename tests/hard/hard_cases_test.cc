// Every class of the catalogue, in both scalars: certified or declined with a reason, and never a wrong yes or no.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>

#include "support/hard/draw.h"
#include "support/hard/examine.h"

namespace dgd_test {

void PrintTo(const HardClass& hard_class, std::ostream* out) { *out << hard_class.name; }

namespace {

constexpr int kUsualCases = 200;

struct Share {
  int cases = 0, certified = 0;
};

template <class S>
Share ExamineAll(const HardClass& hard_class) {
  const int count = TestCount(kUsualCases);
  Share share{count, 0};
  for (int index = 0; index < count; ++index) {
    const HardCase hard_case = MakeHardCase(hard_class, TestSeed(), index);
    const Examination examination = Examine<S>(hard_class, hard_case);
    share.certified += examination.growth_distance == Verdict::kCertified ? 1 : 0;
    EXPECT_NE(examination.growth_distance, Verdict::kRefuted);
    EXPECT_FALSE(examination.is_wrong_yes_no);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << hard_class.name << ", seed " << TestSeed() << ", case " << index << ":\n"
                    << examination.remarks << Dump(hard_case.pair);
      return share;
    }
  }
  return share;
}

class HardCases : public ::testing::TestWithParam<HardClass> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, HardCases, ::testing::ValuesIn(AllHardClasses().begin(), AllHardClasses().end()),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(HardCases, AreCertifiedOrDeclinedInDouble) {
  const Share share = ExamineAll<double>(GetParam());
  EXPECT_GE(share.certified, GetParam().least_certified * share.cases) << GetParam().why;
}

TEST_P(HardCases, AreCertifiedOrDeclinedInFloat) {
  const Share share = ExamineAll<float>(GetParam());
  EXPECT_GE(share.certified, GetParam().least_certified_float * share.cases) << GetParam().why;
}

class KnownFailures : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(AsReported, KnownFailures, ::testing::Range(0, hard::KnownFailureCount()),
                         [](const auto& test) {
                           std::string name = hard::NameOfKnownFailure(test.param);
                           std::ranges::replace_if(
                               name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
                           return name + "_" + std::to_string(test.param);
                         });

TEST_P(KnownFailures, AreCertifiedInBothScalars) {
  const HardClass known{hard::NameOfKnownFailure(GetParam()), "", hard::DrawKnownFailures};
  const HardCase hard_case = MakeHardCase(known, TestSeed(), GetParam());
  for (const Examination& examination : {Examine<double>(known, hard_case), Examine<float>(known, hard_case)}) {
    EXPECT_EQ(examination.growth_distance, Verdict::kCertified) << examination.remarks << Dump(hard_case.pair);
    EXPECT_FALSE(examination.is_wrong_yes_no || examination.is_undecided_yes_no) << examination.remarks;
  }
}

}  // namespace
}  // namespace dgd_test
