// Shape of the image of a cloud's sources (passes/cloud_source.comp): four values a block.
const uint kCloudBlocks = 4u;
const uint kCloudSky = 9u;      // first of three values of the sky's light, after nine of the sun's
const uint kCloudGround = 12u;  // likewise of the ground's
