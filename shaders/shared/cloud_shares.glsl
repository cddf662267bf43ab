// An ordinate's share of the hemisphere: some zenith cosines, an eighth of a turn. Nine directions of it are even over
// the share.

const uint kShareRows = 3u;  // directions in zenith angle, and in azimuth
const uint kShareDirections = kShareRows * kShareRows;

// How far light of direction k goes aside, over its way up or down.
vec2 share_shift(CloudOrdinate ordinate, uint k) {
  const float kTurn = 6.283185307179586;
  const float kAzimuths = 8.0;
  float width = ordinate.weight * kAzimuths / kTurn;  // of the zenith cosines
  float mu = ordinate.lowest + width * (float(k / kShareRows) + 0.5) / float(kShareRows);
  float turn = atan(ordinate.direction.y, ordinate.direction.x) +
               kTurn / kAzimuths * ((float(k % kShareRows) + 0.5) / float(kShareRows) - 0.5);
  return vec2(cos(turn), sin(turn)) * (sqrt(1.0 - mu * mu) / mu);
}
