#include "core/measure/sample_error.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace airlight::measure {
namespace {

TEST(SampleError, IsTheWeightedMeanOverChannels) {
  const std::vector<float> reference{1, 1, 1, 2, 2, 2};
  const std::vector<float> a{1.1F, 1, 1, 2, 2, 2.6F};
  EXPECT_NEAR(sample_error(a, reference).mean, (0.1 / 3 + 0.3 / 3) / 2, 1e-7);
  const std::vector<double> weights{3, 1};
  EXPECT_NEAR(sample_error(a, reference, weights).mean, (3 * 0.1 / 3 + 0.3 / 3) / 4, 1e-7);
  EXPECT_NEAR(sample_error(a, reference).p95, 0.3, 1e-6);
  EXPECT_EQ(sample_error(a, reference).used, 2U);
}

TEST(SampleError, LeavesOutWhatIsBlackInBoth) {
  const std::vector<float> reference{1, 1, 1, 0, 0, 0};
  const std::vector<float> a{1.5F, 1.5F, 1.5F, 0, 0, 0};
  EXPECT_NEAR(sample_error(a, reference).mean, 0.5, 1e-9);
  EXPECT_EQ(sample_error(a, reference).used, 1U);
}

TEST(SampleError, CutsOffWhatHasNoFigure) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sample_error(std::vector<float>{nan, 1, 1}, std::vector<float>{1, 1, 1}).p95, kWorstError);
  EXPECT_EQ(sample_error(std::vector<float>{1, 0, 0}, std::vector<float>{0, 0, 0}).p95, kWorstError);
  EXPECT_EQ(sample_error({}, {}).mean, 0.0);
}

TEST(SampleError, SpreadIsThatOfAMean) {
  // 50 errors each of 0 and 0.2, alternating: their standard deviation is 0.1, that of their mean a tenth of it.
  std::vector<float> a;
  std::vector<float> reference;
  for (int i = 0; i < 100; ++i) {
    for (int c = 0; c < 3; ++c) {
      reference.push_back(1);
      a.push_back(i % 2 == 0 ? 1.0F : 1.2F);
    }
  }
  EXPECT_NEAR(sample_error(a, reference).spread, 0.01, 1e-4);
}

TEST(SampleNoise, IsRelative) {
  EXPECT_NEAR(sample_noise(std::vector<float>{2, 2, 2, 0, 0, 0}, std::vector<float>{0.1F, 0.1F, 0.1F, 0, 0, 0}), 0.05,
              1e-7);
}

}  // namespace
}  // namespace airlight::measure
