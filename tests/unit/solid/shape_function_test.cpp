#include "slope/solid/shape_function.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace slope::solid {
namespace {

template <class Shape>
class ShapeFunctions : public ::testing::Test {};
using Shapes = ::testing::Types<QuadraticBSpline, Linear>;
TYPED_TEST_SUITE(ShapeFunctions, Shapes);

TYPED_TEST(ShapeFunctions, SumToOneAndReproduceLinearFields) {
  constexpr double size = 0.25;
  for (int k = 0; k < 1000; ++k) {
    const double position = 0.0071 * k;
    const AxisWeights w = TypeParam::weights(position, 1.0 / size);
    double sum = 0.0, field = 0.0, slope_of_one = 0.0, slope = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = size * (w.first + static_cast<double>(a));
      EXPECT_GE(w.value[a], 0.0);
      sum += w.value[a];
      field += w.value[a] * x;
      slope_of_one += w.gradient[a];
      slope += w.gradient[a] * x;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(field, size * position, 1e-13);
    EXPECT_NEAR(slope_of_one, 0.0, 1e-12);
    EXPECT_NEAR(slope, 1.0, 1e-12);
  }
}

TYPED_TEST(ShapeFunctions, GradientIsTheDerivative) {
  constexpr double inverse_size = 4.0, step = 1e-6;
  for (int k = 1; k < 300; ++k) {
    const double position = 0.0137 * k;
    const AxisWeights before = TypeParam::weights(position - step, inverse_size);
    const AxisWeights after = TypeParam::weights(position + step, inverse_size);
    if (before.first != after.first) continue;
    const AxisWeights w = TypeParam::weights(position, inverse_size);
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_NEAR((after.value[a] - before.value[a]) / (2.0 * step) * inverse_size, w.gradient[a], 1e-7);
    }
  }
}

TEST(QuadraticBSpline, HasAContinuousGradientWhereTheNodesChange) {
  constexpr double just_before = 2.5 - 1e-12;
  const AxisWeights before = QuadraticBSpline::weights(just_before, 1.0);
  const AxisWeights after = QuadraticBSpline::weights(2.5, 1.0);
  ASSERT_EQ(before.first + 1, after.first);
  EXPECT_NEAR(before.value[1], after.value[0], 1e-11);
  EXPECT_NEAR(before.gradient[1], after.gradient[0], 1e-11);
  EXPECT_NEAR(before.gradient[0], 0.0, 1e-11);
  EXPECT_NEAR(after.gradient[2], 0.0, 1e-11);
}

}  // namespace
}  // namespace slope::solid
