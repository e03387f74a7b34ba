#include "soak/shrink.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace dgd_soak {
namespace {

using dgd_test::PairNumbers;
using dgd_test::PoseNumbers;
using dgd_test::SetNumbers;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Nothing where there is nothing left of what it changes.
using Change = std::function<void(SoakCase&)>;
using Changes = std::vector<Change>;

double Rounded(double number, int digits) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.*e", digits - 1, number);
  return std::strtod(text.data(), nullptr);
}

/// First to none, then to a few digits.
constexpr std::array kDigits = {1, 3};

Vector3d Rounded(const Vector3d& vector, int digits) {
  return vector.unaryExpr([digits](double number) { return Rounded(number, digits); });
}

void LeaveOutFrames(std::size_t frames, Changes& changes) {
  changes.emplace_back([](SoakCase& c) { c.motion.clear(); });
  for (std::size_t frame = frames; frame-- > 0;) {
    changes.emplace_back([frame](SoakCase& c) {
      if (frame < c.motion.size()) c.motion.erase(c.motion.begin() + static_cast<std::ptrdiff_t>(frame));
    });
  }
}

/// The world becomes set 1's frame.
void MoveToSet1(SoakCase& c) {
  const Matrix3d rotation = c.pair.pose_1.rotation.transpose();
  const Vector3d translation = c.pair.pose_1.translation;
  const auto move = [&](PoseNumbers& pose) {
    pose = {rotation * pose.rotation, rotation * (pose.translation - translation)};
  };
  if (rotation.isIdentity(0) && translation.isZero(0)) return;
  move(c.pair.pose_2);
  for (PoseNumbers& pose : c.motion) move(pose);
  c.pair.pose_1 = {};
}

void SimplifyPoses(Changes& changes) {
  changes.emplace_back(MoveToSet1);
  for (PoseNumbers PairNumbers::*pose : {&PairNumbers::pose_1, &PairNumbers::pose_2}) {
    changes.emplace_back([pose](SoakCase& c) { (c.pair.*pose).rotation.setIdentity(); });
    for (int axis = 0; axis < 3; ++axis) {
      changes.emplace_back([pose, axis](SoakCase& c) { (c.pair.*pose).translation[axis] = 0; });
    }
    for (const int digits : kDigits) {
      changes.emplace_back([pose, digits](SoakCase& c) {
        Vector3d& translation = (c.pair.*pose).translation;
        translation = Rounded(translation, digits);
      });
    }
  }
}

void SimplifySet(SetNumbers PairNumbers::*set, const PairNumbers& pair, Changes& changes) {
  const auto add = [&](const auto& change) {
    changes.emplace_back([set, change](SoakCase& c) { change(c.pair.*set); });
  };
  const std::size_t points = (pair.*set).points.size();
  add([](SetNumbers& s) { s.points.resize((s.points.size() + 1) / 2); });
  for (std::size_t i = points; i-- > 0;) {
    add([i](SetNumbers& s) {
      if (i < s.points.size()) s.points.erase(s.points.begin() + static_cast<std::ptrdiff_t>(i));
    });
  }
  add([](SetNumbers& s) { s.radius = 0; });
  add([](SetNumbers& s) { s.stretch.setIdentity(); });
  for (const int digits : kDigits) {
    add([digits](SetNumbers& s) { s.radius = Rounded(s.radius, digits); });
    add([digits](SetNumbers& s) { s.exponent = Rounded(s.exponent, digits); });
    for (int i = 0; i < 3; ++i) add([i, digits](SetNumbers& s) { s.lengths[i] = Rounded(s.lengths[i], digits); });
    for (std::size_t i = 0; i < points; ++i) {
      add([i, digits](SetNumbers& s) {
        if (i < s.points.size()) s.points[i] = Rounded(s.points[i], digits);
      });
    }
  }
}

Changes AllChanges(const SoakCase& soak_case) {
  Changes changes;
  LeaveOutFrames(soak_case.motion.size(), changes);
  SimplifyPoses(changes);
  SimplifySet(&PairNumbers::set_1, soak_case.pair, changes);
  SimplifySet(&PairNumbers::set_2, soak_case.pair, changes);
  return changes;
}

bool IsSame(const SoakCase& a, const SoakCase& b) {
  return a.growth_distance == b.growth_distance && a.motion.size() == b.motion.size() && Dump(a.pair) == Dump(b.pair);
}

bool StillFails(const SoakCase& candidate, const Fails& fails) try {
  return fails(candidate);
} catch (const std::invalid_argument&) {
  return false;
}

}  // namespace

SoakCase Shrink(SoakCase failing, const Fails& fails) {
  for (bool is_simpler = true; std::exchange(is_simpler, false);) {
    for (const Change& change : AllChanges(failing)) {
      SoakCase candidate = failing;
      change(candidate);
      candidate.growth_distance = 0;
      if (IsSame(candidate, failing) || !StillFails(candidate, fails)) continue;
      failing = std::move(candidate);
      is_simpler = true;
    }
  }
  return failing;
}

}  // namespace dgd_soak
