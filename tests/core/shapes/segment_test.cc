#include "dgd/shapes/segment.h"

#include <limits>

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

TEST(Segment, Contract_HoldsForManyLengths) {
  for (const double half_length : {0.0, 1e-6, 0.5, 1e3}) {
    const ReferenceSet reference{.type = CoreType::kSegment, .size = {half_length, 0, 0}};
    CheckShape(dgd::Segment<double>(half_length), reference);
    CheckShape(dgd::Segment<float>(static_cast<float>(half_length)),
               {.type = CoreType::kSegment, .size = {double(float(half_length)), 0, 0}});
  }
}

TEST(Segment, Constructor_RejectsBadLengthNamingIt) {
  ExpectRejected([] { return dgd::Segment<double>(-0.25); },
                 "segment half length must be finite and >= 0, in metres; got -0.25");
  ExpectRejected([] { return dgd::Segment<double>(std::numeric_limits<double>::quiet_NaN()); }, "nan");
  ExpectRejected([] { return dgd::Segment<float>(std::numeric_limits<float>::infinity()); }, "inf");
}

}  // namespace
}  // namespace dgd_test
