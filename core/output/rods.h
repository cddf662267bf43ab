#pragma once
// Colours as an eye in the dark sees them: below 3 cd/m2 the rods take part, which know one colour only.

#include "core/base/radiance_image.h"

namespace airlight {

// Kirk and O'Brien, ACM Transactions on Graphics 30 (2011) 42, whose model is that of Cao, Pokorny, Smith and Zele,
// Vision Research 48 (2008) 2586: the rods' signal adds to the eye's three opponent channels. Below 0.005 cd/m2 it
// counts in full, from 3 on not at all, between them by the logarithm. The sum is scaled so that grey stays as bright
// as it is: how bright a dark picture is shown is the exposure's to say. Alpha passes unchanged. `one`: cd/m2 of (1, 1,
// 1).
void see_by_rods(RadianceImage& rows, double one);

// What the rods see of linear Rec.709, 1 for (1, 1, 1): CIE 1951's V' regressed on the colour matching functions of
// 1931, by lights of 2000 to 25 000 K above all.
double rods_luminance(double red, double green, double blue);

}  // namespace airlight
