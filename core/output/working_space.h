#pragma once
// The linear spaces that an EXR's colours may be in. airlight computes in linear Rec.709; the others are reached
// through OpenColorIO: ACES2065-1 and ACEScg, whose white is not D65, by the Bradford adaptation; Rec.2020, of the same
// white, without any.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/radiance_image.h"

namespace airlight {

enum class WorkingSpace { linear_rec709, acescg, aces2065_1, linear_rec2020 };

// "linear-rec709", "ACEScg", "ACES2065-1", "linear-rec2020": for options, their help and messages; in the enum's order.
std::span<const std::string> working_space_names();
std::optional<WorkingSpace> working_space(std::string_view name);

// CIE xy of red, green, blue and white, as OpenEXR's attribute of the name.
using Chromaticities = std::array<float, 8>;
Chromaticities chromaticities_of(WorkingSpace space);

// Rows: what red, green and blue of linear Rec.709 give to each channel of the space, as OpenColorIO has it.
using ColorMatrix = std::array<std::array<double, 3>, 3>;
ColorMatrix from_rec709(WorkingSpace space);

// From linear Rec.709, or back to it. Alpha passes unchanged. No entry of the matrices to wider spaces is negative, so
// that no value that is not negative becomes so, and a standard error converted like a colour is the bound that holds
// however the channels' errors hang together.
RadianceImage converted(RadianceImage image, WorkingSpace from, WorkingSpace to);

}  // namespace airlight
