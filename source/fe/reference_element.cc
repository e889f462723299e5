#include <taut/base/exceptions.h>
#include <taut/fe/reference_element.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

namespace taut::fe
{
namespace
{
/// FE_Q numbers the two end points of a line first, then its middle.
void fill_line(const unsigned int degree, ReferenceElement& element)
{
  const dealii::FE_Q<1> fe(degree);
  const dealii::QGauss<1> quadrature(degree + 1);
  element.line_weights = quadrature.get_weights();
  for (const auto& point : quadrature.get_points())
    for (unsigned int k = 0; k < fe.n_dofs_per_cell(); ++k)
    {
      element.line_values.push_back(fe.shape_value(k, point));
      element.line_gradients.push_back(fe.shape_grad(k, point)[0]);
    }
}
} // namespace

ReferenceElement::ReferenceElement(const unsigned int degree)
    : degree(degree), n_nodes((degree + 1) * (degree + 1))
{
  if (degree != 1 && degree != 2)
    throw BadInput("the degree of the film's quads must be 1 or 2, not " +
                   std::to_string(degree));
  const dealii::FE_Q<2> fe(degree);
  const dealii::QGauss<2> quadrature(degree + 1);
  weights = quadrature.get_weights();
  for (const auto& point : quadrature.get_points())
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
    {
      const auto gradient = fe.shape_grad(a, point);
      values.push_back(fe.shape_value(a, point));
      gradients.insert(gradients.end(), {gradient[0], gradient[1]});
    }
    points.insert(points.end(), {point[0], point[1]});
  }
  fill_line(degree, *this);
  // Vertices of the faces of a deal.II quad; node 4 + f is the middle of face
  // f.
  constexpr unsigned int vertices[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
  for (unsigned int face = 0; face < 4; ++face)
  {
    face_nodes.push_back({vertices[face][0], vertices[face][1]});
    if (degree == 2)
      face_nodes.back().push_back(4 + face);
  }
}
} // namespace taut::fe
