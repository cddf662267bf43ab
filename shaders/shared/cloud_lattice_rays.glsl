// Marches the lattice's rays, as if nothing stood in their way, and empties the list of pixels.
#include "shared/cloud_lattice.glsl"
#include "shared/cloud_list.glsl"

layout(scalar, set = 0, binding = 43) buffer CloudLattice { LatticeRay values[]; } cloud_lattice;

LatticeRay lattice_ray(PastCloud past, bool at_ground, bool inside) {
  LatticeRay ray;
  ray.sent = past.sent;
  ray.through = past.through;
  ray.share = past.share;
  ray.end = !inside ? kEndsOutside : at_ground ? kEndsOnGround : kEndsInSky;
  ray.taken = past.taken;
  return ray;
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x == 0u && at.y == 0u) {
    cloud_list.groups = uvec3(kListGroups, 0u, 1u);
    cloud_list.count = 0u;
  }
  uvec2 pixel = lattice_pixel(at);
  // The last pixels of a tile may stand between rays of which the farther two are outside.
  if (int(pixel.x) > int(width) + 1 || int(pixel.y) > int(height) + 1) {
    return;
  }
  ViewRay view = picture_ray(pixel);
  AirRay of = ray_through_clouds(pixel, view.direction);
  cloud_lattice.values[at.y * lattice_row(width) + at.x] =
      lattice_ray(past_cloud(of, of.ray.length_), of.ray.at_ground, view.inside);
}
