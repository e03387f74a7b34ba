#include "motion/sampling_planner.h"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <string>

namespace dgd_demos {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Streams of one seed. OMPL's generators take 32 bits.
enum Stream : std::uint64_t { kSampler, kPlanner, kSimplifier };
std::uint_fast32_t StreamSeed(std::uint64_t seed, Stream stream) {
  // By splitmix64, so that neighbouring seeds give generators that have nothing in common.
  std::uint64_t bits = seed * 3 + stream + 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::uint32_t>(bits ^ (bits >> 31)) | 1u;
}

// Length of a branch of the tree at most, rad. Two trees meet by short branches without detours: OMPL's own choice, a
// fifth of the extent, gives longer paths. One tree reaches a goal in a narrow place by long ones: plan_motion
// --planner rrt --seeds 20 has 8 plans within 5 s each with 6 rad, 5 with 1 rad.
double RangeOf(PlannerKind kind) { return kind == PlannerKind::kRrt ? 6 : 1; }

class SeededSampler : public ob::RealVectorStateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint_fast32_t seed) : RealVectorStateSampler(space) {
    rng_.setLocalSeed(seed);
  }
};

template <class Base>
class Seeded : public Base {
 public:
  Seeded(const ob::SpaceInformationPtr& space, std::uint_fast32_t seed) : Base(space) { this->rng_.setLocalSeed(seed); }
};

Configuration ToConfiguration(const ob::State* state, std::size_t joints) {
  const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return Eigen::Map<const Eigen::VectorXd>(values, static_cast<Eigen::Index>(joints));
}

}  // namespace

struct SamplingPlanner::Ompl {
  std::size_t joints;
  std::shared_ptr<ob::RealVectorStateSpace> space;
  ob::SpaceInformationPtr information;
  ob::ProblemDefinitionPtr problem;
  ob::PlannerPtr planner;
  std::unique_ptr<Seeded<og::PathSimplifier>> simplifier;

  ob::ScopedState<ob::RealVectorStateSpace> ToState(const Configuration& configuration) const {
    ob::ScopedState<ob::RealVectorStateSpace> state(space);
    for (std::size_t i = 0; i < joints; ++i)
      state[static_cast<unsigned>(i)] = configuration[static_cast<Eigen::Index>(i)];
    return state;
  }
  JointPath ToJointPath(og::PathGeometric& path) const {
    JointPath configurations;
    for (const ob::State* state : path.getStates()) configurations.push_back(ToConfiguration(state, joints));
    return configurations;
  }
};

SamplingPlanner::SamplingPlanner(PlannerKind kind, const PlanningProblem& problem, std::uint64_t seed)
    : ompl_(std::make_unique<Ompl>()) {
  ompl::msg::noOutputHandler();
  Ompl& ompl = *ompl_;
  ompl.joints = static_cast<std::size_t>(problem.start.size());
  ompl.space = std::make_shared<ob::RealVectorStateSpace>(static_cast<unsigned>(ompl.joints));
  ob::RealVectorBounds bounds(static_cast<unsigned>(ompl.joints));
  for (std::size_t i = 0; i < ompl.joints; ++i) {
    bounds.setLow(static_cast<unsigned>(i), problem.lower[static_cast<Eigen::Index>(i)]);
    bounds.setHigh(static_cast<unsigned>(i), problem.upper[static_cast<Eigen::Index>(i)]);
  }
  ompl.space->setBounds(bounds);
  ompl.space->setStateSamplerAllocator([seed](const ob::StateSpace* space) {
    return std::make_shared<SeededSampler>(space, StreamSeed(seed, kSampler));
  });

  ompl.information = std::make_shared<ob::SpaceInformation>(ompl.space);
  const auto is_valid = [joints = ompl.joints, check = problem.is_valid](const ob::State* state) {
    return check(ToConfiguration(state, joints));
  };
  ompl.information->setStateValidityChecker(is_valid);
  ompl.information->setStateValidityCheckingResolution(kResolution);
  ompl.information->setup();

  ompl.problem = std::make_shared<ob::ProblemDefinition>(ompl.information);
  ompl.problem->setStartAndGoalStates(ompl.ToState(problem.start), ompl.ToState(problem.goal));
  if (kind == PlannerKind::kRrt) {
    ompl.planner = std::make_shared<Seeded<og::RRT>>(ompl.information, StreamSeed(seed, kPlanner));
  } else {
    ompl.planner = std::make_shared<Seeded<og::RRTConnect>>(ompl.information, StreamSeed(seed, kPlanner));
  }
  ompl.planner->params().setParam("range", std::to_string(RangeOf(kind)));
  ompl.planner->setProblemDefinition(ompl.problem);
  ompl.planner->setup();
  ompl.simplifier = std::make_unique<Seeded<og::PathSimplifier>>(ompl.information, StreamSeed(seed, kSimplifier));
}

SamplingPlanner::~SamplingPlanner() = default;

double SamplingPlanner::StepLength() const { return kResolution * ompl_->space->getMaximumExtent(); }

std::optional<FoundPath> SamplingPlanner::FindPath(double time_limit) {
  ompl_->planner->clear();
  ompl_->problem->clearSolutionPaths();
  const ob::PlannerStatus status = ompl_->planner->solve(ob::timedPlannerTerminationCondition(time_limit));
  if (!ompl_->problem->hasSolution()) return std::nullopt;
  return FoundPath{ompl_->ToJointPath(*ompl_->problem->getSolutionPath()->as<og::PathGeometric>()),
                   status == ob::PlannerStatus::EXACT_SOLUTION};
}

JointPath SamplingPlanner::Simplify(const JointPath& path) {
  og::PathGeometric simplified(ompl_->information);
  for (const Configuration& configuration : path) simplified.append(ompl_->ToState(configuration).get());
  constexpr int kMaxRounds = 10;
  for (int round = 0; round < kMaxRounds; ++round) {
    // Not `||`, which would leave out what comes after a success.
    bool is_shorter = ompl_->simplifier->reduceVertices(simplified);
    is_shorter |= ompl_->simplifier->shortcutPath(simplified);
    is_shorter |= ompl_->simplifier->collapseCloseVertices(simplified);
    if (!is_shorter) break;
  }
  return ompl_->ToJointPath(simplified);
}

}  // namespace dgd_demos
