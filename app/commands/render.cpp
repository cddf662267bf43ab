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
        "is that of --png; one in .hdr, .npy, .json, .ktx2 or .dds makes a file of that format in place of the EXR",
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
       {"--usd", "FILE.usda",
        "Also write a USD stage that lights a scene with the EXR, a latlong, as a dome, and with sun and moon as "
        "distant "
        "lights. The EXR then shows no discs",
        &given.usd, Completes::file},
       {"--radiance", "FILE.rad",
        "Also write sky, ground, sun and moon for the lighting programs of Radiance: FILE.rad and FILE.hdr, "
        "or with --spectral FILE.hsr",
        &given.radiance, Completes::file},
       {.names = "--up",
        .metavar = "y|z",
        .help = "The axis that points up in that stage (default: y)",
        .target = &given.up,
        .choices = {"y", "z"}},
       {"--spectral", "FIRST:LAST:STEP",
        "Also write spectral radiance into the EXR, at these wavelengths in nm, e.g. 380:780:10; of a preset with "
        "spectra",
        &given.spectral},
       {.names = "--prefilter",
        .metavar = "ggx",
        .help =
            "Make the mips of a .ktx2 or .dds the sky seen by ever rougher surfaces, as engines look light up (the "
            "mip i of n has roughness i/(n - 1), GGX's alpha its square), and write the sky's 9 spherical harmonics "
            "and the sun beside it, into FILE.light.json",
        .target = &given.prefilter,
        .choices = {"ggx"}},
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
                                         given.tolerance),
                            {"--judge-time", "TIME",
                             "How much CPU time of all threads --tolerance may take to choose, e.g. 60s; without it 16 "
                             "times what the plain picture takes, and 2 s at least",
                             &given.judge_time}}));
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
      "Without -o and --png, airlight writes out/NAME.exr and out/NAME.png. NAME is the preset's name. airlight "
      "makes the folder out if it is missing.\n\n"
      "Every file appears whole or not at all. airlight does not write a picture with a NaN, an infinity or a "
      "negative luminance: the command fails and says where it is. A colour of spectra outside linear Rec.709 has a "
      "negative channel: airlight writes it, and a warning counts such pixels.\n\n"
      "An EXR of airlight's carries its whole preset: rendering the EXR renders the same picture again.\n\n"
      "--layers is for the method orders, the default. It adds NAME.R, .G and .B for each medium that scatters, and "
      "for multiple, sun and ground, and for cloud where clouds stand. Their sum is R, G and B. transmittance reaches "
      "to the ground or to space. "
      "depth.Z is the distance in km to the ground or to the place where the ray leaves the air, always with 32 "
      "bits; it is 1e10 where the ray meets neither. N.X, .Y and .Z are the ground's normal (x east, y up, z south), "
      "and 0 where there is no ground. cloud_alpha.A is the share of what stands behind clouds that they hide, and "
      "cloud_depth.Z the mean distance in km of what hides it. --layers stokes adds Q and U, the Stokes parameters of "
      "all light: Q is above 0 "
      "for light that swings in the plane of direction and zenith, U for light that leans by 45 degrees from downward "
      "toward growing azimuth. Bloom, if the preset asks for it in the EXR, is a layer outside the sum. "
      "--colorspace converts the layers of light. It converts the transmittance as the colour of white that is seen "
      "through the air.\n\n"
      "--spectral writes the layout of Fichet, Pacanowski and Wilkie (JCGT 2021): a channel such as S0.550,000000nm "
      "for each wavelength, beside R, G and B. A channel is the mean radiance, disc included, over a band around "
      "its wavelength. The band is as wide as the step, and at most 10 nm. Channels have 32 bits unless --half is "
      "given. emissiveUnits is W.m^-2.sr^-1.nm^-1 if sunlight is ASTM G-173 times sun.irradiance, or if sun.unit "
      "scales it to an illuminance. Otherwise it is sun.spectrum.sr^-1: the preset's own numbers times "
      "sun.irradiance. airlight:sunlight holds the sunlight above the air. R, G and B are the integral of the "
      "spectrum by CIE 1931 if its wavelengths tell colours to 0.2 %, as 380:780:10 do. Otherwise they are the "
      "colours of the picture without --spectral. airlight:picture says which. 'airlight diff --layer S0' compares "
      "spectra.\n\n"
      "--tolerance and --time-limit choose method and quality for this scene and picture. They replace what the "
      "preset has under render. If the error of 'orders' is known to be small enough, airlight takes 'orders' at "
      "once. Otherwise path-trace measures the error at 128 of the picture's pixels, which takes about a second for "
      "3 % and ten for 1 %, or airlight computes 256 directions with each candidate. The log, --json and the EXR "
      "tell the choice, the bound that its error keeps and what it leaves out. -v and --dry-run tell what was "
      "tried. If nothing reaches a tolerance, airlight refuses it and names the best that you can have. Before the "
      "search makes the command some 20 times as dear as the plain picture, airlight stops and tells the bound so "
      "far; 2 CPU-seconds are always allowed. The same command then goes on from there, but with --no-cache, and "
      "--judge-time allows more at once.";
  command.examples = {
      {"airlight render earth-sunset", "Write out/earth-sunset.exr and out/earth-sunset.png"},
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
      {"airlight render my-sky.json --projection latlong --size 64x32 -o dome.exr --usd dome.usda",
       "A lit stage for programs that read USD"},
      {"airlight render my-sky.json --radiance daylight.rad -o sky.exr",
       "Also daylight.rad and daylight.hdr, for Radiance"},
      {"airlight render my-sky.json --projection latlong --size 64x32 -o sky.hdr", "An environment map for an engine"},
      {"airlight render my-sky.json --projection cube --size 16x96 -o sky.ktx2", "A cube map with its mips"},
      {"airlight render my-sky.json --projection cube --size 16x96 -o light.ktx2 --prefilter ggx --set "
       "/sun/disc/visible=false",
       "A cube map for image-based light, and its harmonics in light.light.json"},
      {"airlight render sky.exr -o again.exr", "Render the picture of an EXR again"},
      {"airlight render earth-sunset --layers -o layers.exr --size 160x90",
       "Rayleigh, aerosol, multiple, sun, ground, transmittance, depth and normals apart, for compositing"},
      {"airlight render earth-sunset --layers stokes -o stokes.exr --size 160x90",
       "Also Q and U, which tell how the light is polarised"},
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
