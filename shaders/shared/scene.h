// The scene as the shaders see it: one uniform block in scalar layout, the same text in C++ (core/physics).
// Lengths in km, angles in radians, coefficients in 1/km, directions in the preset's frame: x east, y up, -z north.
// Where the air bends light, altitudes and distances are optical (physics/refraction.glsl).
// No include guard: C++ includes it once with real = float (the block) and once with real = double (the tests).

const uint kMaxMedia = 8u;
const uint kMaxDensityLayers = 256u;
const uint kMaxShellRows = 64u;
const uint kPhaseSamples = 1024u;  // of a phase function by table
const uint kRefractionCells = 64u;
const uint kLegendreMoments = 10u;  // 0 to 9: the peak above degree 8 follows from the last two

struct PlanetData {
  real ground_radius;
  real atmosphere_height;
  vec3 ground_albedo;
};

struct MediumData {
  vec3 scattering;  // at density 1
  vec3 absorption;  // at density 1
  real scale_height;
  real center;
  real half_width;
  real below;  // the density is 1 up to there: where `constant` ends and a height fog begins to fall
  real g;
  vec3 depolarization;  // Chandrasekhar's gamma, of molecules
  uint phase_table;     // index among the scene's tables, for a phase function by table
  uint first_layer;
  uint layer_count;
  vec3 legendre[kLegendreMoments];   // of the phase function: integral of p(nu) P_l(nu) over the sphere, from l = 0
  vec3 peak[kLegendreMoments - 1u];  // by the degree kept: forward_peak() of physics/moments.glsl
};

struct SunData {
  vec3 direction;   // to the sun
  vec3 seen;        // where the camera sees its middle, through air that bends light
  vec3 dispersion;  // bending of each channel over that of the tables
  vec3 irradiance;  // on a plane that faces the sun, above the air
  real angular_radius;
  real limb_darkening;
  vec3 disc_radiance;  // at the disc's centre, above the air
  real fade_scale;     // published lesson's fade, used when kSunFade is set
  real fade_bias;
  vec3 lit_from;    // of a lit ball: to the light that shines on it; of a covered disc: to the middle of its cover
  real lit_scale;   // mean radiance over that of the law of its surface; of a covered disc: 2 sin(half the cover's
                    // radius)
  real earthshine;  // evenly over the disc, over the mean radiance
};

// Axes of the table of radiance moments (physics/moments.glsl). They follow from the planet and the air alone.
struct MomentTableData {
  real top;              // altitude of the highest row: hardly any scattering stands above
  real elevation_scale;  // sun elevation = elevation_scale sinh(v)
  real v_low;
  real v_high;
};

// Air that bends light: altitudes over optical ones.
struct RefractionData {
  real ground_radius;  // true
  real scale;          // of optical altitudes and lengths, so that they are true near a camera among things
  vec3 nodes[kRefractionCells + 1u];  // altitude; its derivative over the optical one; sun_lift()
};

struct CameraData {
  real altitude;
  vec3 right;
  vec3 up;
  vec3 forward;
  vec3 polariser;  // axis of the polarising filter, across `forward`
  real azimuth;
  real half_fov;  // of the height (perspective), of the shorter side (fisheye)
  uint width;
  uint height;
  uint cube_layout;
  // The planet's edge may cross a pixel only if the zenith cosine of the pixel's centre lies between these two.
  real edge_low;
  real edge_high;
};

// The rectangle of the picture that a plan renders: all of it, or a tile.
struct TileData {
  uint x;  // column of its upper left pixel
  uint y;
  uint width;
};

struct SceneData {
  PlanetData planet;
  SunData sun;
  CameraData camera;
  RefractionData refraction;
  real multiple_scattering_scale;
  MomentTableData moments;
  MediumData media[kMaxMedia];
  vec2 layers[kMaxDensityLayers];  // altitude, density
  uint shell_rows;                 // 0: this air is not cut into shells (physics/shells.glsl)
  real shell_altitudes[kMaxShellRows];
  TileData tile;
};
