#include "core/render/sky_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
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

PatchMeans::PatchMeans(const SkyPatches& patches, int width, int height) : count_(patches.count()) {
  constexpr int kPoints = 4;  // in each direction of a pixel
  std::vector<double> weights(count_, 0.0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::map<std::size_t, double> shares;  // of a pixel among patches
      for (int i = 0; i < kPoints * kPoints; ++i) {
        const double elevation = 0.5 * pi - pi * (y + (i / kPoints + 0.5) / kPoints) / height;
        const double azimuth = 2.0 * pi * (x + (i % kPoints + 0.5) / kPoints) / width - pi;
        shares[patches.at(elevation, azimuth)] += std::cos(elevation);
      }
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      for (const auto& [patch, weight] : shares) {
        pieces_.push_back({pixel, patch, weight});
        weights[patch] += weight;
      }
    }
  }
  for (Piece& piece : pieces_) {
    piece.weight /= weights[piece.patch];
  }
}

std::vector<std::array<double, 3>> PatchMeans::of(const RadianceImage& latlong) const {
  std::vector<std::array<double, 3>> means(count_);
  for (const Piece& piece : pieces_) {
    const float* const pixel = latlong.rgba.data() + 4 * piece.pixel;
    for (std::size_t c = 0; c < 3; ++c) {
      means[piece.patch][c] += piece.weight * static_cast<double>(pixel[c]);
    }
  }
  return means;
}

}  // namespace airlight
