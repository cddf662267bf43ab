#include "core/spectra/moonlight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace airlight {
namespace {

// A band's centre in nm, and the coefficients of the logarithm of its reflectance.
struct Band {
  double nm;
  std::array<double, 4> a;
  std::array<double, 3> b;
  std::array<double, 3> d;
};

constexpr std::array<Band, kLunarBands> kBands{{
    {350.0, {-2.67511, -1.78539, 0.50612, -0.25578}, {0.03744, 0.00981, -0.00322}, {0.34185, 0.01441, -0.01602}},
    {355.1, {-2.71924, -1.74298, 0.44523, -0.23315}, {0.03492, 0.01142, -0.00383}, {0.33875, 0.01612, -0.00996}},
    {405.0, {-2.35754, -1.72134, 0.40337, -0.21105}, {0.03505, 0.01043, -0.00341}, {0.35235, -0.03818, -0.00006}},
    {412.3, {-2.34185, -1.74337, 0.42156, -0.21512}, {0.03141, 0.01364, -0.00472}, {0.36591, -0.05902, 0.00080}},
    {414.4, {-2.43367, -1.72184, 0.43600, -0.22675}, {0.03474, 0.01188, -0.00422}, {0.35558, -0.03247, -0.00503}},
    {441.6, {-2.31964, -1.72114, 0.37286, -0.19304}, {0.03736, 0.01545, -0.00559}, {0.37935, -0.09562, 0.00970}},
    {465.8, {-2.35085, -1.66538, 0.41802, -0.22541}, {0.04274, 0.01127, -0.00439}, {0.33450, -0.02546, -0.00484}},
    {475.0, {-2.28999, -1.63180, 0.36193, -0.20381}, {0.04007, 0.01216, -0.00437}, {0.33024, -0.03131, 0.00222}},
    {486.9, {-2.23351, -1.68573, 0.37632, -0.19877}, {0.03881, 0.01566, -0.00555}, {0.36590, -0.08945, 0.00678}},
    {544.0, {-2.13864, -1.60613, 0.27886, -0.16426}, {0.03833, 0.01189, -0.00390}, {0.37190, -0.10629, 0.01428}},
    {549.1, {-2.10782, -1.66736, 0.41697, -0.22026}, {0.03451, 0.01452, -0.00517}, {0.36814, -0.09815, -0.00000}},
    {553.8, {-2.12504, -1.65970, 0.38409, -0.20655}, {0.04052, 0.01009, -0.00388}, {0.37206, -0.10745, 0.00347}},
    {665.1, {-1.88914, -1.58096, 0.30477, -0.17908}, {0.04415, 0.00983, -0.00389}, {0.37141, -0.13514, 0.01248}},
    {693.1, {-1.89410, -1.58509, 0.28080, -0.16427}, {0.04429, 0.00914, -0.00351}, {0.39109, -0.17048, 0.01754}},
    {703.6, {-1.92103, -1.60151, 0.36924, -0.20567}, {0.04494, 0.00987, -0.00386}, {0.37155, -0.13989, 0.00412}},
    {745.3, {-1.86896, -1.57522, 0.33712, -0.19415}, {0.03967, 0.01318, -0.00464}, {0.36888, -0.14828, 0.00958}},
    {763.7, {-1.85258, -1.47181, 0.14377, -0.11589}, {0.04435, 0.02000, -0.00738}, {0.39126, -0.16957, 0.03053}},
    {774.8, {-1.80271, -1.59357, 0.36351, -0.20326}, {0.04710, 0.01196, -0.00476}, {0.36908, -0.16182, 0.00830}},
    {865.3, {-1.74561, -1.58482, 0.35009, -0.19569}, {0.04142, 0.01612, -0.00550}, {0.39200, -0.18837, 0.00978}},
    {872.6, {-1.76779, -1.60345, 0.37974, -0.20625}, {0.04645, 0.01170, -0.00424}, {0.39354, -0.19360, 0.00568}},
    {882.0, {-1.73011, -1.61156, 0.36115, -0.19576}, {0.04847, 0.01065, -0.00404}, {0.40714, -0.21499, 0.01146}},
    {928.4, {-1.75981, -1.45395, 0.13780, -0.11254}, {0.05000, 0.01476, -0.00513}, {0.41900, -0.19963, 0.02940}},
    {939.3, {-1.76245, -1.49892, 0.07956, -0.07546}, {0.05461, 0.01355, -0.00464}, {0.47936, -0.29463, 0.04706}},
    {942.1, {-1.66473, -1.61875, 0.14630, -0.09216}, {0.04533, 0.03010, -0.01166}, {0.57275, -0.38204, 0.04902}},
    {1059.5, {-1.59323, -1.71358, 0.50599, -0.25178}, {0.04906, 0.03178, -0.01138}, {0.48160, -0.29486, 0.00116}},
}};

constexpr double kDegrees = 180.0 / std::numbers::pi;

// Measured phases end at 1.55 degrees, where the earth's shadow begins.
constexpr double kLeastPhase = 1.55 / kDegrees;

// Logarithm of the reflectance at a wavelength: a straight line through the bands around it, which count by a bell
// curve 15 nm wide. It stays within 5 % of each band.
double smooth_logarithm(double nm, const std::array<double, kLunarBands>& logarithms) {
  constexpr double kWidth = 15.0;
  std::array<double, 3> moments{};
  std::array<double, 2> values{};
  const auto nearest = std::ranges::min(kBands, {}, [nm](const Band& band) { return std::abs(band.nm - nm); }).nm - nm;
  for (std::size_t i = 0; i < kLunarBands; ++i) {
    const double off = kBands[i].nm - nm;
    const double weight = std::exp(0.5 * (nearest * nearest - off * off) / (kWidth * kWidth));
    for (std::size_t k = 0; k < 3; ++k) {
      moments[k] += weight * std::pow(off, static_cast<double>(k));
    }
    values[0] += weight * logarithms[i];
    values[1] += weight * logarithms[i] * off;
  }
  const double determinant = moments[0] * moments[2] - moments[1] * moments[1];
  return (values[0] * moments[2] - values[1] * moments[1]) / determinant;
}

}  // namespace

double lunar_band(std::size_t band) {
  return kBands.at(band).nm;
}

double lunar_reflectance(std::size_t band, double phase) {
  const Band& c = kBands.at(band);
  const double g = std::max(std::abs(phase), kLeastPhase);
  // The sun's longitude on the moon: east, where it rises, while the moon waxes.
  const double longitude = std::copysign(g, phase);
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    sum += c.a[i] * std::pow(g, static_cast<double>(i));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    sum += c.b[j] * std::pow(longitude, static_cast<double>(2 * j + 1));
  }
  // In these terms the phase is in degrees.
  const double degrees = g * kDegrees;
  sum += c.d[0] * std::exp(-degrees / 4.06054) + c.d[1] * std::exp(-degrees / 12.8802);
  return std::exp(sum + c.d[2] * std::cos((degrees + 30.5858) / 16.7498));
}

Curve moonlight(double phase, double distance) {
  constexpr double kSolidAngle = 6.4236e-5;  // of the moon at its mean distance, sr
  std::array<double, kLunarBands> logarithms{};
  for (std::size_t i = 0; i < kLunarBands; ++i) {
    logarithms[i] = std::log(lunar_reflectance(i, phase));
  }
  const double nearer = kMeanMoonDistance / distance;
  Curve curve;
  for (double nm = kBands.front().nm; nm < kBands.back().nm; nm += 5.0) {
    curve.wavelengths.push_back(nm);
    curve.values.push_back(std::exp(smooth_logarithm(nm, logarithms)) * kSolidAngle / std::numbers::pi * nearer *
                           nearer);
  }
  return curve;
}

double earthshine(double phase) {
  constexpr std::size_t kGreen = 10;
  constexpr double kGeometricAlbedo = 0.434;
  constexpr double kEarthOverDistance = 6371.0 / kMeanMoonDistance;
  const double lit = std::abs(phase);  // the earth is full when the moon is new
  const double earth = (std::sin(lit) - lit * std::cos(lit)) / std::numbers::pi;
  return kGeometricAlbedo * kEarthOverDistance * kEarthOverDistance * earth * lunar_reflectance(kGreen, 0.0) /
         lunar_reflectance(kGreen, phase);
}

}  // namespace airlight
