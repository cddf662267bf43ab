#pragma once
// Noise over integer lattices that repeats itself in x and y, and in z where a period is given. It is made by integer
// arithmetic, floor and square root alone, so that every machine has the same.

#include <cstdint>
#include <vector>

namespace airlight {

// Cells of the lattice after which the noise repeats itself; z 0: never. Value noise takes none for z.
struct NoisePeriod {
  int x = 1;
  int y = 1;
  int z = 0;
};

// In [0, 1), by whole numbers.
double hashed(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed);

// Smooth, of mean 1/2, mostly in 0.2 to 0.8; in cells of the lattice [Perlin 2002, with values in place of gradients].
double value_noise(double x, double y, double z, NoisePeriod period, std::uint32_t seed);

// Distance to the nearest of the points that are strewn one a cell, in cells, at most 1: bumps around points [Worley
// 1996].
double cell_noise(double x, double y, double z, NoisePeriod period, std::uint32_t seed);

// Octaves of these: each has twice the frequency and half the weight of the one before; the weights' sum is 1.
double value_octaves(double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed);
double cell_octaves(double x, double y, double z, NoisePeriod period, int octaves, std::uint32_t seed);

// cell_noise() from 0 to `most_z`, its points made once: the same values in a third of the time where many are asked
// for.
class StrewnPoints {
 public:
  StrewnPoints(NoisePeriod period, double most_z, std::uint32_t seed);
  double noise(double x, double y, double z) const;

 private:
  struct Point {
    double x;
    double y;
    double z;
  };
  NoisePeriod period_;
  std::uint32_t seed_;
  int layers_ = 0;             // of cells, from the one below 0 on; 0: too many to keep, points are made when asked for
  std::vector<Point> points_;  // in their cells, x fastest, then y, then z
};

// cell_octaves() from 0 to `most_z` likewise.
class CellOctaves {
 public:
  CellOctaves(NoisePeriod period, double most_z, int octaves, std::uint32_t seed);
  double at(double x, double y, double z) const;

 private:
  std::vector<StrewnPoints> octaves_;
};

}  // namespace airlight
