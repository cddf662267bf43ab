#include "core/air/air.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/air/phase_functions.h"
#include "core/air/phase_samples.h"
#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/air/shells.h"
#include "core/scene/density_profiles.h"

namespace airlight {
namespace {

static_assert(kMaxMedia == static_cast<int>(physics::kMaxMedia));
static_assert(kMaxDensityLayers == static_cast<int>(physics::kMaxDensityLayers));

double largest(const Spectrum& s) {
  return *std::ranges::max_element(s);
}

constexpr int kLayers = 1000;  // the highest row stands at a whole one of them

// The lowest of the layers' edges above which no more than this share of the vertical scattering stands; mean over
// channels.
int layer_below_share(const physics::Physics& p, const Column& column, double share) {
  std::vector<double> up_to{0.0};  // each edge
  for (std::size_t k = 0; k < column.cells(); ++k) {
    double here = 0.0;
    for (physics::uint i = 0; i < p.medium_count(); ++i) {
      const physics::vec3& s = p.scene.media[i].scattering;
      here += column.density[k][i] * (s.x + s.y + s.z);
    }
    up_to.push_back(up_to.back() + here * column.width(k));
  }
  const double aim = up_to.back() * (1.0 - share);
  const auto found = std::upper_bound(up_to.begin(), up_to.end(), aim);
  const auto k = static_cast<std::size_t>(found - up_to.begin());
  if (k >= up_to.size()) {
    return kLayers;  // nothing scatters
  }
  const double part = (aim - up_to[k - 1]) / (up_to[k] - up_to[k - 1]);
  const double h = column.edges[k - 1] + part * column.width(k - 1);
  return std::clamp(static_cast<int>(std::ceil(kLayers * h / column.edges.back())), 1, kLayers);
}

// How far below level the sun rises as seen from there.
double dip_of(physics::Physics& p, double top) {
  const double horizon = p.horizon_mu(p.scene.planet, top);
  return -std::asin(p.refraction ? p.sun_before_lift(top, horizon) : horizon);
}

// How far under the horizon the sun of the table's last column stands, for a horizon that falls by `dip` up to the
// highest row: light scattered twice no longer matters there.
double lowest_sun(double dip) {
  return std::min(0.5 * std::numbers::pi, 5.0 * dip + 0.02);
}

// Axes of the moment table: the altitude under which all but 1.5e-4 of the vertical scattering optical depth lies, and
// sun elevations up to the zenith, densest around the horizon, and down to a sun so low that no light is left.
physics::MomentTableData moment_axes(physics::Physics& p, const Column& column) {
  constexpr double kLeftAbove = 1.5e-4;
  physics::MomentTableData table;
  table.top = p.scene.planet.atmosphere_height * layer_below_share(p, column, kLeftAbove) / kLayers;
  const double dip = dip_of(p, table.top);
  table.elevation_scale = std::clamp(0.7 * dip, 0.01, 0.35);
  table.v_high = std::asinh(0.5 * std::numbers::pi / table.elevation_scale);
  table.v_low = -std::asinh(lowest_sun(dip) / table.elevation_scale);
  return table;
}

// The same where the table's rows are edges of shells, up to the top of the atmosphere.
physics::MomentTableData shell_moment_axes(physics::Physics& p) {
  physics::MomentTableData table;
  table.top = p.scene.planet.atmosphere_height;
  const double dip = dip_of(p, table.top);
  table.elevation_scale = std::clamp(0.7 * dip, 0.05, 0.35);
  table.v_high = std::asinh(0.5 * std::numbers::pi / table.elevation_scale);
  table.v_low = -std::asinh(lowest_sun(dip) / table.elevation_scale);
  return table;
}

std::uint32_t code_of(const Medium& medium, bool schlick) {
  const PhaseRow& row = phase_row(medium.phase);
  const bool mixes = medium.phase == PhaseFunction::rayleigh && largest(medium.depolarization) > 0.0;
  const std::uint32_t code = schlick && row.is_peaked_by_g() ? physics::Physics::kPhaseSchlick : row.code;
  return mixes ? physics::Physics::kPhaseDepolarized : code;
}

void put_media(physics::Physics& p, const std::vector<Medium>& media) {
  assert(media.size() <= static_cast<std::size_t>(kMaxMedia));
  p.media = static_cast<physics::uint>(media.size());
  p.phase_samples = phase_samples(media);
  physics::uint layer = 0;
  physics::uint table = 0;
  for (std::size_t i = 0; i < media.size(); ++i) {
    physics::MediumData& m = p.scene.media[i];
    m.scattering = vector_of(media[i].scattering);
    m.absorption = vector_of(media[i].absorption);
    m.g = media[i].phase_g;
    m.depolarization = vector_of(media[i].depolarization);
    m.phase_table = has_samples(media[i]) ? table++ : 0;
    put_density(p, static_cast<physics::uint>(i), media[i].density, layer);
    layer += m.layer_count;
  }
}

// What the options say of the phase functions, with their moments.
void put_phases(physics::Physics& p, const std::vector<Medium>& media, bool schlick) {
  p.phase_functions = 0;
  for (std::size_t i = 0; i < media.size(); ++i) {
    const std::uint32_t sharp = is_sharp(media[i]) ? physics::kPhaseSharp : 0U;
    p.phase_functions |= (code_of(media[i], schlick) | sharp) << (physics::kBitsPerMedium * i);
    const LegendreMoments moments = legendre_moments(p, static_cast<physics::uint>(i));
    std::ranges::copy(moments, std::begin(p.scene.media[i].legendre));
    for (std::size_t l = 0; l + 1 < moments.size(); ++l) {
      p.scene.media[i].peak[l] = p.forward_peak(static_cast<physics::uint>(l), moments[l], moments[l + 1]);
    }
  }
}

void put_rows(physics::Physics& p, const Column& column, const std::vector<Medium>& media, const AirOptions& options) {
  p.scene.moments = moment_axes(p, column);
  p.scene.shell_rows = 0;
  const bool wanted =
      options.shells == Shells::where_needed && needs_shells(column, media, p.scene.moments.top, options.moment_rows);
  if (options.shells == Shells::always || wanted) {
    const std::vector<double> rows = shell_altitudes(column, options.moment_rows);
    assert(rows.size() <= static_cast<std::size_t>(physics::kMaxShellRows));
    p.scene.shell_rows = static_cast<physics::uint>(rows.size());
    std::ranges::copy(rows, std::begin(p.scene.shell_altitudes));
    p.scene.moments = shell_moment_axes(p);
  }
}

std::string key_of(const physics::Physics& p) {
  const device::SceneData block = narrowed(p.scene);
  std::string key;
  for (const std::uint32_t word :
       {p.media, p.density_profiles, p.phase_functions, p.fade ? 1U : 0U, p.refraction ? 1U : 0U}) {
    key += std::to_string(word) + ' ';
  }
  key.append(reinterpret_cast<const char*>(&block), sizeof block);
  if (p.phase_samples != nullptr) {
    const std::vector<std::byte> tables = narrowed_tables(p);
    key.append(reinterpret_cast<const char*>(tables.data()), tables.size());
  }
  return key;
}

}  // namespace

struct Air::Matter {
  std::vector<Medium> media;
  Planet planet;
  physics::Physics formulas{};  // as the media say; zeros where nothing is said, since the key holds all of it
  Column column;

  Matter(const std::vector<Medium>& m, const Planet& p) : media(m), planet(p) {
    put_planet(formulas, p);
    put_media(formulas, media);
    put_phases(formulas, media, false);
    column = column_of(formulas);
  }
};

struct Air::Content {
  AirOptions options;
  physics::Physics formulas;
  std::string key;

  Content(const Matter& matter, const AirOptions& o) : options(o), formulas(matter.formulas) {
    if (o.schlick) {
      put_phases(formulas, matter.media, true);
    }
    const SunFade fade = o.sun_fade.value_or(SunFade{});
    formulas.fade = o.sun_fade.has_value();
    formulas.scene.sun.fade_scale = fade.scale;
    formulas.scene.sun.fade_bias = fade.bias;
    formulas.scene.multiple_scattering_scale = o.multiple_scattering_scale;
    put_rows(formulas, matter.column, matter.media, o);
    key = key_of(formulas);
  }
};

Air::Air(const std::vector<Medium>& media, const Planet& planet, const AirOptions& options)
    : Air(std::make_shared<const Matter>(media, planet), options) {}

Air::Air(std::shared_ptr<const Matter> matter, const AirOptions& options)
    : matter_(std::move(matter)), content_(std::make_shared<const Content>(*matter_, options)) {}

Air Air::with(const AirOptions& options) const {
  return options == content_->options ? *this : Air(matter_, options);
}

const std::vector<Medium>& Air::media() const {
  return matter_->media;
}

const Planet& Air::planet() const {
  return matter_->planet;
}

const AirOptions& Air::options() const {
  return content_->options;
}

const Column& Air::column() const {
  return matter_->column;
}

const physics::Physics& Air::formulas() const {
  return content_->formulas;
}

const std::string& Air::key() const {
  return content_->key;
}

bool Air::ground_reflects() const {
  return largest(matter_->planet.ground_albedo) > 0.0;
}

std::uint32_t Air::scattering_media() const {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < media().size(); ++i) {
    bits |= largest(media()[i].scattering) > 0.0 ? 1U << i : 0U;
  }
  return bits;
}

Spectrum Air::scattering_depth(std::size_t medium) const {
  Spectrum depth = media()[medium].scattering;
  for (double& d : depth) {
    d *= column().amount[medium];
  }
  return depth;
}

OpticalDepths Air::depths() const {
  constexpr double kPeaked = 0.3;  // mean cosine, either way
  OpticalDepths most;
  for (std::size_t c = 0; c < Spectrum{}.size(); ++c) {
    OpticalDepths here;
    for (std::size_t i = 0; i < media().size(); ++i) {
      const double scattering = scattering_depth(i)[c];
      here.scattering += scattering;
      here.extinction += scattering + media()[i].absorption[c] * column().amount[i];
      here.peaked += std::abs(channel(formulas().scene.media[i].legendre[1], c)) >= kPeaked ? scattering : 0.0;
      here.abrupt += profile_row(media()[i].density.profile).ends_abruptly ? scattering : 0.0;
    }
    most.extinction = std::max(most.extinction, here.extinction);
    most.scattering = std::max(most.scattering, here.scattering);
    most.peaked = std::max(most.peaked, here.peaked);
    most.abrupt = std::max(most.abrupt, here.abrupt);
  }
  return most;
}

DiffusionDepths Air::diffusion_depths(unsigned int degree) const {
  constexpr double kForward = 0.3;  // mean cosine
  constexpr double kBackward = 0.5;
  DiffusionDepths depths;
  for (std::size_t i = 0; i < media().size(); ++i) {
    const auto& legendre = formulas().scene.media[i].legendre;
    const double depth = largest(scattering_depth(i));
    // The channel that counts is that in which the medium turns light least, or keeps most of it.
    const auto least = [](const physics::vec3& v) { return std::min({v.x, v.y, v.z}); };
    depths.forward += -least(-legendre[1]) > kForward ? depth : 0.0;
    depths.backward += least(legendre[1]) < -kBackward ? depth : 0.0;
    depths.transport += depth * (1.0 - least(legendre[1]));
    depths.scaled += depth * (1.0 - std::max(least(legendre[degree + 1]), 0.0));
  }
  return depths;
}

}  // namespace airlight
