#include "core/chart/labels.h"

#include <algorithm>
#include <cmath>

namespace airlight::chart {
namespace {

struct Box {
  double left, bottom, right, top;  // pixels
};

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

class Panel {
 public:
  explicit Panel(const Frame& frame) : frame_(frame) {}

  Spot pixel(const Spot& spot) const {
    return {frame_.width * std::log(spot.x / frame_.x_low) / std::log(frame_.x_high / frame_.x_low),
            frame_.height * std::log(spot.y / frame_.y_low) / std::log(frame_.y_high / frame_.y_low)};
  }
  Spot value(const Spot& pixel) const {
    return {frame_.x_low * std::pow(frame_.x_high / frame_.x_low, pixel.x / frame_.width),
            frame_.y_low * std::pow(frame_.y_high / frame_.y_low, pixel.y / frame_.height)};
  }
  void keep_clear(const Box& box) { taken_.push_back(box); }
  bool is_free(const Box& box) const {
    const bool inside = box.left >= 0.0 && box.bottom >= 0.0 && box.right <= frame_.width && box.top <= frame_.height;
    return inside && std::ranges::none_of(taken_, [&](const Box& other) { return meet(box, other); });
  }

 private:
  Frame frame_;
  std::vector<Box> taken_;
};

constexpr double kDot = 4.0;  // pixels, half a point's width

// A line between two points as a row of small boxes.
void keep_clear_line(Panel& panel, const Spot& a, const Spot& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const int steps = std::max(1, static_cast<int>(length / kDot));
  for (int i = 0; i <= steps; ++i) {
    const double x = a.x + (b.x - a.x) * i / steps;
    const double y = a.y + (b.y - a.y) * i / steps;
    panel.keep_clear({x - 1.0, y - 1.0, x + 1.0, y + 1.0});
  }
}

}  // namespace

std::vector<Label> place_labels(const std::vector<Label>& wanted, const std::vector<Spot>& points,
                                const std::vector<Spot>& line, const Frame& frame, std::size_t most) {
  Panel panel(frame);
  for (const Spot& point : points) {
    const Spot at = panel.pixel(point);
    panel.keep_clear({at.x - kDot, at.y - kDot, at.x + kDot, at.y + kDot});
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    keep_clear_line(panel, panel.pixel(line[i]), panel.pixel(line[i + 1]));
  }
  struct Way {
    bool left;
    double up;  // lines
  };
  std::vector<Label> placed;
  for (const Label& label : wanted) {
    if (placed.size() == most) {
      break;
    }
    const Spot at = panel.pixel(label.at);
    const double width = frame.letter * static_cast<double>(label.text.size());
    for (const Way& way : {Way{true, 0.9}, Way{true, -0.9}, Way{false, -0.9}, Way{false, 0.9}, Way{true, 0.0},
                           Way{false, 0.0}, Way{true, 2.0}, Way{true, -2.0}, Way{false, -2.0}}) {
      const double gap = way.up == 0.0 ? 2.0 * kDot : 0.5 * kDot;
      const double edge = at.x + (way.left ? gap : -gap);
      const double middle = at.y + way.up * frame.line;
      const Box box{way.left ? edge : edge - width, middle - 0.5 * frame.line, way.left ? edge + width : edge,
                    middle + 0.5 * frame.line};
      if (panel.is_free(box)) {
        panel.keep_clear(box);
        placed.push_back({label.text, label.at, way.left, panel.value({edge, middle})});
        break;
      }
    }
  }
  return placed;
}

}  // namespace airlight::chart
