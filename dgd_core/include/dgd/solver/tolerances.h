// The solver's small numbers, each with what it bounds.
#pragma once

#include <cmath>
#include <limits>

namespace dgd {

template <class S>
inline constexpr S kEpsilon = std::numeric_limits<S>::epsilon();

/// Square root of epsilon: the default relative gap (paper, Sec. IV-A). Written out because std::sqrt is not constexpr.
template <class S>
inline constexpr S kSqrtEpsilon = S(1.4901161193847656e-8);
template <>
inline constexpr float kSqrtEpsilon<float> = 3.4526698e-4f;

/// Smallest sum of radii, relative to the inradii of the cores, that the rounded inner approximation takes. Its edge
/// and vertex normals have an error of about epsilon * size / radius; below this, the radius goes into the support
/// function. Test: RayIntersection_TinyRadius_*.
template <class S>
inline constexpr S kMinConvexRadius = kSqrtEpsilon<S>;

/// Barycentric weights down to minus this are roundoff of a point on the feature's border and count as zero. They cost
/// at most this times the feature's size in primal feasibility.
template <class S>
inline constexpr S kWeightSlack = 16 * kEpsilon<S>;

/// Triangles with less area than this part of the square over their farthest corner, seen along the ray, are slivers:
/// plain differences and sums would cost their normal and their barycentric weights more than two digits.
/// Test: GrowthDistance.SteepTriangle_*.
template <class S>
inline constexpr S kSliver = S(0.05);

/// How far from the ray a sliver's point may lie, as a part of the sliver's reach across it: the roundoff of its
/// corners and its weights. A steep sliver magnifies it to the height, so that float, with fewer digits, spends fewer
/// of them. With 64 in double, too, pairs of the soak stalled that now converge; one float test had a bound that was
/// off by 3e-5 with 1800. Test: WarmStart.MovingPairs_*InFloat.
template <class S>
inline constexpr S kOffRay = (sizeof(S) == 8 ? 4096 : 64) * kEpsilon<S>;

/// Planes whose unit normal has a smaller part along the ray are steep: the height at which they meet the ray magnifies
/// the roundoff of their points by the inverse, so a flatter one is looked for. Test: GrowthDistance.SteepTriangle_*.
template <class S>
inline constexpr S kSteep = S(0.01);

/// Centres nearer than this part of the inradii coincide: the growth distance is then below it, and the direction
/// between the centres is roundoff.
template <class S>
inline constexpr S kCoincidence = kEpsilon<S>;

/// Sizes, in metres, between which products of four lengths, as barycentric weights and their heights are, are normal
/// numbers: the fourth roots of the least and of the largest number, with room for most of the digits; float, which has
/// none to spare, gives up a few, so that micrometres are in range. Below, results were seen that the certificate
/// refutes, and wrong ones to yes or no. Test: HardCases, subnormal_sizes.
template <class S>
inline constexpr S kLeastSize = S(1e-73);
template <>
inline constexpr float kLeastSize<float> = 4e-9f;
template <class S>
inline constexpr S kGreatestSize = S(1e73);
template <>
inline constexpr float kGreatestSize<float> = 8e7f;

/// Whether a vector has unit length, for assertions. True for NaN, which a query refuses where it ends.
template <class Vector>
bool IsUnitOrNan(const Vector& vector) {
  using S = typename Vector::Scalar;
  return !(std::abs(vector.squaredNorm() - 1) > 8 * kSqrtEpsilon<S>);
}

}  // namespace dgd
