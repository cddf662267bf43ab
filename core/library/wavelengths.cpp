#include "core/library/wavelengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/render/tile_sizes.h"
#include "core/scene/json_format.h"

namespace airlight {
namespace {

// The ends of the standard observer's table, nm.
constexpr double kLowest = 360.0;
constexpr double kHighest = 830.0;
constexpr double kLeastStep = 0.1;
constexpr double kWidestBand = 10.0;
constexpr std::size_t kFewest = 2;
constexpr std::size_t kMost = 96;

// Most wavelengths times pixels: they are kept in memory, 512 MiB of them.
constexpr std::size_t kMostSpectralSamples = std::size_t{1} << 27;

}  // namespace

Nodes wavelengths_from(const std::string& text, const std::string& option) {
  const std::string what = option + ": '" + text + "'";
  const std::string like = std::string("; write for example ") + kUsualWavelengths;
  const std::optional<std::array<double, 3>> numbers = three_numbers(text);
  if (!numbers) {
    throw InputError(what + " is not FIRST:LAST:STEP in nm" + like);
  }
  const auto [first, last, step] = *numbers;
  if (first < kLowest || first > kHighest || last < kLowest || last > kHighest) {
    throw InputError(what + " leaves the range from " + format_number(kLowest) + " to " + format_number(kHighest) +
                     " nm, in which colours and sunlight are known" + like);
  }
  if (!(first < last)) {
    throw InputError(what + " does not ascend: the first wavelength must be below the last" + like);
  }
  if (step < kLeastStep) {
    throw InputError(what + " has a step of " + format_number(step) + " nm; expected at least " +
                     format_number(kLeastStep) + like);
  }
  // A rounding error must not lose the last wavelength.
  const auto count = static_cast<std::size_t>(std::floor((last - first) / step + 1e-9)) + 1;
  if (count < kFewest || count > kMost) {
    throw InputError(what + " is " + (count < kFewest ? "one wavelength" : std::to_string(count) + " wavelengths") +
                     "; expected " + std::to_string(kFewest) + " to " + std::to_string(kMost) + " of them" + like);
  }
  std::vector<double> nm;
  for (std::size_t k = 0; k < count; ++k) {
    nm.push_back(std::min(first + static_cast<double>(k) * step, last));
  }
  return listed_nodes(nm, std::min(step, kWidestBand));
}

void require_spectrum_fits(const Scene& scene, std::size_t wavelengths, const std::string& option) {
  const auto pixels = static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  const std::size_t most = std::min(kMostSpectralSamples / wavelengths, kTileBytes / (4 * sizeof(float)));
  if (pixels > most) {
    throw InputError(option + ": " + std::to_string(scene.image.width) + "x" + std::to_string(scene.image.height) +
                     " are " + std::to_string(pixels) + " pixels; a spectrum of " + std::to_string(wavelengths) +
                     " wavelengths is kept in memory for at most " + std::to_string(most) +
                     " of them; give a smaller --size or a larger step");
  }
}

void require_spectra(const Scene& scene, const std::string& option) {
  if (!scene.spectra) {
    throw InputError(option +
                     ": the preset has three channels and no spectra; give it curves over the wavelength in place of " +
                     "[r, g, b] (presets/README.md, Curves), or take one that has, such as earth");
  }
}

}  // namespace airlight
