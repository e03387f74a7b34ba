#include "dgd_bullet/recorder.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <cstdint>
#include <exception>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "dgd_bullet/record_file.h"
#include "record_format.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// The content of a shape's block.
class ShapeContent {
 public:
  /// @return nothing for a core that only its support function describes.
  static std::optional<std::string> Of(const dgd::AnySet& set) {
    return set.Visit([](const auto& rounded) { return ShapeContent(rounded.radius).With(rounded.core); });
  }

 private:
  using Core = RecordedShape::Core;
  using Content = std::optional<std::string>;

  explicit ShapeContent(double radius) : radius_(radius) {}

  Content With(const dgd::Point<double>&) const { return Make(Core::kPoint, {}); }
  Content With(const dgd::Segment<double>& segment) const {
    return Make(Core::kSegment, {segment.SupportValue(Vector3::UnitZ())});
  }
  Content With(const dgd::Triangle<double>& triangle) const { return Make(Core::kTriangle, CoordinatesOf(triangle)); }
  Content With(const dgd::Box<double>& box) const {
    const Vector3 corner = box.Vertex(0);
    return Make(Core::kBox, {corner.x(), corner.y(), corner.z()});
  }
  Content With(const dgd::Cylinder<double>& cylinder) const {
    return Make(Core::kCylinder, {cylinder.SupportValue(Vector3::UnitX()), cylinder.SupportValue(Vector3::UnitZ())});
  }
  Content With(const dgd::Cone<double>& cone) const {
    return Make(Core::kCone, {cone.SupportValue(Vector3::UnitX()), 2 * cone.SupportValue(Vector3::UnitZ())});
  }
  Content With(const dgd::CoreReference<dgd::Polytope<double>>& hull) const {
    return Make(Core::kHull, CoordinatesOf(hull));
  }
  template <class... Cores>
  Content With(const dgd::OneOf<Cores...>& core) const {
    return core.Visit([this](const auto& one) { return this->With(one); });
  }
  /// No Bullet shape has these cores.
  Content With(const dgd::Frustum<double>&) const { return std::nullopt; }
  Content With(const dgd::Ellipsoid<double>&) const { return std::nullopt; }
  Content With(const dgd::CustomCore&) const { return std::nullopt; }

  template <class VertexCore>
  static std::vector<double> CoordinatesOf(const VertexCore& core) {
    std::vector<double> numbers;
    for (dgd::VertexId i = 0; i < core.VertexCount(); ++i) {
      const Vector3 vertex = core.Vertex(i);
      numbers.insert(numbers.end(), vertex.begin(), vertex.end());
    }
    return numbers;
  }

  Content Make(Core core, const std::vector<double>& numbers) const {
    std::string content;
    record::Append(content, static_cast<std::uint32_t>(core));
    record::Append(content, radius_);
    for (const double number : numbers) record::Append(content, number);
    return content;
  }

  double radius_;
};

void AppendPose(const Pose& pose, std::string& bytes) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) record::Append(bytes, btScalar(pose.rotation(row, column)));
  }
  for (int row = 0; row < 3; ++row) record::Append(bytes, btScalar(pose.translation[row]));
}

/// Which object, and which part of it.
using Member = std::tuple<const btCollisionObject*, int, int>;
Member MemberOf(const btCollisionObjectWrapper& body) {
  return {body.getCollisionObject(), body.m_partId, body.m_index};
}

}  // namespace

class Recorder::Writer {
 public:
  explicit Writer(const std::string& path) : path_(path), file_(path, std::ios::binary | std::ios::trunc) {
    file_ << Header({});
    file_.flush();
    if (!file_) throw std::runtime_error(path_ + ": cannot be written");
  }

  void NextStep() {
    const std::lock_guard lock(mutex_);
    WriteStep();
    ++step_;
  }

  void Add(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1) {
    const std::lock_guard lock(mutex_);
    if (!file_.is_open()) return;
    // The pair counts as left out until it is written.
    ++counts_.left_out;
    std::shared_ptr<const CachedHull> hull_0, hull_1;
    const PosedShape shape_0 = Adapt(body_0, hull_0), shape_1 = Adapt(body_1, hull_1);
    const std::optional<std::uint32_t> number_0 = NumberOf(shape_0.set), number_1 = NumberOf(shape_1.set);
    if (!number_0 || !number_1) return;
    const auto body_pair = static_cast<std::uint32_t>(body_pairs_.size());
    record::Append(pairs_, body_pairs_.try_emplace({MemberOf(body_0), MemberOf(body_1)}, body_pair).first->second);
    record::Append(pairs_, *number_0);
    record::Append(pairs_, *number_1);
    AppendPose(shape_0.pose, pairs_);
    AppendPose(shape_1.pose, pairs_);
    --counts_.left_out;
    ++counts_.pairs;
    if (pairs_.size() >= kBlockSize) WriteStep();
  }

  std::uint64_t pair_count() const {
    const std::lock_guard lock(mutex_);
    return counts_.pairs;
  }

  void Close() {
    const std::lock_guard lock(mutex_);
    if (!file_.is_open()) return;
    WriteStep();
    counts_.steps = step_ + 1;
    file_.seekp(0);
    file_ << Header(counts_);
    const bool is_written = file_.good();
    file_.close();
    if (!is_written || !file_) throw std::runtime_error(path_ + ": not all of it could be written");
  }

 private:
  static constexpr std::size_t kBlockSize = 1U << 20;  // Bytes.

  static std::string Header(const record::Counts& counts) {
    std::string header(record::kMagic);
    record::Append(header, record::kVersion);
    record::Append(header, static_cast<std::uint32_t>(sizeof(btScalar)));
    record::Append(header, counts);
    record::Append(header, record::ChecksumOf(header));
    return header;
  }

  void WriteBlock(std::uint32_t kind, std::string_view content) {
    std::string block;
    record::Append(block, kind);
    record::Append(block, static_cast<std::uint32_t>(content.size()));
    block += content;
    record::Append(block, record::ChecksumOf(block));
    file_ << block;
  }

  void WriteStep() {
    if (pairs_.empty()) return;
    std::string content;
    record::Append(content, step_);
    WriteBlock(record::kStepBlock, content + pairs_);
    pairs_.clear();
  }

  PosedShape Adapt(const btCollisionObjectWrapper& body, std::shared_ptr<const CachedHull>& hull) {
    return AdaptShape(*static_cast<const btConvexShape*>(body.getCollisionShape()), body.getWorldTransform(),
                      GeometryMode::kBullet, hulls_, hull, HullUse::kStep);
  }

  /// Number of the shape with this content, which is written if it is new.
  std::optional<std::uint32_t> NumberOf(const dgd::AnySet& set) {
    std::optional<std::string> content = ShapeContent::Of(set);
    if (!content) return std::nullopt;
    const auto [place, is_new] = shapes_.try_emplace(std::move(*content), static_cast<std::uint32_t>(shapes_.size()));
    if (is_new) {
      WriteBlock(record::kShapeBlock, place->first);
      counts_.shapes = shapes_.size();
    }
    return place->second;
  }

  const std::string path_;
  mutable std::mutex mutex_;
  std::ofstream file_;
  record::Counts counts_{0, 0, 0, 0};
  std::uint64_t step_ = 0;
  std::string pairs_;  // Pairs of this step since the last block.
  HullCache hulls_;
  std::unordered_map<std::string, std::uint32_t> shapes_;  // Numbers by content: children and triangles come and go.
  std::map<std::pair<Member, Member>, std::uint32_t> body_pairs_;
};

Recorder::Recorder(const std::string& path) : writer_(std::make_unique<Writer>(path)) {}

Recorder::~Recorder() {
  try {
    Close();
  } catch (const std::exception&) {
    // Close() reports errors.
  }
}

void Recorder::NextStep() { writer_->NextStep(); }

void Recorder::OnPair(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1) noexcept {
  try {
    writer_->Add(body_0, body_1);
  } catch (const std::exception&) {
    // No shape, or no memory: left out.
  }
}

std::uint64_t Recorder::pair_count() const { return writer_->pair_count(); }

void Recorder::Close() { writer_->Close(); }

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
