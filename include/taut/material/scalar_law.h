#pragma once

#include <string>
#include <vector>

// How a property depends on a scalar such as the temperature or the humidity:
// every law gives the factor on the value at its reference.
namespace taut::material
{
/// f = 1.
struct ConstantLaw
{
};

/// f = 1 + c_1 (x - x_0) + c_2 (x - x_0)^2 + ...
struct PolynomialLaw
{
  double reference;                 ///< x_0
  std::vector<double> coefficients; ///< c_i
  double lowest;                    ///< range of x in which the law holds
  double highest;
};

/// Linear between rows.
struct TableLaw
{
  std::vector<double> arguments; ///< increasing
  std::vector<double> factors;
};

/// A factor and its derivative by the scalar.
struct Factor
{
  double value, derivative;
};
Factor compute(const ConstantLaw& law, double argument);
Factor compute(const PolynomialLaw& law, double argument);
Factor compute(const TableLaw& law, double argument);

/// Range of the scalar in which a law holds; infinite where it has no bounds.
struct LawRange
{
  double lowest, highest;
};
LawRange get_range(const ConstantLaw& law);
LawRange get_range(const PolynomialLaw& law);
LawRange get_range(const TableLaw& law);

/// Errors: StepRejected outside the range of a law, as in "the temperature is
/// 401 K, its law holds from 250 to 400 K".
void require_in_range(const LawRange& range, double argument,
                      const std::string& name, const std::string& unit);
} // namespace taut::material
