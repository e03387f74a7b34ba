// Fracture at run time: a block is replaced by convex hulls that fill it, in flight or at rest; its own shape is freed,
// and the pieces' shapes get its memory. Pieces fly on as the block did, lie as it lay, and do not burst apart.
#include <algorithm>
#include <memory>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

/// Shape and body, made and destroyed while the world runs.
struct Piece {
  std::unique_ptr<btConvexHullShape> shape;
  std::unique_ptr<btRigidBody> body;
};

/// Pieces of the world that live shorter than it.
class Pieces {
 public:
  explicit Pieces(Lab& lab) : lab_(lab) {}
  ~Pieces() {
    while (!pieces_.empty()) Remove(0);
  }
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;

  /// @param corners  In the piece's frame, margin included.
  btRigidBody& Add(const std::vector<btVector3>& corners, double margin, double mass, const btTransform& pose) {
    Piece piece;
    piece.shape = std::make_unique<btConvexHullShape>();
    for (const btVector3& corner : corners) piece.shape->addPoint(corner * btScalar(1 - margin), false);
    piece.shape->recalcLocalAabb();
    piece.shape->setMargin(0);
    piece.body = dgd_test::MakeRigidBody(*piece.shape, mass, pose);
    piece.body->setActivationState(DISABLE_DEACTIVATION);
    lab_.world().addRigidBody(piece.body.get());
    pieces_.push_back(std::move(piece));
    return *pieces_.back().body;
  }
  void Remove(std::size_t index) {
    lab_.world().removeRigidBody(pieces_[index].body.get());
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(index));
  }
  std::size_t size() const { return pieces_.size(); }
  const btRigidBody& operator[](std::size_t index) const { return *pieces_[index].body; }

 private:
  Lab& lab_;
  std::vector<Piece> pieces_;
};

constexpr double kBlockHalf = 0.3;  // Of the block, m.

std::vector<btVector3> BlockCorners(const btVector3& least, const btVector3& most) {
  std::vector<btVector3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(btVector3((i & 1) == 0 ? least.x() : most.x(), (i & 2) == 0 ? least.y() : most.y(),
                                (i & 4) == 0 ? least.z() : most.z()));
  }
  return corners;
}

/// The block in `side`^3 boxes of unlike sizes, or each of them in two wedges; corners in the block's frame.
std::vector<std::vector<btVector3>> Shards(int side, bool has_wedges) {
  std::vector<double> cuts = {-kBlockHalf};
  for (int i = 1; i < side; ++i) cuts.push_back(kBlockHalf * (2.0 * i / side - 1 + 0.1 * (i % 2)));
  cuts.push_back(kBlockHalf);
  std::vector<std::vector<btVector3>> shards;
  for (int i = 0; i < side * side * side; ++i) {
    const std::size_t x = static_cast<std::size_t>(i % side), y = static_cast<std::size_t>(i / side % side),
                      z = static_cast<std::size_t>(i / side / side);
    const std::vector<btVector3> box =
        BlockCorners(Vec(cuts[x], cuts[y], cuts[z]), Vec(cuts[x + 1], cuts[y + 1], cuts[z + 1]));
    if (!has_wedges) {
      shards.push_back(box);
      continue;
    }
    shards.push_back({box[0], box[1], box[2], box[4], box[5], box[6]});
    shards.push_back({box[3], box[1], box[2], box[7], box[5], box[6]});
  }
  return shards;
}

struct Break {
  Ground ground;
  int side;
  bool has_wedges;
  bool is_in_flight;
  int index;
};

/// Replaces the block by shards with its motion.
void Shatter(Pieces& pieces, const Break& it, double mass) {
  const btTransform pose = pieces[0].getWorldTransform();
  const btVector3 velocity = pieces[0].getLinearVelocity(), spin = pieces[0].getAngularVelocity();
  pieces.Remove(0);
  const std::vector<std::vector<btVector3>> shards = Shards(it.side, it.has_wedges);
  for (std::vector<btVector3> shard : shards) {
    btVector3 centre = Vec(0, 0, 0);
    for (const btVector3& corner : shard) centre += corner / btScalar(shard.size());
    for (btVector3& corner : shard) corner -= centre;
    btRigidBody& body = pieces.Add(shard, 0.002, mass / double(shards.size()), pose * At(centre));
    body.setLinearVelocity(velocity + spin.cross(pose.getBasis() * centre));
    body.setAngularVelocity(spin);
  }
}

/// Energy that comes from nowhere just after the break, deepest overlap, speed when all should rest, and lost pieces.
Case RunBreak(const Conditions& conditions, const Break& it) {
  constexpr double kMass = 8, kRestTime = 4, kMeasureTime = 0.3;  // kg, s
  Lab lab(conditions);
  lab.AddGround(it.ground, btTransform::getIdentity(), {}, {.friction = 1});
  Pieces pieces(lab);
  const double height = kBlockHalf + (it.is_in_flight ? 0.5 : 0);
  const std::vector<btVector3> block =
      BlockCorners(Vec(-kBlockHalf, -kBlockHalf, -kBlockHalf), Vec(kBlockHalf, kBlockHalf, kBlockHalf));
  btRigidBody& body = pieces.Add(block, 0, kMass, At(Vec(0.23, 0.31, height), Yaw(HeadingOf(it.index))));
  if (it.is_in_flight) body.setAngularVelocity(Vec(0.5, 0.3, 2));
  lab.Run(it.is_in_flight ? 0.15 : 0.4);
  Shatter(pieces, it, kMass);
  const auto fastest = [&pieces] {
    double speed = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) speed = std::max(speed, SpeedOf(pieces[i], 0.1));
    return speed;
  };
  const double before = fastest();
  double burst = 0, overlap = 0;
  for (int step = lab.StepsIn(0.1); step > 0; --step) {
    lab.Step();
    const double fall = kGravity * 0.1;
    burst = std::max(burst, fastest() - before - (it.is_in_flight ? fall : 0));
  }
  for (int step = lab.StepsIn(kRestTime); step > 0; --step) {
    lab.Step();
    overlap = std::max(overlap, DeepestOverlap(lab));
  }
  const double rest = RestSpeed(lab, kMeasureTime, 0.1);
  double lost = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!(HeightOf(pieces[i]) > -0.02)) ++lost;
  }
  return {it.is_in_flight ? "in flight" : "at rest",
          Text(double(pieces.size())) + (it.has_wedges ? " wedges" : " blocks") + " on " + NameOf(it.ground) +
              (it.is_in_flight ? ", in flight" : ", at rest"),
          {1000 * std::max(0.0, burst), 1000 * overlap, lost > 0 ? 0 : 1000 * rest, lost}};
}

/// Each step another shape takes the last one's place, and often its address.
Case RunReplaced(const Conditions& conditions) {
  Lab lab(conditions);
  lab.AddGround(Ground::kBox, btTransform::getIdentity(), {}, {.friction = 1});
  Pieces pieces(lab);
  double overlap = 0, fastest = 0;
  const int steps = lab.StepsIn(0.5);
  for (int step = 0; step < steps; ++step) {
    if (pieces.size() > 0) pieces.Remove(0);
    const double half = 0.1 + 0.05 * (step * 7 % 5);
    pieces.Add(BlockCorners(Vec(-half, -half, -half), Vec(half, half, half)), 0, 1, At(Vec(0, 0, half)));
    lab.Step();
    overlap = std::max(overlap, DeepestOverlap(lab));
    fastest = std::max(fastest, SpeedOf(pieces[0], half));
  }
  const double resting = kGravity * lab.dt();
  return {"new shapes", "a new shape each step", {1000 * std::max(0.0, fastest - resting), 1000 * overlap, 0, 0}};
}

Cases RunFracture(const Conditions& conditions) {
  constexpr std::array kGrounds = {Ground::kBox, Ground::kMesh, Ground::kPlane};
  Cases cases;
  for (const int i : SelectIndices(conditions, 12, 2)) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back(RunBreak(conditions, {kGrounds[j % 3], i % 4 == 3 ? 3 : 2, (i / 2) % 2 == 1, (i / 4) % 2 == 1, i}));
  }
  cases.push_back(RunReplaced(conditions));
  return cases;
}

}  // namespace

App Fracture() {
  return {"fracture",
          "blocks are replaced by hulls while the world runs: whether pieces burst apart, overlap, rest, get lost",
          {{"burst, mm/s", Combine::kMean, 0.1, 10, "what falls for a millisecond has that speed"},
           {"deepest overlap, mm", Combine::kMean, 0.1, 1, "a millimetre is not seen"},
           {"speed at rest, mm/s", Combine::kMean, 0.3, 5, "how long pieces tumble is chance"},
           {"lost pieces", Combine::kTotal, 0, 0, "one is one too many"}},
          RunFracture};
}

}  // namespace dgd_apps
