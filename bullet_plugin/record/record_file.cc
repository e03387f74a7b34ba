#include "dgd_bullet/record_file.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "record_format.h"

namespace dgd_bullet {
namespace {

/// Blocks are written at a megabyte; a hull's may be larger. More than this is damage, not data.
constexpr std::uint32_t kLargestBlock = 1U << 30;

/// What a block holds that its checksum does not vouch for, or a file that ends within one.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether a core may have so many numbers.
bool IsCountOf(RecordedShape::Core core, std::size_t count) {
  constexpr std::size_t kPointSize = 3;
  switch (core) {
    case RecordedShape::Core::kPoint:
      return count == 0;
    case RecordedShape::Core::kSegment:
      return count == 1;
    case RecordedShape::Core::kTriangle:
      return count == 3 * kPointSize;
    case RecordedShape::Core::kBox:
      return count == 3;
    case RecordedShape::Core::kCylinder:
    case RecordedShape::Core::kCone:
      return count == 2;
    case RecordedShape::Core::kHull:
      return count > 0 && count % kPointSize == 0;
  }
  return false;
}

RecordedShape ShapeFrom(std::string_view content) {
  constexpr std::size_t kHeadSize = sizeof(std::uint32_t) + sizeof(double);
  if (content.size() < kHeadSize || (content.size() - kHeadSize) % sizeof(double) != 0) {
    throw Damage("a shape of odd size");
  }
  RecordedShape shape;
  const auto core = record::Take<std::uint32_t>(content);
  shape.radius = record::Take<double>(content);
  const std::size_t count = content.size() / sizeof(double);
  constexpr auto kLastCore = static_cast<std::uint32_t>(RecordedShape::Core::kHull);
  shape.core = static_cast<RecordedShape::Core>(std::min(core, kLastCore));
  if (core > kLastCore || !IsCountOf(shape.core, count)) {
    throw Damage("a shape of core " + std::to_string(core) + " with " + std::to_string(count) + " numbers");
  }
  while (!content.empty()) shape.numbers.push_back(record::Take<double>(content));
  return shape;
}

template <class Real>
RecordedPose PoseFrom(std::string_view& content) {
  RecordedPose pose;
  for (double& number : pose.rotation) number = double(record::Take<Real>(content));
  for (double& number : pose.translation) number = double(record::Take<Real>(content));
  return pose;
}

template <class Real>
void AddPairs(std::string_view content, Record& record) {
  if (content.size() < sizeof(std::uint64_t) ||
      (content.size() - sizeof(std::uint64_t)) % record::PairSize(sizeof(Real)) != 0) {
    throw Damage("pairs of odd size");
  }
  const auto step = record::Take<std::uint64_t>(content);
  while (!content.empty()) {
    RecordedPair pair;
    pair.step = step;
    pair.body_pair = record::Take<std::uint32_t>(content);
    pair.shape_1 = record::Take<std::uint32_t>(content);
    pair.shape_2 = record::Take<std::uint32_t>(content);
    pair.pose_1 = PoseFrom<Real>(content);
    pair.pose_2 = PoseFrom<Real>(content);
    if (const std::uint32_t shape = std::max(pair.shape_1, pair.shape_2); shape >= record.shapes.size()) {
      throw Damage("a pair of a shape " + std::to_string(shape) + " that has not come");
    }
    record.pairs.push_back(pair);
  }
}

class Reader {
 public:
  Reader(std::istream& file, const std::string& name) : file_(file), name_(name) {}

  /// Throws std::runtime_error if this is no record.
  record::Counts ReadHeader(Record& record) {
    std::string bytes;
    const bool is_whole = Read(record::kHeaderSize, bytes);
    std::string_view header = bytes;
    if (header.substr(0, record::kMagic.size()) != record::kMagic) throw std::runtime_error(name_ + ": not a record");
    if (!is_whole) throw std::runtime_error(name_ + ": ends within its header");
    const record::Checksum expected = record::ChecksumOf(header.substr(0, header.size() - sizeof(record::Checksum)));
    header.remove_prefix(record::kMagic.size());
    const auto version = record::Take<std::uint32_t>(header);
    if (version != record::kVersion) {
      throw std::runtime_error(name_ + ": a record of version " + std::to_string(version) + "; this reads version " +
                               std::to_string(record::kVersion));
    }
    const auto real_bytes = record::Take<std::uint32_t>(header);
    const auto counts = record::Take<record::Counts>(header);
    if (record::Take<record::Checksum>(header) != expected || (real_bytes != 4 && real_bytes != 8)) {
      throw std::runtime_error(name_ + ": its header is damaged");
    }
    record.real_bytes = static_cast<int>(real_bytes);
    return counts;
  }

  /// @return whether there was one; throws Damage for one that is not whole.
  bool ReadBlock(Record& record) {
    std::string block;
    if (!Read(record::kBlockHeadSize, block)) {
      if (block.empty()) return false;
      throw Damage("the file ends within a block");
    }
    const auto [kind, size] = HeadFrom(block);
    if (size > kLargestBlock) throw Damage("a block of " + std::to_string(size) + " bytes");
    const std::size_t checked = record::kBlockHeadSize + size;
    if (!Read(checked + sizeof(record::Checksum), block)) throw Damage("the file ends within a block");
    if (!HasChecksum(std::string_view(block).substr(0, checked), std::string_view(block).substr(checked))) {
      throw Damage("a block's checksum is wrong");
    }
    const std::string_view content = std::string_view(block).substr(record::kBlockHeadSize, size);
    if (kind == record::kShapeBlock) {
      record.shapes.push_back(ShapeFrom(content));
    } else if (kind != record::kStepBlock) {
      throw Damage("a block of unknown kind " + std::to_string(kind));
    } else if (record.real_bytes == sizeof(float)) {
      AddPairs<float>(content, record);
    } else {
      AddPairs<double>(content, record);
    }
    place_ += block.size();
    return true;
  }

  /// Offset of the next block from the file's beginning; bytes.
  std::size_t place() const { return place_; }

 private:
  struct BlockHead {
    std::uint32_t kind, size;
  };
  static BlockHead HeadFrom(std::string_view bytes) {
    const auto kind = record::Take<std::uint32_t>(bytes);
    return {kind, record::Take<std::uint32_t>(bytes)};
  }

  static bool HasChecksum(std::string_view bytes, std::string_view checksum) {
    return record::Take<record::Checksum>(checksum) == record::ChecksumOf(bytes);
  }

  /// More of the file, until `bytes` has so many. In pieces: a damaged size must not claim memory that the file does
  /// not fill.
  bool Read(std::size_t size, std::string& bytes) {
    constexpr std::size_t kPiece = 1U << 16;
    while (bytes.size() < size && file_) {
      const std::size_t have = bytes.size(), wanted = std::min(kPiece, size - have);
      bytes.resize(have + wanted);
      file_.read(bytes.data() + have, static_cast<std::streamsize>(wanted));
      bytes.resize(have + static_cast<std::size_t>(file_.gcount()));
    }
    return bytes.size() == size;
  }

  std::istream& file_;
  const std::string& name_;
  std::size_t place_ = record::kHeaderSize;
};

std::string CountsIn(const Record& record) {
  return std::to_string(record.shapes.size()) + " shapes and " + std::to_string(record.pairs.size()) + " pairs";
}

}  // namespace

Record ReadRecord(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  return ReadRecord(file, path);
}

Record ReadRecord(std::istream& file, const std::string& name) {
  Record record;
  Reader reader(file, name);
  const record::Counts counts = reader.ReadHeader(record);
  try {
    while (reader.ReadBlock(record)) {
    }
  } catch (const Damage& damage) {
    record.problem = name + ": damaged from byte " + std::to_string(reader.place()) + " on (" + damage.what() +
                     "); read before it: " + CountsIn(record);
    return record;
  }
  if (counts.pairs == record::kNotClosed) {
    record.problem = name + ": was not closed; read to its end: " + CountsIn(record);
    return record;
  }
  record.left_out = counts.left_out;
  if (counts.pairs != record.pairs.size() || counts.shapes != record.shapes.size()) {
    record.problem = name + ": ends too early, at byte " + std::to_string(reader.place()) + "; it should have " +
                     std::to_string(counts.pairs) + " pairs, and has " + CountsIn(record);
  }
  return record;
}

}  // namespace dgd_bullet
