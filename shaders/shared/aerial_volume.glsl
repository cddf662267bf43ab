// Shape of the aerial volume: columns and rows of the picture's table of factors, blocks side by side as there, slices
// along each ray.

layout(constant_id = 28) const uint kSlices = 16u;
// The mean extinction is alike all around and hence cheap: its slices stand closer, so that transmittance falls evenly.
const uint kExtinctionSlices = 4u * kSlices;

// In the shared block all air stands before the ground.
float volume_carrier(float nu) { return shared_carrier(kSectionSky, nu); }

// Mean sources, for a sun of irradiance 1, as roots in halves: from 1e-15 to 1000 they are good to a thousandth, and below
// fade to 0.
const float kVolumeUnit = 2048.0;

vec3 volume_code(vec3 source) { return sqrt(source) * kVolumeUnit; }
vec3 volume_source(vec3 code) { return code * code * (1.0 / (kVolumeUnit * kVolumeUnit)); }
