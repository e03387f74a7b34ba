// What a thread knows of the order in which it visits pairs: what came next the last time, or nothing.
#include "visiting_order.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace {

using dgd_bullet::VisitingOrder;

struct Pair {
  VisitingOrder::Place place = 0;
};

/// What each visit says comes next.
std::vector<const void*> VisitAll(VisitingOrder& order, const std::vector<Pair*>& pairs) {
  std::vector<const void*> next;
  for (Pair* pair : pairs) next.push_back(order.Visit(pair, pair->place));
  return next;
}

TEST(VisitingOrder, FirstStep_NothingIsKnown) {
  VisitingOrder order;
  Pair a, b, c;
  EXPECT_EQ(VisitAll(order, {&a, &b, &c}), (std::vector<const void*>{nullptr, nullptr, nullptr}));
}

TEST(VisitingOrder, SameOrderAgain_TheNextOneIsKnown) {
  VisitingOrder order;
  Pair a, b, c;
  VisitAll(order, {&a, &b, &c});
  // After the last one of a step comes the first one of the next.
  for (int step = 0; step < 3; ++step) {
    EXPECT_EQ(VisitAll(order, {&a, &b, &c}), (std::vector<const void*>{&b, &c, &a})) << step;
  }
}

TEST(VisitingOrder, PairsThatComeAndGo_TheOthersKeepTheirs) {
  VisitingOrder order;
  Pair a, b, c, d;
  VisitAll(order, {&a, &b, &c});
  EXPECT_EQ(VisitAll(order, {&a, &d, &c}), (std::vector<const void*>{&b, nullptr, &a}));
  EXPECT_EQ(VisitAll(order, {&a, &d, &c}), (std::vector<const void*>{&d, &c, &a}));
}

TEST(VisitingOrder, TheLastVisitOfAll_NothingCameNext) {
  VisitingOrder order;
  Pair a;
  order.Visit(&a, a.place);
  EXPECT_EQ(order.Visit(&a, a.place), nullptr);
}

TEST(VisitingOrder, VisitsLongAgo_AreForgotten) {
  VisitingOrder order;
  Pair a, b;
  std::vector<Pair> others(VisitingOrder::kPlaces - 2);
  const auto visit_others = [&](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) order.Visit(&others[i], others[i].place);
  };
  VisitAll(order, {&a, &b});
  visit_others(others.size() - 1);
  EXPECT_EQ(order.Visit(&a, a.place), &b);
  VisitAll(order, {&b, &a, &b});
  visit_others(others.size());
  EXPECT_EQ(order.Visit(&a, a.place), nullptr);
}

TEST(VisitingOrder, AnotherThread_KnowsNothingOfThisOnes) {
  Pair a, b;
  VisitingOrder& here = VisitingOrder::OfThisThread();
  VisitAll(here, {&a, &b});
  std::thread([&] {
    EXPECT_NE(&VisitingOrder::OfThisThread(), &here);
    EXPECT_EQ(VisitAll(VisitingOrder::OfThisThread(), {&a, &b}), (std::vector<const void*>{nullptr, nullptr}));
  }).join();
  EXPECT_EQ(&VisitingOrder::OfThisThread(), &here);
}

}  // namespace
