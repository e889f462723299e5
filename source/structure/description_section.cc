#include <taut/structure/description.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
/// Saint-Venant's torsion constant of a rectangle with sides b >= a (m^4):
///   a^3 b (1/3 - (64/pi^5)(a/b) sum over odd n of tanh(n pi b/(2 a))/n^5).
/// Without tanh the sum is (31/32) zeta(5); what it lacks decays as
/// exp(-n pi b/a), and b >= a.
double compute_torsion_constant(const double width, const double thickness)
{
  const double a = std::min(width, thickness), b = std::max(width, thickness);
  const double pi = std::acos(-1.);
  constexpr double zeta_5 = 1.036927755143369926;
  double sum = 31. / 32 * zeta_5;
  for (unsigned int n = 1; n <= 11; n += 2)
    sum -= 2 / ((1 + std::exp(n * pi * b / a)) * std::pow(n, 5));
  return a * a * a * b * (1. / 3 - 64 / std::pow(pi, 5) * (a / b) * sum);
}
} // namespace

BeamSection make_section(const RectangularSection& rectangle)
{
  const double width = rectangle.width, thickness = rectangle.thickness;
  const double area = width * thickness;
  const double about_2 = area * thickness * thickness / 12;
  const double about_3 = area * width * width / 12;
  const double shear_modulus =
      rectangle.young_modulus / (2 * (1 + rectangle.poisson_ratio));
  constexpr double shear_factor = 5. / 6;
  BeamSection section;
  section.axial_stiffness = rectangle.young_modulus * area;
  section.shear_stiffness.fill(shear_factor * shear_modulus * area);
  section.torsional_stiffness =
      shear_modulus * compute_torsion_constant(width, thickness);
  section.bending_stiffness = {rectangle.young_modulus * about_2,
                               rectangle.young_modulus * about_3};
  section.mass_per_length = rectangle.density * area;
  section.rotary_inertia = {rectangle.density * (about_2 + about_3),
                            rectangle.density * about_2,
                            rectangle.density * about_3};
  section.thickness = thickness;
  return section;
}
} // namespace taut::structure
