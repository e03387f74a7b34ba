#include "dgd/shapes/box.h"

#include <limits>

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

TEST(Box, Contract_HoldsForSolidAndFlatBoxes) {
  for (const Vector3d& half : {Vector3d(1, 1, 1), Vector3d(0.1, 2, 30), Vector3d(1, 0, 2), Vector3d(0, 0, 3),
                               Vector3d(0, 0, 0), Vector3d(1e-6, 2e-6, 1e-6)}) {
    SCOPED_TRACE(half.transpose());
    CheckShape(dgd::Box<double>(half), {.type = CoreType::kBox, .size = half});
    const Eigen::Vector3f half_f = half.cast<float>();
    CheckShape(dgd::Box<float>(half_f), {.type = CoreType::kBox, .size = half_f.cast<double>()});
  }
}

TEST(Box, Inradius_IsSmallestHalfExtent) {
  EXPECT_EQ(dgd::Box<double>({3, 0.5, 7}).Inradius(), 0.5);
  EXPECT_EQ(dgd::Box<double>({3, 0, 7}).Inradius(), 0);
}

TEST(Box, SupportFace_IsTheFaceInOrderAroundIt) {
  Random random(TestSeed());
  const dgd::Box<double> box({1, 2, 3});
  for (const Vector3d& direction : Directions(random)) {
    dgd::SupportingFace<double> face;
    box.SupportFace(direction, face);
    ASSERT_EQ(face.size, 4);
    // A rectangle: its diagonals halve each other, and neighbours differ in one coordinate.
    EXPECT_EQ(face.points[0] + face.points[2], face.points[1] + face.points[3]);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(((face.points[i] - face.points[(i + 1) % 4]).array() != 0).count(), 1);
    }
  }
}

TEST(Box, Constructor_RejectsBadExtentsNamingThem) {
  ExpectRejected([] { return dgd::Box<double>({1, -2.5, 1}); }, "-2.5");
  ExpectRejected([] { return dgd::Box<double>({1, 1, std::numeric_limits<double>::quiet_NaN()}); }, "nan");
  ExpectRejected([] { return dgd::Box<double>({std::numeric_limits<double>::infinity(), 1, 1}); }, "inf");
}

}  // namespace
}  // namespace dgd_test
