// The pixels of a pass over things. The rays of those that have several are listed block by block, and each thread
// takes one ray of the list: threads that go through the rays of one pixel each would leave all others waiting.
// The includer defines:
//   uint width, height;
//   struct PixelSeen;                                 what a pixel shows
//   PixelSeen nothing_seen();
//   PixelSeen ray_seen(ThingRay ray);                 a ray's part of the pixel `here`
//   PixelSeen with_seen(PixelSeen sum, PixelSeen one);
//   void write_seen(bool inside, PixelSeen seen);     the pixel `here`

layout(local_size_x = 8, local_size_y = 8) in;

const uint kThreads = kThingBlock * kThingBlock;
// The most rays of a pixel. A thread goes through one ray more at most: a software device ends the loops of a shader
// after 65536 turns.
const uint kMostRays = kEdgeSide * kEdgeSide;
shared uint listed;
shared uint list[kThreads * kMostRays];  // thread of the pixel, and in the bits above which of its rays
shared PixelSeen seen[kThreads];         // by the rays of one turn

bool in_picture(uvec2 pixel) { return pixel.x < width && pixel.y < height; }

// The first turn takes the pixels of one ray and lists the rays of the others. One loop goes through all rays, so that
// the code of a ray stands once: pipelines are made in half the time.
void main() {
  uint lane = gl_LocalInvocationIndex;
  uvec2 first = kThingBlock * gl_WorkGroupID.xy;
  uvec2 own = first + gl_LocalInvocationID.xy;
  if (lane == 0u) {
    listed = kThreads;
  }
  barrier();
  bool mine = in_picture(own);
  bool inside = false;
  uint begin = lane;  // of the pixel's rays among all of the block
  uint end = mine ? lane + 1u : lane;
  bool taken = mine;
  uint ray = 0u;
  here = own;
  PixelSeen sum = nothing_seen();
  for (uint turn = 0u; turn <= kMostRays; turn++) {
    if (taken) {
      ViewRay view = ray_at(here, vec2(0.5));
      PixelHolds rays = pixel_holds(here, view, sides_of(here, view.direction, true));
      inside = turn == 0u ? view.inside : inside;
      if (turn == 0u && rays.count > 1u) {
        begin = atomicAdd(listed, rays.count);
        end = begin + rays.count;
        for (uint i = 0u; i < rays.count; i++) {
          list[begin - kThreads + i] = lane + kThreads * i;
        }
      } else {
        seen[lane] = ray_seen(thing_ray(here, rays, ray));
      }
    }
    barrier();
    uint from = turn * kThreads;
    uint to = from + kThreads;
    for (uint i = max(begin, from); i < min(end, to); i++) {
      sum = with_seen(sum, seen[i - from]);
    }
    uint all = listed;
    barrier();
    if (to >= all) {
      break;
    }
    taken = to + lane < all;
    uint next = list[min(to + lane, all - 1u) - kThreads];
    ray = next / kThreads;
    here = first + uvec2(next % kThingBlock, next % kThreads / kThingBlock);
  }
  if (mine) {
    here = own;
    write_seen(inside, sum);
  }
}
