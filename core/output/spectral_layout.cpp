#include "core/output/spectral_layout.h"

#include <algorithm>
#include <charconv>

#include "core/base/text.h"

namespace airlight {
std::string spectral_channel_name(double nm) {
  constexpr int kDigits = 6;
  char text[32];
  std::string number(text, std::to_chars(text, text + sizeof text, nm, std::chars_format::fixed, kDigits).ptr);
  std::replace(number.begin(), number.end(), '.', ',');
  return "S0." + number + "nm";
}

std::string origin_of_colours(const SpectralImage& spectrum) {
  return spectrum.tells_colours ? "the spectrum's integral" : "wavelengths of the scene's own";
}

std::map<std::string, std::string> spectral_attributes(const SpectralImage& spectrum) {
  std::string sunlight;
  for (std::size_t k = 0; k < spectrum.nm.size(); ++k) {
    sunlight +=
        shortest(static_cast<float>(spectrum.nm[k])) + "nm:" + shortest(static_cast<float>(spectrum.sunlight[k])) + ";";
  }
  return {{"spectralLayoutVersion", "1.0"},
          {"emissiveUnits", spectrum.unit},
          {"airlight:sunlight", sunlight},
          {"airlight:picture", origin_of_colours(spectrum)}};
}

}  // namespace airlight
