// Light scattered in a cloud of drops, by discrete ordinates on a grid of cells that repeats itself in x and y.
//
// [CF55] Chandrasekhar's ordinates, here the product of two Gauss-Legendre nodes a hemisphere and even azimuths; [W77]
// delta scaling: the share f of the scattered light counts as not scattered,
//
//     extinction' = (1 - a f) extinction,   a' = a (1 - f) / (1 - a f),   chi'_l = (chi_l - f) / (1 - f)
//
// with f = chi_(N+1), N the degree kept, a the single scattering albedo. A cell sends into the direction d
//
//     S(d) = a' sum over l, m of chi'_l M_lm Y_lm(d),   M_lm = integral of L Y_lm + sunlight's
//
// per unit of scaled optical depth. The picture adds sunlight scattered once. On its way to the eye the peak has scattered
// light any number of times by small angles, which the scaled depth passes over. That light keeps the moments l up to N
// by exp(-(1 - a f) depth), the others by exp(-(1 - a chi_l) depth), the depth that of the whole way, unscaled [GS40]:
//
//     P(nu, depth) = sum over l of (2 l + 1) / (4 pi) chi_l P_l(nu) exp(-a (f - chi_l) depth),  the exponential 1 to N
//
// and extinction' takes the rest. At no depth it is the whole phase function, which [NT88] take at all depths (TMS).
//
// [W77] Wiscombe, J. Atmos. Sci. 34, 1408; [NT88] Nakajima and Tanaka, JQSRT 40, 51;
// [GS40] Goudsmit and Saunderson, Phys. Rev. 57, 24; [LMM87] Larsen, Morel and Miller, J. Comput. Phys. 69, 283.

// Real spherical harmonics up to degree 2, orthonormal, by i = l (l + 1) + m; d: of length 1.
real cloud_harmonic(uint i, vec3 d) {
  real x = d.x;
  real y = d.y;
  real z = d.z;
  if (i == 0u) {
    return 0.28209479177387814;
  }
  if (i < 4u) {
    return 0.48860251190291992 * (i == 1u ? y : (i == 2u ? z : x));
  }
  if (i == 4u) {
    return 1.0925484305920792 * x * y;
  }
  if (i == 5u) {
    return 1.0925484305920792 * y * z;
  }
  if (i == 6u) {
    return 0.31539156525252005 * (3.0 * z * z - 1.0);
  }
  if (i == 7u) {
    return 1.0925484305920792 * x * z;
  }
  return 0.54627421529603959 * (x * x - y * y);
}

// The axis along which light of a direction is carried from cell to cell (0: x, 1: y, 2: z): that on which it crosses
// the most cells. Carried from layer to layer alone, flat light would pass several cells in one step as if all were
// the last. Where it goes round the repeating grid more often before it leaves by the top or the base, it is carried
// along z all the same. `extent`, `cell`: km.
uint sweep_axis(vec3 direction, vec3 extent, vec3 cell) {
  const real kMostRounds = 4.0;
  real x = abs(direction.x);
  real y = abs(direction.y);
  real z = abs(direction.z);
  uint level = x / cell.x >= y / cell.y ? 0u : 1u;
  real rounds = extent.z / z * (level == 0u ? x / extent.x : y / extent.y);
  return max(x / cell.x, y / cell.y) > z / cell.z && rounds <= kMostRounds ? level : 2u;
}

// The way through a cell in its direction, km.
real sweep_way(vec3 direction, vec3 cell, uint axis) {
  return axis == 0u ? cell.x / abs(direction.x) : (axis == 1u ? cell.y / abs(direction.y) : cell.z / abs(direction.z));
}

// Cells that rays move by along an axis of the planes that a sweep crosses, from the plane before to the plane that is
// the n-th from 0: whole ones, so that every ray goes from cell to cell and no light spreads beside it. `shift`: the
// cells that they move by in truth.
real sweep_move(real shift, uint n) {
  return floor(shift * (real(n) + 0.5) + 0.5) - floor(shift * (real(n) - 0.5) + 0.5);
}

struct CellLight {
  real mean;     // radiance, the mean along the way through the cell
  real leaving;  // at its far side
};

// What a source's slope adds to the light that leaves a cell, over the slope: 1 - m (1 + depth / 2), m the mean
// transmittance. Divided by the depth, so that it keeps its digits in thin cells.
real slope_share(real depth, real m) {
  if (depth < 0.1) {
    return depth * (1.0 / 12.0 - depth * (1.0 / 24.0 - depth / 80.0));
  }
  return (1.0 - m * (1.0 + 0.5 * depth)) / depth;
}

// Light that enters a cell with `entering` and crosses the optical depth `depth`. The source rises by `slope` along the
// way, `source` in its middle: where a cell is many free paths thick, light that leaves is the source near its far
// side, and a source that is even in the cell would carry light half a cell too far [LMM87]. What the light loses or
// gains on the way is depth times (mean - source), so no light is made or lost whatever the depth.
CellLight through_cell(real entering, real source, real slope, real depth) {
  real m = mean_transmittance(depth);
  real lag = slope * slope_share(depth, m);
  CellLight light;
  light.mean = source + (entering - source) * m - lag;
  light.leaving = entering + ((source - entering) * m + lag) * depth;
  return light;
}

// Rows of the table of P by scaled depth: evenly spaced in its root.
const real kMostPeakDepth = 9.0;

real peak_table_row(real depth) {
  return sqrt(min(max(depth, 0.0), kMostPeakDepth) / kMostPeakDepth) * real(kCloudPeakRows - 1u);
}

real peak_table_depth(real row) {
  real share = row / real(kCloudPeakRows - 1u);
  return kMostPeakDepth * share * share;
}
