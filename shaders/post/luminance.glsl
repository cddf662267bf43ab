// Luminance of scene-linear BT.709.
real luminance_bt709(vec3 c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }
