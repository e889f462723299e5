// Modes of springs and masses in a row, and damped oscillators, against closed
// forms.
#include <taut/base/exceptions.h>
#include <taut/time/damped_modes.h>
#include <taut/time/vibration_modes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::time
{
namespace
{
/// Independent oscillators, dealt out to the ranks in turn.
class Oscillators : public VibrationProblem
{
public:
  Oscillators(const std::vector<double>& stiffnesses,
              const std::vector<double>& masses)
  {
    int rank = 0, n_ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
    for (std::size_t i = rank; i < masses.size(); i += n_ranks)
    {
      stiffnesses_.push_back(stiffnesses[i]);
      masses_.push_back(masses[i]);
    }
  }
  MPI_Comm communicator() const override
  {
    return MPI_COMM_WORLD;
  }
  std::size_t n_unknowns() const override
  {
    return masses_.size();
  }
  void multiply_mass(const double* x, double* result) override
  {
    for (std::size_t i = 0; i < masses_.size(); ++i)
      result[i] = masses_[i] * x[i];
  }
  int factorise(const double shift) override
  {
    int negative = 0, singular = 0;
    pivots_.clear();
    for (std::size_t i = 0; i < masses_.size(); ++i)
    {
      pivots_.push_back(stiffnesses_[i] - shift * masses_[i]);
      negative += pivots_.back() < 0;
      singular += pivots_.back() == 0;
    }
    for (int* number : {&negative, &singular})
      MPI_Allreduce(MPI_IN_PLACE, number, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    if (singular > 0)
      throw StepRejected("singular");
    return negative;
  }
  void solve(const double* r, double* d) override
  {
    for (std::size_t i = 0; i < masses_.size(); ++i)
      d[i] = r[i] / pivots_[i];
  }

private:
  std::vector<double> stiffnesses_, masses_, pivots_;
};

ModeSearch find(Oscillators oscillators, const unsigned int count,
                const std::optional<double>& target = std::nullopt)
{
  ModeOptions options;
  options.count = count;
  options.target = target;
  return find_modes(oscillators, options);
}

std::vector<double> get_squares(const ModeSearch& search)
{
  std::vector<double> squares;
  for (const auto& mode : search.modes)
    squares.push_back(mode.square);
  return squares;
}

void expect_near(const std::vector<double>& found,
                 const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-7 * std::abs(expected.back()));
}

/// A hundred stiffnesses from 1000 on with masses that make the squares 100 i.
Oscillators make_row(std::vector<double> stiffnesses = {},
                     std::vector<double> masses = {})
{
  for (unsigned int i = 1; i <= 100; ++i)
  {
    masses.push_back(1 + .01 * i);
    stiffnesses.push_back(100. * i * masses.back());
  }
  return {stiffnesses, masses};
}

TEST(VibrationModes, LowestOnesAreFoundWhateverTheirSign)
{
  expect_near(get_squares(find(make_row(), 3)), {100, 200, 300});
  // Unstable, rigid and multiple ones.
  const auto search =
      find(make_row({-800, 0, 0, 100, -5e4}, {1, 3, 3, 1, 1}), 6);
  EXPECT_TRUE(search.complete);
  expect_near(get_squares(search), {-5e4, -800, 0, 0, 100, 100});
  // Far from zero.
  expect_near(get_squares(find({{1e9, 1.1e9, 1.3e9}, {1, 1, 1}}, 2)),
              {1e9, 1.1e9});
}

TEST(VibrationModes, UnknownsWithoutMassHaveNone)
{
  expect_near(get_squares(find({{1, 4, 9, 2, 3}, {1, 1, 1, 0, 0}}, 5)),
              {1, 4, 9});
  EXPECT_THROW(find({{1, 4, -9}, {1, 1, 0}}, 1), SolverFailed);
}

TEST(VibrationModes, TargetTakesThoseNextToIt)
{
  expect_near(get_squares(find(make_row(), 3, 5030.)), {4900, 5000, 5100});
  // On a mode the factorisation steps aside.
  expect_near(get_squares(find(make_row(), 1, 700.)), {700});
}

TEST(VibrationModes, ShapesHaveUnitMass)
{
  auto row = make_row();
  for (const auto& mode : find_modes(row, {}).modes)
  {
    std::vector<double> product(mode.shape.size());
    row.multiply_mass(mode.shape.data(), product.data());
    double mass = 0;
    for (std::size_t i = 0; i < product.size(); ++i)
      mass += product[i] * mode.shape[i];
    MPI_Allreduce(MPI_IN_PLACE, &mass, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_NEAR(mass, 1, 1e-12);
  }
}

TEST(DampedModes, OscillatorWithADamper)
{
  // s^2 + 2 zeta omega s + omega^2.
  const double omega = 30;
  for (const double zeta : {0., .1, .7})
  {
    const auto rate =
        find_damped_rate({1, {omega * omega}, {2 * zeta * omega}, {}}, {1.});
    EXPECT_NEAR(rate.real(), -zeta * omega, 1e-10 * omega);
    EXPECT_NEAR(rate.imag(), omega * std::sqrt(1 - zeta * zeta), 1e-10 * omega);
  }
  // Too much to swing: the slower of both.
  const auto slow = find_damped_rate({1, {1}, {4}, {}}, {1.});
  EXPECT_NEAR(slow.real(), -2 + std::sqrt(3.), 1e-12);
  EXPECT_EQ(slow.imag(), 0);
  const auto unstable = find_damped_rate({1, {-4}, {0}, {}}, {1.});
  EXPECT_NEAR(unstable.real(), 2, 1e-12);
}

TEST(DampedModes, ShapeChoosesAmongThem)
{
  // Coupled by a weak relaxation: near 1 and near 10.
  const DampedVibration pair{
      2, {1, 0, 0, 100}, {0, 0, 0, 0}, {{{1e-3, 1e-3, 1e-3, 1e-3}, 1.}}};
  EXPECT_NEAR(find_damped_rate(pair, {1., 0.}).imag(), 1, 1e-3);
  EXPECT_NEAR(find_damped_rate(pair, {0., 1.}).imag(), 10, 1e-3);
  // First order: -Im of 1e-3/(1 + i omega T)/(2 omega).
  EXPECT_NEAR(find_damped_rate(pair, {1., 0.}).real(), -1e-3 / 4, 1e-6);
}
} // namespace
} // namespace taut::time
