#include "core/measure/luminance.h"

#include <gtest/gtest.h>

namespace airlight::measure {
namespace {

// ITU-R BT.709-6, item 3.2: 0.2126, 0.7152, 0.0722.
TEST(Luminance, WeightsOfBt709) {
  const auto weights = luminance_weights(kBt709);
  EXPECT_NEAR(weights[0], 0.2126, 1e-4);
  EXPECT_NEAR(weights[1], 0.7152, 1e-4);
  EXPECT_NEAR(weights[2], 0.0722, 1e-4);
}

// ITU-R BT.2020-2: 0.2627, 0.6780, 0.0593.
TEST(Luminance, WeightsOfBt2020) {
  const auto weights = luminance_weights({0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290});
  EXPECT_NEAR(weights[0], 0.2627, 1e-4);
  EXPECT_NEAR(weights[1], 0.6780, 1e-4);
  EXPECT_NEAR(weights[2], 0.0593, 1e-4);
  EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-12);
}

TEST(Luminance, PrimariesOnALineFallBack) {
  EXPECT_EQ(luminance_weights({0.1, 0.1, 0.2, 0.2, 0.3, 0.3, 0.33, 0.33}), luminance_weights(kBt709));
  EXPECT_EQ(luminance_weights({}), luminance_weights(kBt709));
}

TEST(Luminance, IsTheWeightedSum) {
  const auto values =
      luminance(std::vector<float>{1.0F}, std::vector<float>{2.0F}, std::vector<float>{4.0F}, {0.25, 0.5, 0.125});
  EXPECT_FLOAT_EQ(values[0], 1.75F);
}

}  // namespace
}  // namespace airlight::measure
