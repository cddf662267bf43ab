#include <memory>

#include "app/cli/sampling_options.h"
#include "app/cli/scene_options.h"
#include "app/commands/commands.h"
#include "app/composite/order.h"
#include "core/output/working_space.h"

namespace airlight::cli {

Command composite_command() {
  const auto given = std::make_shared<CompositeOrder>();
  Command command;
  command.name = "composite";
  command.summary = "Put the air between the camera and the things in another program's picture";
  command.description =
      "airlight multiplies the light of each pixel by the transmittance of the air up to the pixel's depth. It adds "
      "the light that this air sends to the camera. It puts sky and sun where there is nothing. Alpha and other "
      "channels pass unchanged. A deep EXR is taken sample by sample, and the result is flat.\n\n"
      "A depth means sky if it is 0, negative, not a number, infinite, or at least 1e9. An opaque pixel without depth "
      "is the other program's background, and the sky replaces it. Colours are linear and premultiplied by alpha. "
      "Their primaries are those of the file.\n\n"
      "The output has the size of the picture. The camera is that of the file if the file has worldToNDC, or "
      "worldToCamera, which is used with the preset's field of view. Otherwise the camera is the preset's.\n\n"
      "--fog takes one of these formulas. c is the colour of the thing, t its distance, y the height of the camera, v "
      "the direction of the view (v_y is its vertical part) and s that of the sun. Lengths are in the unit of "
      "--depth-unit, or in km if it is not given. exponential: mix(c, colour, 1 - exp(-density t)). sun-tinted: "
      "exponential with mix(colour, sun-colour, max(v.s, 0)^sun-power) in place of colour. height: mix(c, colour, "
      "amount) with amount = (a/b) exp(-b y) (1 - exp(-b t v_y)) / v_y, clamped to 0 to 1. --fog-set exact replaces "
      "this amount by 1 - exp(-amount). extinction-inscatter: c exp(-t extinction) + colour (1 - exp(-t inscatter)). "
      "The fogs ignore the height of the sun and the colour of the sky; only sun-tinted uses the sun's direction.";
  command.examples = {
      {"airlight composite earth-sunset --beauty in.exr -o out.exr", "The file holds depth and camera"},
      {"airlight composite earth-noon --beauty in.exr --depth depth.exr:depth.Z --depth-unit m --up z -o out.exr",
       "A picture of Blender's world, with the depth in a file of its own"},
      {"airlight composite earth-noon --beauty 'in.####.exr' -o 'out.####.exr'", "Every frame that exists"},
      {"airlight composite earth-noon --beauty in.exr --fog exponential --fog-set density=0.2 -o out.exr",
       "A simple fog"}};
  command.positionals = {preset_positional(given->scene)};
  const std::vector<std::string> spaces{working_space_names().begin(), working_space_names().end()};
  command.options = {
      {"-o,--output", "FILE.exr", "Write the picture with air here, with #### for the number of a frame",
       &given->output, Completes::file},
      {"--beauty", "FILE",
       "Picture that gets the air, in EXR, PNG, TIFF, HDR or another format of pictures; with ####, every frame that "
       "exists",
       &given->beauty, Completes::file},
      {"--layer", "NAME",
       "Layer of the beauty, e.g. ViewLayer.Combined (default: the main picture, a layer Combined, or the only layer "
       "with colours)",
       &given->layer},
      {"--depth", "FILE[:CHANNEL]", "File and channel of the depth (default: the channel Z or Depth of the beauty)",
       &given->depth, Completes::file},
      {.names = "--depth-kind",
       .metavar = "KIND",
       .help = "Kind of the depth: distance along the ray, planar along the camera's axis, or inverse (1 / planar). "
               "auto takes planar for a perspective picture of another program, and distance for all others (default: "
               "auto)",
       .target = &given->depth_kind,
       .choices = {"auto", "distance", "planar", "inverse"}},
      {"--depth-unit", "UNIT",
       "Unit of depth, camera and fog: mm, cm, m, km, in, ft, or a number of metres. auto takes m, but km for "
       "airlight's own files and for a fog (default: auto)",
       &given->unit},
      {.names = "--camera",
       .metavar = "WHOSE",
       .help = "Camera of the preset or of the file. auto takes the file's if it has one (default: auto)",
       .target = &given->camera,
       .choices = {"auto", "preset", "file"}},
      {.names = "--up",
       .metavar = "AXIS",
       .help = "Axis that points up in the other world: y, with north at -z, or z, with north at y (default: y)",
       .target = &given->up,
       .choices = {"y", "z"}},
      {"--scale", "X", "Factor that brings the light of the beauty to the preset's unit (default: 1)", &given->scale},
      {.names = "--beauty-colorspace",
       .metavar = "NAME",
       .help = "Linear colour space of the beauty (default: by its chromaticities)",
       .target = &given->beauty_colorspace,
       .choices = spaces},
      {.names = "--colorspace",
       .metavar = "NAME",
       .help = "Linear colour space of the output (default: the beauty's)",
       .target = &given->colorspace,
       .choices = spaces},
      {"--layers", "LIST",
       "Also write the layers inscatter, transmittance, or both with a comma between them. In a deep pixel, they are "
       "those of the nearest sample",
       &given->layers},
      {.names = "--aerial",
       .metavar = "WAY",
       .help = "Way to compute the air: march along each ray, or volume, which is faster: a table over the camera's "
               "directions and distances (default: march)",
       .target = &given->aerial,
       .choices = {"march", "volume"}},
      share_option(
          "--tolerance",
          "Use the aerial volume if its mean error stays below this, e.g. 1% or 0.01. airlight measures the error "
          "against the march at 256 of the things",
          given->tolerance),
      {.names = "--fog",
       .metavar = "KIND",
       .help = "Put a simple fog before the things in place of the air",
       .target = &given->fog,
       .choices = {"exponential", "sun-tinted", "height", "extinction-inscatter"}},
      {"--fog-set", "KEY=VALUE",
       "Set a parameter of the fog: colour, density, sun-colour, sun-power, a, b, exact, extinction, inscatter",
       &given->fog_parameters},
      {"--float", "", "Write 32-bit floats (default: as in the beauty)", &given->full_float},
      {"--half", "", "Write 16-bit floats (default: as in the beauty)", &given->half},
  };
  append(command.options, scene_options(given->scene));
  append(command.options, {{"--json", "", "Print one JSON object for each frame", &given->json},
                           {"-q,--quiet", "", "Say nothing but errors", &given->quiet}});
  command.run = [given] { return run_composite(*given); };
  return command;
}

}  // namespace airlight::cli
