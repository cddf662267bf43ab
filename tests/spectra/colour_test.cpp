#include "core/spectra/colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/spectra/data.h"

namespace airlight::test {
namespace {

constexpr std::array<White, 3> kWhites{White::sun, White::d65, White::equal_energy};

std::array<double, kFineBands> over_sun(double (*relative)(double nm)) {
  std::array<double, kFineBands> fine{};
  for (std::size_t b = 0; b < fine.size(); ++b) {
    fine[b] = relative(0.5 * (fine_bands()[b].low + fine_bands()[b].high));
  }
  return fine;
}

double luminance(const Rgb& rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

// The tables of CIE 15 give 106.857, 106.857 and 106.892 at 5 nm (CIE 018, sums times 5 nm).
TEST(Observer, HasTheIntegralsOfCie) {
  EXPECT_NEAR(470.0 * mean_over(observer().x, 360.0, 830.0), 106.857, 0.02);
  EXPECT_NEAR(470.0 * mean_over(observer().y, 360.0, 830.0), 106.857, 0.02);
  EXPECT_NEAR(470.0 * mean_over(observer().z, 360.0, 830.0), 106.892, 0.02);
  EXPECT_DOUBLE_EQ(value_at(observer().y, 555.0), 1.0);
}

// Light of 1 W/(m2 nm) everywhere has 683 lm/W times the observer's integral.
TEST(Observer, TellsIlluminance) {
  EXPECT_NEAR(illuminance(constant_curve(2.0)), 2.0 * 683.002 * 106.857, 20.0);
  // Published values of sunlight above the air lie between 127.5 and 133.8 klx (IES; Darula, Kittler and Gueymard
  // 2005).
  EXPECT_NEAR(illuminance(solar_irradiance()), 130.6e3, 3.2e3);
}

// The cells of the fine bands' middles are the fine bands, to the bit. The cells of other wavelengths integrate a
// straight line, and give the sun its colour.
TEST(Nodes, ListedOnesIntegrate) {
  std::vector<double> middles;
  for (const WaveBand& band : fine_bands()) {
    middles.push_back(0.5 * (band.low + band.high));
  }
  for (const White white : kWhites) {
    const BandColours bands = band_colours(solar_irradiance(), white);
    const ColourMatrix cells = cell_matrix(listed_nodes(middles, 10.0), solar_irradiance(), white);
    for (std::size_t b = 0; b < bands.size(); ++b) {
      EXPECT_EQ(cells[b], bands[b]);
    }
  }
  std::vector<double> nm;
  for (double x = 380.0; x <= 780.0; x += 20.0) {
    nm.push_back(x);
  }
  const Nodes nodes = listed_nodes(nm, 10.0);
  EXPECT_EQ(nodes.bands[1].low, 395.0);
  EXPECT_EQ(nodes.bands[1].high, 405.0);
  const BandColours colours = band_colours(solar_irradiance(), White::d65);
  const ColourMatrix matrix = cell_matrix(nodes, solar_irradiance(), White::d65);
  const Rgb expected = colour_of(colours, over_sun([](double x) { return 2.0 - 0.002 * x; }));
  std::vector<double> at_nodes;
  for (const double x : nm) {
    at_nodes.push_back(2.0 - 0.002 * x);
  }
  const Rgb found = colour_by(matrix, at_nodes);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(found[c] / expected[c], 1.0, 2e-3) << c;
  }
  const Rgb sun = colour_by(matrix, std::vector<double>(nm.size(), 1.0));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sun[c] / sun_colour(colours)[c], 1.0, 2e-3) << c;
  }
}

// Under D65 a black body of 6504 K is near white, one of 2856 K is CIE A: x 0.4476, y 0.4074.
TEST(Colours, OfABlackBody) {
  Curve lamp;
  for (double nm = 355.0; nm <= 845.0; nm += 1.0) {
    lamp.wavelengths.push_back(nm);
    lamp.values.push_back(black_body(2856.0, nm));
  }
  const Rgb rgb = sun_colour(band_colours(lamp, White::d65));
  const Rgb xyz{0.4123907993 * rgb[0] + 0.3575843394 * rgb[1] + 0.1804807884 * rgb[2],
                0.2126390059 * rgb[0] + 0.7151686788 * rgb[1] + 0.0721923154 * rgb[2],
                0.0193308187 * rgb[0] + 0.1191947798 * rgb[1] + 0.9505321522 * rgb[2]};
  const double sum = xyz[0] + xyz[1] + xyz[2];
  EXPECT_NEAR(xyz[1], 1.0, 1e-6);
  EXPECT_NEAR(xyz[0] / sum, 0.4476, 5e-4);
  EXPECT_NEAR(xyz[1] / sum, 0.4074, 5e-4);
}

TEST(Colours, WhiteIsWhatWasAskedFor) {
  const Rgb sun = sun_colour(band_colours(solar_irradiance(), White::sun));
  for (const double channel : sun) {
    EXPECT_NEAR(channel, 1.0, 1e-12);
  }
  // Equal energy, as light over the sun's.
  std::array<double, kFineBands> even{};
  for (std::size_t b = 0; b < even.size(); ++b) {
    even[b] = 1.0 / mean_over(solar_irradiance(), fine_bands()[b].low, fine_bands()[b].high);
  }
  const Rgb white = colour_of(band_colours(solar_irradiance(), White::equal_energy), even);
  EXPECT_NEAR(white[0] / white[1], 1.0, 1e-12);
  EXPECT_NEAR(white[2] / white[1], 1.0, 1e-12);
  // Sunlight above the air is warmer than D65 and has luminance 1.
  const Rgb warm = sun_colour(band_colours(solar_irradiance(), White::d65));
  EXPECT_NEAR(luminance(warm), 1.0, 1e-4);
  EXPECT_GT(warm[0], 1.05);
  EXPECT_LT(warm[2], 0.97);
}

// 683 lm/W at the peak of the eye: G-173 has 133 klx, the constant of the IES is 128 klx.
TEST(Sun, HasItsIlluminance) {
  double lux = 0.0;
  for (const WaveBand& band : fine_bands()) {
    lux += 683.0 * 10.0 * mean_over(observer().y, band.low, band.high) *
           mean_over(solar_irradiance(), band.low, band.high);
  }
  EXPECT_NEAR(lux, 133000.0, 3000.0);
}

TEST(Nodes, AscendAndLieInTheirBands) {
  for (int count = kFewestWavelengths; count <= kMostWavelengths; ++count) {
    const Nodes nodes = nodes_for(count);
    ASSERT_EQ(nodes.nm.size(), static_cast<std::size_t>(count));
    ASSERT_EQ(nodes.bands.size(), nodes.nm.size());
    for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
      EXPECT_LT(nodes.bands[k].low, nodes.nm[k]);
      EXPECT_GT(nodes.bands[k].high, nodes.nm[k]);
      if (k > 0) {
        EXPECT_GT(nodes.bands[k].low + 1e-9, nodes.bands[k - 1].high) << "light counted twice";
      }
    }
  }
}

TEST(Matrix, KeepsTheSunsColour) {
  for (const White white : kWhites) {
    const BandColours colours = band_colours(solar_irradiance(), white);
    for (const int count : {3, 4, 5, 6, 7, 8, 12, 47, 48}) {
      const Nodes nodes = nodes_for(count);
      const std::vector<double> one(nodes.nm.size(), 1.0);
      for (const ColourMatrix& matrix : {nearest_matrix(nodes, colours), universal_matrix(nodes, colours)}) {
        const Rgb found = colour_by(matrix, one);
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(found[c], sun_colour(colours)[c], 1e-9) << count;
        }
      }
    }
  }
}

// With all fine bands nothing is left to fit.
TEST(Matrix, OfAllBandsIsExact) {
  const BandColours colours = band_colours(solar_irradiance(), White::sun);
  const ColourMatrix matrix = nearest_matrix(nodes_for(kFineBands), colours);
  for (std::size_t b = 0; b < colours.size(); ++b) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_DOUBLE_EQ(matrix[b][c], colours[b][c]);
    }
  }
}

// A spectrum outside those that the universal matrix was fitted to: a clear zenith, the sun through 1.7 verticals, over
// bright sand. The error falls as the number of wavelengths grows.
TEST(Matrix, OfFewWavelengthsComesClose) {
  const BandColours colours = band_colours(solar_irradiance(), White::sun);
  const auto zenith = [](double nm) {
    const double rayleigh = rayleigh_scattering(nm);
    return rayleigh * std::exp(-14.0 * rayleigh - 0.2 * std::pow(nm / 550.0, -1.0)) *
           (1.0 + 0.4 * (nm - 400.0) / 300.0);
  };
  const Rgb truth = colour_of(colours, over_sun(zenith));
  const auto worst = [&](int count) {
    const Nodes nodes = nodes_for(count);
    std::vector<double> at_nodes;
    for (const double nm : nodes.nm) {
      at_nodes.push_back(zenith(nm));
    }
    const Rgb found = colour_by(universal_matrix(nodes, colours), at_nodes);
    double error = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      error = std::max(error, std::fabs(found[c] / truth[c] - 1.0));
    }
    return error;
  };
  EXPECT_LT(worst(3), 0.04);
  EXPECT_LT(worst(4), 0.02);
  EXPECT_LT(worst(6), 0.006);
}

// The matrix meets samples that can be met; where they determine nothing the prior stays.
TEST(Matrix, IsFittedToItsSamples) {
  const BandColours colours = band_colours(solar_irradiance(), White::sun);
  const Nodes nodes = nodes_for(4);
  const ColourMatrix prior = universal_matrix(nodes, colours);
  ColourMatrix truth = prior;
  truth[1][0] += 0.1;
  truth[2][0] -= 0.1;  // the sun's colour stays
  std::vector<ColouredSpectrum> samples;
  for (int i = 0; i < 30; ++i) {
    ColouredSpectrum sample;
    for (int k = 0; k < 4; ++k) {
      sample.at_nodes.push_back(1.0 + 0.5 * std::sin(1.7 * i + 2.3 * k));
    }
    sample.colour = colour_by(truth, sample.at_nodes);
    samples.push_back(sample);
  }
  const Rgb sun = sun_colour(colours);
  const ColourMatrix fitted = fitted_matrix(samples, prior, sun, 1e-9);
  EXPECT_LT(mean_error(fitted, samples), 1e-6);
  EXPECT_GT(mean_error(prior, samples), 1e-3);
  EXPECT_NEAR(colour_by(fitted, {1.0, 1.0, 1.0, 1.0})[0], sun[0], 1e-9);
  const ColourMatrix unmoved = fitted_matrix({}, prior, sun, 1e-3);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(unmoved[k][0], prior[k][0], 1e-9);
  }
}

// A column that would give dark light is corrected without changing the sum; a sound column stays unchanged.
TEST(Matrix, HasNoDarkColumns) {
  const auto luminance = [](const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  const ColourMatrix plain{{0.1, 0.1, 0.6}, {0.3, 0.7, 0.3}, {0.6, 0.2, 0.1}};
  const ColourMatrix dark{{0.0, -0.2, 0.7}, {0.4, 1.0, 0.2}, {0.6, 0.2, 0.1}};
  const ColourMatrix mended = lit_matrix(dark, plain);
  EXPECT_NEAR(luminance(mended[0]), 0.0, 1e-12);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(mended[0][c] + mended[1][c] + mended[2][c], 1.0, 1e-12);
  }
  EXPECT_EQ(lit_matrix(plain, dark), plain);
}

}  // namespace
}  // namespace airlight::test
