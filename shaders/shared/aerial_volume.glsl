// Shape of the aerial volume: columns and rows of the picture's table of factors, blocks side by side as there, slices
// along each ray.

layout(constant_id = 28) const uint kSlices = 16u;
// The mean extinction is alike all around and hence cheap: its slices stand closer, so that transmittance falls evenly.
const uint kExtinctionSlices = 4u * kSlices;

// In the shared block all air stands before the ground.
float volume_carrier(float nu) { return shared_carrier(kSectionSky, nu); }
