// Options of the narrowphase. One value per dispatcher; copied when the narrowphase is made, never read again.
#pragma once

#include "dgd_bullet/linkage.h"

struct btCollisionObjectWrapper;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What the bodies' surfaces are.
enum class GeometryMode {
  kBullet,  ///< What Bullet sees: each shape's core, rounded by its margin; boxes of full size with sharp edges.
  kSharp,  ///< No margins: cylinders of full size with sharp edges, hulls, cones and triangles as they are. Spheres and
           ///< capsules keep their radius.
};

/// An observer of the pairs of convex shapes, called before the narrowphase solves each. Recorder
/// (dgd_bullet/recorder.h) is one.
class PairObserver {
 public:
  /// A pair is about to be solved, its bodies in Bullet's order. Several threads may call this at once. The wrappers
  /// end with the call.
  virtual void OnPair(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1) noexcept = 0;

 protected:
  ~PairObserver() = default;
};

/// Writes the message and a line's end to the standard error stream.
DGD_BULLET_EXPORT void PrintToStandardError(const char* message) noexcept;

/// The options of one dispatcher.
struct Options {
  /// Relative gap between the two bounds of the growth distance at which a query stops; dimensionless, > 0. The depth
  /// that a contact reports is certified for any value: it only bounds how far the normal and the witness points
  /// are from the optimum. Polytopes end at rounding error regardless.
  double relative_tolerance = 1e-8;

  /// Iterations of the solver before the pair is handed to Bullet's own GJK/EPA (counted as a fallback); >= 1.
  int max_iterations = 100;

  /// Hand over all points of the touching features in one step (at most patch_size), and drop cached points which that
  /// patch no longer has. Off: one point a step, and Bullet's own accumulation over several steps.
  bool contact_patch = true;

  /// Points of a patch at most, 1 to 4: the deepest, then those that span most area. Fewer cost less in Bullet's
  /// solver, and let bodies rock.
  int patch_size = 4;

  /// Distance up to which bodies get contacts; metres, >= 0. 0 stands for each manifold's breaking threshold, which is
  /// Bullet's own measure (2 cm for large bodies). Larger values hand over contacts earlier, which Bullet's solver
  /// keeps open until they close; points in manifolds that are not the pair's own never exceed the threshold. In a
  /// dynamics world, bodies that approach each other get contacts only if they meet within the time step, and those
  /// that rebound (combined restitution above 0) only where they touch or will within it.
  double contact_distance = 0;

  /// What the bodies' surfaces are. Bounding boxes stay Bullet's, margins included, in either mode.
  GeometryMode geometry_mode = GeometryMode::kBullet;

  /// Points that are still farther apart than the contact distance are handed over, in a dynamics world, if the bodies'
  /// motion makes them touch within the time step: fast impacts are met before the bodies overlap. Needs contact_patch.
  /// contactTest() and its like never get such points. Off: fast bodies overlap first, or tunnel.
  /// Physics: a sweep proves whether bodies meet, so that those that pass by are not touched; restitution is that of
  /// the moment of touching (tests/physics: restitution, near misses).
  bool speculative_contacts = true;

  /// Contacts of faces that stick are anchored where they stuck: Bullet's solver corrects what they have slipped by
  /// since, within the friction cone, and piles do not creep: the blocks of scenes/pyramid_28.json move by 37 mm in a
  /// minute without, 1.3 mm with it (float, without keep_resting_contacts). Off: friction opposes speed only, as with
  /// Bullet. Needs contact_patch.
  /// Physics: the correction is only the slip that the solver left of contacts that have stuck for two steps, up to a
  /// hundredth of the breaking threshold; not what rolls or slides, nor what a surface's own velocity, a callback or an
  /// app moves (tests/physics: slide, swing_force, taps, belt, platform, feeder, teleport).
  bool friction_anchors = true;

  /// The contact point that carried most in the last step comes first in its manifold, the others around the patch, as
  /// Bullet's solver leaves least undone (src/manifold/point_order.h). Off: a patch's own order.
  /// Physics: points and distances stay the same. Stacks of small boxes and high towers rock and sway less. Links
  /// of multibodies and contacts on what cannot move keep their order.
  bool order_points_by_impulse = true;

  /// Bodies that have not moved by more than a thousandth of the breaking threshold (20 micrometres for large ones)
  /// since their contacts were found recycle them, at a fifth of the cost: only distances are updated. So do bodies on
  /// each other's faces that have moved together: by no more than a twelfth of the threshold against each other, nor by
  /// more than leaves each distance within a two-thousandth of it. Their normal turns with the face. In manifolds of
  /// the pair's own only; needs contact_patch and warm_start. Physics: no distance is off by more than 10 micrometres
  /// for large bodies, no place by more than 1.6 mm, along the face.
  bool keep_resting_contacts = true;

  /// Start each step's query of a pair from its last result. Off: the result depends on nothing but shapes, poses and
  /// the manifold, so that a world whose bodies and manifolds have been saved and restored goes on bit by bit as
  /// before; pairs that stay near each other then cost about twice the time.
  bool warm_start = true;

  /// A pair whose bounding boxes overlap has a manifold from its first step to its last, with or without contacts, as
  /// with Bullet. Off: from its second step on it has one only while it touches and for a step after, or next to a
  /// kinematic body, by which Bullet wakes the other. Bullet looks at each pair's manifold three times a step: without
  /// empty ones a step of 500 falling polytopes takes 0.8 of the time. An app that lists manifolds then sees fewer, in
  /// another order. With Bullet's own threads, only where that is built with BT_THREADSAFE. Needs warm_start.
  bool keep_empty_manifolds = true;

  /// Fill Statistics::pairs. Threads then share counters; without it, none are touched.
  bool count_pairs = false;

  /// The observer of all pairs that Bullet processes, triangles of meshes among them, or null. It is not owned, and
  /// must outlive the dispatcher.
  PairObserver* pair_observer = nullptr;

  /// Called when the growth distance does not solve a call, for each of the reasons in FallbackCounts once: one line,
  /// without its end, that names the two types of shapes and the reason. All later ones are only counted. Called by
  /// whichever thread meets it, in the middle of a step. Null: silence.
  void (*on_first_fallback)(const char* message) noexcept = PrintToStandardError;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
