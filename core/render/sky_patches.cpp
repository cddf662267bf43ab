#include "core/render/sky_patches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {
namespace {

using std::numbers::pi;

constexpr std::array<int, 7> kAround{30, 30, 24, 24, 18, 12, 6};  // Tregenza's patches, row by row

}  // namespace

SkyPatches::SkyPatches(int factor) : height_(0.5 * pi / (static_cast<double>(kAround.size()) * factor + 0.5)) {
  solid_angles_.push_back(2.0 * pi);
  for (const int around : kAround) {
    for (int part = 0; part < factor; ++part) {
      const double low = height_ * static_cast<double>(rows_.size());
      rows_.push_back({solid_angles_.size(), around * factor});
      const double each = 2.0 * pi * (std::sin(low + height_) - std::sin(low)) / (around * factor);
      solid_angles_.insert(solid_angles_.end(), static_cast<std::size_t>(around * factor), each);
    }
  }
  rows_.push_back({solid_angles_.size(), 1});
  solid_angles_.push_back(2.0 * pi * (1.0 - std::cos(0.5 * height_)));
}

std::size_t SkyPatches::at(double elevation, double azimuth) const {
  if (elevation < 0.0) {
    return 0;
  }
  const Row& row = rows_[std::min(static_cast<std::size_t>(elevation / height_), rows_.size() - 1)];
  const double turn = azimuth / (2.0 * pi) * row.count + 0.5;  // patches are centred on their direction
  const auto k = static_cast<long>(std::floor(turn)) % row.count;
  return row.first + static_cast<std::size_t>(k < 0 ? k + row.count : k);
}

std::array<double, 3> SkyPatches::centre(std::size_t patch) const {
  const auto after = std::ranges::find_if(rows_, [&](const Row& row) { return row.first > patch; });
  const std::size_t r = static_cast<std::size_t>(after - rows_.begin()) - 1;
  const double elevation = r + 1 == rows_.size() ? 0.5 * pi : height_ * (static_cast<double>(r) + 0.5);
  const double azimuth = 2.0 * pi * static_cast<double>(patch - rows_[r].first) / rows_[r].count;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), -std::cos(elevation) * std::cos(azimuth)};
}

std::array<SkyPatches::Share, 4> SkyPatches::around(double elevation, double azimuth) const {
  const std::size_t last = rows_.size() - 1;
  const auto middle = [&](std::size_t r) { return r == last ? 0.5 * pi : height_ * (static_cast<double>(r) + 0.5); };
  const double steps = std::clamp(elevation / height_ - 0.5, 0.0, static_cast<double>(last) - 1e-9);
  const auto low = static_cast<std::size_t>(steps);
  const double from = std::sin(middle(low));
  const double to = std::sin(middle(low + 1));
  const double up = std::clamp((std::sin(elevation) - from) / (to - from), 0.0, 1.0);
  std::array<Share, 4> shares{};
  for (std::size_t part = 0; part < 2; ++part) {
    const Row& row = rows_[low + part];
    const double turn = azimuth / (2.0 * pi) - std::floor(azimuth / (2.0 * pi));
    const double place = turn * row.count;
    const auto k = static_cast<std::size_t>(place);
    const double along = place - std::floor(place);
    const double share = part == 0 ? 1.0 - up : up;
    const auto count = static_cast<std::size_t>(row.count);
    shares[2 * part] = {row.first + k % count, share * (1.0 - along)};
    shares[2 * part + 1] = {row.first + (k + 1) % count, share * along};
  }
  return shares;
}

std::vector<std::array<double, 3>> SkyPatches::means(const RadianceImage& latlong) const {
  constexpr int kPoints = 4;  // in each direction of a pixel
  std::vector<std::array<double, 3>> sums(count());
  std::vector<double> weights(count(), 0.0);
  for (int y = 0; y < kPoints * latlong.height; ++y) {
    const double elevation = 0.5 * pi - pi * (y + 0.5) / (kPoints * latlong.height);
    const double weight = std::cos(elevation);
    for (int x = 0; x < kPoints * latlong.width; ++x) {
      const std::size_t patch = at(elevation, 2.0 * pi * (x + 0.5) / (kPoints * latlong.width) - pi);
      const float* const pixel = latlong.at(x / kPoints, y / kPoints);
      weights[patch] += weight;
      for (std::size_t c = 0; c < 3; ++c) {
        sums[patch][c] += weight * static_cast<double>(pixel[c]);
      }
    }
  }
  for (std::size_t patch = 0; patch < sums.size(); ++patch) {
    for (double& sum : sums[patch]) {
      sum /= weights[patch];
    }
  }
  return sums;
}

}  // namespace airlight
