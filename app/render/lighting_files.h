#pragma once
// `render --irradiance FILE.exr`: the irradiance map, and beside it FILE.json with the spherical harmonics and the sun.

#include <string>
#include <vector>

#include "app/render/picture_files.h"
#include "core/render/lighting.h"

namespace airlight::cli {

// "light.exr" -> "light.json".
std::string lighting_json_file(const std::string& exr);

// One JSON object; colours in the working space of the pictures.
std::string lighting_json(const Lighting& lighting, const PictureContext& context);

// Encodes both files, then writes them. Returns their names. Throws RunError.
std::vector<std::string> write_lighting(const std::string& exr, const Lighting& lighting,
                                        const PictureContext& context);

// "sky.light.json" beside a cube map "sky.ktx2".
std::string cube_light_file(const std::string& cube);

// Writes harmonics, sun and moon in the cube map's axes: x to the right of the camera's azimuth, y up, z back. Returns
// the file's name. Throws RunError.
std::string write_cube_light(const std::string& cube, const Lighting& lighting, const PictureContext& context);

}  // namespace airlight::cli
