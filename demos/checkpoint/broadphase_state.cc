#include "checkpoint/broadphase_state.h"

#include <new>
#include <vector>

namespace dgd_demos {
namespace {

using Proxies = std::vector<btDbvtProxy*>;

constexpr int kNone = -1;

Proxies ProxiesOf(const btCollisionObjectArray& objects) {
  Proxies proxies;
  for (int i = 0; i < objects.size(); ++i) {
    proxies.push_back(static_cast<btDbvtProxy*>(objects[i]->getBroadphaseHandle()));
  }
  return proxies;
}

int IndexOf(const btDbvtProxy* proxy) {
  return proxy == nullptr ? kNone : static_cast<btCollisionObject*>(proxy->m_clientObject)->getWorldArrayIndex();
}

btDbvtProxy* At(const Proxies& proxies, int index) {
  return index == kNone ? nullptr : proxies.at(static_cast<std::size_t>(index));
}

// A node with its descendants. Reading makes nodes as the tree allocates and frees them; writing assigns what is there.
btDbvtNode* SerializeSubtree(StateArchive& archive, btDbvtNode* node, btDbvtNode* parent, const Proxies& proxies) {
  if (archive.is_reading()) node = new (btAlignedAlloc(sizeof(btDbvtNode), 16)) btDbvtNode{};
  node->parent = parent;
  archive.SerializePlain(node->volume);
  int leaf = kNone;
  if (!archive.is_reading() && node->isleaf()) leaf = IndexOf(static_cast<btDbvtProxy*>(node->data));
  archive.Serialize(leaf);
  if (leaf == kNone) {
    for (btDbvtNode*& child : node->childs) child = SerializeSubtree(archive, child, node, proxies);
    return node;
  }
  btDbvtProxy* const proxy = At(proxies, leaf);
  node->childs[1] = nullptr;
  node->data = proxy;
  proxy->leaf = node;
  return node;
}

// Bullet keeps the nodes of a tree in the order of their addresses, but only exchanges nodes for that: its shape does
// not depend on the addresses.
void SerializeTree(StateArchive& archive, btDbvt& tree, const Proxies& proxies) {
  bool is_empty = tree.m_root == nullptr;
  archive.Serialize(is_empty);
  if (archive.is_reading()) tree.clear();
  if (!is_empty) tree.m_root = SerializeSubtree(archive, tree.m_root, nullptr, proxies);
  archive.Serialize(tree.m_leaves);
  archive.Serialize(tree.m_lkhd);
  archive.Serialize(tree.m_opath);
}

// The proxies that were moved in one stage of the broadphase, a doubly linked list.
void SerializeStage(StateArchive& archive, btDbvtProxy*& root, const Proxies& proxies) {
  std::vector<int> indices;
  for (const btDbvtProxy* proxy = root; proxy != nullptr; proxy = proxy->links[1]) indices.push_back(IndexOf(proxy));
  archive.Serialize(indices, [&](int& index) { archive.Serialize(index); });
  if (!archive.is_reading()) return;
  root = nullptr;
  btDbvtProxy* last = nullptr;
  for (const int index : indices) {
    btDbvtProxy* proxy = At(proxies, index);
    proxy->links[0] = last;
    proxy->links[1] = nullptr;
    (last == nullptr ? root : last->links[1]) = proxy;
    last = proxy;
  }
}

}  // namespace

void SerializeBroadphase(StateArchive& archive, btDbvtBroadphase& broadphase, const btCollisionObjectArray& objects) {
  const Proxies proxies = ProxiesOf(objects);
  for (btDbvtProxy* proxy : proxies) {
    archive.SerializePlain(proxy->m_aabbMin);
    archive.SerializePlain(proxy->m_aabbMax);
    archive.Serialize(proxy->stage);
  }
  for (btDbvt& tree : broadphase.m_sets) SerializeTree(archive, tree, proxies);
  for (btDbvtProxy*& root : broadphase.m_stageRoots) SerializeStage(archive, root, proxies);
  archive.Serialize(broadphase.m_stageCurrent);
  archive.Serialize(broadphase.m_newpairs);
  archive.Serialize(broadphase.m_fixedleft);
  archive.Serialize(broadphase.m_updates_call);
  archive.Serialize(broadphase.m_updates_done);
  archive.Serialize(broadphase.m_updates_ratio);
  archive.Serialize(broadphase.m_pid);
  archive.Serialize(broadphase.m_cid);
  archive.Serialize(broadphase.m_gid);
  archive.Serialize(broadphase.m_needcleanup);
}

}  // namespace dgd_demos
