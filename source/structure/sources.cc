#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/structure/sources.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

namespace taut::structure
{
namespace
{
/// Sums that an exact voltage leaves of Q differ by less, relative to Q.
constexpr double round_off = 1e-13;

double dot(const std::vector<double>& a, const double* b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

[[noreturn]] void refuse_charge(const std::string& electrode,
                                const double charge, const double voltage,
                                const double capacitance)
{
  throw StepRejected("no voltage gives electrode '" + electrode +
                     "' the charge " + number_text(charge) + " C: at " +
                     number_text(voltage) + " V its capacitance is " +
                     number_text(capacitance) +
                     " F, and beyond the wrinkled film widens without end");
}

/// The voltage between `low` and `high`, at which the charge is less and not
/// less than `charge`; all positive.
double find_between(const CapacitanceOf& capacitance_of, const double charge,
                    const double low, const double high)
{
  const auto excess = [&](const double voltage)
  {
    const auto capacitance = capacitance_of(voltage);
    return capacitance ? *capacitance * voltage - charge : charge;
  };
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(50),
      iterations);
  return std::abs(excess(bracket.first)) < std::abs(excess(bracket.second))
             ? bracket.first
             : bracket.second;
}
} // namespace

CircuitCurrents compute_currents(const Electrode& circuit,
                                 const double source_voltage,
                                 const double voltage)
{
  return {(source_voltage - voltage) / circuit.series_resistance,
          voltage / circuit.leakage_resistance};
}

double compute_rest_voltage(const Electrode& circuit,
                            const double source_voltage)
{
  return source_voltage /
         (1 + circuit.series_resistance / circuit.leakage_resistance);
}

double get_conductance(const Electrode& electrode)
{
  return electrode.control == Electrode::Control::circuit
             ? 1 / electrode.series_resistance +
                   1 / electrode.leakage_resistance
             : 0;
}

std::vector<unsigned int>
find_circuits(const std::vector<Electrode>& electrodes)
{
  std::vector<unsigned int> circuits;
  for (unsigned int e = 0; e < electrodes.size(); ++e)
    if (electrodes[e].control == Electrode::Control::circuit)
      circuits.push_back(e);
  return circuits;
}

void give_charges(const std::vector<Electrode>& electrodes,
                  const std::vector<double>& charges, LoadState& loads)
{
  for (const unsigned int e : find_circuits(electrodes))
  {
    loads.charge_is_given[e] = true;
    loads.charges[e] = charges[e];
    loads.voltages[e] = std::numeric_limits<double>::quiet_NaN();
  }
}

double find_voltage(const CapacitanceOf& capacitance_of, const double charge,
                    double voltage, const std::string& electrode)
{
  if (charge == 0)
    return 0;
  const double target = std::abs(charge);
  voltage = std::abs(voltage);
  auto capacitance = capacitance_of(voltage);
  if (!capacitance)
  {
    voltage = 0;
    capacitance = capacitance_of(voltage);
  }
  // Without voltage the film alone is to blame, as the forces will say.
  if (!capacitance || !(*capacitance > 0))
    return 0;
  const double other = target / *capacitance;
  const auto at_other = capacitance_of(other);
  double found = other;
  if (!at_other || std::abs(*at_other * other - target) > round_off * target)
    found = find_between(capacitance_of, target, std::min(voltage, other),
                         std::max(voltage, other));
  // Where the charge jumps to infinity the search ends, too.
  constexpr double tolerance = 1e-9;
  const auto at_found = found == other ? at_other : capacitance_of(found);
  if (!at_found || std::abs(*at_found * found - target) > tolerance * target)
  {
    const double last = found * (1 - 1e-9);
    refuse_charge(electrode, charge, last,
                  capacitance_of(last).value_or(*capacitance));
  }
  return std::copysign(found, charge);
}

void SourceBorder::reset(const MPI_Comm communicator, const double alpha)
{
  communicator_ = communicator;
  alpha_ = alpha;
  columns_.clear();
  solutions_.clear();
}

void SourceBorder::add(Column column)
{
  columns_.push_back(std::move(column));
}

double SourceBorder::get_weight(const Column& column) const
{
  return 1 / (column.capacitance + column.conductance / alpha_);
}

std::vector<double> SourceBorder::multiply_columns(const double* x) const
{
  std::vector<double> products;
  for (const Column& column : columns_)
    products.push_back(dot(column.b, x));
  dealii::Utilities::MPI::sum(products, communicator_, products);
  return products;
}

void SourceBorder::add_product(const double* x, double* result) const
{
  if (empty())
    return;
  const auto products = multiply_columns(x);
  for (std::size_t k = 0; k < columns_.size(); ++k)
  {
    const double factor = products[k] * get_weight(columns_[k]);
    for (std::size_t i = 0; i < columns_[k].b.size(); ++i)
      result[i] += factor * columns_[k].b[i];
  }
}

void SourceBorder::eliminate(const std::function<void(double*)>& solve)
{
  if (empty())
    return;
  const std::size_t m = columns_.size();
  solutions_.clear();
  schur_.reinit(m);
  for (std::size_t k = 0; k < m; ++k)
  {
    solutions_.push_back(columns_[k].b);
    solve(solutions_.back().data());
    const auto products = multiply_columns(solutions_.back().data());
    for (std::size_t j = 0; j < m; ++j)
      schur_(j, k) = products[j] + (j == k ? 1 / get_weight(columns_[k]) : 0.);
  }
  schur_factors_ = schur_;
  try
  {
    schur_factors_.compute_lu_factorization();
  }
  catch (const dealii::LACExceptions::ExcSingular&)
  {
    throw StepRejected("the tangent with the sources is singular");
  }
}

void SourceBorder::correct(double* x) const
{
  if (empty())
    return;
  const auto products = multiply_columns(x);
  dealii::Vector<double> share(products.begin(), products.end());
  schur_factors_.solve(share);
  for (std::size_t k = 0; k < columns_.size(); ++k)
    for (std::size_t i = 0; i < solutions_[k].size(); ++i)
      x[i] -= share[k] * solutions_[k][i];
}

void SourceBorder::add_residuals(const std::vector<double>& residuals,
                                 double* f) const
{
  for (const Column& column : columns_)
  {
    const double factor =
        get_weight(column) * residuals[column.electrode] / alpha_;
    for (std::size_t i = 0; i < column.b.size(); ++i)
      f[i] += factor * column.b[i];
  }
}

void SourceBorder::compute_charge_changes(const double* du,
                                          std::vector<double>& residuals) const
{
  if (empty())
    return;
  const auto products = multiply_columns(du);
  for (std::size_t k = 0; k < columns_.size(); ++k)
  {
    double& charge = residuals[columns_[k].electrode];
    const double voltage =
        get_weight(columns_[k]) * (charge / alpha_ - products[k]);
    charge = columns_[k].capacitance * voltage + products[k];
  }
}

int SourceBorder::count_removed_negative_eigenvalues() const
{
  if (empty())
    return 0;
  dealii::LAPACKFullMatrix<double> matrix = schur_;
  matrix.compute_eigenvalues();
  int count = 0;
  for (std::size_t k = 0; k < columns_.size(); ++k)
    count += matrix.eigenvalue(k).real() < 0;
  return count;
}
} // namespace taut::structure
