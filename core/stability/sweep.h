#pragma once
// The sweeps of `airlight stability`, over two quantities at a time, and the scene at each of their places.

#include <array>
#include <string>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace airlight::stability {

// As the device takes it.
constexpr double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

// A value for each Quantity; NaN: the scene's or the method's own.
class Place {
 public:
  Place();
  double operator[](Quantity q) const { return values_[static_cast<std::size_t>(q)]; }
  void set(Quantity q, double value) { values_[static_cast<std::size_t>(q)] = value; }
  bool given(Quantity q) const;

 private:
  std::array<double, kQuantities> values_;
};

enum class Form { quick, brief, full };  // quick: for CI

struct Sweep {
  std::string name;   // of its picture, "sun-altitude"
  std::string title;  // one sentence: the swept quantities, and the scene
  Quantity x;
  Quantity y;
  std::vector<double> xs;
  std::vector<double> ys;
  Place base;           // fixed quantities, neither x nor y
  bool narrow = false;  // x is the view: a row is one picture of a column of pixels a degree high at the horizon
  bool energy = false;  // the air's global balance of energy is taken at each place
};

std::vector<Sweep> sweeps(Form form);

// "sun elevation, degrees"
std::string_view quantity_name(Quantity q);

Place place_of(const Sweep& sweep, std::size_t x, std::size_t y);

// The scene at a place, without a method. It is Earth's air [H20, Table 1] over a ground of albedo 0.3. Where an
// optical depth is given, it is air of that depth without absorption over a white ground: molecules, or haze where an
// asymmetry is given. All scenes have the same kinds of media, so that no cell needs a shader of its own. Every number
// is a 32-bit float's.
Scene scene_at(const Place& place);

// A camera whose pixels are the sweep's directions: all round, or a narrow column.
Scene looking(Scene scene, const Sweep& sweep);

// The directions of the pixels of the scene's camera, row by row.
std::vector<Direction> pixel_directions(const Scene& scene);

}  // namespace airlight::stability
