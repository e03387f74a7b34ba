// Radii from a thousandth of the sets' size down to rounding, about cores with and without an interior:
// kMinConvexRadius.
#include <gtest/gtest.h>

#include "support/checks.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

template <class S>
void CertifyWithRadius(double part, bool solid) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(1500, 150); ++i) {
    const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(solid ? 3 + random.Below(4) : random.Below(3))];
    const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(solid ? random.Below(7) : random.Below(3))];
    ReferencePair reference{RandomSet(random, type_1, false), RandomSet(random, type_2, false), {}, {}};
    reference.set_1.radius = random.Flip() ? part * reference.Extent() : 0;
    reference.set_2.radius = reference.set_1.radius > 0 && random.Flip() ? 0 : part * reference.Extent();
    if (reference.Extent() == 0) continue;  // Two points.
    PlaceRandomly(random, reference);
    ASSERT_TRUE(SolvesAndCertifies<S>(reference)) << "case " << i;
  }
}

class RayIntersectionWithRadius : public ::testing::TestWithParam<double> {};

TEST_P(RayIntersectionWithRadius, TinyRadius_SolidCoresAreCertifiedInDouble) {
  CertifyWithRadius<double>(GetParam(), true);
}
TEST_P(RayIntersectionWithRadius, TinyRadius_SolidCoresAreCertifiedInFloat) {
  CertifyWithRadius<float>(GetParam(), true);
}
INSTANTIATE_TEST_SUITE_P(OfTheSize, RayIntersectionWithRadius,
                         ::testing::Values(1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-15));

// Nothing but the radius has an interior: down to what a plate or a cable has. A thinner one loses its digits.
TEST(RayIntersection, TinyRadius_FlatCoresAreCertified) {
  for (const double part : {1e-2, 1e-3, 1e-4}) CertifyWithRadius<double>(part, false);
  CertifyWithRadius<float>(1e-2, false);
}

}  // namespace
}  // namespace dgd_test
