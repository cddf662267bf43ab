// Shape of the aerial volume: columns, rows and blocks of the picture's table of factors, and slices along each ray.

layout(constant_id = 28) const uint kSlices = 16u;
// Mean extinction is the same for all azimuths, hence cheap: its slices are denser, for an even fall of transmittance.
const uint kExtinctionSlices = 4u * kSlices;

// The carrier of the shared block, in which all air stands before the ground.
float volume_carrier(float nu) { return shared_carrier(kSectionSky, nu); }

// The volume holds the root of the mean source, for a sun of irradiance 1, in halves. Sources from 1e-15 to 1000 are
// good to a thousandth; smaller ones fade to 0.
const float kVolumeUnit = 2048.0;

vec3 volume_code(vec3 source) { return sqrt(source) * kVolumeUnit; }
vec3 volume_source(vec3 code) { return code * code * (1.0 / (kVolumeUnit * kVolumeUnit)); }
