#pragma once
// The options for turning pixels into files, shared by every command that writes pictures.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "app/cli/scene_options.h"
#include "core/output/display.h"
#include "core/output/working_space.h"
#include "core/render/render.h"
#include "core/scene/scene.h"

namespace airlight::cli {

// Views of `--view` that no OCIO config knows.
inline constexpr const char* kGpuView = "gpu";                // the GPU tone curve
inline constexpr const char* kDiagnosticView = "diagnostic";  // what kind of number each pixel holds

// Words of `--layers`.
inline constexpr const char* kLightLayers = "light";
inline constexpr const char* kStokesLayers = "stokes";

struct PictureOptions {
  bool full_float = false;
  bool half_float = false;
  std::optional<std::string> exposure;
  std::optional<double> compensation;
  std::string layers;  // empty: none; else a word of --layers
  std::string ocio_config;
  std::optional<std::string> display;
  std::optional<std::string> view;
  int bits = 8;
  std::string colorspace;  // empty: linear-rec709
};

// How many bits an EXR's samples have.
struct ExrDepth {
  bool half = true;
  std::string why = {};  // what required 32 bits that were not asked for; empty: nothing
};

// The depth that --half or --float asks for, else the depth that the picture needs.
ExrDepth exr_depth(const PictureOptions& options, const Rendering& rendering);

// Throws InputError where --half and --float were both given. `command`: "render".
void require_one_depth(const PictureOptions& options, const std::string& command);

// The space of the EXR's colours.
WorkingSpace working_space_of(const PictureOptions& options);

// --exposure, --ev, --layers, --float, --half, --colorspace, --ocio-config, --display, --view, --bits.
std::vector<Option> picture_options(PictureOptions& options);

std::vector<Override> overrides(const PictureOptions& options);

// --tile, for commands whose pictures may have any size.
Option tile_option(std::optional<std::string>& tile);

// None for the views gpu and diagnostic. Throws InputError for a config, display or view that does not exist.
std::optional<DisplayTransform> display_transform(const PictureOptions& options, const Scene& scene);

// The request that the wanted files need.
RenderRequest request_for(const Scene& scene, bool exr, bool png);

LayerSet layer_set(const PictureOptions& options);

// Checks --layers. Throws InputError where layers are impossible: no EXR to hold them, or a method without layers (the
// message names it and those that have them). `command`: "render".
void require_layers(const PictureOptions& options, const Scene& scene, bool exr, const std::string& command);

// The names of EXR and PNG by the two options. A name in .png after -o is the PNG's; "-" is standard output,
// "/dev/stdout" from here on. Throws InputError: two PNGs, two pictures or also --json on standard output, a terminal
// there. `command`: "render".
struct PictureNames {
  std::optional<std::string> exr;
  std::optional<std::string> png;
};
PictureNames picture_names(std::optional<std::string> output, std::optional<std::string> png, bool json,
                           const std::string& command);

// Throws InputError unless the name has the ending; devices may have any name. `option`: "render: --png".
void require_ending(const std::string& file, const std::string& option, const std::string& ending);

}  // namespace airlight::cli
