#pragma once
// libairlight: skies in memory. A session opens a device on first use and keeps on it what skies have in common; a
// scene is a preset with changes; pictures, directions and irradiance come back as plain numbers.
//
//   airlight::Session session;
//   airlight::Scene scene = session.load("earth-noon");
//   scene.set("/sun/elevation_deg", "4");
//   airlight::Image image = session.render(scene);
//
// Units. Radiance is in the unit of the preset's sun per steradian: W/(m2 sr) where sun.unit is "W/m2", lx/sr (cd/m2
// for white) where it is "lux", else relative to a sun of irradiance 1. Colours are linear Rec.709. Angles are degrees,
// elevations above the horizon, azimuths clockwise from north. Directions as vectors: x east, y up, z south.
//
// Nothing is written to any folder unless SessionOptions names one. The Vulkan driver may keep a cache of its own:
// Mesa's is turned off by MESA_SHADER_CACHE_DISABLE=true.
//
// Versions: while the major version is 0, a minor version may change this header; the library's file name and the
// namespace v0 then change with it. A patch version changes neither.

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#define AIRLIGHT_VERSION_MAJOR 0
#define AIRLIGHT_VERSION_MINOR 1
#define AIRLIGHT_VERSION_PATCH 0

#define AIRLIGHT_API __attribute__((visibility("default")))

#ifndef AIRLIGHT_INLINE_NAMESPACE
#define AIRLIGHT_INLINE_NAMESPACE inline
#endif

namespace airlight {
AIRLIGHT_INLINE_NAMESPACE namespace v0 {
  // A preset, a change of it or an argument is wrong. The message says where, what was found, what was expected and
  // what to do; several problems of a preset are a line each.
  class AIRLIGHT_API InputError : public std::runtime_error {
   public:
    explicit InputError(const std::string& message);
    ~InputError() override;
  };

  // Something failed while it ran: no Vulkan device, no memory, a picture at fault, a render that was stopped.
  class AIRLIGHT_API RunError : public std::runtime_error {
   public:
    explicit RunError(const std::string& message);
    ~RunError() override;
  };

  // The library's own version, "0.1.0"; the header's is in the macros above.
  AIRLIGHT_API std::string version();

  // Names of the built-in presets, in order.
  AIRLIGHT_API std::vector<std::string> presets();

  // The text (JSON) of a built-in preset with every key written out. Throws InputError for an unknown name.
  AIRLIGHT_API std::string preset_text(const std::string& name);

  // Names that Scene::option() takes, in order.
  AIRLIGHT_API std::vector<std::string> option_names();

  using Rgb = std::array<double, 3>;

  // A preset with changes. A copy costs as much as the preset's text.
  class AIRLIGHT_API Scene {
   public:
    Scene(const Scene& other);
    Scene(Scene&& other) noexcept;
    Scene& operator=(const Scene& other);
    Scene& operator=(Scene&& other) noexcept;
    ~Scene();

    // Sets the key at an RFC 6901 pointer to a value in JSON: set("/media/1/scale", "2"). A value that is no JSON is
    // text. Applied after all options. Throws InputError for a pointer that leads nowhere; values are judged when the
    // scene is used, or by check().
    Scene& set(const std::string& pointer, const std::string& value);

    // Sets an option of `airlight render` by its long name, '-' or '_' between words: option("sun-elevation", "4"),
    // option("size", "1280x720"). "date", "time", "lat", "lon" and, if wanted, "tz" put sun, moon and stars where they
    // stand: option("date", "2026-06-21").option("time", "21:30"). Throws InputError for an unknown name, naming the
    // nearest, and for a value that cannot be read.
    Scene& option(const std::string& name, const std::string& value);

    // Throws InputError with every problem of the preset and its changes, a line each.
    void check() const;

    // The preset with every key written out. Throws as check().
    std::string json() const;

   private:
    friend class Session;
    struct State;
    explicit Scene(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
  };

  // Planes of floats beside a picture, one after the other, each row by row from the top.
  struct Layer {
    std::string name;      // "rayleigh", "depth"
    std::string channels;  // a letter for each plane: "RGB", "Z"
    std::vector<float> planes;
  };

  // A picture's spectral radiance, wavelength by wavelength.
  struct Spectrum {
    std::vector<double> nm;        // each stands for a band around it as wide as the step, at most 10 nm
    std::vector<double> sunlight;  // irradiance above the air, the unit times sr
    std::string unit;              // of the radiance: "W.m^-2.sr^-1.nm^-1", or "sun.spectrum.sr^-1" of a relative sun
    std::vector<float> planes;     // one after the other, each row by row from the top
  };

  struct Image {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;             // radiance, three floats a pixel, row by row from the top
    std::vector<Layer> layers;          // those asked for
    std::optional<Spectrum> spectrum;   // if asked for
    double exposure = 1.0;              // a factor that makes the picture fit for a tone curve
    std::vector<std::string> left_out;  // parts that this picture did not need, with the reason
    std::vector<std::string> undone;    // parts that it needs but that would not have ended
    std::vector<std::string> warnings;  // where the method does not claim to hold, or is known to fail, for this scene

    // Red, green and blue at a pixel; no check of bounds.
    const float* at(int x, int y) const {
      return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    }
  };

  struct RenderOptions {
    // "": none; "light": each medium's single scattering, multiple scattering, sun and ground, whose sum is the
    // picture, then transmittance, depth in km and normals; "stokes": Q and U too. By the method "orders".
    std::string layers = {};
    // "FIRST:LAST:STEP" in nm, 360 to 830, 2 to 96 wavelengths: spectral radiance beside the picture, of a preset that
    // has spectra; "380:780:10". Where the wavelengths tell colours to 0.2 % the picture is their integral.
    std::string spectral = {};
    // Called some times a second with the share done, 0 to 1, on the thread that renders. When it returns false the
    // render ends with RunError. It makes a small render on the processor about a tenth slower.
    std::function<bool(double done)> progress = {};
  };

  struct Direction {
    double elevation_deg = 0.0;
    double azimuth_deg = 0.0;
  };

  // Light that arrives from a direction, without the sun's disc.
  struct Probe {
    Direction direction;
    Rgb radiance{};
    Rgb transmittance{};  // to the ground or to space
    // Stokes parameters, by a method that tells them: q > 0 in the plane of direction and zenith, u > 0 leaning from
    // downward toward growing azimuth.
    std::optional<Rgb> q;
    std::optional<Rgb> u;
  };

  // Sun or moon as a directional light at the camera's place.
  struct DirectionalLight {
    std::array<double, 3> direction{};  // toward the disc's centre
    double elevation_deg = 0.0;
    double azimuth_deg = 0.0;
    double angular_radius_deg = 0.0;
    Rgb irradiance{};  // on a plane that faces it, through the air
    Rgb irradiance_above_air{};
    double visible_share = 0.0;  // share of the disc's light that the planet leaves, before the air
  };

  struct Irradiance {
    // Of a surface by the normal, without sun and moon: a latlong of 64x32 whose centre is the camera's azimuth.
    Image map;
    // The sky's radiance in nine spherical harmonics: real, orthonormal, without Condon-Shortley sign, in the order
    // Y00 Y1-1 Y10 Y11 Y2-2 Y2-1 Y20 Y21 Y22, whatever the camera's azimuth.
    std::array<Rgb, 9> harmonics{};
    DirectionalLight sun;
    std::optional<DirectionalLight> moon;
  };

  struct SessionOptions {
    // Part of a Vulkan device's name. Empty: $AIRLIGHT_DEVICE, else the software device, else the first usable one.
    std::string device;
    // Folder in which prepared shaders and tables are kept for later starts. Empty: none is read or written.
    std::string cache_folder;
    // Threads of methods that run on the processor (path-trace); 0: as many as the machine has.
    unsigned int threads = 0;
  };

  // One device and what skies have in common on it: a day of skies bakes the tables of its air once. Its functions may
  // be called from several threads and then wait for one another. Each throws InputError and RunError.
  class AIRLIGHT_API Session {
   public:
    explicit Session(const SessionOptions& options = {});
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // A built-in preset's name ("earth-noon") or a preset's file ("my-sky.json"; `extends` is relative to it). Pictures
    // that a preset names (height_map, albedo_map, mask_map) are read by the command-line tool alone: InputError.
    Scene load(const std::string& preset) const;

    // A preset's text; `extends` names a built-in preset, or a file relative to the working folder.
    Scene parse(std::string_view json) const;

    // The camera's picture. A NaN, an infinity or a negative value in it is a RunError.
    Image render(const Scene& scene, const RenderOptions& options = {});

    // The light along directions from the camera's place.
    std::vector<Probe> probe(const Scene& scene, std::span<const Direction> directions);

    // What the whole sky gives a diffuse surface at the camera's place, and sun and moon apart.
    Irradiance irradiance(const Scene& scene);

    // Name of the device; opens it.
    std::string device();

   private:
    struct State;
    std::unique_ptr<State> state_;
  };

}  // namespace v0
}  // namespace airlight
