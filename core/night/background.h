#pragma once
// The smooth light of the night sky above the air.

#include <array>

#include "core/night/celestial.h"
#include "core/scene/scene.h"
#include "core/spectra/curve.h"

namespace airlight {

// Luminance of a solar star of 10th magnitude (V) a square degree, cd/m2: 27.78 magnitudes a square arc second.
inline constexpr double kS10 = 8.35e-7;

// Zodiacal light in that unit, by angles from the sun along the ecliptic and from the ecliptic, rad: Leinert et al.,
// Astronomy and Astrophysics Supplement 127 (1998) 1, table 16. Nearer than 15 degrees to the sun, where they have
// nothing, it stays as it is at the table's edge. The table holds at 500 nm.
double zodiacal_light(double from_sun, double latitude);

// Spectral radiance of zodiacal light over that of so many stars like the sun, at 360 to 830 nm: it is redder than the
// sun (Leinert et al. 1998, eq. 22, at 90 degrees from the sun and beyond).
double zodiacal_redness(double nm);

// Light of all stars fainter than 6.5 in that unit, in a J2000 direction; coarse: 36 / (|sin b| + 1/4) at the galactic
// latitude b, and 69 for each ninth of the brightness by which the Milky Way's five outlines in d3-celestial (O. Frohn,
// BSD-3-Clause) rise, over cells of two degrees. Its mean, 88, is that of 460 stars of magnitude 0 over the sky less
// the brighter ones: stars up to magnitude 10.5 are 225, about half of all (Sky & Telescope's answer to "how bright are
// all stars together").
double faint_stars(const physics::vec3& j2000);

// Airglow at the zenith, W/(m2 nm sr): means over 10 nm of the dark sky at Paranal, solar flux 130 (Noll et al.,
// Astronomy and Astrophysics 543 (2012) A92, by ESO's sky model).
const Curve& airglow();

// Spectra of lamps, up to a factor, from main features: a white diode's blue peak at 450 nm and its phosphor's wide one
// at 578; of high-pressure sodium, broad about 594 nm with lines at 498, 569 and 616. Heights and widths are set by the
// colours of such lamps, of 4000 and 2000 K.
double lamp_light(Lamps lamps, double nm);

}  // namespace airlight
