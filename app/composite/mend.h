#pragma once
// Light that is no number: one such value would spread over all that is computed of it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/foreign/foreign_picture.h"

namespace airlight::cli {

// Samples of a picture that were mended, and the pixel of the first.
struct Mended {
  std::size_t count = 0;
  int x = 0;
  int y = 0;
};

struct MendedLight {
  Mended colours;  // NaN or infinity in one of R, G and B: the sample is taken as black
  Mended alphas;   // NaN or infinity: the sample is taken as opaque
};

// Mends the channels of these names in place. `alpha`: empty where there is none. `pixel_of`: the pixel of each sample
// of a deep picture; empty for a flat one.
MendedLight mend_light(foreign::Picture& picture, const std::array<std::string, 3>& colours, const std::string& alpha,
                       const std::vector<std::uint32_t>& pixel_of);

// A line for people for each kind that was mended; `file` names the picture.
std::vector<std::string> mended_warnings(const MendedLight& mended, const std::string& file);

}  // namespace airlight::cli
