#pragma once
// `render --cube-faces`: a cube map as six pictures. Each is a perspective picture of 90 degrees and carries that
// preset, so that a face can be rendered again, compared and tilted like any other picture.

#include <vector>

#include "app/render/publish.h"

namespace airlight::cli {

// Throws InputError unless the scene is a cube in the layout "stack".
void require_cube_stack(const Scene& scene);

// A picture for each face, "sky.posx.exr" for "sky.exr", in OpenEXR's order: posx, negx, posy, negy, posz, negz.
std::vector<PicturePart> face_parts(const Scene& scene, const Targets& files);

}  // namespace airlight::cli
