#include "app/cli/picture_options.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/output/half_block.h"
#include "core/scene/json_format.h"

namespace airlight::cli {
namespace {

bool is_ocio_view(const std::string& view) {
  return view != kGpuView && view != kDiagnosticView;
}

// The exposure in a preset's form: a factor, or a word.
std::string exposure_json(const std::string& text) {
  constexpr std::string_view kLock = "lock:";
  constexpr double kMostStops = 29.0;
  const auto stops = number_from<double>(std::string_view(text).substr(text.size() > 1 && text[0] == '+' ? 1 : 0));
  if (stops && std::abs(*stops) <= kMostStops) {
    return format_number(std::exp2(*stops));
  }
  const bool is_frame =
      text.starts_with(kLock) && number_from<int>(std::string_view(text).substr(kLock.size())).value_or(-1) >= 0;
  if (text != "auto" && text != "day" && !is_frame) {
    throw InputError("--exposure: '" + text +
                     "' is none of auto, day, lock:FRAME (a frame's number) and stops from -29 to 29");
  }
  return json_string(text);
}

}  // namespace

std::vector<Option> picture_options(PictureOptions& options) {
  return grouped(
      "Picture",
      {{"--exposure", "auto|EV|lock:FRAME|day",
        "Exposure of the PNG. auto: from the picture's own light, as an eye adapts. EV: stops over a factor of 1. "
        "lock:FRAME: what auto gives that frame of the sequence. day: what auto gives this view with the sun 45 "
        "degrees high behind the camera",
        &options.exposure},
       {"--ev", "STOPS", "Stops to add to the exposure of the PNG, e.g. +1 to double it", &options.compensation,
        Completes::nothing, Range{-30.0, 30.0}},
       {.names = "--layers",
        .metavar = "[light|stokes]",
        .help =
            "Also write layers into the EXR: the single scattering of each medium under its name, multiple, sun and "
            "ground, whose sum is the picture; transmittance, depth (km) and N, the normal of the ground. stokes "
            "adds Q and U, which tell polarised light; --layers alone means light",
        .target = &options.layers,
        .choices = {kLightLayers, kStokesLayers},
        .implied = kLightLayers},
       {"--float", "",
        "Write 32-bit floats into the EXR (default: 16-bit floats if they hold the picture, otherwise 32-bit floats)",
        &options.full_float},
       {"--half", "", "Write 16-bit floats into the EXR, and warn if they lose something", &options.half_float},
       {"--colorspace",
        "NAME",
        "Linear colour space of the EXR (default: linear-rec709). The header holds its chromaticities. The PNG does "
        "not change",
        &options.colorspace,
        Completes::nothing,
        {},
        {working_space_names().begin(), working_space_names().end()}},
       {"--ocio-config", "FILE",
        "OpenColorIO config for the PNG (default: $OCIO; if it is not set, the built-in config)", &options.ocio_config,
        Completes::file},
       {"--display", "NAME", "Display of the OpenColorIO config", &options.display},
       {"--view",
        "NAME",
        "View of the OpenColorIO display, or gpu for the GPU tone curve, or diagnostic. The diagnostic picture shows "
        "NaN, infinite, negative, zero and other numbers in different colours",
        &options.view,
        Completes::nothing,
        {},
        {},
        {kGpuView, kDiagnosticView}},
       {"--bits",
        "N",
        "Bits of each channel of the PNG (default: 8). 8 bits are dithered",
        &options.bits,
        Completes::nothing,
        {},
        {"8", "16"}}});
}

Option tile_option(std::optional<std::string>& tile) {
  return {"--tile", "WxH",
          "Render in tiles of this size and stream them into the files, in bounded memory. The files are the same. "
          "Without --tile, airlight does this in rows of tiles if a picture has more than 8388608 pixels",
          &tile};
}

ExrDepth exr_depth(const PictureOptions& options, const Rendering& rendering) {
  if (options.full_float || options.half_float) {
    return {options.half_float, {}};
  }
  if (rendering.spectrum) {
    return {false, {}};
  }
  const std::string loss = half_loss(rendering.radiance, rendering.picture.metered_luminance);
  return {loss.empty(), loss};
}

void require_one_depth(const PictureOptions& options, const std::string& command) {
  if (options.full_float && options.half_float) {
    throw InputError(command +
                     ": --half and --float exclude each other; give one, or none: each picture then has the " +
                     "bits that it needs");
  }
}

WorkingSpace working_space_of(const PictureOptions& options) {
  return working_space(options.colorspace).value_or(WorkingSpace::linear_rec709);
}

std::vector<Override> overrides(const PictureOptions& options) {
  std::vector<Override> all;
  if (options.exposure) {
    all.push_back({"/display/exposure=" + exposure_json(*options.exposure), "--exposure " + *options.exposure});
  }
  if (options.compensation) {
    const std::string stops = format_number(*options.compensation);
    all.push_back({"/display/compensation_ev=" + stops, "--ev " + stops});
  }
  if (options.display) {
    all.push_back({"/display/display=" + json_string(*options.display), "--display " + *options.display});
  }
  if (options.view) {
    all.push_back({"/display/view=" + json_string(*options.view), "--view " + *options.view});
  }
  return all;
}

std::optional<DisplayTransform> display_transform(const PictureOptions& options, const Scene& scene) {
  if (!is_ocio_view(scene.display.view)) {
    return std::nullopt;
  }
  DisplaySettings settings;
  settings.config = options.ocio_config;
  settings.display = scene.display.display;
  settings.view = scene.display.view;
  settings.pixels.bits = options.bits;
  settings.pixels.alpha = has_outside(scene.camera);
  return DisplayTransform(settings);
}

RenderRequest request_for(const Scene& scene, bool exr, bool png) {
  RenderRequest request;
  const bool shown = png && scene.display.view != kDiagnosticView;
  request.bloom = shown || (scene.bloom.in_exr && exr);
  request.gpu_tone = shown && scene.display.view == kGpuView;
  request.bloom_picture = !request.gpu_tone || (scene.bloom.in_exr && exr);
  return request;
}

LayerSet layer_set(const PictureOptions& options) {
  return options.layers.empty() ? LayerSet::none : options.layers == kStokesLayers ? LayerSet::stokes : LayerSet::light;
}

void require_layers(const PictureOptions& options, const Scene& scene, bool exr, const std::string& command) {
  if (options.layers.empty()) {
    return;
  }
  if (!exr) {
    throw InputError(command + ": --layers: layers stand in the EXR, and none is written; give -o FILE.exr too");
  }
  if (method_of(scene).add_layer_passes == nullptr) {
    throw InputError(command + ": --layers: " + scene.render.method +
                     " does not tell its light apart; choose --method " + methods_with_layers());
  }
  if (const std::string why = no_layers(scene); !why.empty()) {
    throw InputError(command + ": --layers: " + why);
  }
  if (scene.camera.polariser) {
    throw InputError(command + ": --layers: layers hold light before the lens, where camera.polariser counts for " +
                     "nothing; leave one of the two out");
  }
  if (layer_set(options) == LayerSet::stokes && !scene.render.polarisation) {
    throw InputError(command + ": --layers stokes: render.polarisation is false, which leaves Q and U out; set it to " +
                     "true, or write --layers");
  }
}

PictureNames picture_names(std::optional<std::string> output, std::optional<std::string> png, bool json,
                           const std::string& command) {
  if (output && output->ends_with(".png")) {
    if (png) {
      throw InputError(command + ": -o " + *output + " and --png " + *png +
                       " both name the PNG; -o is for the EXR: name it *.exr, or leave one out");
    }
    png = std::exchange(output, std::nullopt);
  }
  if (output == "-" || png == "-") {
    const std::string option = output == "-" ? "-o -" : "--png -";
    if (output == png || json) {
      throw InputError(command + ": " + option + ": " + (json ? "--json" : "--png -") +
                       " writes to standard output too; give a file's name for one of them");
    }
    if (stdout_is_terminal()) {
      throw InputError(command + ": " + option +
                       ": standard output is a terminal; send it to a program or, by >, to "
                       "a file");
    }
    (output == "-" ? output : png) = "/dev/stdout";
  }
  return {std::move(output), std::move(png)};
}

void require_ending(const std::string& file, const std::string& option, const std::string& ending) {
  const bool device = file.rfind("/dev/", 0) == 0;
  if (!device && std::filesystem::path(file).extension() != ending) {
    throw InputError(option + ": '" + file + "' does not end in " + ending + ", which is what it writes");
  }
}

}  // namespace airlight::cli
