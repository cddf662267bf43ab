#pragma once
// A phase function measured at some angles, perhaps at some wavelengths.

#include <cstddef>
#include <vector>

namespace airlight {

struct PhaseTable {
  std::vector<double> angles_deg;         // ascending from 0 to 180
  std::vector<double> wavelengths_nm;     // ascending; empty: one row stands for all
  std::vector<std::vector<double>> rows;  // 1/sr, a row a wavelength, a value an angle
  double integral = 1.0;  // over the sphere as read, of the row furthest off 1; each row is divided by its own
  bool operator==(const PhaseTable& other) const {
    return angles_deg == other.angles_deg && wavelengths_nm == other.wavelengths_nm && rows == other.rows;
  }
};

// The logarithm is linear between angles and between wavelengths; beyond the outermost wavelengths it is constant.
// Values below 1e-9 count as 1e-9.
double phase_at(const PhaseTable& table, double nm, double angle_deg);

// The integral of a row over the sphere, in closed form.
double sphere_integral(const PhaseTable& table, std::size_t row);

}  // namespace airlight
