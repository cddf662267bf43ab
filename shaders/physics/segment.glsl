// Light gathered over one step of a ray in which source and extinction are constant.

// Radiance and transmittance of a whole ray.
struct PathRadiance {
  vec3 radiance;       // W/(m2 sr)
  vec3 transmittance;  // from the camera to the ray's end
};

struct SegmentTransfer {
  vec3 mean;     // mean transmittance from the step's start to the points of the step
  vec3 through;  // transmittance of the whole step
};

// (1 - exp(-x))/x for 0 <= x < 1/2: the polynomial of this degree, 1 at 0, whose greatest error is least, 1.8e-9. A
// Taylor series takes two terms more for 1.1e-8.
real thin_mean_transmittance(real x) {
  return 1.0 -
         x * (0.49999987516386 -
              x * (0.16666308791649 - x * (0.04163324627352 - x * (0.00819612570380 - x * 0.00112823200036))));
}

// (1 - exp(-x))/x for x >= 1/2, where the quotient loses no digits. For smaller x it would lose them, and more steps
// would make a picture worse.
real thick_mean_transmittance(real x) { return (1.0 - exp(-x)) / max(x, 0.5); }

real mean_transmittance(real x) { return x < 0.5 ? thin_mean_transmittance(x) : thick_mean_transmittance(x); }

// Transfer of a step of optical depth x. exp(-x) = 1 - x (1 - exp(-x))/x: where the polynomial holds, no exponential is
// taken. On the software device an exponential's error (1e-6, always the same way) would grow with the number of steps.
// Most steps are thin in all channels.
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

// A panel of two Gauss-Legendre nodes, +-kPanelNode of its width from its middle: what a source at each node adds to
// the radiance at the panel's near end, and the transmittance of the panel.
const real kPanelNode = 0.28867513459481287;  // 1/(2 sqrt 3)

struct PanelTransfer {
  vec3 near;     // km
  vec3 far;      // km
  vec3 depth;
  vec3 through;
};

// The transmittance up to each node weighs the light there; extinction is taken as linear between the nodes. The
// weights are scaled so that sum(weight x extinction) is the share of a beam that the panel takes out. In thin air this
// is of fourth order; in air of any thickness it is a mean of the source functions at the nodes, and no light is made
// or lost.
PanelTransfer panel_transfer(vec3 near_extinction, vec3 far_extinction, real width) {
  vec3 extinction = near_extinction + far_extinction;
  PanelTransfer panel;
  panel.depth = extinction * (0.5 * width);
  SegmentTransfer segment = segment_transfer(panel.depth);
  // Between the nodes lies 1/sqrt 3 of the panel's depth. The limit above 0 makes one node in a vacuum leave the other.
  vec3 between = max(exp(-panel.depth * 0.57735026918962576), vec3(1e-12));
  vec3 scale = extinction / max(near_extinction + far_extinction * between, vec3(1e-37));
  panel.near = segment.mean * scale * (0.5 * width);
  panel.far = panel.near * between;
  panel.through = segment.through;
  return panel;
}
