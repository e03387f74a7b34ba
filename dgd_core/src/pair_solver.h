// The queries of two types of sets, compiled in a file of their own for each pair of types.
#pragma once

#include "dgd/any_set.h"
#include "dgd/growth_distance.h"
#include "dgd/signed_distance.h"

namespace dgd {

using PolytopeSet = RoundedSet<PolytopeCore>;
using CurvedSet = RoundedSet<CurvedCore>;
using CustomSet = RoundedSet<CustomCore>;

/// Instantiates the queries of two types of sets: see any_set.h.
/// @param kExtern  `extern` where another file does so; else empty.
#define DGD_INSTANTIATE_QUERIES(kExtern, Set1, Set2)                                                                 \
  kExtern template Result<double> GrowthDistance(const Set1&, const Pose<double>&, const Set2&, const Pose<double>&, \
                                                 const Settings<double>&, WarmStart<double>*, const NoObserver&&);   \
  kExtern template CollisionResult<double> DetectCollision(const Set1&, const Pose<double>&, const Set2&,            \
                                                           const Pose<double>&, const Settings<double>&,             \
                                                           WarmStart<double>*);                                      \
  kExtern template SignedDistanceResult<double> SignedDistance(                                                      \
      const Set1&, const Pose<double>&, const Set2&, const Pose<double>&, const Result<double>&,                     \
      const WarmStart<double>*, const Settings<double>&, WarmStart<double>*);                                        \
  kExtern template SignedDistanceResult<double> SignedDistance(const Set1&, const Pose<double>&, const Set2&,        \
                                                               const Pose<double>&, const Settings<double>&,         \
                                                               WarmStart<double>*);                                  \
  kExtern template SignedDistanceResult<double> UpdateDistance(const Set1&, const Pose<double>&, const Set2&,        \
                                                               const Pose<double>&, const Settings<double>&,         \
                                                               WarmStart<double>&);

DGD_INSTANTIATE_QUERIES(extern, PolytopeSet, PolytopeSet)
DGD_INSTANTIATE_QUERIES(extern, PolytopeSet, CurvedSet)
DGD_INSTANTIATE_QUERIES(extern, CurvedSet, PolytopeSet)
DGD_INSTANTIATE_QUERIES(extern, CurvedSet, CurvedSet)
DGD_INSTANTIATE_QUERIES(extern, CustomSet, CustomSet)

}  // namespace dgd
