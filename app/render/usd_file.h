#pragma once
// `--usd FILE.usda` of render and sequence: a stage that lights a scene with the picture, for programs that read USD.
//
// A UsdLuxDomeLight holds the EXR, a latlong without discs; a UsdLuxDistantLight stands for each of sun and moon. The
// stage's world is the preset's frame: x east, y up, z south, or with z up x east, y north. UsdLux puts the middle of
// a latlong toward +z with +x to its left, as OpenEXR does, so the dome is turned by 180 degrees less the camera's
// azimuth. A distant light shines along its -z; with inputs:normalize its intensity is the irradiance of a surface that
// faces it, whatever its angle.

#include <optional>
#include <span>
#include <string>

#include "app/render/picture_files.h"
#include "app/render/run.h"
#include "app/render/targets.h"
#include "core/render/lighting.h"

namespace airlight::cli {

// Throws InputError where no dome can be made: no EXR in a file, or not a whole sky.
void require_dome(const RenderOrder& given, const Scene& scene, const Targets& targets);

// The same of a scene whose EXRs are told. `command`: "render".
void require_latlong_dome(const Scene& scene, const PictureOptions& options, const std::string& command);

// A sky of the stage at a time code, which is a frame's number.
struct UsdSample {
  long frame = 0;
  std::string exr;       // as the stage's file is to name it: exr_from_stage()
  double azimuth = 0.0;  // of the picture's middle, radians
  SunLight sun;
  std::optional<SunLight> moon = {};
};

std::string exr_from_stage(const std::string& stage, const std::string& exr);

// The stage's text. One sky stands for all time; of several, in the order of their frames, each value has a time
// sample for each. `up`: "y" or "z"; `doc`: one line about the scene; `frames_a_second`: of the time codes.
std::string usd_text(std::span<const UsdSample> skies, const std::string& up, const std::string& doc,
                     int frames_a_second = 24);

// Writes the stage of one picture, and returns its name. Throws RunError.
std::string write_usd(const RenderOrder& given, const Lighting& lighting, const PictureContext& context);

}  // namespace airlight::cli
