#include "app/cli/picture_options.h"

#include <filesystem>
#include <utility>

#include "app/cli/terminal.h"
#include "app/render/picture_files.h"
#include "core/error.h"
#include "core/scene/json_format.h"

namespace airlight::cli {
namespace {

bool is_ocio_view(const std::string& view) {
  return view != kGpuView && view != kDiagnosticView;
}

}  // namespace

std::vector<Option> picture_options(PictureOptions& options) {
  return grouped(
      "Picture",
      {{"--layers", "",
        "Also write into the EXR: each medium's single scattering under its name, multiple, sun and ground, whose sum "
        "is the picture, and transmittance, depth (km) and N, the ground's normal",
        &options.layers},
       {"--float", "", "32-bit floats in the EXR instead of 16-bit ones", &options.full_float},
       {"--colorspace",
        "NAME",
        "Linear space of the EXR's colours (default: linear-rec709); its chromaticities stand in the header, and the "
        "PNG stays as it is",
        &options.colorspace,
        Completes::nothing,
        {},
        {working_space_names().begin(), working_space_names().end()}},
       {"--ocio-config", "FILE", "OpenColorIO config for the PNG; else $OCIO, else the built-in one",
        &options.ocio_config, Completes::file},
       {"--display", "NAME", "Display of the OCIO config", &options.display},
       {"--view",
        "NAME",
        "View of the OCIO display, or gpu for the GPU tone curve, or diagnostic for a picture that colours NaN, "
        "infinite, negative, zero and other numbers apart",
        &options.view,
        Completes::nothing,
        {},
        {},
        {kGpuView, kDiagnosticView}},
       {"--bits",
        "N",
        "Bits of a channel in the PNG; 8 are dithered",
        &options.bits,
        Completes::nothing,
        {},
        {"8", "16"}}});
}

Option tile_option(std::optional<std::string>& tile) {
  return {
      "--tile", "WxH",
      "Render in tiles of this size, streamed into the files, in bounded memory; else in rows of tiles from 8388609 "
      "pixels on. The files are the same",
      &tile};
}

WorkingSpace working_space_of(const PictureOptions& options) {
  return working_space(options.colorspace).value_or(WorkingSpace::linear_rec709);
}

std::vector<Override> overrides(const PictureOptions& options) {
  std::vector<Override> all;
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

void require_layers(const PictureOptions& options, const Scene& scene, bool exr, const std::string& command) {
  if (!options.layers) {
    return;
  }
  if (!exr) {
    throw InputError(command + ": --layers: layers stand in the EXR, and none is written; give -o FILE.exr too");
  }
  if (find_method(scene.render.method)->add_layer_passes == nullptr) {
    throw InputError(command + ": --layers: " + scene.render.method +
                     " does not tell its light apart; choose by --method one of " + methods_with_layers());
  }
  if (const std::string refusal = layers_refusal(scene); !refusal.empty()) {
    throw InputError(command + ": --layers: " + refusal);
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
