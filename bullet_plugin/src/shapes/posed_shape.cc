#include "shapes/posed_shape.h"

#include <cmath>
#include <concepts>

#include "dgd/assert.h"

namespace dgd_bullet {
namespace {

/// Centres of bodies that touch are so near to each other where each is straight behind the contact, as parts of the
/// distance that the balls about them have then.
constexpr double kMostStraight = 1.5;

template <class... Cores>
bool IsOneOf(const dgd::AnySet& set) {
  const auto* polytope = set.AsPolytope();
  return polytope != nullptr &&
         polytope->core.Visit([]<class Core>(const Core&) { return (std::same_as<Core, Cores> || ...); });
}

double InradiusOf(const dgd::AnySet& set) { return set.CoreInradius() + set.Radius(); }

void MoveCenterNear(const Vector3& point, PosedShape& shape) {
  shape.set.MoveCenterNear(shape.pose.rotation.transpose() * (point - shape.pose.translation));
}

}  // namespace

Vector3 CenterOf(const PosedShape& shape) { return shape.pose * shape.set.Center(); }

Vector3 SupportPoint(const PosedShape& shape, const Vector3& direction) {
  DGD_ASSERT(!(std::abs(direction.squaredNorm() - 1) > 1e-3));
  const Vector3 local = shape.pose.rotation.transpose() * direction;
  return shape.pose * shape.set.CoreSupport(local) + shape.set.Radius() * direction;
}

bool TouchAlongCenters(const PosedShape& shape_a, const PosedShape& shape_b) {
  const auto is_ball = IsOneOf<dgd::Point<double>>;
  const auto is_thin = IsOneOf<dgd::Point<double>, dgd::Segment<double>, dgd::Triangle<double>>;
  return (is_ball(shape_a.set) && is_thin(shape_b.set)) || (is_thin(shape_a.set) && is_ball(shape_b.set));
}

Contact ContactAlongCenters(const PosedShape& shape_a, const PosedShape& shape_b) {
  const Vector3 center_a = CenterOf(shape_a), center_b = CenterOf(shape_b);
  const double distance = (center_b - center_a).norm(), radii = shape_a.set.Radius() + shape_b.set.Radius();
  Contact contact;
  if (!(distance > dgd::kCoincidence<double> * radii && std::isfinite(distance + radii))) return contact;
  contact.status = dgd::Status::kOptimal;
  contact.iterations = 1;
  contact.lower_bound = contact.upper_bound = distance / radii;
  contact.normal = (center_b - center_a) / distance;
  contact.separation = distance - radii;
  contact.witness_1 = center_a + shape_a.set.Radius() * contact.normal;
  contact.witness_2 = contact.witness_1 + contact.separation * contact.normal;
  return contact;
}

void MoveCentersTogether(PosedShape& shape_a, PosedShape& shape_b) {
  const bool moves_a = shape_a.set.MovesCenter(), moves_b = shape_b.set.MovesCenter();
  if (!moves_a && !moves_b) return;
  // Both move from where they were, so that the order of the two does not matter.
  const Vector3 center_a = CenterOf(shape_a), center_b = CenterOf(shape_b);
  if (moves_a) MoveCenterNear(center_b, shape_a);
  if (moves_b) MoveCenterNear(center_a, shape_b);
  if (!moves_a || !moves_b) return;
  // Two long bodies that cross are now near each other's middle, which may be beyond where they meet: that is between.
  const Vector3 moved_a = CenterOf(shape_a), moved_b = CenterOf(shape_b);
  const double reach = kMostStraight * (InradiusOf(shape_a.set) + InradiusOf(shape_b.set));
  if ((moved_b - moved_a).squaredNorm() <= reach * reach) return;
  const Vector3 between = (moved_a + moved_b) / 2;
  MoveCenterNear(between, shape_a);
  MoveCenterNear(between, shape_b);
}

}  // namespace dgd_bullet
