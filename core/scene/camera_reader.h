#pragma once
// What of a preset goes by the projection: `camera`, `image`, `bloom`.

#include "core/scene/section.h"

namespace airlight {

Camera read_camera(const Section& root);
// The picture's size, which a map's layout binds.
ImageSize read_image(const Section& root, const Camera& camera);
// No bloom where it would stop at the edges of a map that is cut.
Bloom read_bloom(const Section& root, const Camera& camera);

}  // namespace airlight
