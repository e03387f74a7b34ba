// An app with a Bullet of its own, linked statically or as a shared library. Exit status 0 if both getters return what
// that Bullet returns.
#include "own_bullet.h"

int main() {
  btDefaultCollisionConfiguration& configuration = OnlyConfiguration();
  const bool are_own = configuration.getCollisionAlgorithmCreateFunc(0, 0) == &configuration &&
                       configuration.getClosestPointsAlgorithmCreateFunc(0, 0) == &configuration;
  return are_own ? 0 : 1;
}
