// Level slabs of the radiative-transfer literature against adding and doubling.

#include <gtest/gtest.h>

#include <ostream>

#include "path_trace_scene.h"
#include "slab.h"

namespace airlight {
namespace {

// A test of the reference itself: it loses nothing without absorption, and one thin layer is single scattering.
TEST(SlabJudge, ConservesEnergyAndIsRightWhenThin) {
  for (const double ground_albedo : {0.0, 1.0}) {
    const int sun = 9;
    const Slab slab({2.0, 1.0, henyey_greenstein_moments(0.75, 48), ground_albedo}, 24, sun);
    double up = 0.0;
    double down = 0.0;
    for (std::size_t i = 0; i < slab.nodes().size(); ++i) {
      const double share = 2.0 * std::numbers::pi * slab.nodes()[i] * slab.weights()[i];
      up += share * slab.mean_reflected(i);
      down += share * slab.mean_transmitted(i);
    }
    const double in = slab.nodes()[sun];
    const double direct = in * std::exp(-2.0 / in);
    EXPECT_NEAR(up + (1.0 - ground_albedo) * (down + direct), in, 1e-6 * in);
  }
  const Slab thin({1e-6, 0.7, rayleigh_moments(), 0.0}, 8, 5);
  const double mu = thin.nodes()[2];
  const double mu_sun = thin.nodes()[5];
  const double nu = -mu * mu_sun + std::sqrt((1 - mu * mu) * (1 - mu_sun * mu_sun));
  const double expected = 0.7 * 3.0 / (16.0 * std::numbers::pi) * (1.0 + nu * nu) * 1e-6 / mu;
  EXPECT_NEAR(thin.reflected(2, 0.0), expected, 1e-4 * expected);
}

struct LevelCase {
  const char* name;
  double optical_depth;
  double single_scattering_albedo;
  double g;  // 0: Rayleigh
  double ground_albedo;
  int samples;
  double precision;  // standard error that these samples must reach, of the radiance
};

void PrintTo(const LevelCase& c, std::ostream* out) {
  *out << c.name;
}

class PathTraceSlab : public testing::TestWithParam<LevelCase> {};

TEST_P(PathTraceSlab, RadianceAtTopAndBottomMeetsAddingAndDoubling) {
  const LevelCase& c = GetParam();
  constexpr int kSun = 14;
  const bool rayleigh = c.g == 0.0;
  const Slab judge({c.optical_depth, c.single_scattering_albedo,
                    rayleigh ? rayleigh_moments() : henyey_greenstein_moments(c.g, 48), c.ground_albedo},
                   24, kSun);
  Scene scene = slab(c.optical_depth, c.single_scattering_albedo,
                     rayleigh ? PhaseFunction::rayleigh : PhaseFunction::henyey_greenstein, c.g);
  scene.planet.ground_albedo = {c.ground_albedo, c.ground_albedo, c.ground_albedo};
  scene.sun.elevation = std::asin(judge.nodes()[kSun]);
  set(scene, "samples", c.samples);
  struct Look {
    std::size_t node;
    double azimuth;
  };
  const std::vector<Look> looks{{4, 0.0}, {12, 2.0}, {23, 0.0}};
  for (const bool top : {true, false}) {
    scene.camera.altitude = top ? 10.0 : 0.0;
    std::vector<Direction> directions;
    for (const Look& look : looks) {
      directions.push_back({(top ? -1.0 : 1.0) * std::asin(judge.nodes()[look.node]), look.azimuth});
    }
    const HostPicture picture = trace(scene, directions);
    for (std::size_t k = 0; k < looks.size(); ++k) {
      const auto& [node, azimuth] = looks[k];
      const double expected = top ? judge.reflected(node, azimuth) : judge.transmitted(node, azimuth);
      const double error = picture.standard_error.at(static_cast<int>(k), 0)[1];
      EXPECT_LT(error, c.precision * expected);
      EXPECT_NEAR(picture.radiance.at(static_cast<int>(k), 0)[1], expected, 0.002 * expected + 4.0 * error)
          << (top ? "top" : "bottom") << " zenith cosine " << judge.nodes()[node] << " azimuth " << azimuth;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Published, PathTraceSlab,
                         testing::Values(LevelCase{"rayleigh 0.2, albedo 0.5", 0.2, 0.5, 0, 0, 4096, 0.005},
                                         LevelCase{"rayleigh 0.2, albedo 1", 0.2, 1, 0, 0, 4096, 0.005},
                                         LevelCase{"rayleigh 5, albedo 0.5", 5, 0.5, 0, 0, 8192, 0.05},
                                         LevelCase{"rayleigh 5, albedo 1", 5, 1, 0, 0, 8192, 0.05},
                                         LevelCase{"HG 0.75, 1", 1, 1, 0.75, 0, 16384, 0.04},
                                         LevelCase{"HG 0.75, 8", 8, 1, 0.75, 0, 16384, 0.1},
                                         LevelCase{"rayleigh 1 over white ground", 1, 1, 0, 1, 4096, 0.02}));

}  // namespace
}  // namespace airlight
