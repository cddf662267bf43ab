#pragma once
// What the air of a scene is to those who compute light in it: found once, never changed, cheap to hand on. It knows no
// sun but the lesson's fade, no camera and no picture, so that all frames of a day and all methods share it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/air/column.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// What a method says of the air beside what it is: filled in by the method from its own keys.
enum class Shells { never, where_needed, always };

struct AirOptions {
  std::optional<SunFade> sun_fade;         // absent: the planet's shadow alone
  bool schlick = false;                    // Schlick's phase function in place of the media's peaked ones
  double multiple_scattering_scale = 1.0;  // 0: single scattering alone
  Shells shells = Shells::never;  // whether rays go through the air shell by shell (shaders/physics/shells.glsl)
  int moment_rows = 12;           // altitudes of the table of moments; by shells there are more
  bool operator==(const AirOptions&) const = default;
};

// The three channels as the formulas have them.
inline physics::vec3 vector_of(const Spectrum& s) {
  return {s[0], s[1], s[2]};
}

// Vertical optical depths of all the air, each in the channel where it is largest.
struct OpticalDepths {
  double extinction = 0.0;
  double scattering = 0.0;
  double peaked = 0.0;  // scattering by media that scatter mostly forward or mostly back
  double abrupt = 0.0;  // scattering by media of constant density, which ends at an edge
};

// Vertical optical depths of scattering, of each medium in the channel where it is largest.
struct DiffusionDepths {
  double forward = 0.0;    // by media that scatter mostly forward
  double backward = 0.0;   // likewise, of those that scatter mostly back
  double transport = 0.0;  // by all, what is scattered straight on left out: the sum of (1 - first moment) tau
  double scaled = 0.0;     // by all, the part that delta-scaling after `degree` takes as unscattered left out
};

class Air {
 public:
  Air(const std::vector<Medium>& media, const Planet& planet, const AirOptions& options = {});

  // The same air as another method wants it: the column is shared.
  Air with(const AirOptions& options) const;

  const std::vector<Medium>& media() const;
  const Planet& planet() const;
  const AirOptions& options() const;
  const Column& column() const;

  // Formulas, media and planet on double; sun and camera blank, tables empty. To be copied by who calls them: the
  // functions are shader text and know no const.
  const physics::Physics& formulas() const;

  // Two airs of one key have the same tables.
  const std::string& key() const;

  bool ground_reflects() const;
  std::uint32_t scattering_media() const;  // bit i: medium i scatters
  Spectrum scattering_depth(std::size_t medium) const;
  OpticalDepths depths() const;
  DiffusionDepths diffusion_depths(unsigned int degree) const;

 private:
  struct Matter;   // media, planet, column
  struct Content;  // by options
  Air(std::shared_ptr<const Matter> matter, const AirOptions& options);
  std::shared_ptr<const Matter> matter_;
  std::shared_ptr<const Content> content_;
};

}  // namespace airlight
