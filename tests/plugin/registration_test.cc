// Which pairs of types the narrowphase takes, in both of the dispatcher's tables, and which stay as they were.
#include <BulletCollision/CollisionDispatch/btEmptyCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

using CreateFunc = btCollisionAlgorithmCreateFunc;

/// Opens the dispatcher's tables.
class OpenDispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  const CreateFunc* Contact(int type_0, int type_1) const { return m_doubleDispatchContactPoints[type_0][type_1]; }
  const CreateFunc* Closest(int type_0, int type_1) const { return m_doubleDispatchClosestPoints[type_0][type_1]; }
};

/// Convex, and not one of the two types that Bullet's GJK treats as flat.
bool IsConvexSolid(int type) {
  return type < CONCAVE_SHAPES_START_HERE && type != BOX_2D_SHAPE_PROXYTYPE && type != CONVEX_2D_SHAPE_PROXYTYPE;
}

bool IsMesh(int type) {
  return type == TRIANGLE_MESH_SHAPE_PROXYTYPE || type == SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE ||
         type == MULTIMATERIAL_TRIANGLE_MESH_PROXYTYPE || type == TERRAIN_SHAPE_PROXYTYPE;
}

/// Whose triangles are pairs of convex shapes; only what is kept of them is ours, in the contact table.
bool IsConvexOnMesh(int type_0, int type_1) {
  return (IsConvexSolid(type_0) && IsMesh(type_1)) || (IsMesh(type_0) && IsConvexSolid(type_1));
}

bool IsConvexOnPlane(int type_0, int type_1) {
  return (IsConvexSolid(type_0) && type_1 == STATIC_PLANE_PROXYTYPE) ||
         (type_0 == STATIC_PLANE_PROXYTYPE && IsConvexSolid(type_1));
}

/// Whose children are pairs that the dispatcher has algorithms for; only which of them are near is found by ours.
bool IsOfCompounds(int type_0, int type_1) {
  const auto may_meet_one = [](int type) {
    return type == COMPOUND_SHAPE_PROXYTYPE || type < CONCAVE_SHAPES_START_HERE || IsMesh(type) ||
           type == STATIC_PLANE_PROXYTYPE;
  };
  return (type_0 == COMPOUND_SHAPE_PROXYTYPE && may_meet_one(type_1)) ||
         (type_1 == COMPOUND_SHAPE_PROXYTYPE && may_meet_one(type_0));
}

template <class Check>
void ForAllTypes(const Check& check) {
  for (int type_0 = 0; type_0 < MAX_BROADPHASE_COLLISION_TYPES; ++type_0) {
    for (int type_1 = 0; type_1 < MAX_BROADPHASE_COLLISION_TYPES; ++type_1) {
      SCOPED_TRACE("types " + std::to_string(type_0) + " and " + std::to_string(type_1));
      check(type_0, type_1);
    }
  }
}

/// What a registration throws; empty if nothing.
template <class Function>
std::string MessageOf(const Function& function) {
  try {
    function();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// The app's headers may be of another version than the plugin's. (Another precision: tests/package.)
TEST(Registration, AnotherVersionOfBullet_IsRefusedInOneSentence) {
  const std::string of_app = "Bullet 9.01", of_plugin = "compiled for Bullet 3.24";
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  for (const std::string& message : {MessageOf([] { dgd_bullet::MakeNarrowphase({}, 901); }),
                                     MessageOf([&] { dgd_bullet::Register(&dispatcher, {}, 901); })}) {
    EXPECT_NE(message.find(of_app), std::string::npos) << message;
    EXPECT_NE(message.find(of_plugin), std::string::npos) << message;
  }
}

TEST(Registration, Configuration_TakesEveryConvexPairInBothTablesAndOrders) {
  dgd_bullet::CollisionConfiguration configuration;
  using Stock = btDefaultCollisionConfiguration;
  const int box = BOX_SHAPE_PROXYTYPE;
  const CreateFunc* contact = configuration.getCollisionAlgorithmCreateFunc(box, box);
  const CreateFunc* closest = configuration.getClosestPointsAlgorithmCreateFunc(box, box);
  ForAllTypes([&](int type_0, int type_1) {
    if (!IsConvexSolid(type_0) || !IsConvexSolid(type_1)) return;
    EXPECT_EQ(configuration.getCollisionAlgorithmCreateFunc(type_0, type_1), contact);
    EXPECT_EQ(configuration.getClosestPointsAlgorithmCreateFunc(type_0, type_1), closest);
    EXPECT_NE(configuration.Stock::getCollisionAlgorithmCreateFunc(type_0, type_1), contact);
    EXPECT_NE(configuration.Stock::getClosestPointsAlgorithmCreateFunc(type_0, type_1), closest);
  });
}

TEST(Registration, Configuration_LeavesTheOtherPairsToBullet) {
  dgd_bullet::CollisionConfiguration configuration;
  ForAllTypes([&](int type_0, int type_1) {
    if (IsConvexSolid(type_0) && IsConvexSolid(type_1)) return;
    EXPECT_EQ(configuration.getCollisionAlgorithmCreateFunc(type_0, type_1) ==
                  configuration.btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(type_0, type_1),
              !IsConvexOnMesh(type_0, type_1) && !IsConvexOnPlane(type_0, type_1) && !IsOfCompounds(type_0, type_1));
    EXPECT_EQ(configuration.getClosestPointsAlgorithmCreateFunc(type_0, type_1) ==
                  configuration.btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(type_0, type_1),
              !IsConvexOnPlane(type_0, type_1));
  });
}

TEST(Registration, Dispatcher_CopiesTheConfigurationsTables) {
  dgd_bullet::CollisionConfiguration configuration;
  const OpenDispatcher dispatcher(&configuration);
  ForAllTypes([&](int type_0, int type_1) {
    EXPECT_EQ(dispatcher.Contact(type_0, type_1), configuration.getCollisionAlgorithmCreateFunc(type_0, type_1));
    EXPECT_EQ(dispatcher.Closest(type_0, type_1), configuration.getClosestPointsAlgorithmCreateFunc(type_0, type_1));
  });
}

TEST(Registration, Register_TakesConvexPairsMeshesPlanesAndCompoundsAndNothingElse) {
  btDefaultCollisionConfiguration configuration;
  const OpenDispatcher before(&configuration);
  OpenDispatcher after(&configuration);
  dgd_bullet::Register(after);
  const CreateFunc* contact = after.Contact(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE);
  const CreateFunc* closest = after.Closest(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE);
  ForAllTypes([&](int type_0, int type_1) {
    if (IsConvexSolid(type_0) && IsConvexSolid(type_1)) {
      EXPECT_EQ(after.Contact(type_0, type_1), contact);
      EXPECT_EQ(after.Closest(type_0, type_1), closest);
      EXPECT_NE(before.Contact(type_0, type_1), contact);
      EXPECT_NE(before.Closest(type_0, type_1), closest);
    } else {
      const bool is_plane = IsConvexOnPlane(type_0, type_1);
      EXPECT_EQ(after.Contact(type_0, type_1) == before.Contact(type_0, type_1),
                !IsConvexOnMesh(type_0, type_1) && !is_plane && !IsOfCompounds(type_0, type_1));
      EXPECT_EQ(after.Closest(type_0, type_1) == before.Closest(type_0, type_1), !is_plane);
    }
  });
}

// GImpact has one create function for its whole row and column, and writes it into the contact table only.
TEST(Registration, Register_KeepsGImpactsRowsWhicheverComesFirst) {
  btDefaultCollisionConfiguration configuration;
  OpenDispatcher gimpact_first(&configuration), gimpact_last(&configuration);
  btGImpactCollisionAlgorithm::registerAlgorithm(&gimpact_first);
  dgd_bullet::Register(gimpact_first);
  dgd_bullet::Register(gimpact_last);
  btGImpactCollisionAlgorithm::registerAlgorithm(&gimpact_last);
  const CreateFunc* gimpact = gimpact_first.Contact(GIMPACT_SHAPE_PROXYTYPE, GIMPACT_SHAPE_PROXYTYPE);
  const CreateFunc* ours = gimpact_first.Contact(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE);
  for (int type = 0; type < MAX_BROADPHASE_COLLISION_TYPES; ++type) {
    EXPECT_EQ(gimpact_first.Contact(GIMPACT_SHAPE_PROXYTYPE, type), gimpact) << type;
    EXPECT_EQ(gimpact_first.Contact(type, GIMPACT_SHAPE_PROXYTYPE), gimpact) << type;
    EXPECT_EQ(gimpact_last.Contact(GIMPACT_SHAPE_PROXYTYPE, type), gimpact) << type;
    EXPECT_EQ(gimpact_last.Contact(type, GIMPACT_SHAPE_PROXYTYPE), gimpact) << type;
  }
  EXPECT_NE(ours, gimpact);
  EXPECT_EQ(gimpact_first.Contact(TRIANGLE_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE), ours);
}

// An engine with an algorithm of its own for two types keeps it by registering it after ours, as Bullet has it.
TEST(Registration, LastRegistered_IsUsed) {
  btDefaultCollisionConfiguration configuration;
  OpenDispatcher dispatcher(&configuration);
  btEmptyAlgorithm::CreateFunc own;
  dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, &own);
  dispatcher.registerClosestPointsCreateFunc(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, &own);
  dgd_bullet::Register(dispatcher);
  EXPECT_NE(dispatcher.Contact(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE), &own);
  EXPECT_NE(dispatcher.Closest(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE), &own);
  dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, &own);
  dispatcher.registerClosestPointsCreateFunc(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, &own);
  EXPECT_EQ(dispatcher.Contact(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE), &own);
  EXPECT_EQ(dispatcher.Closest(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE), &own);
  EXPECT_NE(dispatcher.Contact(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE), &own);
}

// An app may call Bullet's setters on any configuration that derives from Bullet's; they write into its members.
TEST(Registration, MultipointIterationSetters_ChangeNothing) {
  dgd_bullet::CollisionConfiguration configuration;
  configuration.setConvexConvexMultipointIterations(3, 3);
  configuration.setPlaneConvexMultipointIterations(3, 3);
  btCollisionDispatcher dispatcher(&configuration);
  Dispatching untouched(Route::kConfiguration);
  btCylinderShape cylinder(Vec(0.5, 0.5, 0.5));
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  PairQuery with_setters(dispatcher, cylinder, box), without(untouched.dispatcher(), cylinder, box);
  for (PairQuery* pair : {&with_setters, &without}) {
    pair->SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0.1, 0.99, 0.2}), btTransform::getIdentity());
  }
  const std::vector<Contact> contacts = with_setters.Step(), expected = without.Step();
  ASSERT_EQ(contacts.size(), expected.size());
  ASSERT_FALSE(contacts.empty());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_EQ(contacts[i].on_b, expected[i].on_b);
    EXPECT_EQ(contacts[i].depth, expected[i].depth);
  }
  EXPECT_EQ(configuration.statistics().Fallbacks(), 0U);
}

// Pairs that live keep their algorithm; what is made afterwards is ours, also when Bullet's pairs are still around.
TEST(Registration, Register_OnADispatcherWithLivingPairs) {
  Dispatching dispatching(Route::kBuiltin);
  btCollisionDispatcher& dispatcher = dispatching.dispatcher();
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  const btTransform above = MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.99});
  PairQuery old_pair(dispatcher, box, box);
  old_pair.SetPoses(above, btTransform::getIdentity());
  EXPECT_EQ(old_pair.Step().size(), 4U);
  const btCollisionAlgorithm* old_algorithm = old_pair.algorithm();

  dgd_bullet::Register(dispatcher);
  EXPECT_EQ(old_pair.Step().size(), 4U);
  EXPECT_EQ(old_pair.algorithm(), old_algorithm);
  EXPECT_EQ(old_pair.manifold()->getNumContacts(), 4);

  PairQuery new_pair(dispatcher, box, box);
  new_pair.SetPoses(above, btTransform::getIdentity());
  EXPECT_EQ(new_pair.Step().size(), 4U);
  EXPECT_EQ(dispatcher.getNumManifolds(), 2);
  old_pair.Forget();
  EXPECT_EQ(new_pair.Step().size(), 4U);
  new_pair.Forget();
  EXPECT_EQ(dispatcher.getNumManifolds(), 0);
}

TEST(Registration, Register_TwiceUsesTheLastOptions) {
  Dispatching dispatching(Route::kRegister);
  dgd_bullet::Options one_point;
  one_point.contact_patch = false;
  dgd_bullet::Register(dispatching.dispatcher(), one_point);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  PairQuery pair(dispatching.dispatcher(), box, box);
  pair.SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.99}), btTransform::getIdentity());
  EXPECT_EQ(pair.Step().size(), 1U);
}

// A dispatcher may die before the process does; its registered narrowphase stays.
TEST(Registration, Register_OutlivesTheDispatcher) {
  const dgd_bullet::Narrowphase* narrowphase = nullptr;
  {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    narrowphase = &dgd_bullet::Register(&dispatcher);
  }
  EXPECT_EQ(dgd_bullet::StatisticsOf(*narrowphase).Fallbacks(), 0U);
}

TEST(Registration, OptionsOutOfRange_AreRefusedByValue) {
  const auto message = [](const dgd_bullet::Options& options) -> std::string {
    try {
      const dgd_bullet::CollisionConfiguration configuration(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no exception";
  };
  dgd_bullet::Options options;
  EXPECT_EQ(message(options), "no exception");
  for (const double tolerance :
       {0.0, -1e-8, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    options.relative_tolerance = tolerance;
    const std::string text = message(options);
    EXPECT_NE(text.find("relative_tolerance"), std::string::npos) << text;
    EXPECT_NE(text.find(std::to_string(tolerance)), std::string::npos) << text;
  }
  options.relative_tolerance = 1e-8;
  for (const int iterations : {0, -7}) {
    options.max_iterations = iterations;
    const std::string text = message(options);
    EXPECT_NE(text.find("max_iterations"), std::string::npos) << text;
    EXPECT_NE(text.find(std::to_string(iterations)), std::string::npos) << text;
  }
  options.max_iterations = 100;
  for (const int size : {0, 5}) {
    options.patch_size = size;
    const std::string text = message(options);
    EXPECT_NE(text.find("patch_size must be 1 to 4; got " + std::to_string(size)), std::string::npos) << text;
  }
  options.patch_size = 4;
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double distance : {-1.0, kInfinity, kNan}) {
    options.contact_distance = distance;
    EXPECT_NE(message(options).find("contact_distance"), std::string::npos) << distance;
  }
  options.contact_distance = 0.1;
  EXPECT_EQ(message(options), "no exception");
}

TEST(Registration, RegisterWithBadOptions_ChangesNothing) {
  btDefaultCollisionConfiguration configuration;
  OpenDispatcher dispatcher(&configuration);
  const CreateFunc* stock = dispatcher.Contact(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE);
  dgd_bullet::Options options;
  options.max_iterations = 0;
  EXPECT_THROW(dgd_bullet::Register(dispatcher, options), std::invalid_argument);
  EXPECT_EQ(dispatcher.Contact(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE), stock);
}

// Both create functions make the algorithm through the dispatcher's pool, whatever the order of the types.
TEST(Registration, EveryZooPair_GetsAnAlgorithmThatAnswers) {
  for (const Route route : {Route::kConfiguration, Route::kRegister}) {
    Dispatching dispatching(route);
    const std::vector<ZooShape> zoo = MakeShapeZoo(1);
    for (const ZooShape& a : zoo) {
      for (const ZooShape& b : zoo) {
        PairQuery pair(dispatching.dispatcher(), *a.shape, *b.shape);
        pair.SetPoses(btTransform::getIdentity(), MakeTransform(Eigen::Matrix3d::Identity(), {0.1, 0.05, 0.1}));
        EXPECT_FALSE(pair.Step().empty()) << Name(route) << ": " << a.name << " on " << b.name;
        EXPECT_FALSE(pair.ClosestPoints(0).empty()) << Name(route) << ": " << a.name << " on " << b.name;
      }
    }
    EXPECT_EQ(dispatching.dispatcher().getNumManifolds(), 0);
  }
}

}  // namespace
}  // namespace dgd_test
