// Light gathered over one step of a ray in which source and extinction are constant.

// What a whole ray brings.
struct PathRadiance {
  vec3 radiance;       // W/(m2 sr)
  vec3 transmittance;  // from the camera to the ray's end
};

struct SegmentTransfer {
  vec3 mean;     // mean transmittance from the step's start to the points of the step
  vec3 through;  // transmittance of the whole step
};

// (1 - exp(-x))/x for x >= 0. The quotient loses digits as x falls (more steps would make a picture worse), so a
// Taylor series below 1/2: its first term left out is x^8/9! = 1.1e-8 there.
real mean_transmittance(real x) {
  const real kThird = 1.0 / 3.0;
  const real kSixth = 1.0 / 6.0;
  const real kSeventh = 1.0 / 7.0;
  real series =
      1.0 -
      x * 0.5 *
          (1.0 -
           x * kThird * (1.0 - x * 0.25 * (1.0 - x * 0.2 * (1.0 - x * kSixth * (1.0 - x * kSeventh * (1.0 - x * 0.125))))));
  real quotient = (1.0 - exp(-x)) / max(x, 0.5);
  return x < 0.5 ? series : quotient;
}

// Of a step of optical depth x. exp(-x) = 1 - x (1 - exp(-x))/x: where the series holds no exponential is taken, whose
// error on the software device (1e-6, always the same way) would grow with the number of steps.
SegmentTransfer segment_transfer(vec3 x) {
  SegmentTransfer s;
  s.mean = vec3(mean_transmittance(x.x), mean_transmittance(x.y), mean_transmittance(x.z));
  s.through = max(vec3(1.0) - x * s.mean, vec3(0.0));
  return s;
}

// A panel of two Gauss-Legendre nodes, +-kPanelNode of its width from its middle: what sources at the nodes add to the
// radiance at its near end, and what it leaves of light from behind.
const real kPanelNode = 0.28867513459481287;  // 1/(2 sqrt 3)

struct PanelTransfer {
  vec3 near;     // km
  vec3 far;      // km
  vec3 depth;
  vec3 through;
};

// Light at the nodes is weighed by the transmittance up to them, of an extinction that is linear between, and the
// weights are scaled so that sum(weight x extinction) is what the panel takes out of a beam: of fourth order in thin air,
// and in air of any thickness a mean of the source functions at the nodes, no light made or lost.
PanelTransfer panel_transfer(vec3 near_extinction, vec3 far_extinction, real width) {
  vec3 extinction = near_extinction + far_extinction;
  PanelTransfer panel;
  panel.depth = extinction * (0.5 * width);
  SegmentTransfer segment = segment_transfer(panel.depth);
  // From node to node the depth is 1/sqrt 3 of the panel's. Held above 0, so that one node in a vacuum leaves the other.
  vec3 between = max(exp(-panel.depth * 0.57735026918962576), vec3(1e-12));
  vec3 scale = extinction / max(near_extinction + far_extinction * between, vec3(1e-37));
  panel.near = segment.mean * scale * (0.5 * width);
  panel.far = panel.near * between;
  panel.through = segment.through;
  return panel;
}
