// The algebra by its definitions, at random points of the cone.
#include "bench/textbook/second_order_cone.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace dgd_bench {
namespace {

using dgd_test::Random;

constexpr int kCases = 1000;

Vector4 RandomVector(Random& random) {
  Vector4 vector;
  vector << random.Uniform(-1, 1), random.InCube();
  return vector;
}

/// From well inside to near the border.
Vector4 InsideCone(Random& random) {
  Vector4 vector = RandomVector(random);
  vector[0] = vector.tail<3>().norm() * (1 + random.LogUniform(1e-4, 10));
  return vector;
}

Vector4 Product(const Vector4& a, const Vector4& b) {
  Vector4 product = a[0] * b + b[0] * a;
  product[0] = a.dot(b);
  return product;
}

TEST(SecondOrderCone, Quotient_InvertsProduct) {
  Random random(1);
  for (int i = 0; i < kCases; ++i) {
    const Vector4 divisor = InsideCone(random), right = RandomVector(random);
    const Vector4 quotient = ConeQuotient(right, divisor, ConeDeterminant(divisor));
    EXPECT_LE((Product(divisor, quotient) - right).norm(), 1e-10);
    EXPECT_LE((ConeSquare(right) - Product(right, right)).norm(), 1e-14);
  }
}

TEST(SecondOrderCone, StepsToBorder_LeadToTheBorderAndNotBeyond) {
  Random random(1);
  int reached = 0;
  for (int i = 0; i < kCases; ++i) {
    const Vector4 point = InsideCone(random), step = RandomVector(random);
    const double steps = StepsToConeBorder(point, ConeDeterminant(point), step);
    const bool stays = step[0] >= step.tail<3>().norm();
    EXPECT_EQ(std::isinf(steps), stays);
    if (stays) continue;
    ++reached;
    const Vector4 end = point + steps * step, before = point + 0.999 * steps * step;
    EXPECT_NEAR(end[0], end.tail<3>().norm(), 1e-9 * end.norm());
    EXPECT_GT(before[0], before.tail<3>().norm());
  }
  EXPECT_GE(reached, kCases / 2);
}

// The two zeros of the determinant are one there, and rounding may make them none.
TEST(SecondOrderCone, StepsToBorder_EndAtTheTip) {
  Random random(1);
  for (int i = 0; i < kCases; ++i) {
    const Vector4 point = InsideCone(random);
    const double steps = random.LogUniform(0.01, 100);
    EXPECT_NEAR(StepsToConeBorder(point, ConeDeterminant(point), -point / steps), steps, 1e-5 * steps);
  }
}

TEST(SecondOrderCone, Scaling_TakesSlackAndMultiplierToTheSamePoint) {
  Random random(1);
  for (int i = 0; i < kCases; ++i) {
    const Vector4 s = InsideCone(random), z = InsideCone(random);
    const NesterovToddScaling scaling(s, ConeDeterminant(s), z, ConeDeterminant(z));
    // W^-2 s = z, and W^-2 is the square of W^-1.
    EXPECT_LE((scaling.InverseSquared() * s - z).norm(), 1e-8 * z.norm());
    const Vector4 v = RandomVector(random);
    const Vector4 twice = scaling.InverseTimes(scaling.InverseTimes(v));
    EXPECT_LE((scaling.InverseSquared() * v - twice).norm(), 1e-8 * twice.norm());
  }
}

}  // namespace
}  // namespace dgd_bench
