"""A Python app on DART with Bullet as its collision detector: a box falls on a ground, and must come to rest on it."""

import sys

import dartpy as dart


def make_box(name, size, height, joint):
    skeleton = dart.dynamics.Skeleton(name)
    joint, body = {
        "free": skeleton.createFreeJointAndBodyNodePair,
        "weld": skeleton.createWeldJointAndBodyNodePair,
    }[joint]()
    shape_node = body.createShapeNode(dart.dynamics.BoxShape(size))
    shape_node.createCollisionAspect()
    shape_node.createDynamicsAspect()
    pose = dart.math.Isometry3()
    pose.set_translation([0, 0, height])
    joint.setTransformFromParentBodyNode(pose)
    return skeleton


world = dart.simulation.World()
world.setGravity([0, 0, -9.81])
world.getConstraintSolver().setCollisionDetector(dart.collision.BulletCollisionDetector())
box = make_box("box", [1, 1, 1], 0.6, "free")
world.addSkeleton(make_box("ground", [10, 10, 1], -0.5, "weld"))
world.addSkeleton(box)
for _ in range(1000):
    world.step()
height = box.getBodyNode(0).getWorldTransform().translation()[2]
print(float(height).hex())
sys.exit(0 if abs(height - 0.5) < 0.005 else 1)
