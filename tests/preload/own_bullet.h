// As much of a Bullet of one's own as a linker sees.
#pragma once

class btDefaultCollisionConfiguration {
 public:
  virtual ~btDefaultCollisionConfiguration();
  virtual void* getCollisionAlgorithmCreateFunc(int type_0, int type_1);
  virtual void* getClosestPointsAlgorithmCreateFunc(int type_0, int type_1);
};

class btConvexHullShape {
 public:
  btConvexHullShape(const float* points, int count, int stride);
};

btDefaultCollisionConfiguration& OnlyConfiguration();
