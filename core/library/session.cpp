// The library's session: one device, and the last scene's stage, from which the next takes over what is equal.
#include <filesystem>
#include <mutex>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/library/built_in.h"
#include "core/library/embedded_presets.h"
#include "core/library/errors.h"
#include "core/library/scene_state.h"
#include "core/library/validity.h"
#include "core/library/wavelengths.h"
#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/render/lighting.h"
#include "core/scene/angle.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

// Thrown through the device's run where a caller's `progress` ends it; never leaves the library.
struct Stopped {};

v0::Image image_of(const RadianceImage& radiance) {
  v0::Image image;
  image.width = radiance.width;
  image.height = radiance.height;
  image.rgb = rgb_of(radiance.rgba);
  return image;
}

v0::DirectionalLight light_of(const SunLight& light) {
  v0::DirectionalLight out;
  out.direction = light.direction;
  out.elevation_deg = degrees_from_radians(light.elevation);
  out.azimuth_deg = degrees_from_radians(light.azimuth);
  out.angular_radius_deg = degrees_from_radians(light.angular_radius);
  out.irradiance = light.irradiance;
  out.irradiance_above_air = light.irradiance_above_air;
  out.visible_share = light.visible_share;
  return out;
}

v0::Spectrum spectrum_of(const SpectralImage& spectrum) {
  v0::Spectrum out{spectrum.nm, spectrum.sunlight, spectrum.unit, {}};
  for (const std::vector<float>& plane : spectrum.planes) {
    out.planes.insert(out.planes.end(), plane.begin(), plane.end());
  }
  return out;
}

std::optional<Nodes> wavelengths_called(const std::string& text, const Scene& scene) {
  if (text.empty()) {
    return std::nullopt;
  }
  const Nodes nodes = wavelengths_from(text, "spectral");
  require_spectra(scene, "spectral");
  require_spectrum_fits(scene, nodes.nm.size(), "spectral");
  return nodes;
}

LayerSet layers_called(const std::string& name, const Stage& stage) {
  if (name.empty()) {
    return LayerSet::none;
  }
  if (name != "light" && name != "stokes") {
    throw InputError("layers: '" + name + "' is unknown" + suggested(name, {"light", "stokes"}) +
                     "; expected light, stokes, or nothing");
  }
  const Scene& scene = stage.scene();
  if (stage.method().add_layer_passes == nullptr) {
    throw InputError("layers: " + scene.render.method + " does not tell its light apart; choose the method " +
                     methods_with_layers());
  }
  if (const std::string why = no_layers(scene); !why.empty()) {
    throw InputError("layers: " + why);
  }
  if (scene.camera.polariser) {
    throw InputError(
        "layers: layers hold light before the lens, where camera.polariser counts for nothing; leave one of the two "
        "out");
  }
  if (name == "stokes" && !scene.render.polarisation) {
    throw InputError(
        "layers: stokes: render.polarisation is false, which leaves Q and U out; set it to true, or ask "
        "for light");
  }
  return name == "light" ? LayerSet::light : LayerSet::stokes;
}

std::vector<Direction> directions_of(std::span<const v0::Direction> given) {
  std::vector<Direction> directions;
  for (const v0::Direction& one : given) {
    if (!(one.elevation_deg >= -90.0 && one.elevation_deg <= 90.0) || !std::isfinite(one.azimuth_deg)) {
      throw InputError("directions: number " + std::to_string(directions.size()) + " has elevation " +
                       shortest(one.elevation_deg) + " and azimuth " + shortest(one.azimuth_deg) +
                       "; expected an elevation from -90 to 90 degrees and a finite azimuth");
    }
    directions.push_back({radians_from_degrees(one.elevation_deg), radians_from_degrees(one.azimuth_deg)});
  }
  return directions;
}

}  // namespace

namespace v0 {

struct Session::State {
  SessionOptions options;
  std::mutex mutex;
  std::unique_ptr<Executor> executor = {};
  std::optional<Stage> last = {};

  explicit State(SessionOptions given) : options(std::move(given)) {}

  Executor& device() {
    if (!executor) {
      DeviceOptions wanted;
      wanted.name_substring = options.device;
      wanted.cache_folder = options.cache_folder;
      wanted.stores_tables = !options.cache_folder.empty();
      executor = std::make_unique<Executor>(wanted);
    }
    return *executor;
  }
  DeviceOnDemand on_demand() {
    return [this]() -> Executor& { return device(); };
  }

  const Stage& stage_of(const Scene::State& scene) {
    const auto like = last ? &last->scene() : nullptr;
    const airlight::Scene judged = scene.judged(like);
    last = last ? ready(judged, *last) : ready(judged);
    return *last;
  }

  // `stopped` is set when the caller ends the render. A method that samples then ends by itself; a plan on the device
  // is left by an exception.
  RenderRequest request_of(const RenderOptions& asked, const Stage& stage, bool& stopped) const {
    RenderRequest request;
    request.layers = layers_called(asked.layers, stage);
    request.spectrum = wavelengths_called(asked.spectral, stage.scene());
    request.host.threads = options.threads;
    if (asked.progress) {
      request.host.report = [&asked, &stopped, throws = !samples(stage)](double done) {
        stopped = stopped || !asked.progress(done);
        return stopped && throws ? throw Stopped() : !stopped;
      };
    }
    return request;
  }

  Rendering rendered(const Stage& stage, const RenderOptions& asked) {
    bool stopped = false;
    Rendering rendering;
    try {
      rendering = airlight::render(on_demand(), stage, request_of(asked, stage, stopped));
    } catch (...) {
      executor.reset();  // after a run that was left half recorded, or a device that failed
      if (!stopped) {
        throw;
      }
    }
    if (stopped) {
      throw airlight::RunError("the render was stopped");
    }
    return rendering;
  }
};

Session::Session(const SessionOptions& options) : state_(std::make_unique<State>(options)) {}
Session::~Session() = default;

Scene Session::load(const std::string& preset) const {
  return translated([&] {
    std::error_code ignored;
    const fs::file_status status = fs::status(preset, ignored);
    const bool is_name = preset.find('/') == std::string::npos && !preset.ends_with(".json");
    const bool is_file = fs::exists(status) && !fs::is_directory(status);
    Preset found = is_name && !is_file ? built_in_preset(preset, "presets()") : load_preset(preset, embedded_presets());
    return Scene(std::make_unique<Scene::State>(std::move(found)));
  });
}

Scene Session::parse(std::string_view json) const {
  return translated([&] {
    Preset found = parse_preset(json, "text", fs::current_path(), embedded_presets());
    return Scene(std::make_unique<Scene::State>(std::move(found)));
  });
}

Image Session::render(const Scene& scene, const RenderOptions& options) {
  const std::lock_guard lock(state_->mutex);
  return translated([&] {
    const Stage& stage = state_->stage_of(*scene.state_);
    const Rendering rendering = state_->rendered(stage, options);
    if (const std::string fault = rendering.fault(); !fault.empty()) {
      throw airlight::RunError(stage.scene().name + ": " + fault);
    }
    Image image = image_of(rendering.radiance);
    image.exposure = rendering.exposure;
    image.left_out = rendering.left_out;
    image.undone = rendering.undone;
    image.warnings = scene_warnings(stage);
    if (rendering.spectrum) {
      image.spectrum = spectrum_of(*rendering.spectrum);
    }
    for (const airlight::Layer& layer : rendering.layers) {
      image.layers.push_back({layer.name, layer.channels, layer.planes});
    }
    return image;
  });
}

std::vector<Probe> Session::probe(const Scene& scene, std::span<const Direction> directions) {
  const std::lock_guard lock(state_->mutex);
  return translated([&] {
    const std::vector<airlight::Direction> asked = directions_of(directions);
    const ProbeResults found = airlight::probe(state_->on_demand(), state_->stage_of(*scene.state_), asked);
    std::vector<Probe> probes;
    for (std::size_t i = 0; i < found.directions.size(); ++i) {
      const ProbeResult& one = found.directions[i];
      probes.push_back({directions[i], one.radiance, one.transmittance, one.q, one.u});
    }
    return probes;
  });
}

Irradiance Session::irradiance(const Scene& scene) {
  const std::lock_guard lock(state_->mutex);
  return translated([&] {
    HostOptions host;
    host.threads = state_->options.threads;
    const Lighting lighting = lighting_of(state_->on_demand(), state_->stage_of(*scene.state_), host);
    Irradiance out;
    out.map = image_of(lighting.irradiance);
    out.harmonics = lighting.sh;
    out.sun = light_of(lighting.sun);
    if (lighting.moon) {
      out.moon = light_of(*lighting.moon);
    }
    return out;
  });
}

std::string Session::device() {
  const std::lock_guard lock(state_->mutex);
  return translated([&] { return state_->device().device().name; });
}

}  // namespace v0
}  // namespace airlight
