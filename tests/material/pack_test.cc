// The functions of the material must serve packs of doubles that know nothing
// but arithmetic, sqrt, log and exp: no branch on a value. Those of a tension
// field also compare and choose.
#include <taut/material/tension_field.h>

#include "states.h"

namespace pack
{
struct Pair
{
  double a, b;

  Pair() = default;
  Pair(double both) : a(both), b(both) {}
  Pair(double first, double second) : a(first), b(second) {}

  friend Pair operator+(Pair x, Pair y)
  {
    return {x.a + y.a, x.b + y.b};
  }
  friend Pair operator-(Pair x, Pair y)
  {
    return {x.a - y.a, x.b - y.b};
  }
  friend Pair operator*(Pair x, Pair y)
  {
    return {x.a * y.a, x.b * y.b};
  }
  friend Pair operator/(Pair x, Pair y)
  {
    return {x.a / y.a, x.b / y.b};
  }
  friend Pair operator-(Pair x)
  {
    return {-x.a, -x.b};
  }
};

Pair sqrt(Pair x)
{
  return {std::sqrt(x.a), std::sqrt(x.b)};
}

Pair log(Pair x)
{
  return {std::log(x.a), std::log(x.b)};
}

Pair exp(Pair x)
{
  return {std::exp(x.a), std::exp(x.b)};
}

double largest(Pair x)
{
  return std::max(x.a, x.b);
}

struct Truths
{
  bool a, b;

  friend Truths operator&(Truths x, Truths y)
  {
    return {x.a && y.a, x.b && y.b};
  }
  friend Truths operator|(Truths x, Truths y)
  {
    return {x.a || y.a, x.b || y.b};
  }
  friend Truths operator!(Truths x)
  {
    return {!x.a, !x.b};
  }
};

Truths is_less(Pair x, Pair y)
{
  return {x.a < y.a, x.b < y.b};
}

Pair select(Truths condition, Pair x, Pair y)
{
  return {condition.a ? x.a : y.a, condition.b ? x.b : y.b};
}

bool any(Truths x)
{
  return x.a || x.b;
}
} // namespace pack

namespace
{
using namespace taut::material;
using pack::Pair;
using PairTensor = SymmetricTensor2<Pair>;

PairTensor combine(const Tensor& a, const Tensor& b)
{
  return {{a.xx, b.xx}, {a.yy, b.yy}, {a.xy, b.xy}};
}

/// The same operations in the same order give the same digits, up to fused
/// multiplications.
void expect_pair(const PairTensor& pair, const Tensor& a, const Tensor& b)
{
  const auto near = [](double x, double y)
  { EXPECT_NEAR(x, y, 1e-12 * (1. + std::abs(y))); };
  near(pair.xx.a, a.xx);
  near(pair.yy.a, a.yy);
  near(pair.xy.a, a.xy);
  near(pair.xx.b, b.xx);
  near(pair.yy.b, b.yy);
  near(pair.xy.b, b.xy);
}

class Packs : public testing::Test
{
protected:
  const Elastomer elastomer = make_elastomer();
  const std::size_t networks = elastomer.networks.size();
  const Field field = make_strong_field();
  const State first = make_states(networks)[0];
  const State second = make_states(networks)[1];
  const PairTensor C = combine(first.C, second.C);
  std::vector<PairTensor> A;

  void SetUp() override
  {
    for (std::size_t m = 0; m < networks; ++m)
      A.push_back(combine(first.A[m], second.A[m]));
  }
};

TEST_F(Packs, StressAndStiffnessAreThoseOfEachLane)
{
  PairTensor S;
  Tensor S_first, S_second;
  Matrix3<Pair> D;
  Matrix3<double> D_first, D_second;
  stress_and_stiffness(elastomer, C, A.data(), field, 4., S, D);
  stress_and_stiffness(elastomer, first.C, first.A.data(), field, 4., S_first,
                       D_first);
  stress_and_stiffness(elastomer, second.C, second.A.data(), field, 4.,
                       S_second, D_second);
  expect_pair(S, S_first, S_second);
  expect_pair(stress(elastomer, C, A.data(), field), S_first, S_second);
  for (unsigned int i = 0; i < 3; ++i)
    expect_pair({D[i][0], D[i][1], D[i][2]},
                {D_first[i][0], D_first[i][1], D_first[i][2]},
                {D_second[i][0], D_second[i][1], D_second[i][2]});
}

TEST_F(Packs, FlowIsThatOfEachLane)
{
  std::vector<PairTensor> rate(networks), dA(networks);
  std::vector<Tensor> rate_first(networks), rate_second(networks),
      dA_first(networks), dA_second(networks);
  const Tensor dE = {.1, .2, .3};
  rates(elastomer, C, A.data(), rate.data());
  rates(elastomer, first.C, first.A.data(), rate_first.data());
  rates(elastomer, second.C, second.A.data(), rate_second.data());
  network_response(elastomer, C, A.data(), 4., combine(dE, dE), rate.data(),
                   dA.data());
  network_response(elastomer, first.C, first.A.data(), 4., dE,
                   rate_first.data(), dA_first.data());
  network_response(elastomer, second.C, second.A.data(), 4., dE,
                   rate_second.data(), dA_second.data());
  for (std::size_t m = 0; m < networks; ++m)
  {
    expect_pair(rate[m], rate_first[m], rate_second[m]);
    expect_pair(dA[m], dA_first[m], dA_second[m]);
  }
  expect_pair(
      stress_change(elastomer, C, A.data(), dA.data()),
      stress_change(elastomer, first.C, first.A.data(), dA_first.data()),
      stress_change(elastomer, second.C, second.A.data(), dA_second.data()));
}

TEST_F(Packs, ScalarsAreThoseOfEachLane)
{
  const auto expect = [](const Pair& pair, double a, double b)
  {
    EXPECT_NEAR(pair.a, a, 1e-12 * (1. + std::abs(a)));
    EXPECT_NEAR(pair.b, b, 1e-12 * (1. + std::abs(b)));
  };
  const Tensor* A_first = first.A.data();
  const Tensor* A_second = second.A.data();
  expect(energy(elastomer, C, A.data(), field),
         energy(elastomer, first.C, A_first, field),
         energy(elastomer, second.C, A_second, field));
  expect(dissipation(elastomer, C, A.data()),
         dissipation(elastomer, first.C, A_first),
         dissipation(elastomer, second.C, A_second));
  expect(charge_density(elastomer, C, field, 1e7),
         charge_density(elastomer, first.C, field, 1e7),
         charge_density(elastomer, second.C, field, 1e7));
  EXPECT_DOUBLE_EQ(limit_margin(elastomer, C, A.data()),
                   std::min(limit_margin(elastomer, first.C, A_first),
                            limit_margin(elastomer, second.C, A_second)));
}

TEST(HeldWidthPacks, AreThoseOfEachLane)
{
  Elastomer elastomer = {{}, {}, {}, 0.};
  for (const Spring& spring : make_springs())
    elastomer.networks.push_back({spring, .7, FlowLaw::held_width});
  elastomer.fibres = {make_fibres_across(1e4, 1.2)};
  const std::size_t networks = elastomer.networks.size();
  const Field field = make_strong_field();
  const State first = make_states(0)[0], second = make_states(0)[1];
  const PairTensor C = combine(first.C, second.C);
  const std::vector<Tensor> A(networks, {.7, 1., 0.});
  const std::vector<PairTensor> A_pair(networks, combine(A[0], A[0]));
  PairTensor S;
  Tensor S_first, S_second;
  Matrix3<Pair> D;
  Matrix3<double> D_first, D_second;
  stress_and_stiffness(elastomer, C, A_pair.data(), field, 4., S, D);
  stress_and_stiffness(elastomer, first.C, A.data(), field, 4., S_first,
                       D_first);
  stress_and_stiffness(elastomer, second.C, A.data(), field, 4., S_second,
                       D_second);
  expect_pair(S, S_first, S_second);
  expect_pair({D[0][0], D[1][1], D[0][1]},
              {D_first[0][0], D_first[1][1], D_first[0][1]},
              {D_second[0][0], D_second[1][1], D_second[0][1]});
  std::vector<PairTensor> rate(networks), dA(networks);
  std::vector<Tensor> one(networks), dA_first(networks), dA_second(networks);
  const Tensor dE = {.1, .2, .3};
  rates(elastomer, C, A_pair.data(), rate.data());
  network_response(elastomer, C, A_pair.data(), 4., combine(dE, dE), nullptr,
                   dA.data());
  network_response(elastomer, first.C, A.data(), 4., dE, nullptr,
                   dA_first.data());
  network_response(elastomer, second.C, A.data(), 4., dE, nullptr,
                   dA_second.data());
  rates(elastomer, first.C, A.data(), one.data());
  for (std::size_t m = 0; m < networks; ++m)
  {
    EXPECT_NEAR(rate[m].xx.a, one[m].xx, 1e-12 * (1. + std::abs(one[m].xx)));
    expect_pair(dA[m], dA_first[m], dA_second[m]);
    expect_pair(relaxed_internal(elastomer.networks[m], C),
                relaxed_internal(elastomer.networks[m], first.C),
                relaxed_internal(elastomer.networks[m], second.C));
  }
  EXPECT_NEAR(dissipation(elastomer, C, A_pair.data()).b,
              dissipation(elastomer, second.C, A.data()),
              1e-12 * dissipation(elastomer, second.C, A.data()));
}

TEST_F(Packs, WrinklesAreThoseOfEachLane)
{
  const double stiffness = get_wrinkle_stiffness(elastomer);
  const Tensor shapes[] = {make_turned(2., 1.9, .3), make_turned(1.6, .5, .3),
                           make_turned(.5, .4, .3)};
  const auto find = [&](const Tensor& metric, const std::vector<Tensor>& inner)
  {
    return find_wrinkles(elastomer, metric, inner.data(), field,
                         stress(elastomer, metric, inner.data(), field),
                         stiffness);
  };
  for (const Tensor& a : shapes)
    for (const Tensor& b : shapes)
    {
      const std::vector<Tensor> inner(networks, make_identity<double>());
      const std::vector<PairTensor> inner_pair(networks, make_identity<Pair>());
      const PairTensor both = combine(a, b);
      const auto pair = find_wrinkles(
          elastomer, both, inner_pair.data(), field,
          stress(elastomer, both, inner_pair.data(), field), stiffness);
      const auto of_a = find(a, inner), of_b = find(b, inner);
      expect_pair(pair.metric, of_a.metric, of_b.metric);
      EXPECT_EQ(pair.wrinkled.a, of_a.wrinkled);
      EXPECT_EQ(pair.wrinkled.b, of_b.wrinkled);
      EXPECT_EQ(pair.slack.a, of_a.slack);
      EXPECT_EQ(pair.slack.b, of_b.slack);
      EXPECT_TRUE(pair.admissible.a && pair.admissible.b);
    }
}
} // namespace
