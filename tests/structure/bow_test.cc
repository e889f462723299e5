#include <gtest/gtest.h>

#include "structure/bow.h"

// The exact bow: end slope a with k = sin(a/2), chord/L_1 = 2 E(k)/K(k) - 1,
// 4 K(k)^2 EI/L_1^2 = S (l - l^-3 - e l), l = lambda_p chord/L_1.
namespace taut::testing
{
namespace
{
struct Row
{
  double pre_stretch, slope, stretch, middle;
};

TEST(Bow, RestShapesAreExact)
{
  for (const Row& row : {Row{2, .9030373789, 1.6091813971, .2636755134},
                         Row{3, 1.5264068249, 1.4507784387, .3765497001},
                         Row{4, 1.7630879393, 1.3510502791, .3968142391}})
  {
    Bow bow;
    bow.pre_stretch = row.pre_stretch;
    Model model(make_bow_device(bow), make_bow_mesh(bow));
    auto& structure = *model.structure;
    structure::LoadHistory history(structure.device());
    history.enter_interval(0);
    std::vector<double> u(structure.n_free(), 0.);
    const auto shape = structure::find_rest_shape(structure, history,
                                                  structure::Networks::relaxed,
                                                  nullptr, 0, {}, u.data());
    EXPECT_EQ(shape.negative_eigenvalues, 0);
    EXPECT_GT(shape.flat_negative_eigenvalues, 0);
    const auto measured = measure_bow(structure, history.at(0), u.data());
    EXPECT_NEAR(measured.slope, row.slope, 1e-5);
    EXPECT_NEAR(measured.chord / bow.film_length, row.stretch, 1e-5);
    EXPECT_NEAR(measured.middle / bow.length(), row.middle, 1e-5);
  }
}
} // namespace
} // namespace taut::testing
