// The generators of the catalogue, one a class, by what is hard about it; and what they share.
#pragma once

#include "support/hard/hard_case.h"
#include "support/pairs/random_pair.h"

namespace dgd_test::hard {

// Proportions and sizes: proportions.cc.
HardCase DrawNeedlesAndSheets(Random& random, int index);
HardCase DrawSizeRatios(Random& random, int index);
HardCase DrawMicrometres(Random& random, int index);
HardCase DrawKilometres(Random& random, int index);
HardCase DrawDeepInside(Random& random, int index);
HardCase DrawMargins(Random& random, int index);
HardCase DrawInThePlane(Random& random, int index);

// Poses: poses.cc.
HardCase DrawFarFromTheOrigin(Random& random, int index);
HardCase DrawNearlyCoincident(Random& random, int index);
HardCase DrawCoincident(Random& random, int index);
HardCase DrawIdentical(Random& random, int index);
HardCase DrawRoughRotations(Random& random, int index);
HardCase DrawSubnormalOffsets(Random& random, int index);
HardCase DrawSubnormalSizes(Random& random, int index);

// Vertices, edges and faces that meet: features.cc.
HardCase DrawTouchingFeatures(Random& random, int index);
HardCase DrawSlidingFaces(Random& random, int index);
HardCase DrawNearlyParallelEdges(Random& random, int index);

// Flat sets, and hulls that nearly are: flat_sets.cc.
HardCase DrawFlatAgainstSolid(Random& random, int index);
HardCase DrawFlatAgainstFlat(Random& random, int index);
HardCase DrawThinTriangles(Random& random, int index);
HardCase DrawDegenerateHulls(Random& random, int index);

// Tips, sides and rims: round_features.cc.
HardCase DrawConeTips(Random& random, int index);
HardCase DrawRims(Random& random, int index);

// Failures of other engines, from their public issues: known_failures.cc.
HardCase DrawKnownFailures(Random& random, int index);
int KnownFailureCount();
/// Engine and issue.
const char* NameOfKnownFailure(int index);

/// The types of space in turn.
SetType TypeOfSpace(int index);
/// Any type of space with an interior.
SetType RandomSolidType(Random& random);
/// Lengths near a metre; a third of them with a radius.
SetNumbers UnitSet(Random& random, SetType type);
SetNumbers Scaled(const SetNumbers& set, double factor);
/// Two flat sets without a radius have no growth distance: gives the first one a small one then.
void GiveInterior(PairNumbers& pair);
/// Places the pair in any way that random_pair.h knows; says what that tells.
HardCase PlacedAnyhow(Random& random, PairNumbers pair);
/// Turns and moves both sets, if only by the axes' permutations in half of the cases.
void MoveBoth(Random& random, PairNumbers& pair);
/// Zero in a third of the cases, else of either sign and of any size from `least` to `greatest`.
double TinyGap(Random& random, double least, double greatest);

}  // namespace dgd_test::hard
