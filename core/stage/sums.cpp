#include "core/stage/sums.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"

namespace airlight {
namespace {

// Gives each group random numbers of its own.
void take_seed(Scene& scene, std::size_t group) {
  const auto seed = scene.render.parameters.find("seed");
  if (seed != scene.render.parameters.end() && group > 0) {
    const auto mixed =
        static_cast<std::uint32_t>(std::get<int>(seed->second)) + static_cast<std::uint32_t>(group) * 0x9e3779b9U;
    seed->second = static_cast<int>(mixed & 0x7fffffffU);
  }
}

}  // namespace

GroupRuns::GroupRuns(const HostOptions& options, std::size_t count, std::string suffix)
    : options_(options), count_(count), suffix_(std::move(suffix)) {}

HostOptions GroupRuns::start(Scene& group, std::size_t g) {
  if (stopped_) {
    throw RunError("stopped at group " + std::to_string(g) + " of " + std::to_string(count_) +
                   " of the wavelengths; a picture needs them all");
  }
  take_seed(group, g);
  HostOptions mine = options_;
  mine.checkpoint += options_.checkpoint.empty() ? "" : suffix_ + std::to_string(g);
  if (options_.report) {
    mine.report = [this, g](double done) {
      const bool goes_on = options_.report((static_cast<double>(g) + done) / static_cast<double>(count_));
      stopped_ = stopped_ || !goes_on;
      return goes_on;
    };
  }
  return mine;
}

void add_part(RadianceImage& sum, const RadianceImage& part, const std::array<Rgb, 3>& colours) {
  if (sum.rgba.empty()) {
    sum = {part.width, part.height, std::vector<float>(part.rgba.size())};
  }
  for (std::size_t i = 0; i < part.rgba.size(); i += 4) {
    const float* channels = &part.rgba[i];
    for (std::size_t c = 0; c < 3; ++c) {
      sum.rgba[i + c] = static_cast<float>(add_colour(double{sum.rgba[i + c]}, colours, c, double{channels[0]},
                                                      double{channels[1]}, double{channels[2]}));
    }
    sum.rgba[i + 3] = std::max(sum.rgba[i + 3], part.rgba[i + 3]);
  }
}

void add_error(RadianceImage& variance, const RadianceImage& part, const std::array<Rgb, 3>& colours) {
  if (variance.rgba.empty()) {
    variance = {part.width, part.height, std::vector<float>(part.rgba.size())};
  }
  for (std::size_t i = 0; i < part.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      double most = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        most += std::fabs(colours[k][c]) * static_cast<double>(part.rgba[i + k]);
      }
      variance.rgba[i + c] += static_cast<float>(most * most);
    }
    variance.rgba[i + 3] = std::max(variance.rgba[i + 3], part.rgba[i + 3]);
  }
}

void take_roots(RadianceImage& variance) {
  for (std::size_t i = 0; i < variance.rgba.size(); ++i) {
    if (i % 4 != 3) {
      variance.rgba[i] = std::sqrt(variance.rgba[i]);
    }
  }
}

void add_new_lines(std::vector<std::string>& lines, const std::vector<std::string>& more) {
  for (const std::string& line : more) {
    if (std::ranges::find(lines, line) == lines.end()) {
      lines.push_back(line);
    }
  }
}

}  // namespace airlight
