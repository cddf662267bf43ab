#pragma once
// The planets that the eye sees.

#include <array>
#include <string_view>

#include "core/night/stars.h"

namespace airlight {

struct PlanetInSky {
  std::string_view name;
  CatalogueStar star;  // the place where its light comes from, J2000, seen from the earth's centre, without aberration
};

// Mercury, Venus, Mars, Jupiter and Saturn. `julian_date`: UTC. Places with light time: of Mercury and Venus by ERFA's
// plan94 (Simon et al., Astronomy and Astrophysics 282 (1994) 663), within 0.005 degrees; of the others by libnova's
// VSOP87 (Bretagnon and Francou, Astronomy and Astrophysics 202 (1988) 309), within 0.001. Magnitudes in V by Mallama
// and Hilton, Astronomy and Computing 25 (2018) 10, Saturn's rings among them; colours, their B - V. Times are taken
// for terrestrial ones a minute off: 1e-3 degrees.
std::array<PlanetInSky, 5> planets_at(double julian_date);

}  // namespace airlight
