#include "core/output/color_cube.h"

#include <OpenColorIO/OpenColorIO.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <sstream>

#include "core/output/embedded_config.h"

namespace airlight {
namespace {

namespace ocio = OCIO_NAMESPACE;

constexpr int kBlockWidth = 768, kBlockHeight = 512;

ocio::ConstCPUProcessorRcPtr processor_of(const char* view) {
  std::istringstream text(kEmbeddedConfig);
  const ocio::ConstConfigRcPtr config = ocio::Config::CreateFromStream(text);
  const auto transform = ocio::DisplayViewTransform::Create();
  transform->setSrc("scene_linear");
  transform->setDisplay("sRGB - Display");
  transform->setView(view);
  return config->getProcessor(transform)->getDefaultCPUProcessor();
}

ColorTransform transform_of(const ocio::ConstCPUProcessorRcPtr& processor) {
  return [processor](std::span<float> rgba) {
    ocio::PackedImageDesc pixels(rgba.data(), static_cast<long>(rgba.size() / 4), 1, 4);
    processor->apply(pixels);
  };
}

// A picture of sky-like colours: from 2^-6 to 2^5 across, from orange through grey to blue downwards.
void sky_row(int y, std::span<float> rgba) {
  const float tint = static_cast<float>(y) / kBlockHeight - 0.5F;
  for (int x = 0; x < kBlockWidth; ++x) {
    const float light = std::exp2(11.0F * static_cast<float>(x) / kBlockWidth - 6.0F);
    float* const pixel = &rgba[4 * static_cast<std::size_t>(x)];
    pixel[0] = light * std::exp2(-5.0F * tint);
    pixel[1] = light;
    pixel[2] = light * std::exp2(5.0F * tint);
    pixel[3] = 1.0F;
  }
}

using Rows = std::function<void(int y, std::span<float> rgba)>;

// Prepared for the whole picture at once.
ColorCube cube_of(const Rows& row, const ColorTransform& transform) {
  std::vector<float> picture(4 * static_cast<std::size_t>(kBlockWidth) * kBlockHeight);
  for (int y = 0; y < kBlockHeight; ++y) {
    row(y, std::span(picture).subspan(static_cast<std::size_t>(y) * 4 * kBlockWidth, 4 * kBlockWidth));
  }
  ColorCube cube;
  cube.prepare(picture, transform);
  return cube;
}

double worst_error(const char* view) {
  const ColorTransform exact = transform_of(processor_of(view));
  const ColorCube cube = cube_of(sky_row, exact);
  EXPECT_GT(cube.points(), 0U);
  double worst = 0;
  std::vector<float> fast(4 * kBlockWidth), truth(4 * kBlockWidth);
  for (int y = 0; y < kBlockHeight; ++y) {
    sky_row(y, fast);
    sky_row(y, truth);
    cube.apply(fast, exact);
    exact(truth);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      worst = std::max(worst, std::fabs(std::clamp(fast[i], 0.0F, 1.0F) - std::clamp(truth[i], 0.0F, 1.0F)) * 255.0);
    }
  }
  return worst;
}

TEST(ColorCube, IsWithinHalfACodeOfTheAcesView) {
  EXPECT_LT(worst_error("ACES 1.0 - SDR Video"), 0.5);
}

TEST(ColorCube, IsWithinHalfACodeOfThePlainView) {
  EXPECT_LT(worst_error("Un-tone-mapped"), 0.2);
}

// Piecewise linear interpolation leaves a linear function unchanged if positions, strides and weights are right.
TEST(ColorCube, LeavesALinearTransformAlone) {
  const ColorTransform mix = [](std::span<float> rgba) {
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      const float red = rgba[i], green = rgba[i + 1], blue = rgba[i + 2];
      rgba[i] = 0.5F * red + 0.2F * green + 0.1F * blue + 0.3F;
      rgba[i + 1] = 0.1F * red - 0.7F * green + 0.2F * blue;
      rgba[i + 2] = 2.0F * blue - red;
    }
  };
  const ColorCube cube = cube_of(sky_row, mix);
  ASSERT_GT(cube.points(), 0U);
  const auto inside = [](const float* rgb) { return std::max({rgb[0], rgb[1], rgb[2]}) < 63.0F; };
  std::size_t compared = 0;
  std::vector<float> fast(4 * kBlockWidth), truth(4 * kBlockWidth), source;
  for (int y = 0; y < kBlockHeight; ++y) {
    sky_row(y, fast);
    sky_row(y, truth);
    source = truth;
    cube.apply(fast, [](std::span<float>) {});
    mix(truth);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (inside(&source[i / 4 * 4])) {
        ASSERT_NEAR(fast[i], truth[i], 1e-5F * 64.0F) << y << ", " << i;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 4U * kBlockWidth * kBlockHeight / 2);
}

// A step inside a cell: interpolation would smear it.
TEST(ColorCube, LeavesSharpBendsToTheTransform) {
  const ColorTransform step = [](std::span<float> rgba) {
    for (float& value : rgba) {
      value = value > 0.53F ? 0.8F : 0.2F;
    }
  };
  const ColorCube cube = cube_of(sky_row, step);
  ASSERT_GT(cube.points(), 0U);
  std::vector<float> fast(4 * kBlockWidth), truth(4 * kBlockWidth);
  for (int y = 0; y < kBlockHeight; ++y) {
    sky_row(y, fast);
    sky_row(y, truth);
    cube.apply(fast, step);
    step(truth);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (i % 4 != 3) {
        ASSERT_NEAR(fast[i], truth[i], 1e-6F) << y << ", " << i;
      }
    }
  }
}

TEST(ColorCube, SendsColoursOutsideTheGridThroughTheTransform) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> outside = {64.5F, 1, 1,        1, 1, -0.01F, 1, 1, 1,         1,
                                      nan,   1, infinity, 1, 1, 1,      1, 1, -infinity, 1};
  const auto row = [&](int, std::span<float> rgba) {
    std::fill(rgba.begin(), rgba.end(), 0.5F);
    std::copy(outside.begin(), outside.end(), rgba.begin());
  };
  const ColorTransform mark = [](std::span<float> rgba) { std::fill(rgba.begin(), rgba.end(), 7.0F); };
  const ColorCube cube = cube_of(row, mark);
  ASSERT_GT(cube.points(), 0U);
  std::vector<float> rgba(4 * kBlockWidth);
  row(0, rgba);
  std::atomic<std::size_t> exact = 0;
  cube.apply(rgba, [&](std::span<float> pixels) {
    exact += pixels.size() / 4;
    std::fill(pixels.begin(), pixels.end(), 9.0F);
  });
  EXPECT_EQ(exact, outside.size() / 4);
  EXPECT_EQ(rgba[0], 9.0F);
  EXPECT_EQ(rgba[outside.size()], 7.0F);  // the first colour on the grid
}

// Later colours are prepared later, and no point twice.
TEST(ColorCube, GrowsWithThePicture) {
  const ColorTransform exact = transform_of(processor_of("ACES 1.0 - SDR Video"));
  std::atomic<std::size_t> evaluated = 0;
  const ColorTransform counted = [&](std::span<float> rgba) { evaluated += rgba.size() / 4; };
  ColorCube cube;
  std::vector<float> half(4 * static_cast<std::size_t>(kBlockWidth) * kBlockHeight / 2);
  for (const int part : {0, 1, 0, 1}) {
    for (int y = 0; y < kBlockHeight / 2; ++y) {
      sky_row(part * kBlockHeight / 2 + y,
              std::span(half).subspan(static_cast<std::size_t>(y) * 4 * kBlockWidth, 4 * kBlockWidth));
    }
    cube.prepare(half, counted);
  }
  EXPECT_EQ(evaluated, cube.points());
  EXPECT_EQ(cube.points(), cube_of(sky_row, exact).points());
}

TEST(ColorCube, DeclinesAPictureOfAllColours) {
  const ColorTransform nothing = [](std::span<float>) {};
  const auto noise = [](int y, std::span<float> rgba) {
    std::mt19937 random(static_cast<unsigned>(y));
    for (float& value : rgba) {
      value = std::exp2(static_cast<float>(random() % 1500) / 100.0F - 10.0F);
    }
  };
  EXPECT_EQ(cube_of(noise, nothing).points(), 0U);
}

}  // namespace
}  // namespace airlight
