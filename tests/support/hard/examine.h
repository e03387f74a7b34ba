// The solver's answers to one hard case, and the judge's word on each.
#pragma once

#include <string>

#include "support/hard/hard_case.h"

namespace dgd_test {

enum class Verdict {
  kCertified,  ///< Optimal, and the certificate holds within the limits of rounding.
  kDeclined,   ///< The status says why not, or the set's constructor did; what bounds it gives are valid.
  kRefuted,    ///< Something it says is false.
};
const char* NameOf(Verdict verdict);

struct Examination {
  Verdict growth_distance = Verdict::kCertified;
  /// Overlap where the sets are apart, or the opposite, by more than the stated tolerance: rounding of the pair's
  /// coordinates.
  bool is_wrong_yes_no = false;
  bool is_undecided_yes_no = false;  ///< Neither yes, no nor "touching".
  double relative_gap = 0;           ///< The certificate's.
  double shortfall = 0;  ///< The same as a length: how far the plane lies before the witness, of the pair's size.
  double primal_infeasibility = 0;  ///< Of the pair's size.
  int iterations = 0;
  double microseconds = 0;  ///< Of the growth distance: the least of three.
  std::string remarks;      ///< Why not certified, and what is wrong; one line each.
};

/// Asks for the growth distance and for yes or no, cold, default settings, in scalar S (which the numbers are rounded
/// to first), and judges both: the growth distance by its certificate, yes or no by the proven distance (in the plane,
/// by the growth distance), and either by what the construction says.
template <class S>
Examination Examine(const HardClass& hard_class, const HardCase& hard_case);

/// Metres: how far from touching a pair may be called overlapping or apart when it is the other. Of coordinates up to
/// `reach` metres.
template <class S>
double YesNoTolerance(double reach, double pose_error);

}  // namespace dgd_test
