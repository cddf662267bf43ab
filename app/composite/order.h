#pragma once
// The options of `airlight composite`.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/scene_options.h"
#include "core/composite/camera.h"
#include "core/composite/depth.h"
#include "core/composite/fog.h"

namespace airlight::cli {

struct CompositeOrder {
  SceneOptions scene;
  std::string beauty;  // a file or a pattern of frames
  std::string layer;   // of the beauty: "ViewLayer.Combined"; empty: found automatically
  std::string depth;   // FILE, FILE:CHANNEL or :CHANNEL; empty: in the beauty's file
  std::string depth_kind = "auto";
  std::string unit = "auto";  // of depth and camera: "m", "km", ... or metres as a number
  std::string camera = "auto";
  std::string up = "y";
  double scale = 1.0;
  std::string beauty_colorspace;    // empty: by its chromaticities
  std::string colorspace;           // of the output; empty: the beauty's
  std::string layers;               // "inscatter,transmittance"
  std::string aerial;               // "march" or "volume"; empty: by the tolerance, else march
  std::optional<double> tolerance;  // mean error of the air that is allowed
  std::string fog;
  std::vector<std::string> fog_parameters;  // KEY=VALUE
  std::string output;
  bool full_float = false;
  bool half = false;
  bool json = false;
  bool quiet = false;
};

struct ExtraLayers {
  bool inscatter = false;
  bool transmittance = false;
};
// Throws InputError for another name.
ExtraLayers extra_layers(const std::string& text);

// Kilometres of a unit; nothing for "auto". Throws InputError.
std::optional<double> unit_km(const std::string& text);

// Throws InputError for an unknown kind, a key that the kind has not, a value that is no number.
std::optional<composite::Fog> fog_of(const CompositeOrder& order);

// Throws InputError for usage that can be judged before a file is read.
void check(const CompositeOrder& order);

// One picture or every frame of the pattern; the exit code.
int run_composite(const CompositeOrder& order);

}  // namespace airlight::cli
