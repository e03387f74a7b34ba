#include "mesh/mesh_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "bullet_conversions.h"
#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Sine of the angle within which directions count as one: above the rounding of normals and of flat meshes, far below
/// how far a ball is off its lowest point where a corner next to that stands for it.
constexpr double kMaxSine = 1e-4;

/// Least cosine to its triangle's normal of a ghost that is turned to the triangle's face: about 11 degrees. Of faces
/// that are tilted more, no more than a strip of two decimetres is within the contact distance, next to an edge that
/// has contacts of its own.
constexpr double kFromAbove = 0.996;

/// Places within this part of a triangle's size are one: where apps compute corners twice, they differ by rounding.
constexpr btScalar kSamePlace = btScalar(1e-4);

Vector3 Corner(const MeshTriangle& triangle, int corner) {
  return FromBullet(triangle.corners[static_cast<std::size_t>(corner)]);
}

/// Normal in the mesh's frame, twice the area long.
Vector3 AreaOf(const MeshTriangle& triangle) {
  const Vector3 origin = Corner(triangle, 0);
  return (Corner(triangle, 1) - origin).cross(Corner(triangle, 2) - origin);
}

/// Whether two unit vectors count as one.
bool AreAlike(const Vector3& a, const Vector3& b) {
  return a.dot(b) > 0 && a.cross(b).squaredNorm() <= kMaxSine * kMaxSine;
}

/// Longest extent along an axis of the mesh.
btScalar SizeOf(const MeshTriangle& triangle) {
  const btVector3 to_1 = (triangle.corners[1] - triangle.corners[0]).absolute();
  const btVector3 to_2 = (triangle.corners[2] - triangle.corners[0]).absolute();
  return btMax(to_1[to_1.maxAxis()], to_2[to_2.maxAxis()]);
}

bool IsNear(const btVector3& a, const btVector3& b, btScalar tolerance) {
  return btFabs(a.x() - b.x()) <= tolerance && btFabs(a.y() - b.y()) <= tolerance && btFabs(a.z() - b.z()) <= tolerance;
}

/// Whether a triangle has a corner at a place.
bool HasCorner(const MeshTriangle& triangle, const btVector3& place, btScalar tolerance) {
  return IsNear(triangle.corners[0], place, tolerance) || IsNear(triangle.corners[1], place, tolerance) ||
         IsNear(triangle.corners[2], place, tolerance);
}

/// The point of an edge, or corner, that is nearest to a place.
btVector3 NearestOn(const btVector3& from, const btVector3& to, const btVector3& place) {
  const btVector3 edge = to - from;
  const btScalar length_sq = edge.length2();
  if (!(length_sq > 0)) return from;
  return from + btClamped(edge.dot(place - from) / length_sq, btScalar(0), btScalar(1)) * edge;
}

/// Whether a place in its bounding box is on a triangle.
bool IsOn(const MeshTriangle& triangle, const btVector3& place, btScalar tolerance) {
  const btVector3 &a = triangle.corners[0], &b = triangle.corners[1], &c = triangle.corners[2];
  const btVector3 area = (b - a).cross(c - a);
  const btScalar length = area.length();
  if (!(length > 0)) return false;
  const btVector3 normal = area / length;
  if (!(btFabs(normal.dot(place - a)) <= tolerance)) return false;
  const auto is_inside = [&](const btVector3& from, const btVector3& to) {
    const btVector3 side = to - from;
    return side.cross(place - from).dot(normal) >= -tolerance * side.length();
  };
  return is_inside(a, b) && is_inside(b, c) && is_inside(c, a);
}

/// Whether a triangle that a place is on rises above it along a direction, beyond kMaxSine.
bool RisesAbove(const MeshTriangle& triangle, const btVector3& place, const Vector3& direction, btScalar tolerance) {
  for (const btVector3& corner : triangle.corners) {
    if (IsNear(corner, place, tolerance)) continue;
    const Vector3 to_corner = FromBullet(corner) - FromBullet(place);
    const double rise = direction.dot(to_corner);
    if (rise > 0 && rise * rise > kMaxSine * kMaxSine * to_corner.squaredNorm()) return true;
  }
  return false;
}

}  // namespace

void MeshContacts::Begin(const btTransform& mesh) {
  mesh_ = &mesh;
  rotation_ = FromBullet(mesh).rotation;
  triangles_.clear();
  normals_.clear();
  boxes_.clear();
  sorted_.clear();
  states_.clear();
  patches_.clear();
  contacts_.clear();
  links_.clear();
  to_turn_.clear();
}

int MeshContacts::AddTriangle(const btVector3* corners, int part, int index) {
  triangles_.push_back({{corners[0], corners[1], corners[2]}, part, index});
  const MeshTriangle& triangle = triangles_.back();
  const Vector3 area = rotation_ * AreaOf(triangle);
  const double length_sq = area.squaredNorm();
  normals_.push_back(length_sq > 0 ? Vector3(area / std::sqrt(length_sq)) : Vector3(Vector3::Zero()));
  Box box{corners[0], corners[0]};
  for (int i = 1; i < 3; ++i) {
    box.low.setMin(corners[i]);
    box.high.setMax(corners[i]);
  }
  DGD_ASSERT(boxes_.size() + 1 == triangles_.size() && states_.size() == boxes_.size());
  boxes_.push_back(box);
  states_.push_back(State::kNone);
  return triangles() - 1;
}

void MeshContacts::Add(int triangle, const dgd::ContactPatch<double>& patch, const Vector3& normal) {
  if (patch.size == 0) return;
  DGD_ASSERT(triangle >= 0 && triangle < triangles() && IsUnit(normal));
  const std::size_t begin = contacts_.size();
  for (std::size_t i = 0; i < static_cast<std::size_t>(patch.size); ++i) {
    const dgd::ContactPoint<double>& point = patch.points[i];
    contacts_.push_back({-normal, point.on_1, point.on_2, point.separation, triangle});
  }
  patches_.push_back({triangle, begin, contacts_.size(), false});
}

void MeshContacts::RemoveGhosts() {
  for (Patch& patch : patches_) ClassifyFace(patch);
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    if (patches_[i].counts) continue;
    if (sorted_.empty()) SortTriangles();
    ClassifyFeature(i);
  }
  CoverGhosts();
  std::size_t kept = 0;
  for (const Patch& patch : patches_) {
    if (!patch.counts) continue;
    for (std::size_t i = patch.begin; i < patch.end; ++i) contacts_[kept++] = contacts_[i];
  }
  DGD_ASSERT(kept <= contacts_.size());
  contacts_.resize(kept);
  patches_.clear();
}

void MeshContacts::DropSeamPoints(double equal_depth) {
  const auto is_deeper = [&](const MeshContact& deeper, const MeshContact& contact) {
    return deeper.separation < contact.separation - equal_depth && AreAlike(deeper.normal_on_b, contact.normal_on_b);
  };
  kept_.clear();
  for (const MeshContact& contact : contacts_) {
    const bool has_deeper =
        std::ranges::any_of(contacts_, [&](const MeshContact& other) { return is_deeper(other, contact); });
    if (!has_deeper || !IsOnSeam(contact)) kept_.push_back(contact);
  }
  contacts_.swap(kept_);
}

bool MeshContacts::IsOnSeam(const MeshContact& contact) const {
  const MeshTriangle& own = triangle(contact.triangle);
  const btVector3 place = mesh_->invXform(ToBullet(contact.on_b));
  const btScalar tolerance = kSamePlace * SizeOf(own);
  const auto is_on_border = [&](std::size_t from, std::size_t to) {
    return IsNear(NearestOn(own.corners[from], own.corners[to], place), place, tolerance);
  };
  if (!is_on_border(0, 1) && !is_on_border(1, 2) && !is_on_border(2, 0)) return false;
  const Vector3 normal = AreaOf(own).normalized();
  for (int i = 0; i < triangles(); ++i) {
    if (i == contact.triangle || !boxes_[static_cast<std::size_t>(i)].Contains(place, tolerance)) continue;
    const Vector3 other = AreaOf(triangle(i)).normalized();
    if (AreAlike(normal, normal.dot(other) < 0 ? Vector3(-other) : other) && IsOn(triangle(i), place, tolerance)) {
      return true;
    }
  }
  return false;
}

bool MeshContacts::HasContacts(int triangle) const {
  DGD_ASSERT(triangle >= 0 && triangle < triangles());
  return states_[static_cast<std::size_t>(triangle)] == State::kCounts;
}

void MeshContacts::SortTriangles() {
  DGD_ASSERT(!boxes_.empty() && sorted_.empty());
  btVector3 low = boxes_[0].low, high = low;
  widths_.setZero();
  for (const Box& box : boxes_) {
    low.setMin(box.low);
    high.setMax(box.low);
    widths_.setMax(box.high - box.low);
  }
  const btVector3 spread = high - low;
  row_axis_ = spread.maxAxis();
  const int next = (row_axis_ + 1) % 3, last = (row_axis_ + 2) % 3;
  along_axis_ = spread[next] > spread[last] ? next : last;
  first_row_ = low[row_axis_];
  row_width_ = btMax(widths_[row_axis_], btMax(spread[row_axis_] / btScalar(triangles()), btScalar(SIMD_EPSILON)));
  for (int i = 0; i < triangles(); ++i) {
    const btVector3& corner = boxes_[static_cast<std::size_t>(i)].low;
    sorted_.push_back({RowOf(corner[row_axis_]), corner[along_axis_], i});
  }
  std::sort(sorted_.begin(), sorted_.end(), [](const Sorted& a, const Sorted& b) {
    return std::tie(a.row, a.low, a.triangle) < std::tie(b.row, b.low, b.triangle);
  });
}

int MeshContacts::RowOf(btScalar place) const {
  return static_cast<int>(btClamped((place - first_row_) / row_width_, btScalar(-1), btScalar(triangles())) + 1);
}

void MeshContacts::ClassifyFace(Patch& patch) {
  DGD_ASSERT(patch.begin < patch.end && patch.end <= contacts_.size());
  Vector3 face = NormalOf(patch.triangle);
  const Vector3 normal = contacts_[patch.begin].normal_on_b;
  if (normal.dot(face) < 0) face = -face;
  if (!AreAlike(normal, face)) return;
  for (std::size_t i = patch.begin; i < patch.end; ++i) contacts_[i].normal_on_b = face;
  patch.counts = true;
  states_[static_cast<std::size_t>(patch.triangle)] = State::kCounts;
}

MeshContacts::Feature MeshContacts::HighestFeature(const MeshTriangle& triangle, const Vector3& direction) const {
  int highest = 0;
  for (const int corner : {1, 2}) {
    if (direction.dot(Corner(triangle, corner)) > direction.dot(Corner(triangle, highest))) highest = corner;
  }
  // Of corners that are all as high, as a thin triangle's, the one farther away.
  int other = highest;
  double longest_sq = 0;
  for (const int corner : {0, 1, 2}) {
    const Vector3 way = Corner(triangle, corner) - Corner(triangle, highest);
    const double fall = direction.dot(way), length_sq = way.squaredNorm();
    if (!(length_sq > longest_sq) || !(fall * fall <= kMaxSine * kMaxSine * length_sq)) continue;
    other = corner;
    longest_sq = length_sq;
  }
  return {{highest, other}, other == highest ? 1 : 2};
}

void MeshContacts::ClassifyFeature(std::size_t index) {
  DGD_ASSERT(index < patches_.size() && sorted_.size() == triangles_.size());
  Patch& patch = patches_[index];
  const MeshTriangle& own = triangle(patch.triangle);
  const Vector3 normal = rotation_.transpose() * contacts_[patch.begin].normal_on_b;
  const btScalar tolerance = kSamePlace * SizeOf(own);
  const Feature feature = HighestFeature(own, normal);
  const btVector3& first = own.corners[static_cast<std::size_t>(feature.corners[0])];
  const btVector3& second = own.corners[static_cast<std::size_t>(feature.corners[1])];
  // The contact's place on the feature: witness points of bodies deep inside each other are off both.
  const btVector3 seen = NearestOn(first, second, mesh_->invXform(ToBullet(contacts_[patch.begin].on_b)));
  const auto hides = [&](const MeshTriangle& other) {
    if (HasCorner(other, first, tolerance) && (feature.size == 1 || HasCorner(other, second, tolerance))) {
      return RisesAbove(other, first, normal, tolerance);
    }
    // Some meshes have triangles that meet between corners.
    return IsOn(other, seen, tolerance) && RisesAbove(other, seen, normal, tolerance);
  };
  State& state = states_[static_cast<std::size_t>(patch.triangle)];
  State found = State::kCounts;
  const btScalar from = seen[along_axis_] - widths_[along_axis_] - tolerance;
  const int last_row = RowOf(seen[row_axis_] + tolerance);
  for (int row = RowOf(seen[row_axis_] - widths_[row_axis_] - tolerance); row <= last_row && found != State::kCovered;
       ++row) {
    auto next = std::lower_bound(sorted_.begin(), sorted_.end(), std::tie(row, from),
                                 [](const Sorted& a, const auto& b) { return std::tie(a.row, a.low) < b; });
    for (; next != sorted_.end() && next->row == row && next->low <= seen[along_axis_] + tolerance; ++next) {
      const int i = next->triangle;
      if (!boxes_[static_cast<std::size_t>(i)].Contains(seen, tolerance)) continue;
      if (i == patch.triangle || !hides(triangle(i))) continue;
      found = HasContacts(i) ? State::kCovered : State::kGhost;
      if (found == State::kCovered) break;
      links_.push_back({patch.triangle, i});
    }
  }
  patch.counts = found == State::kCounts;
  // Contacts along another normal that count stay valid.
  if (state != State::kCounts) state = found;
  if (patch.counts) return;
  const Vector3 area = AreaOf(own);
  const double height = normal.dot(area);
  if (height * height > kFromAbove * kFromAbove * area.squaredNorm()) to_turn_.push_back(patch.triangle);
}

void MeshContacts::CoverGhosts() {
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const Link& link : links_) {
      State& ghost = states_[static_cast<std::size_t>(link.ghost)];
      const State above = states_[static_cast<std::size_t>(link.above)];
      if (ghost != State::kGhost || (above != State::kCounts && above != State::kCovered)) continue;
      ghost = State::kCovered;
      goes_on = true;
    }
  }
  for (int i = 0; i < triangles(); ++i) {
    if (states_[static_cast<std::size_t>(i)] == State::kGhost) to_turn_.push_back(i);
  }
  std::sort(to_turn_.begin(), to_turn_.end());
  to_turn_.erase(std::unique(to_turn_.begin(), to_turn_.end()), to_turn_.end());
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
