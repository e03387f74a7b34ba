#include "parity/judge.h"

#include <algorithm>
#include <cmath>

namespace dgd_test {
namespace {

/// Whether the supporting planes along the contact's normal are as far apart as it says.
bool IsCertified(const Truth& truth, const PairQuery& pair, const Contact& contact) {
  if (!contact.normal_b_to_a.allFinite() || !std::isfinite(contact.depth)) return false;
  const double length = contact.normal_b_to_a.norm();
  if (!(std::abs(length - 1) <= truth.tolerance)) return false;
  const double separation = PlaneSeparation(pair.A(), pair.B(), contact.normal_b_to_a / length);
  return std::abs(contact.depth - separation) <= truth.tolerance * truth.scale;
}

/// @return whether there is an answer to judge further.
bool JudgeSign(const Truth& truth, const std::vector<Contact>& contacts, bool must_answer, Verdict& verdict) {
  ++verdict.answers;
  if (contacts.empty()) {
    verdict.missing += must_answer ? 1 : 0;
    return false;
  }
  const double depth = Deepest(contacts).depth;
  verdict.wrong += (truth.IsApart() && depth <= 0) || (truth.Overlaps() && depth > 0) ? 1 : 0;
  return true;
}

}  // namespace

Verdict& Verdict::operator+=(const Verdict& other) {
  answers += other.answers;
  missing += other.missing;
  wrong += other.wrong;
  not_certified += other.not_certified;
  inexact += other.inexact;
  worst_apart = std::max(worst_apart, other.worst_apart);
  worst_overlap = std::max(worst_overlap, other.worst_overlap);
  return *this;
}

void JudgeClosestPoints(const Truth& truth, const PairQuery& pair, const std::vector<Contact>& contacts,
                        Verdict& verdict) {
  if (!JudgeSign(truth, contacts, true, verdict)) return;
  const Contact& deepest = Deepest(contacts);
  verdict.not_certified += IsCertified(truth, pair, deepest) ? 0 : 1;
  // Nothing that lies between what is proven from either side is an error.
  const double off = std::max({0.0, truth.distance.value - deepest.depth, deepest.depth - truth.distance.upper});
  const double error = std::isfinite(deepest.depth) ? off / truth.scale : 1;
  verdict.inexact += error > truth.tolerance ? 1 : 0;
  double& worst = truth.distance.value > 0 ? verdict.worst_apart : verdict.worst_overlap;
  worst = std::max(worst, error);
}

void JudgeContacts(const Truth& truth, const PairQuery& pair, const std::vector<Contact>& contacts, Verdict& verdict) {
  if (!JudgeSign(truth, contacts, truth.Overlaps(), verdict)) return;
  verdict.not_certified += IsCertified(truth, pair, Deepest(contacts)) ? 0 : 1;
}

}  // namespace dgd_test
