#include "own_bullet.h"

btDefaultCollisionConfiguration::~btDefaultCollisionConfiguration() = default;
void* btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(int, int) { return this; }
void* btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(int, int) { return this; }

btConvexHullShape::btConvexHullShape(const float*, int, int) {}

btDefaultCollisionConfiguration& OnlyConfiguration() {
  static btDefaultCollisionConfiguration configuration;
  return configuration;
}
