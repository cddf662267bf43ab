// Codes of the functions that parity_calls.glsl calls; the same text in GLSL and C++.

const uint kCallHorizon = 0u;
const uint kCallDistances = 1u;
const uint kCallRay = 2u;
const uint kCallPoint = 3u;
const uint kCallPhase = 4u;
const uint kCallSegment = 5u;
const uint kCallStep = 6u;
const uint kCallTransmittanceCoordinate = 7u;
const uint kCallTransmittanceState = 8u;
const uint kCallScattering = 9u;
const uint kCallAir = 10u;
const uint kCallDepth = 11u;
const uint kCallDisc = 12u;
const uint kCallViewRay = 32u;  // plus the projection's code
