#include "run/trajectory_reader.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kPrefix = 10;  // Bytes: magic number, version of the format, length of the dictionary.

// Numbers of a row: one body in one sample.
enum Row { kTime = 0, kPosition = 1, kOrientation = 4, kVelocity = 8, kRowSize = 14 };
constexpr std::size_t kRowBytes = kRowSize * sizeof(double);

// NumPy writes blanks, and no comma after the last column.
std::string WithoutBlanks(std::string_view text) {
  std::string dense;
  for (const char letter : text) {
    if (letter == ' ' || letter == '\n') continue;
    if (letter == ']' && dense.ends_with(',')) dense.pop_back();
    dense += letter;
  }
  return dense;
}

// The value of a key, up to where `end` begins; empty if there is none.
std::string_view ValueOf(std::string_view dictionary, std::string_view key, std::string_view end) {
  const std::size_t begin = dictionary.find(key);
  if (begin == std::string_view::npos) return {};
  const std::string_view value = dictionary.substr(begin + key.size());
  const std::size_t length = value.find(end);
  return length == std::string_view::npos ? std::string_view{} : value.substr(0, length);
}

// "(11,2)": samples and bodies. False if it is anything else.
bool ParseShape(std::string_view text, std::size_t& samples, std::size_t& bodies) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, samples);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ',') return false;
  const auto second = std::from_chars(first.ptr + 1, end, bodies);
  return second.ec == std::errc() && second.ptr == end;
}

// A piece of a file that may be anything, for a message.
std::string Printable(std::string_view text) {
  constexpr std::size_t kMost = 200;
  std::string printable(text.substr(0, kMost));
  std::ranges::replace_if(
      printable, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  return text.size() <= kMost ? printable : printable + "...";
}

template <class Vector>
std::string ToText(const Vector& vector) {
  std::ostringstream text;
  text << '(' << vector[0];
  for (Eigen::Index i = 1; i < vector.size(); ++i) text << ", " << vector[i];
  text << ')';
  return text.str();
}

}  // namespace

std::vector<NpyFile::Column> TrajectoryColumns() {
  return {{"time"},
          {"position", false, 3},
          {"orientation", false, 4},
          {"velocity", false, 3},
          {"angular_velocity", false, 3}};
}

TrajectoryReader::TrajectoryReader(const std::filesystem::path& file) : file_(file), stream_(file, std::ios::binary) {
  if (!stream_) Fail("cannot be opened");
  ReadHead();
  ReadTimes();
}

void TrajectoryReader::ReadHead() {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file_, error);
  if (error) Fail("cannot be read: " + error.message());
  std::string prefix(kPrefix, '\0');
  stream_.read(prefix.data(), kPrefix);
  if (!stream_ || !prefix.starts_with(kMagic)) Fail("is no .npy file: it does not begin with NumPy's magic number");
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(prefix[i])); };
  if (byte(6) != 1) {
    Fail("has version " + std::to_string(byte(6)) + " of the .npy format, and only version 1 is read");
  }
  const std::size_t length = byte(8) + 256 * byte(9);
  data_ = kPrefix + length;
  if (size < data_) {
    Fail("is cut off: its head takes " + std::to_string(data_) + " bytes, and it has " + std::to_string(size));
  }
  std::string text(length, '\0');
  stream_.read(text.data(), static_cast<std::streamsize>(length));
  if (!stream_) Fail("cannot be read");
  ParseHead(WithoutBlanks(text), size - data_);
}

void TrajectoryReader::ParseHead(const std::string& head, std::uintmax_t data_size) {
  const std::string_view columns = ValueOf(head, "'descr':", ",'fortran_order'");
  const std::string expected = WithoutBlanks(NpyFile::Description(TrajectoryColumns()));
  if (columns != expected) {
    Fail("is no trajectory: its columns are " + Printable(columns.empty() ? head : columns) + ", and not " + expected);
  }
  const std::string_view shape = ValueOf(head, "'shape':(", ")");
  if (head.find("'fortran_order':False") == std::string::npos || !ParseShape(shape, samples_, bodies_)) {
    Fail("is no trajectory: its head is " + Printable(head) + ", without a shape (samples, bodies) in C order");
  }
  if (samples_ == 0 || bodies_ == 0) Fail("has no samples: its shape is (" + Printable(shape) + ")");
  // By division, since the product of numbers from a file may overflow.
  if (samples_ > data_size / kRowBytes / bodies_) {
    Fail("is cut off: it counts " + std::to_string(samples_) + " samples of " + std::to_string(bodies_) +
         " bodies of " + std::to_string(kRowBytes) + " bytes each, and has " + std::to_string(data_size) +
         " bytes of them");
  }
}

void TrajectoryReader::ReadTimes() {
  times_.resize(samples_);
  for (std::size_t i = 0; i < samples_; ++i) {
    Read(data_ + i * bodies_ * kRowBytes, &times_[i], 1);
    const bool is_next = std::isfinite(times_[i]) && (i == 0 || times_[i] > times_[i - 1]);
    if (is_next) continue;
    std::ostringstream complaint;
    complaint << "the time of sample " << i << " is " << times_[i] << " s";
    if (i > 0) complaint << ", after " << times_[i - 1] << " s";
    Fail(complaint.str());
  }
}

std::size_t TrajectoryReader::NearestSample(double time) const {
  const auto next = std::ranges::lower_bound(times_, time);
  const std::size_t last = times_.size() - 1;
  const std::size_t after = std::min(static_cast<std::size_t>(next - times_.begin()), last);
  const std::size_t before = after == 0 || next == times_.end() ? after : after - 1;
  const std::size_t nearest = time - times_[before] < times_[after] - time ? before : after;
  const double interval = last == 0 ? 0 : nearest == 0 ? times_[1] - times_[0] : times_[nearest] - times_[nearest - 1];
  if (std::abs(time - times_[nearest]) <= interval) return nearest;
  std::ostringstream complaint;
  complaint << "has no sample at " << time << " s: its times are from " << times_.front() << " to " << times_.back()
            << " s";
  Fail(complaint.str());
}

Snapshot TrajectoryReader::At(std::size_t sample) {
  constexpr double kFarthest = 1e9;        // m
  constexpr double kUnitTolerance = 1e-3;  // Of a quaternion's norm, which Bullet in float has to 1e-6.
  std::vector<double> rows(bodies_ * kRowSize);
  Read(data_ + sample * bodies_ * kRowBytes, rows.data(), rows.size());
  Snapshot state{times_[sample], {}, {}};
  for (std::size_t body = 0; body < bodies_; ++body) {
    const double* const row = &rows[body * kRowSize];
    const Eigen::Map<const Vector3d> position(row + kPosition), velocity(row + kVelocity);
    const Eigen::Map<const Eigen::Quaterniond> orientation(row + kOrientation);
    const auto fail = [&](const char* name, const std::string& value, const char* reason) {
      Fail(std::string("the ") + name + " of body " + std::to_string(body) + " in sample " + std::to_string(sample) +
           " is " + value + ", which is " + reason);
    };
    // Each comparison is false for NaN.
    if (!(position.norm() <= kFarthest)) {
      fail("position", ToText(position), "not finite, or too far away");
    }
    if (!(std::abs(orientation.norm() - 1) <= kUnitTolerance)) {
      fail("orientation", ToText(orientation.coeffs()), "no unit quaternion");
    }
    if (!std::isfinite(velocity.squaredNorm())) fail("velocity", ToText(velocity), "not finite, or too fast");
    state.poses.push_back({orientation.normalized().toRotationMatrix(), position});
    state.speeds.push_back(velocity.norm());
  }
  return state;
}

void TrajectoryReader::Read(std::size_t offset, double* numbers, std::size_t size) {
  stream_.seekg(static_cast<std::streamoff>(offset));
  stream_.read(reinterpret_cast<char*>(numbers), static_cast<std::streamsize>(size * sizeof(double)));
  if (!stream_) Fail("cannot be read at byte " + std::to_string(offset));
}

void TrajectoryReader::Fail(const std::string& complaint) const { throw SceneError(file_.string() + ": " + complaint); }

}  // namespace dgd_demos
