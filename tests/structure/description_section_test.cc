#include <taut/structure/description.h>

#include <gtest/gtest.h>

namespace taut::structure
{
namespace
{
RectangularSection make_rectangle(const double width, const double thickness)
{
  RectangularSection rectangle;
  rectangle.width = width;
  rectangle.thickness = thickness;
  rectangle.young_modulus = 2.4;
  rectangle.poisson_ratio = 0.2;
  rectangle.density = 3;
  return rectangle;
}

TEST(FrameSection, StiffnessesOfARectangle)
{
  // G = E/2.4 = 1.
  const BeamSection section = make_section(make_rectangle(6, 2));
  EXPECT_DOUBLE_EQ(section.axial_stiffness, 2.4 * 12);
  EXPECT_DOUBLE_EQ(section.shear_stiffness[0], 10);
  EXPECT_DOUBLE_EQ(section.shear_stiffness[1], 10);
  EXPECT_DOUBLE_EQ(section.bending_stiffness[0], 2.4 * 6 * 8 / 12);
  EXPECT_DOUBLE_EQ(section.bending_stiffness[1], 2.4 * 2 * 216 / 12);
  EXPECT_DOUBLE_EQ(section.thickness, 2);
}

TEST(FrameSection, InertiaOfARectangle)
{
  const BeamSection section = make_section(make_rectangle(6, 2));
  EXPECT_DOUBLE_EQ(section.mass_per_length, 36);
  EXPECT_DOUBLE_EQ(section.rotary_inertia[1], 3 * 4.);
  EXPECT_DOUBLE_EQ(section.rotary_inertia[2], 3 * 36.);
  EXPECT_DOUBLE_EQ(section.rotary_inertia[0],
                   section.rotary_inertia[1] + section.rotary_inertia[2]);
}

TEST(FrameSection, TorsionConstantOfSaintVenant)
{
  // J/(a^3 b) for b/a = 1, 2, 10 (Timoshenko and Goodier), and the limit
  // (1 - .63025 a/b)/3 of thin strips.
  EXPECT_NEAR(make_section(make_rectangle(1, 1)).torsional_stiffness, .140577,
              1e-6);
  EXPECT_NEAR(make_section(make_rectangle(2, 1)).torsional_stiffness, 2 * .2287,
              1e-4);
  EXPECT_NEAR(make_section(make_rectangle(10, 1)).torsional_stiffness,
              10 * .3123, 1e-3);
  EXPECT_NEAR(make_section(make_rectangle(30, .6)).torsional_stiffness,
              .216 * 30 * (1 - .63025 * .6 / 30) / 3, 1e-5);
  EXPECT_DOUBLE_EQ(make_section(make_rectangle(1, 3)).torsional_stiffness,
                   make_section(make_rectangle(3, 1)).torsional_stiffness);
}
} // namespace
} // namespace taut::structure
