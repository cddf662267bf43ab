#include <memory>

#include "app/commands/commands.h"
#include "app/render/run.h"

namespace airlight::cli {
namespace {

std::vector<Option> output_options(RenderOrder& given) {
  return grouped(
      "Output",
      {{"-o,--output", "FILE.exr",
        "Write the scene-linear EXR here, - for standard output; then no PNG unless --png asks for it. A name in .png "
        "is that of --png",
        &given.exr, Completes::file},
       {"--png", "FILE.png", "Write the picture for people here, - for standard output; then no EXR unless -o asks",
        &given.png, Completes::file},
       {"--luts", "DIR", "Also write every table into this folder, as 'airlight luts' does", &given.tables,
        Completes::folder},
       tile_option(given.tile),
       {"--irradiance", "FILE.exr",
        "Also write what the sky gives a diffuse surface: a map over normals here, and in FILE.json beside it its 9 "
        "spherical-harmonic coefficients and the sun as a directional light",
        &given.irradiance, Completes::file},
       {"--spectral", "FIRST:LAST:STEP",
        "Also write spectral radiance into the EXR, at these wavelengths in nm, e.g. 380:780:10; of a preset with "
        "spectra",
        &given.spectral},
       {"--cube-faces", "",
        "Write a cube map as six pictures instead of one: FILE.posx.exr, .negx, .posy, .negy, .posz, .negz",
        &given.cube_faces}});
}

std::vector<Option> run_options(RenderOrder& given) {
  return grouped("Run",
                 {{"--timings", "", "Tell where the time went, every millisecond by name", &given.timings},
                  {"--json", "", "Print one JSON object about the render on standard output", &given.json},
                  {"--dry-run", "",
                   "Print the resolved scene and the passes; write nothing, and open no device unless --tolerance or "
                   "--time-limit has to be explained",
                   &given.dry_run},
                  {"-q,--quiet", "", "Say nothing but errors", &given.quiet},
                  {"-v,--verbose", "", "Say more: device, exposure, what was left out", &given.verbose}});
}

std::vector<Option> render_options(RenderOrder& given) {
  std::vector<Option> options = output_options(given);
  append(options, scene_options(given.scene));
  append(options, place_options(given.place, {time_option(given.place)}));
  append(options, camera_options(given.scene));
  append(options,
         grouped("Method", {share_option("--tolerance",
                                         "Choose the cheapest method and quality whose mean relative error stays below "
                                         "this, e.g. 1%, by probing this very picture; with --method among its "
                                         "qualities",
                                         given.tolerance)}));
  append(options, sampling_options(given.sampling));
  append(options, picture_options(given.picture));
  append(options, run_options(given));
  return options;
}

}  // namespace

Command render_command() {
  const auto given = std::make_shared<RenderOrder>();
  Command command;
  command.name = "render";
  command.summary = "Render a preset to a scene-linear EXR and a PNG";
  command.description =
      "Without -o and --png the files are out/NAME.exr and out/NAME.png, NAME being the preset's; the folder out is "
      "made "
      "if need be.\n\n"
      "Every file appears whole or not at all. A result with a NaN, an infinity or a negative value is not written: "
      "the command fails and says where it is.\n\n"
      "An EXR of airlight's carries its whole preset: rendering the EXR renders the same picture again.\n\n"
      "With --layers, NAME.R, .G and .B of each medium that scatters, of multiple, sun and ground sum up to R, G and "
      "B. transmittance is that to the ground or to space, depth.Z the distance in km to the ground or to where the "
      "ray leaves the air (1e10 where it meets neither; always 32 bits), N.X, .Y and .Z the ground's normal, x east, "
      "y up, z south, 0 where there is no ground. Bloom, where the preset asks for it in the EXR, is a layer outside "
      "the sum. --colorspace converts the light layers, and the transmittance as the colour of white seen through the "
      "air.\n\n"
      "With --spectral the EXR is laid out as Fichet, Pacanowski and Wilkie say (JCGT 2021): channels such as "
      "S0.550,000000nm beside R, G and B, each the mean radiance, disc included, over a band around its wavelength as "
      "wide as the step, at most 10 nm; 32 bits unless --half. emissiveUnits is W.m^-2.sr^-1.nm^-1 where sunlight is "
      "ASTM G-173 times sun.irradiance, or is scaled to the illuminance that sun.unit gives it; elsewhere it is "
      "sun.spectrum.sr^-1, the preset's own numbers times sun.irradiance. airlight:sunlight has the sunlight above the "
      "air. R, G and B are the spectrum's integral by CIE 1931 where its wavelengths tell colours to 0.2 %, as "
      "380:780:10 do, else those of the picture without --spectral; airlight:picture says which. 'airlight diff "
      "--layer S0' compares spectra.\n\n"
      "--tolerance and --time-limit choose method and quality for this scene and picture, whatever the preset has "
      "under render. Where the error of 'orders' is known to be small enough nothing is computed for it; else paths of "
      "path-trace at 128 of the picture's pixels tell it, in a second for 3 % and some ten for 1 %, or 256 directions "
      "are computed by candidates. The choice, the error that it is sure to stay below and what it leaves out stand in "
      "the log, in --json and in the EXR; -v and --dry-run tell what was tried. A tolerance that nothing reaches is "
      "refused, the best being named.";
  command.examples = {{"airlight render earth-sunset", "Write out/earth-sunset.exr and out/earth-sunset.png"},
                      {"airlight render my-sky.json -o sky.exr --png sky.png --sun-elevation 2 --size 1920x1080",
                       "A preset of one's own, with a lower sun and a larger picture"},
                      {"airlight render earth-noon --pitch 20 --png up.png --view gpu",
                       "Look up, and show the picture by the GPU tone curve"},
                      {"airlight render earth-noon --projection latlong --size 64x32 -o sky.exr", "An environment map"},
                      {"airlight render earth -o paris.png --date 2026-06-21 --time 21:30 --lat 48.85 --lon 2.35 --tz "
                       "Europe/Paris --size 64x36",
                       "The sun where it stands over Paris then"},
                      {"airlight render my-sky.json --tolerance 1% -o sky.exr", "Model no more than 1 % asks for"},
                      {"airlight render my-sky.json --colorspace ACEScg -o sky.exr", "An EXR for an ACES pipeline"},
                      {"airlight render my-sky.json --irradiance light.exr -o sky.exr",
                       "Also light.exr and light.json, for image-based lighting"},
                      {"airlight render sky.exr -o again.exr", "Render the picture of an EXR again"},
                      {"airlight render earth-sunset --layers -o layers.exr --size 160x90",
                       "Rayleigh, mie, multiple, sun, ground, transmittance, depth and normals apart, for compositing"},
                      {"airlight render earth --spectral 400:700:20 --size 32x18 -o spectral.exr",
                       "Spectral radiance for a spectral renderer, every 20 nm, and the picture beside it"},
                      {"airlight render earth-noon --size 640x360 --tile 200x100 -o tiles.exr",
                       "A picture of any size in bounded memory"}};
  command.positionals = {preset_positional(given->scene)};
  command.options = render_options(*given);
  command.run = [given] { return run_render(*given); };
  return command;
}

}  // namespace airlight::cli
