// What two narrowphases say of the same pair in the same poses, against what is true.
#pragma once

#include <vector>

#include "plugin/bullet_oracle.h"
#include "plugin/pair_query.h"

namespace dgd_test {

/// What is true of a pair, and how exact an answer is asked for.
struct Truth {
  SignedDistance distance;  ///< Metres.
  double scale;      ///< What errors are relative to: the pair's size, or its distance if that is larger; metres.
  double tolerance;  ///< Relative.

  bool IsApart() const { return distance.value > tolerance * scale; }
  bool Overlaps() const { return distance.upper < -tolerance * scale; }
};

/// A narrowphase's answers to one kind of query, summed up. Errors are relative.
struct Verdict {
  int answers = 0;
  int missing = 0;        ///< Pairs without any answer, though they overlap or any distance was asked for.
  int wrong = 0;          ///< Overlap said to be none, or none said to be one.
  int not_certified = 0;  ///< Depths that the planes along the answer's own unit normal do not bear out.
  int inexact = 0;        ///< Distances or depths off by more than the tolerance.
  double worst_apart = 0, worst_overlap = 0;  ///< Of distances, and of depths.

  /// Nothing is false; and nothing is off by much. In deep overlaps of curved shapes a normal elsewhere may be better
  /// by as much (dgd/signed_distance.h).
  bool Holds() const {
    constexpr double kMuch = 0.01;
    return missing + wrong + not_certified == 0 && worst_apart <= kMuch && worst_overlap <= kMuch;
  }
  Verdict& operator+=(const Verdict& other);
};

/// Closest points over any distance: exact distances and depths.
void JudgeClosestPoints(const Truth& truth, const PairQuery& pair, const std::vector<Contact>& contacts,
                        Verdict& verdict);

/// Contacts as contactTest() gets them: none is missed of what is apart, depths need not be the least.
void JudgeContacts(const Truth& truth, const PairQuery& pair, const std::vector<Contact>& contacts, Verdict& verdict);

}  // namespace dgd_test
