#include "pipeline/pair_distance.h"

#include <algorithm>

#include "dgd/boxes_apart.h"

namespace dgd_bullet {
namespace {

/// Of the tolerance.
constexpr double kLeastGain = 0.1;

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

bool IsCustom(const PosedShape& shape_a, const PosedShape& shape_b) {
  return shape_a.set.IsCustom() || shape_b.set.IsCustom();
}

}  // namespace

bool TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            dgd::WarmStart<double>& warm_start, dgd::Result<double>& result) {
  dgd::WarmStart<double> follow;
  const dgd::SignedDistanceResult<double> turned =
      dgd::SignedDistance(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, result, &warm_start, settings, &follow);
  if (turned.status == dgd::Status::kInvalidInput) return false;
  // Whatever else its status, the separation along a normal is certain. A gain within the rounding of the shapes is
  // none: it would cost the witness points more.
  const double tolerance = std::max({settings.relative_tolerance, shape_a.set.Accuracy(), shape_b.set.Accuracy()});
  const double radius = shape_a.set.Radius() + shape_b.set.Radius();
  const double size = shape_a.set.CoreInradius() + shape_b.set.CoreInradius() + radius;
  const double negligible = kLeastGain * tolerance * size;
  if (turned.separation > result.separation + negligible) Take(turned, result);
  if (IsCustom(shape_a, shape_b)) return false;
  if (turned.status != dgd::Status::kOptimal || !(turned.separation + radius > negligible)) return false;
  warm_start = follow;
  return true;
}

bool FollowDistance(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                    dgd::WarmStart<double>& warm_start, dgd::Result<double>& result) {
  if (IsCustom(shape_a, shape_b)) return false;
  // Sharp bodies in contact overlap.
  if (!(shape_a.set.Radius() + shape_b.set.Radius() > 0)) return false;
  // Without a state, the growth distance tells sooner that polytopes are apart.
  const bool are_polytopes = shape_a.set.AsPolytope() != nullptr && shape_b.set.AsPolytope() != nullptr;
  if (are_polytopes && warm_start.size == 0) return false;
  return TakeIfCertain(dgd::FollowDistance(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, settings, warm_start),
                       result);
}

bool FollowContact(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                   double angular_tolerance, dgd::FaceHolder& holder, dgd::WarmStart<double>& warm_start,
                   dgd::FacingFaces<double>& facing, dgd::Result<double>& result) {
  const dgd::Box<double>*box_a = shape_a.set.AsBox(), *box_b = shape_b.set.AsBox();
  if (box_a != nullptr && box_b != nullptr) {
    const dgd::RoundedSet<dgd::Box<double>> set_a{*box_a, shape_a.set.Radius()}, set_b{*box_b, shape_b.set.Radius()};
    const bool is_certain = TakeIfCertain(dgd::FollowBoxes(set_a, shape_a.pose, set_b, shape_b.pose, settings,
                                                           angular_tolerance, holder, warm_start, facing),
                                          result);
    if (is_certain) holder = dgd::HolderOf(facing);
    return is_certain;
  }
  // What only Bullet can evaluate shows no faces.
  if (holder == dgd::FaceHolder::kNone || IsCustom(shape_a, shape_b)) return false;
  return TakeIfCertain(dgd::FollowFace(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, settings,
                                       angular_tolerance, holder, warm_start, facing),
                       result);
}

}  // namespace dgd_bullet
