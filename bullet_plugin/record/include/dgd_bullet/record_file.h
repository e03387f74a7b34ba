// The queries of a narrowphase, as a file: shapes once, then pairs of them in their poses, step by step. Recorder
// (dgd_bullet/recorder.h) writes it, ReadRecord() reads it; neither the file nor this header depends on Bullet.
//
// Numbers are little-endian; an integer is unsigned and of 4 bytes, a count of 8; a real is a float or a double, as
// Bullet was. The file is a header and blocks, in any number, of two kinds:
//
//   header   "DGDRECRD", integer version (1), integer bytes of a real (4 or 8),
//            counts of shapes, of steps, of pairs and of pairs left out, checksum.
//            The counts are all ones in a file that was never closed.
//   block    integer kind, integer bytes of content, content, checksum
//   kind 1   a shape, the next of its number from 0: integer core, double radius, doubles as RecordedShape says
//   kind 2   pairs of one step: count number of the step, then for each pair integers body pair, shape 1, shape 2,
//            and for either shape 9 reals of its rotation, by rows, and 3 of its translation
//
// A checksum is FNV-1a of 64 bits, of all bytes of its header or block before it.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {

/// core + ball(radius), in its own frame: the geometry that Bullet's GJK sees. Metres; round cores stand along z.
struct RecordedShape {
  enum class Core : std::uint8_t {
    kPoint,     ///< The origin: a sphere.
    kSegment,   ///< Half length: a capsule.
    kTriangle,  ///< Three corners.
    kBox,       ///< Three half extents.
    kCylinder,  ///< Radius, half height.
    kCone,      ///< Radius of the base, height; the origin is half-way up.
    kHull,      ///< Points whose hull it is, at least one.
  };
  Core core = Core::kPoint;
  double radius = 0;
  std::vector<double> numbers;  ///< The numbers in the core's line; for points, all their coordinates in a row.
};

/// The pose of a shape's frame in the world: x_world = rotation * x_local + translation.
struct RecordedPose {
  std::array<double, 9> rotation;  ///< Row by row.
  std::array<double, 3> translation;
};

struct RecordedPair {
  std::uint64_t step;
  std::uint32_t body_pair;  ///< Number of the two bodies: the same from step to step.
  std::uint32_t shape_1, shape_2;
  RecordedPose pose_1, pose_2;
};

struct Record {
  int real_bytes = 0;  ///< Bytes of a real of the Bullet that was recorded: 4 for float, 8 for double.
  std::vector<RecordedShape> shapes;
  std::vector<RecordedPair> pairs;  ///< Pairs in the order of the queries.
  std::uint64_t left_out = 0;       ///< Pairs that could not be recorded; see Recorder.
  /// Why this is not all that the file should hold: it is damaged, and what follows was not read; or it was not closed.
  std::optional<std::string> problem;
};

/// Throws std::runtime_error, naming the file, if it cannot be opened or is no record. What is wrong behind the header
/// is reported by Record::problem, with the byte where it is.
DGD_BULLET_EXPORT Record ReadRecord(const std::string& path);
/// @param name  For messages.
DGD_BULLET_EXPORT Record ReadRecord(std::istream& file, const std::string& name);

}  // namespace dgd_bullet
