#include "checkpoint/broadphase_state.h"

#include <algorithm>
#include <array>
#include <new>
#include <vector>

namespace dgd_demos {
namespace {

using Proxies = std::vector<btDbvtProxy*>;

constexpr int kNone = -1;
constexpr int kMostPairs = 1 << 30;
constexpr int kStages = btDbvtBroadphase::STAGECOUNT + 1;  // The last is that of the tree of bodies at rest.

// A node of a tree. Those of its subtrees follow it, one after the other.
struct NodeState {
  btDbvtVolume volume;
  int leaf;  // Index of the leaf's object; kNone if the node has subtrees.
};

// What the broadphase points to.
struct Structure {
  std::vector<int> stages;                        // Of each proxy.
  std::array<std::vector<int>, kStages> members;  // Of each stage, in its list's order.
  std::array<std::vector<NodeState>, 2> trees;
};

Proxies ProxiesOf(const btCollisionObjectArray& objects) {
  Proxies proxies;
  for (int i = 0; i < objects.size(); ++i) {
    proxies.push_back(static_cast<btDbvtProxy*>(objects[i]->getBroadphaseHandle()));
  }
  return proxies;
}

int IndexOf(const btDbvtProxy& proxy) {
  return static_cast<btCollisionObject*>(proxy.m_clientObject)->getWorldArrayIndex();
}

std::vector<NodeState> Describe(const btDbvt& tree) {
  std::vector<NodeState> states;
  std::vector<const btDbvtNode*> left;  // The next one last.
  if (tree.m_root != nullptr) left.push_back(tree.m_root);
  while (!left.empty()) {
    const btDbvtNode& node = *left.back();
    left.pop_back();
    states.push_back({node.volume, node.isleaf() ? IndexOf(*static_cast<btDbvtProxy*>(node.data)) : kNone});
    if (node.isinternal()) left.insert(left.end(), {node.childs[1], node.childs[0]});
  }
  return states;
}

Structure Describe(const btDbvtBroadphase& broadphase, const Proxies& proxies) {
  Structure structure;
  for (const btDbvtProxy* proxy : proxies) structure.stages.push_back(proxy->stage);
  for (std::size_t i = 0; i < kStages; ++i) {
    for (const btDbvtProxy* proxy = broadphase.m_stageRoots[i]; proxy != nullptr; proxy = proxy->links[1]) {
      structure.members[i].push_back(IndexOf(*proxy));
    }
  }
  for (std::size_t i = 0; i < 2; ++i) structure.trees[i] = Describe(broadphase.m_sets[i]);
  return structure;
}

void Serialize(StateArchive& archive, Structure& structure) {
  const auto integer = [&](int& number) { archive.Serialize(number); };
  archive.Serialize(structure.stages, integer);
  for (std::vector<int>& members : structure.members) archive.Serialize(members, integer);
  for (std::vector<NodeState>& tree : structure.trees) {
    archive.Serialize(tree, [&](NodeState& node) {
      archive.SerializePlain(node.volume);
      archive.Serialize(node.leaf);
    });
  }
}

// Whether the nodes are a whole tree: of each that has subtrees, there are two.
bool IsTree(const std::vector<NodeState>& nodes) {
  std::size_t expected = nodes.empty() ? 0 : 1;  // Subtrees that are to follow.
  for (const NodeState& node : nodes) {
    if (expected == 0) return false;
    node.leaf == kNone ? ++expected : --expected;
  }
  return expected == 0;
}

// Each proxy is in the list of its stage and in the tree of its stage, and nowhere else.
void Check(const StateArchive& archive, const Structure& structure, std::size_t proxies) {
  archive.Require(structure.stages.size() == proxies, "it has not one stage of the broadphase for each body");
  std::vector<int> in_lists(proxies, 0), in_trees(proxies, 0);
  const auto count = [&](std::vector<int>& counts, int index, const auto& is_stage) {
    archive.Require(0 <= index && static_cast<std::size_t>(index) < proxies, "the index of a body is out of range");
    const auto place = static_cast<std::size_t>(index);
    archive.Require(is_stage(structure.stages[place]), "a body is not where its stage of the broadphase says");
    ++counts[place];
  };
  for (int stage = 0; stage < kStages; ++stage) {
    for (const int index : structure.members[static_cast<std::size_t>(stage)]) {
      count(in_lists, index, [&](int own) { return own == stage; });
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    archive.Require(IsTree(structure.trees[i]), "a tree of the broadphase is not whole");
    for (const NodeState& node : structure.trees[i]) {
      const bool is_at_rest = i == btDbvtBroadphase::FIXED_SET;
      if (node.leaf == kNone) continue;
      count(in_trees, node.leaf, [&](int own) { return (own == btDbvtBroadphase::STAGECOUNT) == is_at_rest; });
    }
  }
  const auto is_one = [](int times) { return times == 1; };
  archive.Require(std::ranges::all_of(in_lists, is_one) && std::ranges::all_of(in_trees, is_one),
                  "a body is not once in the broadphase");
}

// @pre IsTree(states).
void Rebuild(btDbvt& tree, const std::vector<NodeState>& states, const Proxies& proxies) {
  tree.clear();
  std::vector<btDbvtNode*> open;  // Those that lack a subtree, the next one last.
  for (const NodeState& state : states) {
    void* const place = btAlignedAlloc(sizeof(btDbvtNode), 16);  // As the tree frees them.
    btDbvtNode* const parent = open.empty() ? nullptr : open.back();
    auto* const node = new (place) btDbvtNode{state.volume, parent, {}};
    if (parent == nullptr) {
      tree.m_root = node;
    } else if (parent->childs[0] == nullptr) {
      parent->childs[0] = node;
    } else {
      parent->childs[1] = node;
      open.pop_back();
    }
    if (state.leaf == kNone) {
      open.push_back(node);
      continue;
    }
    node->data = proxies[static_cast<std::size_t>(state.leaf)];
    proxies[static_cast<std::size_t>(state.leaf)]->leaf = node;
    ++tree.m_leaves;
  }
}

// Bullet has a doubly linked list.
void Rebuild(btDbvtProxy*& root, const std::vector<int>& members, const Proxies& proxies) {
  root = nullptr;
  btDbvtProxy* last = nullptr;
  for (const int index : members) {
    btDbvtProxy* proxy = proxies[static_cast<std::size_t>(index)];
    proxy->links[0] = last;
    proxy->links[1] = nullptr;
    (last == nullptr ? root : last->links[1]) = proxy;
    last = proxy;
  }
}

// Bullet keeps the nodes of a tree in the order of their addresses, but only exchanges nodes for that: its shape does
// not depend on the addresses.
void Rebuild(btDbvtBroadphase& broadphase, const Structure& structure, const Proxies& proxies) {
  for (std::size_t i = 0; i < proxies.size(); ++i) proxies[i]->stage = structure.stages[i];
  for (std::size_t i = 0; i < kStages; ++i) Rebuild(broadphase.m_stageRoots[i], structure.members[i], proxies);
  for (std::size_t i = 0; i < 2; ++i) Rebuild(broadphase.m_sets[i], structure.trees[i], proxies);
}

}  // namespace

void SerializeBroadphase(StateArchive& archive, btDbvtBroadphase& broadphase, const btCollisionObjectArray& objects) {
  const Proxies proxies = ProxiesOf(objects);
  for (btDbvtProxy* proxy : proxies) {
    archive.SerializePlain(proxy->m_aabbMin);
    archive.SerializePlain(proxy->m_aabbMax);
  }
  Structure structure;
  if (!archive.is_reading()) structure = Describe(broadphase, proxies);
  Serialize(archive, structure);
  if (archive.is_reading()) {
    Check(archive, structure, proxies.size());
    Rebuild(broadphase, structure, proxies);
  }
  for (btDbvt& tree : broadphase.m_sets) {
    archive.Serialize(tree.m_lkhd);
    archive.Serialize(tree.m_opath);
  }
  archive.Serialize(broadphase.m_stageCurrent);
  archive.Require(0 <= broadphase.m_stageCurrent && broadphase.m_stageCurrent < btDbvtBroadphase::STAGECOUNT,
                  "the broadphase's stage is out of range");
  archive.Serialize(broadphase.m_newpairs);
  archive.Serialize(broadphase.m_fixedleft);
  archive.Serialize(broadphase.m_updates_call);
  archive.Serialize(broadphase.m_updates_done);
  archive.Serialize(broadphase.m_updates_ratio);
  archive.Serialize(broadphase.m_pid);
  archive.Serialize(broadphase.m_cid);  // An index, which Bullet takes modulo the number of pairs.
  archive.Require(0 <= broadphase.m_cid && broadphase.m_cid <= kMostPairs, "the broadphase's place is out of range");
  archive.Serialize(broadphase.m_gid);
  archive.Serialize(broadphase.m_needcleanup);
}

}  // namespace dgd_demos
