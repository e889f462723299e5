#include <taut/base/exceptions.h>
#include <taut/time/continuation.h>
#include <taut/time/null_vector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "time/small_problem.h"

using namespace taut;
using namespace taut::time;
using Kind = CurvePoint::Kind;
using Vector = SmallProblem::Vector;

namespace
{
/// A point with all unknowns.
struct Seen
{
  Kind kind;
  double parameter, arc_length;
  int negative;
  Vector x;
};

struct Journey
{
  ContinuationStatistics statistics;
  std::vector<Seen> points;
  Vector x; ///< at the end

  std::vector<Seen> select(const Kind kind) const
  {
    std::vector<Seen> selected;
    for (const Seen& point : points)
      if (point.kind == kind)
        selected.push_back(point);
    return selected;
  }
};

/// Expects every point to be an equilibrium.
Journey travel(SmallProblem& problem, const double start, const double end,
               const Vector& from, const ContinuationOptions& options = {})
{
  std::vector<double> u(problem.n_unknowns() + 1);
  problem.restrict(from, u.data());
  Journey journey;
  journey.statistics = continue_path(
      problem, start, end, u.data(), options,
      [&](const CurvePoint& point)
      {
        std::vector<double> residual(problem.n_unknowns() + 1);
        problem.compute_residual(point.parameter, point.u, residual.data());
        for (const double component : problem.gather(residual.data()))
          EXPECT_NEAR(component, 0, 1e-9);
        journey.points.push_back({point.kind, point.parameter, point.arc_length,
                                  point.negative_eigenvalues.value(),
                                  problem.gather(point.u)});
        return true;
      });
  journey.x = problem.gather(u.data());
  return journey;
}

/// p = x^3 - 3 x: turns at x = -1, p = 2 and at x = 1, p = -2. A second
/// spring follows.
SmallProblem make_fold()
{
  return {2,
          [](const double p, const Vector& x)
          {
            return Vector{x[0] * x[0] * x[0] - 3 * x[0] - p + x[0] - x[1],
                          x[1] - x[0]};
          },
          [](double, const Vector& x) {
            return Vector{3 * x[0] * x[0] - 2, -1, -1, 1};
          }};
}

/// x^3 c + x^5 - (p - b) x = 0 beside y = p: a pitchfork at p = b.
SmallProblem make_pitchfork(const double c, const double fifth, const double b)
{
  return {2,
          [=](const double p, const Vector& x)
          {
            return Vector{c * std::pow(x[0], 3) + fifth * std::pow(x[0], 5) -
                              (p - b) * x[0],
                          2 * (x[1] - p)};
          },
          [=](const double p, const Vector& x)
          {
            return Vector{3 * c * x[0] * x[0] + 5 * fifth * std::pow(x[0], 4) -
                              (p - b),
                          0, 0, 2};
          }};
}
} // namespace

TEST(Continuation, TurnsAtLimitPointsAndFindsWhereADeviceLands)
{
  for (const double way : {1., -1.})
  {
    SmallProblem problem = make_fold();
    const double start = -way * 5;
    const auto journey = travel(problem, start, way * 7, {-way * 2.5, 0});
    EXPECT_EQ(journey.statistics.end, CurveEnd::reached);
    EXPECT_EQ(journey.points.back().parameter, way * 7);
    const auto limits = journey.select(Kind::limit);
    ASSERT_EQ(limits.size(), 2u);
    // The parameter is stationary there.
    EXPECT_NEAR(limits[0].parameter, way * 2, 2e-9);
    EXPECT_NEAR(limits[1].parameter, -way * 2, 2e-9);
    EXPECT_NEAR(limits[0].x[0], -way, 1e-4);
    const auto landings = journey.select(Kind::landing);
    ASSERT_EQ(landings.size(), 1u);
    EXPECT_NEAR(landings[0].parameter, way * 2, 2e-9);
    EXPECT_NEAR(landings[0].x[1], way * 2, 1e-8);
    for (const Seen& point : journey.select(Kind::regular))
      EXPECT_EQ(point.negative, std::abs(point.x[0]) < 1 ? 1 : 0);
  }
}

TEST(Continuation, StopsWhereverAParameterIsAskedFor)
{
  SmallProblem problem = make_fold();
  ContinuationOptions options;
  options.parameters = {0, 6};
  const auto journey = travel(problem, -5, 7, {-2.5, 0}, options);
  const auto requested = journey.select(Kind::requested);
  ASSERT_EQ(requested.size(), 4u);
  const double expected[3] = {-std::sqrt(3.), 0, std::sqrt(3.)};
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(requested[i].x[0], expected[i], 1e-9);
  for (std::size_t i = 1; i < journey.points.size(); ++i)
    EXPECT_GT(journey.points[i].arc_length, journey.points[i - 1].arc_length);
}

TEST(Continuation, TakesTheSideOfAPitchforkThatIsAskedFor)
{
  for (const double side : {1., -1.})
  {
    SmallProblem problem = make_pitchfork(1, 0, .3);
    ContinuationOptions options;
    options.takes_stable_branch = true;
    options.direction.resize(problem.n_unknowns());
    problem.restrict({side, 0}, options.direction.data());
    const auto journey = travel(problem, -1, 1.3, {0, -1}, options);
    const auto bifurcations = journey.select(Kind::bifurcation);
    ASSERT_EQ(bifurcations.size(), 1u);
    EXPECT_NEAR(bifurcations[0].parameter, .3, 1e-9);
    EXPECT_EQ(journey.select(Kind::branch_switch).size(), 1u);
    EXPECT_NEAR(journey.x[0], side, 1e-9);
    for (const Seen& point : journey.points)
      EXPECT_EQ(point.negative, 0);
  }
}

TEST(Continuation, StaysOnThePrimaryBranchUnlessAsked)
{
  SmallProblem problem = make_pitchfork(1, 0, .3);
  const auto journey = travel(problem, -1, 1.3, {0, -1});
  EXPECT_EQ(journey.statistics.bifurcations, 1u);
  EXPECT_EQ(journey.statistics.branch_switches, 0u);
  EXPECT_NEAR(journey.x[0], 0, 1e-9);
  EXPECT_EQ(journey.points.back().negative, 1);
}

TEST(Continuation, LeavesABentShapeForTheStraightOneWhereTheyMeet)
{
  for (const bool switches : {true, false})
  {
    SmallProblem problem = make_pitchfork(1, 0, .3);
    ContinuationOptions options;
    options.takes_stable_branch = switches;
    // The residual grows with the third power of the distance from the point.
    options.newton.tolerance = 1e-13;
    const auto journey = travel(problem, 1.3, -1, {1, 1.3}, options);
    ASSERT_EQ(journey.statistics.bifurcations, 1u);
    EXPECT_EQ(journey.statistics.limit_points, 0u);
    EXPECT_NEAR(journey.select(Kind::bifurcation)[0].parameter, .3, 1e-9);
    // Else it goes over to the mirror image of the shape, up to as far on the
    // other side of the start.
    EXPECT_EQ(journey.statistics.end,
              switches ? CurveEnd::reached : CurveEnd::left);
    EXPECT_NEAR(journey.x[0], switches ? 0 : -std::sqrt(3.6 - .3), 1e-8);
  }
}

TEST(Continuation, FollowsASubcriticalPitchforkToTheStableShape)
{
  // Off the straight branch p - b = x^4 - x^2, turning at x^2 = 1/2.
  SmallProblem problem = make_pitchfork(-1, 1, 0);
  ContinuationOptions options;
  options.takes_stable_branch = true;
  const auto journey = travel(problem, -1, 1, {0, -1}, options);
  const auto switches = journey.select(Kind::branch_switch);
  ASSERT_EQ(switches.size(), 1u);
  EXPECT_EQ(switches[0].negative, 1);
  const auto limits = journey.select(Kind::limit);
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_NEAR(limits[0].parameter, -.25, 2.5e-10);
  // From the straight shape the device snaps to |x| = 1.
  const auto landings = journey.select(Kind::landing);
  ASSERT_EQ(landings.size(), 1u);
  EXPECT_NEAR(landings[0].parameter, 0, 1e-9);
  EXPECT_NEAR(std::abs(landings[0].x[0]), 1, 1e-8);
  EXPECT_NEAR(std::pow(journey.x[0], 2), .5 + std::sqrt(1.25), 1e-8);
}

TEST(Continuation, ExchangesStabilityAtATranscriticalPoint)
{
  // x (x - p) = 0: x = 0 is stable before, x = p after.
  SmallProblem problem(
      1,
      [](const double p, const Vector& x) { return Vector{x[0] * (x[0] - p)}; },
      [](const double p, const Vector& x) { return Vector{2 * x[0] - p}; });
  ContinuationOptions options;
  options.takes_stable_branch = true;
  // The branch goes both ways, to one side it is stable.
  options.direction.assign(problem.n_unknowns(), -1.);
  const auto journey = travel(problem, -1, 1, {0}, options);
  EXPECT_NEAR(journey.x[0], 1, 1e-9);
  EXPECT_EQ(journey.points.back().negative, 0);
}

TEST(Continuation, EndsWhereAClosedPathBegan)
{
  SmallProblem problem(
      1,
      [](const double p, const Vector& x)
      { return Vector{x[0] * x[0] + p * p - 1}; },
      [](double, const Vector& x) { return Vector{2 * x[0]}; });
  const auto journey = travel(problem, .5, 5, {.8});
  EXPECT_EQ(journey.statistics.end, CurveEnd::closed);
  const auto limits = journey.select(Kind::limit);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(limits[0].parameter, 1, 1e-9);
  EXPECT_NEAR(limits[1].parameter, -1, 1e-9);
}

TEST(Continuation, RefusesToGoRoundWithoutEnd)
{
  // A straight path that joins a circle at its top, on which it then stays.
  const auto is_straight = [](const double p, const double x)
  { return p < 0 && x > 1 - p * p / 4; };
  SmallProblem problem(
      1,
      [&](const double p, const Vector& x)
      {
        return Vector{is_straight(p, x[0]) ? x[0] - 1
                                           : .5 * (p * p + x[0] * x[0] - 1)};
      },
      [&](const double p, const Vector& x)
      { return Vector{is_straight(p, x[0]) ? 1 : x[0]}; });
  std::vector<double> u(problem.n_unknowns() + 1, 1.);
  ContinuationOptions options;
  options.noticeable_displacement = .1;
  double angle = 0, lowest = 1;
  EXPECT_THROW(continue_path(problem, -3, 3, u.data(), options,
                             [&](const CurvePoint& point)
                             {
                               const double x = problem.gather(point.u)[0];
                               angle = std::atan2(point.parameter, x);
                               lowest = std::min(lowest, x);
                               return true;
                             }),
               SolverFailed);
  // It is noticed when it is back at the top.
  EXPECT_LT(lowest, -.9);
  EXPECT_NEAR(angle, 0, 1);
}

TEST(Continuation, SaysWhereAPathEnds)
{
  // x = 1 + (1 - p)^(3/2) exists up to p = 1.
  SmallProblem problem(
      1,
      [](const double p, const Vector& x)
      {
        if (p > 1)
          throw StepRejected("no such load");
        return Vector{x[0] - 1 - std::pow(1 - p, 1.5)};
      },
      [](double, const Vector&) { return Vector{1.}; });
  std::vector<double> u(problem.n_unknowns() + 1, 2.);
  double last = 0;
  EXPECT_THROW(continue_path(problem, 0, 2, u.data(), {},
                             [&](const CurvePoint& point)
                             {
                               last = point.parameter;
                               return true;
                             }),
               SolverFailed);
  EXPECT_NEAR(last, 1, 1e-4);
  EXPECT_NEAR(problem.gather(u.data())[0], 1 + std::pow(1 - last, 1.5), 1e-9);
}

TEST(Continuation, EndsAfterItsPointsAndWhenTold)
{
  SmallProblem problem = make_fold();
  ContinuationOptions options;
  options.most_points = 7;
  const auto journey = travel(problem, -5, 7, {-2.5, 0}, options);
  EXPECT_EQ(journey.statistics.end, CurveEnd::most_points);
  EXPECT_EQ(journey.points.size(), 7u);
  std::vector<double> u(problem.n_unknowns() + 1);
  problem.restrict({-2.5, 0}, u.data());
  const auto stopped = continue_path(problem, -5, 7, u.data(), {},
                                     [](const CurvePoint& point)
                                     { return point.parameter < 0; });
  EXPECT_EQ(stopped.end, CurveEnd::stopped);
}

TEST(Continuation, RefusesStepsAndRangesThatAreNone)
{
  SmallProblem problem = make_fold();
  std::vector<double> u(problem.n_unknowns() + 1, -2.5);
  const auto go_on = [](const CurvePoint&) { return true; };
  ContinuationOptions options;
  options.largest_step = 0;
  EXPECT_THROW(continue_path(problem, -5, 7, u.data(), options, go_on),
               BadInput);
  EXPECT_THROW(continue_path(problem, 1, 1, u.data(), {}, go_on), BadInput);
}

TEST(NullVector, IsThatOfTheEigenvalueNearestToZero)
{
  // Eigenvalues 3, -1 and 10 with vectors (1, 1, 0), (1, -1, 0), (0, 0, 1).
  SmallProblem problem(
      3, [](double, const Vector& x) { return x; },
      [](double, const Vector&) { return Vector{1, 2, 0, 2, 1, 0, 0, 0, 10}; });
  const std::vector<double> u(problem.n_unknowns() + 1);
  problem.prepare(0, u.data());
  const auto pair = find_nearest_eigenvalue(problem);
  EXPECT_NEAR(pair.value, -1, 1e-10);
  const Vector mode = problem.gather(pair.vector.data());
  EXPECT_NEAR(std::abs(mode[0]), std::sqrt(.5), 1e-9);
  EXPECT_NEAR(mode[0] + mode[1], 0, 1e-9);
  EXPECT_NEAR(mode[2], 0, 1e-9);
}

TEST(NullVector, ASolveThatFailsRejectsTheState)
{
  class Singular : public SmallProblem
  {
  public:
    using SmallProblem::SmallProblem;
    void solve(const double*, double*) override
    {
      throw StepRejected("singular");
    }
  };
  Singular problem(
      2, [](double, const Vector& x) { return x; },
      [](double, const Vector&) {
        return Vector{1, 0, 0, 1};
      });
  const std::vector<double> u(problem.n_unknowns() + 1);
  problem.prepare(0, u.data());
  EXPECT_THROW(find_nearest_eigenvalue(problem), StepRejected);
}
