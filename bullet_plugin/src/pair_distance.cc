#include "pair_distance.h"

#include <type_traits>

#include "dgd/boxes_apart.h"
#include "dgd/signed_distance.h"
#include "pair_visit.h"

namespace dgd_bullet {
namespace {

/// Of the tolerance.
constexpr double kLeastGain = 0.1;

template <class Set>
constexpr bool kIsBox = std::is_same_v<Set, dgd::RoundedSet<dgd::Box<double>>>;

void Take(const dgd::SignedDistanceResult<double>& turned, dgd::Result<double>& result) {
  result.normal = turned.normal;
  result.separation = turned.separation;
  result.witness_1 = turned.witness_1;
  result.witness_2 = turned.witness_2;
}

bool TakeIfCertain(const dgd::SignedDistanceResult<double>& followed, dgd::Result<double>& result) {
  if (followed.status != dgd::Status::kOptimal && followed.status != dgd::Status::kSeparated) return false;
  result.status = followed.status;
  result.iterations = followed.iterations;
  Take(followed, result);
  return true;
}

}  // namespace

bool TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            dgd::WarmStart<double>& warm_start, dgd::Result<double>& result) {
  return VisitPair(
      shape_a, shape_b, settings,
      [&]<class SetA, class SetB>(const SetA& set_a, const SetB& set_b, const dgd::Settings<double>& for_pair) {
        dgd::WarmStart<double> follow;
        const dgd::SignedDistanceResult<double> turned =
            dgd::SignedDistance(set_a, shape_a.pose, set_b, shape_b.pose, result, &warm_start, for_pair, &follow);
        if (turned.status == dgd::Status::kInvalidInput) return false;
        // Whatever else its status, the separation along a normal is certain. A gain within the rounding of the shapes
        // is none: it would cost the witness points more.
        const double radius = set_a.radius + set_b.radius;
        const double size = set_a.core.Inradius() + set_b.core.Inradius() + radius;
        const double negligible = kLeastGain * for_pair.relative_tolerance * size;
        if (turned.separation > result.separation + negligible) Take(turned, result);
        if constexpr (!kIsErased<SetA>) {
          if (turned.status != dgd::Status::kOptimal || !(turned.separation + radius > negligible)) return false;
          warm_start = follow;
          return true;
        } else {
          return false;
        }
      });
}

bool FollowDistance(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                    dgd::WarmStart<double>& warm_start, dgd::Result<double>& result) {
  return VisitPair(shape_a, shape_b, settings,
                   [&]<class SetA, class SetB>([[maybe_unused]] const SetA& set_a, [[maybe_unused]] const SetB& set_b,
                                               [[maybe_unused]] const dgd::Settings<double>& for_pair) {
                     if constexpr (!kIsErased<SetA>) {
                       // Sharp bodies in contact overlap.
                       if (!(set_a.radius + set_b.radius > 0)) return false;
                       // Without a state, the growth distance tells sooner that polytopes are apart.
                       if (dgd::MinkowskiDifference<SetA, SetB>::kIsPolytope && warm_start.size == 0) return false;
                       return TakeIfCertain(
                           dgd::FollowDistance(set_a, shape_a.pose, set_b, shape_b.pose, for_pair, warm_start), result);
                     } else {
                       return false;
                     }
                   });
}

bool FollowContact(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                   double angular_tolerance, dgd::FaceHolder& holder, dgd::WarmStart<double>& warm_start,
                   dgd::FacingFaces<double>& facing, dgd::Result<double>& result) {
  return VisitPair(shape_a, shape_b, settings,
                   [&]<class SetA, class SetB>([[maybe_unused]] const SetA& set_a, [[maybe_unused]] const SetB& set_b,
                                               [[maybe_unused]] const dgd::Settings<double>& for_pair) {
                     // What only Bullet can evaluate shows no faces.
                     if constexpr (kIsErased<SetA>) {
                       return false;
                     } else if constexpr (kIsBox<SetA> && kIsBox<SetB>) {
                       const bool is_certain =
                           TakeIfCertain(dgd::FollowBoxes(set_a, shape_a.pose, set_b, shape_b.pose, for_pair,
                                                          angular_tolerance, holder, warm_start, facing),
                                         result);
                       if (is_certain) holder = dgd::HolderOf(facing);
                       return is_certain;
                     } else {
                       return holder != dgd::FaceHolder::kNone &&
                              TakeIfCertain(dgd::FollowFace(set_a, shape_a.pose, set_b, shape_b.pose, for_pair,
                                                            angular_tolerance, holder, warm_start, facing),
                                            result);
                     }
                   });
}

}  // namespace dgd_bullet
