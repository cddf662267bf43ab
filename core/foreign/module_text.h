#pragma once
// A text in a picture's header, through OpenImageIO, joined where it is stored in pieces. Only the module sees this
// header.

#include <OpenImageIO/imageio.h>

#include <optional>
#include <string>

#include "core/output/long_text.h"

namespace airlight::foreign {

inline std::optional<std::string> text_of(const OIIO::ImageSpec& spec, const std::string& name) {
  return text_in(name, [&](const std::string& key) {
    const OIIO::ParamValue* found = spec.find_attribute(key, OIIO::TypeString);
    return found == nullptr ? std::nullopt : std::optional(found->get_string());
  });
}

}  // namespace airlight::foreign
