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

// Mercury, Venus, Mars, Jupiter and Saturn. `julian_date`: UTC. Places by ERFA's plan94 (Simon et al., Astronomy and
// Astrophysics 282 (1994) 663), with light time: within 0.005 degrees for Mercury and Venus, at worst 0.02 for Jupiter
// and 0.024 for Saturn from 1800 to 2050. Magnitudes in V by Mallama and Hilton, Astronomy and Computing 25 (2018) 10,
// Saturn's rings among them; colours, their B - V. Times are taken for terrestrial ones a minute off: 1e-3 degrees.
std::array<PlanetInSky, 5> planets_at(double julian_date);

}  // namespace airlight
