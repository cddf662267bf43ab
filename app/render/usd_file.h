#pragma once
// `render --usd FILE.usda`: a stage that lights a scene with the picture, for programs that read USD.
//
// A UsdLuxDomeLight holds the EXR, a latlong without discs; a UsdLuxDistantLight stands for each of sun and moon. The
// stage's world is the preset's frame: x east, y up, z south, or with z up x east, y north. UsdLux puts the middle of
// a latlong toward +z with +x to its left, as OpenEXR does, so the dome is turned by 180 degrees less the camera's
// azimuth. A distant light shines along its -z; with inputs:normalize its intensity is the irradiance of a surface that
// faces it, whatever its angle.

#include <string>

#include "app/render/picture_files.h"
#include "app/render/run.h"
#include "app/render/targets.h"
#include "core/render/lighting.h"

namespace airlight::cli {

// Throws InputError where no dome can be made: no EXR in a file, or not a whole sky.
void require_dome(const RenderOrder& given, const Scene& scene, const Targets& targets);

// The stage's text. `exr`: the picture's name as the stage's file is to name it; `up`: "y" or "z".
std::string usd_text(const std::string& exr, const std::string& up, const Lighting& lighting,
                     const PictureContext& context);

// Writes it, and returns its name. Throws RunError.
std::string write_usd(const RenderOrder& given, const Lighting& lighting, const PictureContext& context);

}  // namespace airlight::cli
