#include "core/spectra/data.h"

#include <array>
#include <cmath>

namespace airlight {
namespace {

// Observed means over [nm, nm + 10) are kept as samples in the middle of their interval.
constexpr double kFirst = 360.0;
constexpr double kStep = 10.0;

// Every 5 nm from 360 nm: the CIE 1931 standard observer of 2 degrees (ISO/CIE 11664-1).
constexpr double kObserverStep = 5.0;
constexpr std::array<double, 95> kX{
    0.0001299,   0.0002321,   0.0004149,   0.0007416,   0.001368,    0.002236,    0.004243,    0.00765,     0.01431,
    0.02319,     0.04351,     0.07763,     0.13438,     0.21477,     0.2839,      0.3285,      0.34828,     0.34806,
    0.3362,      0.3187,      0.2908,      0.2511,      0.19536,     0.1421,      0.09564,     0.05795,     0.03201,
    0.0147,      0.0049,      0.0024,      0.0093,      0.0291,      0.06327,     0.1096,      0.1655,      0.22575,
    0.2904,      0.3597,      0.43345,     0.51205,     0.5945,      0.6784,      0.7621,      0.8425,      0.9163,
    0.9786,      1.0263,      1.0567,      1.0622,      1.0456,      1.0026,      0.9384,      0.85445,     0.7514,
    0.6424,      0.5419,      0.4479,      0.3608,      0.2835,      0.2187,      0.1649,      0.1212,      0.0874,
    0.0636,      0.04677,     0.0329,      0.0227,      0.01584,     0.0113592,   0.00811092,  0.00579035,  0.00410946,
    0.00289933,  0.00204919,  0.00143997,  0.000999949, 0.000690079, 0.000476021, 0.000332301, 0.000234826, 0.000166151,
    0.000117413, 8.30753e-05, 5.87065e-05, 4.15099e-05, 2.93533e-05, 2.06738e-05, 1.45598e-05, 1.0254e-05,  7.22146e-06,
    5.08587e-06, 3.58165e-06, 2.52253e-06, 1.77651e-06, 1.25114e-06};
constexpr std::array<double, 95> kY{
    3.917e-06,  6.965e-06,  1.239e-05,  2.202e-05,  3.9e-05,   6.4e-05,    0.00012,    0.000217,   0.000396,
    0.00064,    0.00121,    0.00218,    0.004,      0.0073,    0.0116,     0.01684,    0.023,      0.0298,
    0.038,      0.048,      0.06,       0.0739,     0.09098,   0.1126,     0.13902,    0.1693,     0.20802,
    0.2586,     0.323,      0.4073,     0.503,      0.6082,    0.71,       0.7932,     0.862,      0.91485,
    0.954,      0.9803,     0.99495,    1,          0.995,     0.9786,     0.952,      0.9154,     0.87,
    0.8163,     0.757,      0.6949,     0.631,      0.5668,    0.503,      0.4412,     0.381,      0.321,
    0.265,      0.217,      0.175,      0.1382,     0.107,     0.0816,     0.061,      0.04458,    0.032,
    0.0232,     0.017,      0.01192,    0.00821,    0.005723,  0.004102,   0.002929,   0.002091,   0.001484,
    0.001047,   0.00074,    0.00052,    0.0003611,  0.0002492, 0.0001719,  0.00012,    8.48e-05,   6e-05,
    4.24e-05,   3e-05,      2.12e-05,   1.499e-05,  1.06e-05,  7.4657e-06, 5.2578e-06, 3.7029e-06, 2.6078e-06,
    1.8366e-06, 1.2934e-06, 9.1093e-07, 6.4153e-07, 4.5181e-07};
constexpr std::array<double, 95> kZ{
    0.0006061, 0.001086, 0.001946, 0.003486, 0.00645, 0.01055, 0.02005, 0.03621, 0.06785, 0.1102,  0.2074,  0.3713,
    0.6456,    1.03905,  1.3856,   1.62296,  1.74706, 1.7826,  1.77211, 1.7441,  1.6692,  1.5281,  1.28764, 1.0419,
    0.81295,   0.6162,   0.46518,  0.3533,   0.272,   0.2123,  0.1582,  0.1117,  0.07825, 0.05725, 0.04216, 0.02984,
    0.0203,    0.0134,   0.00875,  0.00575,  0.0039,  0.00275, 0.0021,  0.0018,  0.00165, 0.0014,  0.0011,  0.001,
    0.0008,    0.0006,   0.00034,  0.00024,  0.00019, 0.0001,  5e-05,   3e-05,   2e-05,   1e-05,   0,       0,
    0,         0,        0,        0,        0,       0,       0,       0,       0,       0,       0,       0,
    0,         0,        0,        0,        0,       0,       0,       0,       0,       0,       0,       0,
    0,         0,        0,        0,        0,       0,       0,       0,       0,       0,       0};

// W/(m2 nm), means over [nm, nm + 10) from 360 nm: ASTM G-173-03, extraterrestrial column.
constexpr std::array<double, 48> kSun{
    1.11776, 1.14259, 1.01249, 1.14716, 1.72765, 1.73054, 1.6887,  1.61253, 1.91198, 2.03474, 2.02042, 2.02212,
    1.93377, 1.95809, 1.91686, 1.8298,  1.8685,  1.8931,  1.85149, 1.8504,  1.8341,  1.8345,  1.8147,  1.78158,
    1.7533,  1.6965,  1.68194, 1.64654, 1.6048,  1.52143, 1.55622, 1.5113,  1.474,   1.4482,  1.41018, 1.36775,
    1.34188, 1.31429, 1.28303, 1.26758, 1.2367,  1.2082,  1.18737, 1.14683, 1.12362, 1.1058,  1.07124, 1.04992};

// 1e-27 m2 a molecule at 233 K, means over [nm, nm + 10) from 360 nm: Serdyuchenko and Gorshelev 2011 (IUP Bremen).
constexpr std::array<double, 48> kOzone{
    1.18,  0.2182, 0.2818, 0.6636, 1.527, 2.763, 5.52,  8.451, 15.82, 23.16, 36.69, 49.24, 77.52, 90.16, 148,   160.2,
    213.9, 275.5,  309.1,  350,    426.6, 467.2, 439.8, 470.1, 501.9, 430.5, 374,   321.5, 266.2, 223.8, 185.2, 147.3,
    120.9, 94.23,  74.55,  65.66,  51.05, 41.5,  42.28, 32.37, 24.51, 28.01, 25.34, 16.24, 14.65, 20.78, 13.83, 7.105};

template <std::size_t N>
Curve sampled(const std::array<double, N>& values, double first, double step, double factor = 1.0) {
  Curve curve;
  for (std::size_t i = 0; i < N; ++i) {
    curve.wavelengths.push_back(first + step * static_cast<double>(i));
    curve.values.push_back(factor * values[i]);
  }
  return curve;
}

}  // namespace

const Observer& observer() {
  static const Observer cie{sampled(kX, kFirst, kObserverStep), sampled(kY, kFirst, kObserverStep),
                            sampled(kZ, kFirst, kObserverStep)};
  return cie;
}

const Curve& solar_irradiance() {
  static const Curve sun = sampled(kSun, kFirst + 0.5 * kStep, kStep);
  return sun;
}

const Curve& ozone_cross_section() {
  static const Curve ozone = sampled(kOzone, kFirst + 0.5 * kStep, kStep, 1e-27);
  return ozone;
}

double rayleigh_scattering(double nm) {
  constexpr double kMoleculesPerCubicMetre = 2.546899e25;
  const double l2 = nm * nm * 1e-6;  // of the wavelength in micrometres
  const double cross_section =
      1e-32 * (1.0455996 - 341.29061 / l2 - 0.90230850 * l2) / (1.0 + 0.0027059889 / l2 - 85.968563 * l2);
  return 1e3 * kMoleculesPerCubicMetre * cross_section;
}

double air_dispersion(double nm) {
  const auto refractivity = [](double wavelength) {
    const double s2 = 1e6 / (wavelength * wavelength);  // of the wavenumber in 1/um
    return 8060.51 + 2480990.0 / (132.274 - s2) + 17455.7 / (39.32957 - s2);
  };
  return refractivity(nm) / refractivity(550.0);
}

double black_body(double kelvin, double nm) {
  constexpr double kSecondRadiationConstant = 1.438776877e7;  // nm K
  const double x = kSecondRadiationConstant / (nm * kelvin);
  const double y = kSecondRadiationConstant / (560.0 * kelvin);
  return std::pow(560.0 / nm, 5.0) * std::expm1(y) / std::expm1(x);
}

}  // namespace airlight
