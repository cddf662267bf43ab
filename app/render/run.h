#pragma once
// Carries out `airlight render`, from options to files on disk.

#include <optional>
#include <string>

#include "app/cli/picture_options.h"
#include "app/cli/place_options.h"
#include "app/cli/sampling_options.h"
#include "app/cli/scene_options.h"

namespace airlight::cli {

// The command line's options.
struct RenderOrder {
  SceneOptions scene;
  PlaceOptions place;
  SamplingOptions sampling;
  std::optional<double> tolerance;
  std::optional<std::string> judge_time;
  std::optional<std::string> exr;
  std::optional<std::string> png;
  std::optional<std::string> tables;
  std::optional<std::string> tile;
  std::optional<std::string> irradiance;
  std::optional<std::string> usd;
  std::optional<std::string> radiance;  // scene of Radiance, the program
  std::string up = "y";                 // of the USD stage
  std::optional<std::string> spectral;
  std::string prefilter;  // "ggx", of a cube map; empty: none
  bool cube_faces = false;
  PictureOptions picture;
  bool timings = false;
  bool json = false;
  bool dry_run = false;
  bool quiet = false;
  bool verbose = false;
};

// Returns the exit code. Throws InputError and RunError; then no file has been changed.
int run_render(const RenderOrder& given);

}  // namespace airlight::cli
