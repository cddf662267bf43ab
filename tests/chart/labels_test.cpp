// Labels of a panel, and the qualities that are charted.
#include "core/chart/labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/chart/qualities.h"
#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::chart {
namespace {

// A decade in each direction on 400 x 200 pixels, letters of 10 x 20.
constexpr Frame kFrame{1.0, 10.0, 1.0, 10.0, 400.0, 200.0, 10.0, 20.0};

struct Box {
  double left, bottom, right, top;
};

Box box_of(const Label& label) {
  const double x = 400.0 * std::log10(label.text_at.x);
  const double y = 200.0 * std::log10(label.text_at.y);
  const double width = 10.0 * static_cast<double>(label.text.size());
  return {label.left ? x : x - width, y - 10.0, label.left ? x + width : x, y + 10.0};
}

TEST(Labels, LieOnNothingAndStayInside) {
  std::vector<Spot> points;
  std::vector<Label> wanted;
  for (int i = 0; i < 40; ++i) {
    points.push_back({std::pow(10.0, 0.5 + 0.5 * std::sin(7.0 * i)), std::pow(10.0, 0.5 + 0.5 * std::cos(11.0 * i))});
    wanted.push_back({"quality " + std::to_string(i), points.back()});
  }
  const std::vector<Label> placed = place_labels(wanted, points, {}, kFrame, 40);
  EXPECT_GE(placed.size(), 5U);
  EXPECT_LT(placed.size(), 40U);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Box a = box_of(placed[i]);
    EXPECT_GE(a.left, 0.0);
    EXPECT_LE(a.right, 400.0);
    EXPECT_GE(a.bottom, 0.0);
    EXPECT_LE(a.top, 200.0);
    for (const Spot& point : points) {
      const double x = 400.0 * std::log10(point.x);
      const double y = 200.0 * std::log10(point.y);
      EXPECT_FALSE(x > a.left && x < a.right && y > a.bottom && y < a.top) << placed[i].text;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Box b = box_of(placed[j]);
      EXPECT_FALSE(a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top)
          << placed[i].text << " on " << placed[j].text;
    }
  }
  EXPECT_EQ(place_labels(wanted, points, {}, kFrame, 3).size(), 3U);
}

TEST(Labels, LeaveTheLineFree) {
  const Spot point{3.0, 3.0};
  const auto place = [&](const std::vector<Spot>& line) {
    return place_labels({{"abc", point}}, {point}, line, kFrame, 1);
  };
  ASSERT_EQ(place({}).size(), 1U);
  EXPECT_TRUE(place({}).front().left);
  EXPECT_GT(place({}).front().text_at.y, 3.0);
  const std::vector<Label> beside = place({point, {4.0, 5.0}});
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_LT(beside.front().text_at.y, 3.0) << "the line rises to the right, where the label would have stood";
}

TEST(Qualities, OfASpectralSceneHaveWavelengths) {
  const auto scene_of = [](const std::string& scattering) {
    return resolve(parse_preset(R"({"airlight": 1, "media": [{"name": "air", "scattering_per_km": )" + scattering +
                                    R"(, "density": {"profile": "exponential", "scale_height_km": 8}}]})",
                                "test", {}),
                   method_infos());
  };
  const Scene plain = scene_of("[0.006, 0.014, 0.033]");
  const Scene spectral = scene_of(R"({"named": "air"})");
  for (const SkyMethod& method : methods()) {
    EXPECT_EQ(charted_qualities(plain, method).size(), method.sweep.size()) << method.info.name;
    const std::vector<ChartedQuality> all = charted_qualities(spectral, method);
    const auto with = [&](const std::string& label) {
      return std::ranges::find(all, label, [](const ChartedQuality& q) { return q.label; });
    };
    const bool many = method.add_coloured_passes != nullptr;
    EXPECT_EQ(all.size(), method.sweep.size() + (many ? 6 : 0)) << method.info.name;
    if (many) {
      EXPECT_EQ(with("4 wavelengths")->scene.spectra->wavelengths, 4);
      EXPECT_FALSE(with(std::string(kThreeChannels))->scene.spectra.has_value());
      EXPECT_EQ(with("default")->scene.spectra->wavelengths, 0);
    }
  }
}

}  // namespace
}  // namespace airlight::chart
