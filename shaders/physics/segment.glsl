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

// (1 - exp(-x))/x for 0 <= x < 1/2: 1 at 0, and of that form the polynomial of this degree whose greatest error is least,
// 1.8e-9. Two terms fewer than a Taylor series takes for 1.1e-8.
real thin_mean_transmittance(real x) {
  return 1.0 -
         x * (0.49999987516386 -
              x * (0.16666308791649 - x * (0.04163324627352 - x * (0.00819612570380 - x * 0.00112823200036))));
}

// The same for x >= 1/2, where the quotient loses no digits; as x falls it would, and more steps would make a picture
// worse.
real thick_mean_transmittance(real x) { return (1.0 - exp(-x)) / max(x, 0.5); }

real mean_transmittance(real x) { return x < 0.5 ? thin_mean_transmittance(x) : thick_mean_transmittance(x); }

// Of a step of optical depth x. exp(-x) = 1 - x (1 - exp(-x))/x: where the polynomial holds no exponential is taken, whose
// error on the software device (1e-6, always the same way) would grow with the number of steps. Most steps are thin in
// all channels.
SegmentTransfer segment_transfer(vec3 x) {
  SegmentTransfer s;
  s.mean = vec3(thin_mean_transmittance(x.x), thin_mean_transmittance(x.y), thin_mean_transmittance(x.z));
  if (max(max(x.x, x.y), x.z) >= 0.5) {
    s.mean = vec3(x.x < 0.5 ? s.mean.x : thick_mean_transmittance(x.x),
                  x.y < 0.5 ? s.mean.y : thick_mean_transmittance(x.y),
                  x.z < 0.5 ? s.mean.z : thick_mean_transmittance(x.z));
  }
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
