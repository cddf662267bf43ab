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
  command.summary = "Put the air between the camera and the things of another program's picture";
  command.description =
      "Each pixel's light is dimmed by the transmittance of the air up to its depth, the light that this air sends to "
      "the "
      "camera is added, and sky and sun stand where there is nothing. Alpha and other channels pass unchanged; a deep "
      "EXR "
      "is taken sample by sample and written flat.\n\n"
      "Depth is taken as sky where it is not above 0, not a number, infinite or at least 1e9. An opaque pixel without "
      "depth is the other program's background and gives way to the sky. Colours are premultiplied by alpha and "
      "linear; "
      "their primaries are those of the file.\n\n"
      "The size is the picture's. The camera is the file's (worldToNDC, or worldToCamera with the preset's field of "
      "view) where it says so, else the preset's.\n\n"
      "Fogs, of distance t in the depth's unit (--depth-unit; km by default): exponential, mix(c, colour, "
      "1 - exp(-density t)); sun-tinted, the same toward sun-colour by max(v.s, 0)^sun-power; height, by the amount "
      "(a/b) exp(-b y) (1 - exp(-b t v_y)) / v_y held to 0 to 1, or with --fog-set exact by 1 - exp(-amount); "
      "extinction-inscatter, c exp(-t extinction) + colour (1 - exp(-t inscatter)). They know neither the sun's height "
      "nor the sky's colour.";
  command.examples = {
      {"airlight composite earth-sunset --beauty in.exr -o out.exr", "Depth and camera are in the file"},
      {"airlight composite earth-noon --beauty in.exr --depth depth.exr:depth.Z --depth-unit m --up z -o out.exr",
       "Blender's world, depth in a file of its own"},
      {"airlight composite earth-noon --beauty 'in.####.exr' -o 'out.####.exr'", "Every frame that is there"},
      {"airlight composite earth-noon --beauty in.exr --fog exponential --fog-set density=0.2 -o out.exr",
       "A simple fog, for its look"}};
  command.positionals = {preset_positional(given->scene)};
  const std::vector<std::string> spaces{working_space_names().begin(), working_space_names().end()};
  command.options = {
      {"-o,--output", "FILE.exr", "The picture with air; with #### a frame's number", &given->output, Completes::file},
      {"--beauty", "FILE", "The picture, of any format that OpenImageIO reads; with #### every frame that is there",
       &given->beauty, Completes::file},
      {"--layer", "NAME", "Layer of the beauty, such as ViewLayer.Combined, if it cannot be told", &given->layer},
      {"--depth", "FILE[:CHANNEL]", "Where the depth is, if not in the beauty or under another name than Z or Depth",
       &given->depth, Completes::file},
      {.names = "--depth-kind",
       .metavar = "KIND",
       .help = "distance along the ray, planar along the camera's axis, or inverse (1 / planar); auto: planar for a "
               "perspective of another program, else distance",
       .target = &given->depth_kind,
       .choices = {"auto", "distance", "planar", "inverse"}},
      {"--depth-unit", "UNIT",
       "mm, cm, m, km, in, ft or metres as a number, of depth, camera and fog; auto: m, or km in airlight's own files",
       &given->unit},
      {.names = "--camera",
       .metavar = "WHOSE",
       .help = "preset, file, or auto: the file's where it tells it",
       .target = &given->camera,
       .choices = {"auto", "preset", "file"}},
      {.names = "--up",
       .metavar = "AXIS",
       .help = "The other world's vertical: y (north is -z) or z (north is y)",
       .target = &given->up,
       .choices = {"y", "z"}},
      {"--scale", "X", "The beauty's light times X is in the preset's unit", &given->scale},
      {.names = "--beauty-colorspace",
       .metavar = "NAME",
       .help = "Linear space of the beauty, in place of its chromaticities",
       .target = &given->beauty_colorspace,
       .choices = spaces},
      {.names = "--colorspace",
       .metavar = "NAME",
       .help = "Linear space of the output (default: the beauty's)",
       .target = &given->colorspace,
       .choices = spaces},
      {"--layers", "LIST", "Also write inscatter, transmittance or both, with a comma; of a deep pixel the nearest's",
       &given->layers},
      {.names = "--aerial",
       .metavar = "WAY",
       .help =
           "march along each ray (the default), or volume: a table of the camera's directions and distances, faster",
       .target = &given->aerial,
       .choices = {"march", "volume"}},
      share_option(
          "--tolerance",
          "Take the aerial volume where its mean error, measured against the march at 256 of the things, stays "
          "below that: 1% or 0.01",
          given->tolerance),
      {.names = "--fog",
       .metavar = "KIND",
       .help = "A simple fog in place of the air before things",
       .target = &given->fog,
       .choices = {"exponential", "sun-tinted", "height", "extinction-inscatter"}},
      {"--fog-set", "KEY=VALUE",
       "A parameter of the fog: colour, density, sun-colour, sun-power, a, b, exact, extinction, inscatter",
       &given->fog_parameters},
      {"--float", "", "32-bit floats (default: as the beauty)", &given->full_float},
      {"--half", "", "16-bit floats (default: as the beauty)", &given->half},
  };
  append(command.options, scene_options(given->scene));
  append(command.options, {{"--json", "", "Print one JSON object a frame", &given->json},
                           {"-q,--quiet", "", "Say nothing but errors", &given->quiet}});
  command.run = [given] { return run_composite(*given); };
  return command;
}

}  // namespace airlight::cli
