#include "app/composite/mend.h"

#include <algorithm>
#include <cmath>

namespace airlight::cli {
namespace {

std::vector<float>* values_of(foreign::Picture& picture, const std::string& name) {
  const auto found = std::ranges::find(picture.channels, name, &foreign::Channel::name);
  return found == picture.channels.end() ? nullptr : &found->values;
}

}  // namespace

MendedLight mend_light(foreign::Picture& picture, const std::array<std::string, 3>& colours, const std::string& alpha,
                       const std::vector<std::uint32_t>& pixel_of) {
  MendedLight mended;
  const auto count = [&](Mended& kind, std::size_t sample) {
    if (kind.count++ == 0) {
      const int pixel = static_cast<int>(pixel_of.empty() ? sample : pixel_of[sample]);
      kind.x = pixel % picture.width;
      kind.y = pixel / picture.width;
    }
  };
  const std::array<std::vector<float>*, 3> rgb{values_of(picture, colours[0]), values_of(picture, colours[1]),
                                               values_of(picture, colours[2])};
  for (std::size_t i = 0; i < rgb[0]->size(); ++i) {
    if (std::ranges::all_of(rgb, [&](const auto* channel) { return std::isfinite((*channel)[i]); })) {
      continue;
    }
    count(mended.colours, i);
    for (std::vector<float>* channel : rgb) {
      (*channel)[i] = 0.0F;
    }
  }
  if (std::vector<float>* const opacity = alpha.empty() ? nullptr : values_of(picture, alpha)) {
    for (std::size_t i = 0; i < opacity->size(); ++i) {
      if (!std::isfinite((*opacity)[i])) {
        count(mended.alphas, i);
        (*opacity)[i] = 1.0F;
      }
    }
  }
  return mended;
}

std::vector<std::string> mended_warnings(const MendedLight& mended, const std::string& file) {
  std::vector<std::string> lines;
  const auto tell = [&](const Mended& kind, const std::string& what) {
    if (kind.count > 0) {
      lines.push_back(file + ": " + std::to_string(kind.count) + what + ", the first at (" + std::to_string(kind.x) +
                      ", " + std::to_string(kind.y) + ")");
    }
  };
  tell(mended.colours, " colours hold NaN or infinity and are taken as black");
  tell(mended.alphas, " alphas hold NaN or infinity and are taken as opaque");
  return lines;
}

}  // namespace airlight::cli
