#pragma once
// What is read of an OpenEXR header by more than one reader.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/output/channel_order.h"
#include "core/output/long_text.h"

namespace airlight {

// A text attribute, joined where it is stored in pieces.
inline std::optional<std::string> text_of(const OPENEXR_IMF_NAMESPACE::Header& header, const std::string& name) {
  return text_in(name, [&](const std::string& key) {
    const auto* found = header.findTypedAttribute<OPENEXR_IMF_NAMESPACE::StringAttribute>(key);
    return found == nullptr ? std::nullopt : std::optional(found->value());
  });
}

// CIE xy of red, green, blue and white, where the header has them.
template <class Number>
std::optional<std::array<Number, 8>> chromaticities_of(const OPENEXR_IMF_NAMESPACE::Header& header) {
  if (!OPENEXR_IMF_NAMESPACE::hasChromaticities(header)) {
    return std::nullopt;
  }
  const OPENEXR_IMF_NAMESPACE::Chromaticities& c = OPENEXR_IMF_NAMESPACE::chromaticities(header);
  return std::array<Number, 8>{c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
}

// Full names of the channels, as they are listed. Throws InputError where one has fewer samples than pixels.
inline std::vector<std::string> channel_names(const OPENEXR_IMF_NAMESPACE::Header& header, const std::string& file) {
  std::vector<std::string> names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    names.emplace_back(channel.name());
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
      throw InputError(file + ": channel '" + names.back() +
                       "' has fewer samples than the picture has pixels; write it with one for each pixel");
    }
  }
  std::ranges::sort(names, is_listed_before);
  return names;
}

}  // namespace airlight
