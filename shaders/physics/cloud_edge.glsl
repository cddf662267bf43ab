// The edge of a cloud's water. A grid holds how far inside the cloud its places lie, km; noise takes off up to
// `carving`: bumps around strewn points, so that round lobes are left with creases between them, each set with lobes
// and creases again [Worley 1996]. Near the base the noise is turned over: threads are left.

const real kCloudFiner = 7.0;   // finer tiles across one of the noise
const real kFinerShare = 0.22;  // of the finer tiles in the noise
const real kThreads = 0.12;     // height, as a share of the cloud's, over which threads pass into lobes
const real kBaseShare = 0.4;    // of the carving at the base

// What the noise takes off at a height (0 base, 1 top), as a share of `carving`; the noise of both tiles is 0 to 1.
real edge_carved(real height, real noise, real finer) {
  real lobes = (1.0 - kFinerShare) * noise + kFinerShare * finer;
  real above = clamp(height / kThreads, 0.0, 1.0);
  return (above * lobes + (1.0 - above) * (1.0 - lobes)) * (kBaseShare + (1.0 - kBaseShare) * above);
}

// Extinction, 1/km, at a place `inside` km inside the cloud of which the noise takes this share of `carving` off.
// It grows with `inside` and falls with `carved`.
real edge_extinction(CloudEdge edge, real height, real inside, real carved) {
  real share = clamp((inside - edge.carving * carved) / edge.soft, 0.0, 1.0);
  return (edge.low + (edge.high - edge.low) * height) * share * share * (3.0 - 2.0 * share);
}
