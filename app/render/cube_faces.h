#pragma once
// `render --cube-faces`: a cube map as six pictures. Each is a perspective picture of 90 degrees and carries that
// preset, so that a face can be rendered again, compared and tilted like any other picture.

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace airlight::cli {

// Throws InputError unless the scene is a cube in the layout "stack".
void require_cube_stack(const Scene& scene);

struct FaceScene {
  std::string name;  // "posx", "negx", "posy", "negy", "posz", "negz": OpenEXR's order
  Scene scene;
  int first_row = 0;  // in the stack
};
std::vector<FaceScene> face_scenes(const Scene& scene);

// "sky.exr", "posx" -> "sky.posx.exr"; empty stays empty.
std::string face_file(const std::string& file, const std::string& face);

}  // namespace airlight::cli
