// What the tests of hard input share: pairs on our dispatcher and on Bullet's, and what no answer may be.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/test_world.h"

namespace dgd_test {

/// One pair at a time through our dispatcher, beside one of Bullet's own.
class Fallback : public testing::Test {
 protected:
  void ExpectCounts(std::uint64_t no_interior, std::uint64_t invalid) const {
    const dgd_bullet::Statistics statistics = dispatching_.statistics();
    EXPECT_EQ(statistics.fallbacks_no_interior, no_interior);
    EXPECT_EQ(statistics.fallbacks_invalid, invalid);
    EXPECT_EQ(statistics.fallbacks_not_converged, 0U);
    EXPECT_EQ(statistics.Fallbacks(), no_interior + invalid);
  }

  /// Nothing that left the algorithm or stayed in its manifold is NaN or infinite.
  static void ExpectFinite(PairQuery& pair, const std::vector<Contact>& contacts) {
    for (const Contact& contact : contacts) {
      EXPECT_TRUE(contact.normal_b_to_a.allFinite());
      EXPECT_TRUE(contact.on_b.allFinite());
      EXPECT_TRUE(std::isfinite(contact.depth));
    }
    if (pair.manifold() == nullptr) return;
    for (int i = 0; i < pair.manifold()->getNumContacts(); ++i) {
      const btManifoldPoint& point = pair.manifold()->getContactPoint(i);
      EXPECT_TRUE(std::isfinite(point.getDistance()));
      EXPECT_TRUE(ToEigen(point.m_normalWorldOnB).allFinite());
      EXPECT_TRUE(ToEigen(point.m_localPointA).allFinite());
      EXPECT_TRUE(ToEigen(point.m_localPointB).allFinite());
    }
  }

  /// The deepest contact of a step against the supporting planes along its own normal.
  static void ExpectSound(PairQuery& pair, const std::vector<Contact>& contacts) {
    ASSERT_FALSE(contacts.empty());
    ExpectFinite(pair, contacts);
    const Contact& deepest = Deepest(contacts);
    EXPECT_NEAR(deepest.normal_b_to_a.norm(), 1, 1e-6);
    EXPECT_NEAR(deepest.depth, PlaneSeparation(pair.A(), pair.B(), deepest.normal_b_to_a), 2e-5 + kLength);
  }

  Dispatching dispatching_{Route::kConfiguration};
  Dispatching builtin_{Route::kBuiltin};
};

}  // namespace dgd_test
