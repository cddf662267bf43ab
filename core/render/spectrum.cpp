#include "core/render/spectrum.h"

#include <array>
#include <cassert>
#include <utility>

#include "core/methods/ready.h"
#include "core/render/timings.h"
#include "core/scene/photometry.h"
#include "core/spectra/data.h"
#include "core/stage/sampled_sky.h"
#include "core/stage/sums.h"

namespace airlight {
namespace {

// Unit of numbers that the preset gives without one, per steradian.
constexpr const char* kPresetsOwn = "sun.spectrum.sr^-1";

bool is_solar(const Curve& curve) {
  return curve.wavelengths == solar_irradiance().wavelengths && curve.values == solar_irradiance().values;
}

SpectralImage described(const Scene& scene, const Nodes& nodes) {
  const SpectralUnit unit = spectral_unit(scene);
  SpectralImage image{unit.name, nodes.nm, {}, false, {}};
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    image.sunlight.push_back(scene.spectra->irradiance * unit.scale * at_node(scene.spectra->sun, nodes, k));
  }
  return image;
}

// Factors for the channels of a group, which are radiance over the sun's times its irradiance.
std::vector<double> channel_scales(const Scene& scene, const Nodes& nodes) {
  std::vector<double> scales;
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    scales.push_back(spectral_unit(scene).scale * at_node(scene.spectra->sun, nodes, k));
  }
  return scales;
}

bool tells_colours(const Stage& listed) {
  const SceneSpectra& spectra = *listed.scene().spectra;
  const BandColours colours = band_colours(spectra.sun, spectra.white);
  const ColourBasis& basis = listed.basis();
  SampledSky sky(listed.scene(), listed.whole().air, colours);
  return mean_error(basis.matrix, sky.at(basis.nodes)) <= kTellsColours &&
         night_colour_error(listed.scene(), basis.matrix, basis.nodes) <= kTellsColours;
}

void add_planes(SpectralImage& spectrum, const RadianceImage& part, std::size_t first,
                const std::vector<double>& scales) {
  for (std::size_t c = 0; c < 3 && first + c < spectrum.nm.size(); ++c) {
    std::vector<float>& plane = spectrum.planes.emplace_back(part.rgba.size() / 4);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      plane[i] = static_cast<float>(scales[first + c] * static_cast<double>(part.rgba[4 * i + c]));
    }
  }
}

// Adds a group's times and, where the spectrum `tells_colours`, what it gives to the picture.
void add_group(Rendering& all, Rendering part, const std::array<Rgb, 3>& colours, bool tells_colours) {
  if (tells_colours) {
    add_part(all.radiance, part.radiance, colours);
    if (part.standard_error) {
      add_error(all.standard_error ? *all.standard_error : all.standard_error.emplace(), *part.standard_error, colours);
    }
    all.tables_statistics.insert(all.tables_statistics.end(), part.tables_statistics.begin(),
                                 part.tables_statistics.end());
    add_new_lines(all.left_out, part.left_out);
    add_new_lines(all.undone, part.undone);
  }
  add_timings(all.passes, part.passes);
  add_timings(all.host, part.host);
}

}  // namespace

SpectralUnit spectral_unit(const Scene& scene) {
  assert(scene.spectra);
  const Curve& sun = scene.spectra->sun;
  if (const std::optional<double> white = white_luminance(scene.sun.unit)) {
    return {*white / illuminance(sun), kAbsoluteSpectralUnit};
  }
  return {1.0, is_solar(sun) ? kAbsoluteSpectralUnit : kPresetsOwn};
}

Rendering render_spectrum(const DeviceOnDemand& device, const Stage& stage, BandsRequest request) {
  const Scene& scene = stage.scene();
  const Nodes nodes = *std::exchange(request.picture.spectrum, std::nullopt);
  const Stage listed = ready_at(scene, nodes, stage);
  SpectralImage spectrum = described(scene, nodes);
  spectrum.tells_colours = tells_colours(listed);
  const std::vector<double> scales = channel_scales(scene, nodes);
  const std::size_t count = listed.parts().size() + (spectrum.tells_colours ? 0 : 1);
  const HostOptions whole = request.picture.host;
  GroupRuns runs(whole, count, ".wavelengths");
  open_for_post(device, stage, request.picture);
  Rendering given;
  for (std::size_t g = 0; g < listed.parts().size(); ++g) {
    Scene group = listed.parts()[g].scene;
    RenderRequest plain;
    plain.host = runs.start(group, g);
    Rendering part = render(device, ready_part(group, listed, g), plain);
    if (!part.fault().empty()) {
      Band faulty{0, part};
      if (request.past_faults) {
        request.sink(faulty);
      }
      return part;
    }
    add_planes(spectrum, part.radiance, 3 * g, scales);
    add_group(given, std::move(part), listed.parts()[g].colours, spectrum.tells_colours);
  }
  if (given.standard_error) {
    take_roots(*given.standard_error);
  }
  if (!spectrum.tells_colours) {
    Scene other = scene;  // whose seed is not used: the picture is that of a render without a spectrum
    request.picture.host = runs.start(other, count - 1);
  }
  SpectralImage told = spectrum.like();
  given.spectrum = std::move(spectrum);
  Rendering out = render_bands(device, stage, request, std::move(given));
  out.spectrum = std::move(told);
  return out;
}

SpectralProbes probe_spectrum(const DeviceOnDemand& device, const Stage& stage,
                              const std::vector<Direction>& directions, const Nodes& nodes) {
  const Scene& scene = stage.scene();
  const Stage listed = ready_at(scene, nodes, stage);
  const std::vector<double> scales = channel_scales(scene, nodes);
  const HostOptions quiet;
  GroupRuns runs(quiet, listed.parts().size(), "");
  SpectralProbes all{described(scene, nodes), std::vector<SpectralProbe>(directions.size()), {}};
  for (std::size_t g = 0; g < listed.parts().size(); ++g) {
    Scene group = listed.parts()[g].scene;
    runs.start(group, g);
    const ProbeResults found = probe(device, ready_part(group, listed, g), directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (std::size_t c = 0; c < 3 && 3 * g + c < nodes.nm.size(); ++c) {
        const ProbeResult& one = found.directions[i];
        SpectralProbe& spectrum = all.directions[i];
        spectrum.radiance.push_back(scales[3 * g + c] * one.radiance[c]);
        spectrum.transmittance.push_back(one.transmittance[c]);
        if (one.q && one.u) {
          spectrum.q.push_back(scales[3 * g + c] * (*one.q)[c]);
          spectrum.u.push_back(scales[3 * g + c] * (*one.u)[c]);
        }
      }
    }
    add_new_lines(all.undone, found.undone);
  }
  return all;
}

}  // namespace airlight
