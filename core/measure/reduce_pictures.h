#pragma once

#include "core/base/member.h"
#include "core/measure/analyse.h"
#include "core/measure/error_picture.h"
#include "core/measure/shown_pictures.h"

namespace airlight::measure {

// Reduced by the smallest whole factor that leaves at most `most_pixels`, which are at least 1.
ShownPictures reduce_pictures(const PicturePair& pair, const std::vector<float>& errors, const ErrorScale& scale,
                              std::size_t most_pixels);

// The planes of A or of B that are shown: red, green and blue, or one plane three times.
ShownPicture shown_planes(const std::vector<Plane>& planes, MemberOf<Plane, std::vector<float>> side);

}  // namespace airlight::measure
