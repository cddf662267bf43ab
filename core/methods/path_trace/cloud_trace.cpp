#include "core/methods/path_trace/cloud_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace airlight {

using physics::vec3;

namespace {

constexpr int kBlock = 4;           // cells along a block's side
constexpr double kRounding = 1e-7;  // km, by which a place may lie beyond a plane

int blocks_of(int cells) {
  return (cells + kBlock - 1) / kBlock;
}

// The block, or cell, of an unbounded row in the grid's own.
int in_period(int block, int count) {
  const int rest = block % count;
  return rest < 0 ? rest + count : rest;
}

// The edge of a block, in cells from the grid's corner; blocks go on beyond the grid, period by period.
double edge_of(int block, int blocks, int cells) {
  const int within = in_period(block, blocks);
  const double periods = static_cast<double>((block - within) / blocks);
  return periods * cells + std::min(within * kBlock, cells);
}

// Cells beyond what an int counts, near the horizon of a planet as good as flat, count as the last.
int block_at(double cell, int blocks, int cells) {
  constexpr double kFarthest = 1e9;
  cell = std::clamp(cell, -kFarthest, kFarthest);
  const double period = std::floor(cell / cells);
  const int within = std::min(static_cast<int>((cell - period * cells) / kBlock), blocks - 1);
  return static_cast<int>(period) * blocks + within;
}

}  // namespace

Part with_cloud_media(const Part& part) {
  Scene scene = part.scene;
  const Spectrum channels = scene.media.front().phase_wavelengths;
  for (const Cloud& cloud : scene.clouds) {
    scene.media.push_back(cloud_medium(cloud, channels));
  }
  Air air(scene.media, scene.planet, part.air.options());
  Part whole = part;
  whole.scene = std::move(scene);
  whole.air = std::move(air);
  return whole;
}

// A straight line, with what is needed to find where it crosses the planes and shells of a grid.
class TracedCloud::Way {
 public:
  Way(vec3 from, vec3 direction, double radius)
      : from_(from), direction_(direction), radius_(radius), h_(length(from) - radius), along_(dot(from, direction)) {}

  vec3 at(double t) const { return from_ + direction_ * t; }
  const vec3& from() const { return from_; }
  const vec3& direction() const { return direction_; }
  double along() const { return along_; }
  double altitude(double t) const { return length(at(t)) - radius_; }
  double east(double t) const { return radius_ * (from_.x + t * direction_.x) / (from_.y + t * direction_.y); }
  double north(double t) const { return -radius_ * (from_.z + t * direction_.z) / (from_.y + t * direction_.y); }

  // Where the line crosses a plane east = x, or north = y.
  double to_east(double x) const {
    return (x * from_.y - radius_ * from_.x) / (radius_ * direction_.x - x * direction_.y);
  }
  double to_north(double y) const {
    return (y * from_.y + radius_ * from_.z) / (-radius_ * direction_.z - y * direction_.y);
  }
  // Whether the line goes toward east, or north; else it goes the other way, or neither.
  bool eastward() const { return direction_.x * from_.y > from_.x * direction_.y; }
  bool northward() const { return -direction_.z * from_.y > -from_.z * direction_.y; }

  // Where it crosses the shell of altitude h downward, and upward; both kNever where it does not.
  Interval through(double h) const {
    const double c = (h_ - h) * (2.0 * radius_ + h_ + h);
    const double square = along_ * along_ - c;
    if (square < 0.0) {
      return {kNever, kNever};
    }
    const double root = std::sqrt(square);
    // The form that does not cancel.
    if (along_ > 0.0) {
      return {-along_ - root, -c / (along_ + root)};
    }
    return {root > along_ ? c / (root - along_) : 0.0, root - along_};
  }

  static constexpr double kNever = 1e30;

 private:
  vec3 from_;
  vec3 direction_;
  double radius_;
  double h_;      // altitude of its begin
  double along_;  // distance from its point nearest to the planet's centre
};

TracedCloud::TracedCloud(std::shared_ptr<const CloudGrid> grid, double ground_radius)
    : grid_(std::move(grid)),
      radius_(ground_radius),
      blocks_x_(blocks_of(grid_->nx)),
      blocks_y_(blocks_of(grid_->ny)),
      blocks_z_(blocks_of(grid_->nz)) {
  most_.resize(static_cast<std::size_t>(blocks_x_) * static_cast<std::size_t>(blocks_y_) *
               static_cast<std::size_t>(blocks_z_));
  const auto raise = [&](int i, int j, int k, float value) {
    float& most =
        most_[static_cast<std::size_t>(i) +
              static_cast<std::size_t>(blocks_x_) *
                  (static_cast<std::size_t>(j) + static_cast<std::size_t>(blocks_y_) * static_cast<std::size_t>(k))];
    most = std::max(most, value);
  };
  // Between middles the field also depends on the neighbouring cells.
  const int reach = grid_->smooth ? 1 : 0;
  const auto near = [&](int cell, int count, bool repeats) {
    std::array<int, 3> blocks{};
    for (int d = -1; d <= 1; ++d) {
      const int other = cell + d * reach;
      blocks[static_cast<std::size_t>(d + 1)] =
          (repeats ? in_period(other, count) : std::clamp(other, 0, count - 1)) / kBlock;
    }
    return blocks;
  };
  for (int k = 0; k < grid_->nz; ++k) {
    for (int j = 0; j < grid_->ny; ++j) {
      for (int i = 0; i < grid_->nx; ++i) {
        const auto value = static_cast<float>(grid_->most_around(i, j, k));
        if (!(value > 0.0F)) {
          continue;
        }
        for (const int c : near(k, grid_->nz, false)) {
          for (const int b : near(j, grid_->ny, grid_->repeats)) {
            for (const int a : near(i, grid_->nx, grid_->repeats)) {
              raise(a, b, c, value);
            }
          }
        }
      }
    }
  }
}

double TracedCloud::plane_x(int block) const {
  return grid_->west + grid_->cell_x * edge_of(block, blocks_x_, grid_->nx);
}

double TracedCloud::plane_y(int block) const {
  return grid_->south + grid_->cell_y * edge_of(block, blocks_y_, grid_->ny);
}

double TracedCloud::altitude(int block) const {
  return block == blocks_z_ ? grid_->top : grid_->base + grid_->cell_z() * block * kBlock;
}

float TracedCloud::most_in(int i, int j, int k) const {
  return most_[static_cast<std::size_t>(in_period(i, blocks_x_)) +
               static_cast<std::size_t>(blocks_x_) *
                   (static_cast<std::size_t>(in_period(j, blocks_y_)) +
                    static_cast<std::size_t>(blocks_y_) * static_cast<std::size_t>(k))];
}

double TracedCloud::extinction_at(vec3 place) const {
  const double r = length(place);
  const physics::vec2 plane = formulas_.cloud_plane(radius_, place / r);
  return grid_->at(plane.x, plane.y, r - radius_);
}

// The part of the way on which the cloud may stand: before the horizon of clouds, and in the grid's columns where it
// does not repeat. A cone and wedges between planes are convex, so that it is one part; empty: from >= to.
TracedCloud::Interval TracedCloud::in_sight(const Way& way, double limit) const {
  const double c = formulas_.kCloudHorizon * formulas_.kCloudHorizon;
  const vec3& from = way.from();
  const vec3& d = way.direction();
  const double a2 = d.y * d.y - c;
  const double a1 = from.y * d.y - c * way.along();
  const double a0 = from.y * from.y - c * dot(from, from);
  std::array<double, 8> ends{};
  std::size_t count = 1;
  const auto add = [&](double t) {
    if (!(t > 0.0 && t < limit)) {
      return;
    }
    std::size_t k = count++;
    for (; ends[k - 1] > t; --k) {
      ends[k] = ends[k - 1];
    }
    ends[k] = t;
  };
  if (const double square = a1 * a1 - a2 * a0; square > 0.0 && a2 != 0.0) {
    add((-a1 - std::sqrt(square)) / a2);
    add((-a1 + std::sqrt(square)) / a2);
  }
  const double east = grid_->west + grid_->nx * grid_->cell_x;
  const double north = grid_->south + grid_->ny * grid_->cell_y;
  if (!grid_->repeats) {
    add(way.to_east(grid_->west));
    add(way.to_east(east));
    add(way.to_north(grid_->south));
    add(way.to_north(north));
  }
  ends[count++] = limit;
  const auto inside = [&](double t) {
    const bool seen = from.y + t * d.y > 0.0 && a0 + t * (2.0 * a1 + t * a2) >= 0.0;
    return seen && (grid_->repeats || (way.east(t) >= grid_->west && way.east(t) <= east &&
                                       way.north(t) >= grid_->south && way.north(t) <= north));
  };
  Interval part{limit, 0.0};
  for (std::size_t k = 0; k + 1 < count; ++k) {
    if (ends[k + 1] > ends[k] && inside(0.5 * (ends[k] + ends[k + 1]))) {
      part = {std::min(part.from, ends[k]), std::max(part.to, ends[k + 1])};
    }
  }
  return part;
}

// Calls visit(from, to, most) for the blocks along the way, `most` their greatest extinction, until it returns false.
template <class Visit>
void TracedCloud::for_blocks(const Way& way, Interval part, Visit visit) const {
  const Interval base = way.through(grid_->base);
  const Interval top = way.through(grid_->top);
  const int step_x = way.eastward() ? 1 : -1;
  const int step_y = way.northward() ? 1 : -1;
  double t = std::max(part.from, top.from);
  while (t < part.to && t < top.to) {
    double h = way.altitude(t);
    if (base.from <= t && t < base.to) {
      t = base.to;
      h = grid_->base;
    }
    int i = block_at((way.east(t) - grid_->west) / grid_->cell_x, blocks_x_, grid_->nx);
    int j = block_at((way.north(t) - grid_->south) / grid_->cell_y, blocks_y_, grid_->ny);
    int k = std::clamp(static_cast<int>((h - grid_->base) / grid_->cell_z() / kBlock), 0, blocks_z_ - 1);
    while (k >= 0 && k < blocks_z_ && t < part.to) {
      const auto ahead = [&](double crossing) {
        return crossing >= t - kRounding ? std::max(crossing, t) : Way::kNever;
      };
      const double x = ahead(way.to_east(plane_x(step_x > 0 ? i + 1 : i)));
      const double y = ahead(way.to_north(plane_y(step_y > 0 ? j + 1 : j)));
      const double down = t < -way.along() ? std::max(way.through(altitude(k)).from, t) : Way::kNever;
      const double up = std::max(way.through(altitude(k + 1)).to, t);
      const double next = std::min({x, y, down, up});
      const double end = std::min(next, part.to);
      if (const float most = most_in(i, j, k); most > 0.0F && end > t && !visit(t, end, static_cast<double>(most))) {
        return;
      }
      t = end;
      if (next == x) {
        i += step_x;
      } else if (next == y) {
        j += step_y;
      } else {
        k += next == down ? -1 : 1;
      }
    }
    t = std::nextafter(t, Way::kNever);
  }
}

std::optional<double> TracedCloud::collide(vec3 from, vec3 direction, double limit, Random& random) const {
  const Way way(from, direction, radius_);
  std::optional<double> met;
  double left = -std::log1p(-random.uniform());
  for_blocks(way, in_sight(way, limit), [&](double t, double end, double most) {
    while (left < most * (end - t)) {
      t += left / most;
      left = -std::log1p(-random.uniform());
      if (random.uniform() * most < extinction_at(way.at(t))) {
        met = t;
        return false;
      }
    }
    left -= most * (end - t);
    return true;
  });
  return met;
}

double TracedCloud::transmittance(vec3 from, vec3 direction, double limit, Random& random) const {
  constexpr double kFaint = 0.25;  // less is dropped or raised to this, by chance
  const Way way(from, direction, radius_);
  double passed = 1.0;
  double left = -std::log1p(-random.uniform());
  for_blocks(way, in_sight(way, limit), [&](double t, double end, double most) {
    while (left < most * (end - t)) {
      t += left / most;
      left = -std::log1p(-random.uniform());
      passed *= std::max(1.0 - extinction_at(way.at(t)) / most, 0.0);
      if (passed < kFaint) {
        passed = random.uniform() * kFaint < passed ? kFaint : 0.0;
        if (passed == 0.0) {
          return false;
        }
      }
    }
    left -= most * (end - t);
    return true;
  });
  return passed;
}

double TracedCloud::optical_depth(vec3 from, vec3 direction, double limit) const {
  const Way way(from, direction, radius_);
  const double step = std::min({grid_->cell_x, grid_->cell_y, grid_->cell_z()}) / 3.0;
  double sum = 0.0;
  for_blocks(way, in_sight(way, limit), [&](double t, double end, double) {
    const double count = std::ceil((end - t) / step);
    const double width = (end - t) / count;
    for (double n = 0.5; n < count; n += 1.0) {
      sum += width * extinction_at(way.at(t + n * width));
    }
    return true;
  });
  return sum;
}

TracedClouds::TracedClouds(const Part& part) {
  for (std::shared_ptr<const CloudGrid>& grid : part.things.clouds()) {
    highest_ = std::max(highest_, grid->top);
    clouds_.emplace_back(std::move(grid), part.scene.planet.ground_radius);
  }
  for (const Cloud& cloud : part.scene.clouds) {
    albedos_.push_back(cloud.single_scattering_albedo);
  }
}

std::optional<TracedClouds::Met> TracedClouds::collide(vec3 from, vec3 direction, double limit, Random& random) const {
  std::optional<Met> first;
  for (int i = 0; i < count(); ++i) {
    if (const auto distance = clouds_[static_cast<std::size_t>(i)].collide(from, direction, limit, random)) {
      first = Met{*distance, i};
      limit = *distance;
    }
  }
  return first;
}

double TracedClouds::transmittance(vec3 from, vec3 direction, double limit, Random& random) const {
  double passed = 1.0;
  for (const TracedCloud& cloud : clouds_) {
    passed = passed > 0.0 ? passed * cloud.transmittance(from, direction, limit, random) : 0.0;
  }
  return passed;
}

double TracedClouds::optical_depth(vec3 from, vec3 direction, double limit) const {
  double sum = 0.0;
  for (const TracedCloud& cloud : clouds_) {
    sum += cloud.optical_depth(from, direction, limit);
  }
  return sum;
}

}  // namespace airlight
