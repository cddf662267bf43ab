#include "core/measure/error_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/srgb.h"
#include "core/measure/words.h"

namespace airlight::measure {
namespace {

constexpr Colour kPaper = {24, 24, 28};
constexpr Colour kInk = {235, 235, 235};
constexpr int kSmallestShown = 480;  // pixels a picture is enlarged to
constexpr double kSigmaTop = 6.0;
constexpr int kIntervals = 3;           // of the scale; decades when it is logarithmic
constexpr double kBrightExposed = 1.2;  // shown as 0.7 of white

// Enlargement of a picture, and size of the letters.
struct Layout {
  int zoom = 1;
  int text = 1;
  int panel_width = 0;
  int panel_height = 0;
  int margin = 0;
  int title_height = 0;
  int scale_height = 0;
};

Layout layout_for(PictureSize size) {
  Layout layout;
  layout.zoom = std::max(1, (kSmallestShown + size.width - 1) / size.width);
  while (layout.zoom > 1 && layout.zoom * size.height > 4 * kSmallestShown) --layout.zoom;  // for a tall strip
  layout.panel_width = std::max(layout.zoom * size.width, kSmallestShown);
  layout.panel_height = layout.zoom * size.height;
  layout.text = std::max(1, layout.panel_width / 480);
  layout.margin = 4 * layout.text;
  layout.title_height = (kGlyphHeight + 8) * layout.text;
  layout.scale_height = (2 * kGlyphHeight + 18) * layout.text;
  return layout;
}

std::size_t index_of(PictureSize size, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
}

template <class ColourOf>
void draw_panel(Raster& raster, int left, int top, PictureSize size, const Layout& layout, ColourOf colour_of) {
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      raster.fill({left + x * layout.zoom, top + y * layout.zoom, layout.zoom, layout.zoom},
                  colour_of(index_of(size, x, y)));
    }
  }
}

void draw_errors(Raster& raster, int left, int top, std::span<const float> errors, PictureSize size,
                 const Layout& layout, const ErrorScale& scale) {
  draw_panel(raster, left, top, size, layout, [&](std::size_t i) {
    const double error = static_cast<double>(errors[i]);
    return std::isfinite(error) ? error_colour(scale.fraction(error)) : kNotANumber;
  });
}

void draw_title(Raster& raster, int left, int top, const Layout& layout, std::string_view text) {
  raster.write(left + layout.margin, top + layout.margin, layout.text, kInk, text);
}

struct Tick {
  double value;
  std::string label;
};

std::vector<Tick> ticks_of(const ErrorScale& scale) {
  std::vector<Tick> ticks;
  for (int i = 0; i <= kIntervals; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kIntervals);
    const double value = scale.logarithmic ? scale.low * std::pow(scale.high / scale.low, share)
                                           : scale.low + share * (scale.high - scale.low);
    ticks.push_back({value, number(value)});
  }
  ticks.front().label = (scale.logarithmic ? "<" : "") + ticks.front().label;
  ticks.back().label = ">" + ticks.back().label;
  return ticks;
}

// The bar with a number at each tick, and the meaning of the colour outside it.
void draw_scale(Raster& raster, int left, int top, const Layout& layout, const ErrorScale& scale) {
  const std::string outside = "NAN/INF";
  const int t = layout.text;
  const int swatch = kGlyphHeight * t;
  const int bar_left = left + layout.margin;
  const int outside_width = text_width(outside, t) + swatch + 4 * t;
  const int bar_width = layout.panel_width - 2 * layout.margin - outside_width - 6 * t;
  const int bar_height = (kGlyphHeight + 2) * t;
  top += layout.margin;
  for (int x = 0; x < bar_width; ++x) {
    const double share = static_cast<double>(x) / static_cast<double>(std::max(bar_width - 1, 1));
    raster.fill({bar_left + x, top, 1, bar_height}, error_colour(share));
  }
  for (const Tick& tick : ticks_of(scale)) {
    const int x = bar_left + static_cast<int>(std::lround(scale.fraction(tick.value) * (bar_width - 1)));
    raster.fill({x - t / 2, top + bar_height, t, 3 * t}, kInk);
    const int width = text_width(tick.label, t);
    const int place = std::clamp(x - width / 2, bar_left, bar_left + bar_width - width + t);
    raster.write(place, top + bar_height + 4 * t, t, kInk, tick.label);
  }
  const int outside_left = bar_left + bar_width + 6 * t;
  raster.fill({outside_left, top + t, swatch, swatch}, kNotANumber);
  raster.write(outside_left + swatch + 3 * t, top + t, t, kInk, outside);
}

void draw_picture(Raster& raster, int left, int top, const ShownPicture& picture, PictureSize size,
                  const Layout& layout, double exposure) {
  draw_panel(raster, left, top, size, layout, [&](std::size_t i) -> Colour {
    const std::array<double, 3> value = {static_cast<double>(picture.red[i]), static_cast<double>(picture.green[i]),
                                         static_cast<double>(picture.blue[i])};
    Colour colour{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(value[k])) return kNotANumber;
      colour[k] = display_code(exposure * value[k]);
    }
    return colour;
  });
}

}  // namespace

double exposure_for(const ShownPicture& picture) {
  std::vector<double> luminances;
  luminances.reserve(picture.green.size());
  for (std::size_t i = 0; i < picture.green.size(); ++i) {
    const double luminance = bt709_luminance(picture.red[i], picture.green[i], picture.blue[i]);
    if (std::isfinite(luminance) && luminance > 0.0) luminances.push_back(luminance);
  }
  if (luminances.empty()) return 1.0;
  const auto bright = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() * 9 / 10);
  std::nth_element(luminances.begin(), bright, luminances.end());
  return kBrightExposed / *bright;
}

double ErrorScale::fraction(double error) const {
  if (!logarithmic) return std::clamp((error - low) / (high - low), 0.0, 1.0);
  if (error <= low) return 0.0;
  return std::clamp(std::log(error / low) / std::log(high / low), 0.0, 1.0);
}

ErrorScale scale_for(std::span<const float> errors, bool in_sigmas, std::optional<double> top) {
  ErrorScale scale;
  if (in_sigmas) {
    scale.logarithmic = false;
    scale.low = 0.0;
    scale.high = top.value_or(kSigmaTop);
    scale.title = "standard errors, largest of channels";
    return scale;
  }
  double largest = 0.0;
  for (const float error : errors) {
    if (std::isfinite(error)) largest = std::max(largest, static_cast<double>(error));
  }
  // 1e-6: a largest error that is a power of ten up to float precision stays within its decade.
  const double decade = largest > 0.0 ? std::ceil(std::log10(largest) - 1e-6) : -2.0;
  scale.high = top.value_or(std::pow(10.0, decade));
  scale.low = scale.high * std::pow(10.0, -kIntervals);
  scale.title = "relative error, largest of channels";
  return scale;
}

Raster draw_heatmap(std::span<const float> errors, PictureSize size, const ErrorScale& scale) {
  const Layout layout = layout_for(size);
  Raster raster(layout.panel_width, layout.title_height + layout.panel_height + layout.scale_height, kPaper);
  draw_title(raster, 0, 0, layout, scale.title);
  draw_errors(raster, 0, layout.title_height, errors, size, layout, scale);
  draw_scale(raster, 0, layout.title_height + layout.panel_height, layout, scale);
  return raster;
}

Raster draw_side_by_side(const ShownPicture& a, const ShownPicture& b, std::span<const float> errors, PictureSize size,
                         const ErrorScale& scale) {
  const Layout layout = layout_for(size);
  const int stride = layout.panel_width + layout.margin;
  Raster raster(3 * layout.panel_width + 2 * layout.margin,
                layout.title_height + layout.panel_height + layout.scale_height, kPaper);
  const double exposure = exposure_for(b);
  draw_title(raster, 0, 0, layout, "A");
  draw_title(raster, stride, 0, layout, "B");
  draw_title(raster, 2 * stride, 0, layout, scale.title);
  draw_picture(raster, 0, layout.title_height, a, size, layout, exposure);
  draw_picture(raster, stride, layout.title_height, b, size, layout, exposure);
  draw_errors(raster, 2 * stride, layout.title_height, errors, size, layout, scale);
  draw_scale(raster, 2 * stride, layout.title_height + layout.panel_height, layout, scale);
  return raster;
}

}  // namespace airlight::measure
