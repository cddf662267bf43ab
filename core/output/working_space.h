#pragma once
// The linear spaces of an EXR's colours. airlight computes in linear Rec.709; OpenColorIO converts to the others: to
// ACES2065-1 and ACEScg, whose white is not D65, by the Bradford adaptation; to Rec.2020, which has the same white,
// without any.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/radiance_image.h"

namespace airlight {

enum class WorkingSpace { linear_rec709, acescg, aces2065_1, linear_rec2020 };

// "linear-rec709", "ACEScg", "ACES2065-1", "linear-rec2020": for options, their help and messages; in the enum's order.
std::span<const std::string> working_space_names();
std::optional<WorkingSpace> working_space(std::string_view name);

// CIE xy of red, green, blue and white, as in OpenEXR's attribute of the name.
using Chromaticities = std::array<float, 8>;
Chromaticities chromaticities_of(WorkingSpace space);

// Each row: weights of linear Rec.709's red, green and blue in one channel of the space, as in OpenColorIO.
using ColorMatrix = std::array<std::array<double, 3>, 3>;
ColorMatrix from_rec709(WorkingSpace space);

// Converts from or to linear Rec.709. Alpha passes unchanged. No entry of the matrices to wider spaces is negative, so
// non-negative values stay so, and a standard error converted like a colour is an upper bound, however the channels'
// errors are correlated.
RadianceImage converted(RadianceImage image, WorkingSpace from, WorkingSpace to);

}  // namespace airlight
