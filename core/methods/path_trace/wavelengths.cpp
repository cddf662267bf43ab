#include "core/methods/path_trace/wavelengths.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/air/phase_functions.h"
#include "core/methods/path_trace/cloud_trace.h"

namespace airlight {

using physics::uint;
using physics::vec3;

namespace {

// Number of flights whose columns are summed before their transmittance is taken: few, so that no exponential
// underflows.
constexpr int kFlightsTogether = 6;

std::array<double, 3> three_of(vec3 v) {
  return {v.x, v.y, v.z};
}

// The value of that number among those that may have a curve.
Spectrum spectral_value(const Scene& scene, std::size_t number) {
  Spectrum found{};
  std::size_t i = 0;
  for_each_spectral_value(scene, [&](const Spectrum& value) { found = i++ == number ? value : found; });
  return found;
}

// Means of the parts' channels; each channel's weights add up to 1.
Scene mean_scene(std::span<const Part> parts, const std::vector<Rgb>& weights) {
  Scene mean = parts.front().scene;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto sum = [&](const auto& spectrum_of) {
      double total = 0.0;
      for (std::size_t k = 0; k < weights.size(); ++k) {
        total += weights[k][c] * spectrum_of(parts[k / 3].scene)[k % 3];
      }
      return total;
    };
    std::size_t value = 0;
    for_each_spectral_value(mean, [&](SpectralValue& into) {
      into[c] = sum([value](const Scene& s) { return spectral_value(s, value); });
      ++value;
    });
    for (std::size_t i = 0; i < mean.media.size(); ++i) {
      mean.media[i].phase_wavelengths[c] = sum([i](const Scene& s) { return s.media[i].phase_wavelengths; });
    }
    if (mean.terrain) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto mix = [j](const Scene& s) {
          return Spectrum{s.terrain->mix[0][j], s.terrain->mix[1][j], s.terrain->mix[2][j]};
        };
        mean.terrain->mix[c][j] = sum(mix);
      }
    }
    for (std::size_t j = 0; j < 3 && mean.ground; ++j) {
      const auto mix = [j](const Scene& s) {
        return Spectrum{s.ground->mix[0][j], s.ground->mix[1][j], s.ground->mix[2][j]};
      };
      mean.ground->mix[c][j] = sum(mix);
    }
  }
  return mean;
}

std::vector<Rgb> shares_of(const std::vector<Rgb>& colours) {
  Rgb totals{};
  for (const Rgb& colour : colours) {
    for (std::size_t c = 0; c < 3; ++c) {
      totals[c] += std::abs(colour[c]);
    }
  }
  std::vector<Rgb> shares = colours;
  for (Rgb& share : shares) {
    for (std::size_t c = 0; c < 3; ++c) {
      share[c] = std::abs(share[c]) / totals[c];
    }
  }
  return shares;
}

Part mean_part(const Stage& stage) {
  Scene mean = mean_scene(stage.parts(), shares_of(stage.basis().matrix));
  mean.sun.irradiance.fill(stage.scene().spectra->irradiance);
  Air air(mean.media, mean.planet, stage.parts().front().air.options());
  Things things(mean, {&stage.whole().things});
  return {std::move(mean), std::move(air), std::move(things)};
}

}  // namespace

Wavelengths::Wavelengths(const Stage& stage)
    : count_(stage.basis().nodes.nm.size()),
      media_(stage.scene().media.size() + stage.scene().clouds.size()),
      steering_(mean_part(stage)),
      colours_(stage.basis().matrix) {
  for (const Part& bare : stage.parts()) {
    const Part part = bare.scene.clouds.empty() ? bare : with_cloud_media(bare);
    groups_.push_back(formulas_of(part.air, part.scene));
    part.things.put_into(groups_.back());
    groups_.back().polarisation = part.scene.render.polarisation;
  }
  for (std::size_t k = 0; k < count_; ++k) {
    if (const std::optional<Curve>& light = stage.scene().spectra->light) {
      for (double& channel : colours_[k]) {
        channel *= at_node(*light, stage.basis().nodes, k);
      }
    }
    const physics::Physics& p = groups_[k / 3];
    for (uint i = 0; i < media_; ++i) {
      scattering_[i].at[k] = three_of(p.medium(i).scattering)[k % 3];
      extinction_[i].at[k] = three_of(p.medium(i).scattering + p.medium(i).absorption)[k % 3];
    }
  }
  for (uint i = 0; i < media_; ++i) {
    if (groups_.front().polarised() && groups_.front().is_molecular(i)) {
      dipoles_[i] = scattering_[i];
      for (std::size_t k = 0; k < count_; ++k) {
        physics::Physics& p = groups_[k / 3];
        dipoles_[i]->at[k] *= p.kDipole * three_of(p.dipole_share(i))[k % 3];
      }
    }
    same_phase_[i] =
        std::ranges::none_of(groups_, [i](const physics::Physics& p) { return phase_row(p.phase_of(i)).by_channel; });
  }
}

Wavelengths::Phases Wavelengths::phases(double nu) const {
  Phases phases;
  for (uint i = 0; i < media_; ++i) {
    if (same_phase_[i]) {
      phases[i] = Wide(groups_.front().medium_phase(i, nu).x);
      continue;
    }
    phases[i] = of_groups([i, nu](physics::Physics& p) { return p.medium_phase(i, nu); });
  }
  return phases;
}

Wide Wavelengths::thing_albedo(const TracedThings& things, vec3 place, ThingNumber thing) const {
  if (thing != kOnTerrain) {
    return of_groups([thing](physics::Physics& p) { return p.ball_of_body(number_of(thing)).albedo; });
  }
  const physics::vec2 at = things.on_map(place);
  return of_groups([at](physics::Physics& p) { return p.map_albedo(p.terrain_shape(), at.x, at.y); });
}

Wide Wavelengths::scattered(const Columns& densities, const Phases& phases) const {
  Wide sum;
  for (std::size_t i = 0; i < media_; ++i) {
    if (densities[i] > 0.0) {
      sum = sum + scattering_[i] * phases[i] * densities[i];
    }
  }
  return sum;
}

Wide Wavelengths::scattered(const Columns& densities, double nu) const {
  Wide sum;
  for (uint i = 0; i < media_; ++i) {
    if (!(densities[i] > 0.0)) {
      continue;
    }
    if (same_phase_[i]) {
      sum = sum + scattering_[i] * (groups_.front().medium_phase(i, nu).x * densities[i]);
      continue;
    }
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const std::array<double, 3> values = three_of(groups_[g].medium_phase(i, nu));
      for (std::size_t c = 0; c < 3 && 3 * g + c < count_; ++c) {
        sum.at[3 * g + c] += scattering_[i].at[3 * g + c] * values[c] * densities[i];
      }
    }
  }
  return sum;
}

std::optional<Wide> Wavelengths::dipoles(const Columns& densities) const {
  std::optional<Wide> sum;
  for (std::size_t i = 0; i < media_; ++i) {
    if (dipoles_[i] && densities[i] > 0.0) {
      sum = sum.value_or(Wide()) + *dipoles_[i] * densities[i];
    }
  }
  return sum;
}

Wide Wavelengths::transmittance(const Columns& columns) const {
  Wide depth;
  for (std::size_t i = 0; i < media_; ++i) {
    if (columns[i] > 0.0) {
      depth = depth + extinction_[i] * columns[i];
    }
  }
  for (std::size_t k = 0; k < count_; ++k) {
    depth.at[k] = std::exp(-depth.at[k]);
  }
  return depth;
}

vec3 Wavelengths::colour(const Wide& radiance) const {
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < count_; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += colours_[k][c] * radiance.at[k];
    }
  }
  return {sum[0], sum[1], sum[2]};
}

void WidePath::begin(double q) {
  analyser_ = {Wide(q), Wide()};
  carry_ = Wide(1.0);
  passed_ = {};
  flights_ = 0;
}

void WidePath::fly(const Columns& columns, double density) {
  if (++flights_ > kFlightsTogether) {
    carry_ = carry_ * all_.transmittance(passed_);
    passed_ = {};
    flights_ = 1;
  }
  passed_ = passed_ + columns;
  carry_ = carry_ * (1.0 / density);
}

Wide WidePath::sent_into(const Bend& bend, const Columns& densities, const std::optional<Wide>& dipoles) const {
  const Wide all = all_.scattered(densities, bend.nu);
  return dipoles ? all + analyser_.correction(bend, *dipoles) : all;
}

void WidePath::scatter(const Columns& densities, const Bend& bend, double density) {
  const std::optional<Wide> dipoles = all_.dipoles(densities);
  const Wide scattered = sent_into(bend, densities, dipoles);
  if (dipoles) {
    analyser_.turn(bend, *dipoles, scattered);
  } else {
    analyser_.forget();
  }
  carry_ = carry_ * scattered * (1.0 / density);
}

void WidePath::reflect(const Wide& albedo, double cosine, double density) {
  analyser_.forget();
  carry_ = carry_ * albedo * (cosine / density);
}

void WidePath::survive(double factor) {
  carry_ = carry_ * factor;
}

void WidePath::add(const Columns& to_sun, const Wide& sent_back) {
  sum_ = sum_ + carry_ * sent_back * all_.transmittance(passed_ + to_sun);
}

void WidePath::add_scattered(const Columns& to_sun, const Columns& densities, const Bend& bend) {
  add(to_sun, sent_into(bend, densities, all_.dipoles(densities)));
}

void WidePath::add_reflected(const Columns& to_sun, const Wide& albedo, double cosine) {
  add(to_sun, albedo * cosine);
}

}  // namespace airlight
