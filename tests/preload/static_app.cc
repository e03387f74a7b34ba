// An app that has Bullet inside, as far as a linker sees: its configuration is its own.
class btDefaultCollisionConfiguration {
 public:
  virtual ~btDefaultCollisionConfiguration();
  virtual void* getCollisionAlgorithmCreateFunc(int type_0, int type_1);
  virtual void* getClosestPointsAlgorithmCreateFunc(int type_0, int type_1);
};

btDefaultCollisionConfiguration::~btDefaultCollisionConfiguration() = default;
void* btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(int, int) { return this; }
void* btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(int, int) { return this; }

int main() {
  btDefaultCollisionConfiguration configuration;
  return configuration.getCollisionAlgorithmCreateFunc(0, 0) == &configuration ? 0 : 1;
}
