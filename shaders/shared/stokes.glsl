// Whether a pass computes Q and U beside the light, and what becomes of them.
layout(constant_id = 40) const uint kStokes = kStokesNone;

bool stokes() { return kStokes != kStokesNone; }
