#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/stability/report.h"
#include "core/text.h"

namespace airlight::stability {
namespace {

using measure::Colour;
using measure::error_colour;
using measure::kGlyphHeight;
using measure::kGlyphWidth;
using measure::kNotANumber;
using measure::Raster;
using measure::text_width;

constexpr Colour kPaper = {24, 24, 28};
constexpr Colour kInk = {235, 235, 235};
constexpr Colour kDark = {0, 0, 0};
constexpr double kLowError = 1e-5;
constexpr double kHighError = 1.0;
constexpr int kPanelWidth = 420;
constexpr int kPanelHeight = 260;
constexpr int kMargin = 8;
constexpr int kLeft = 52;  // for the numbers of y
constexpr int kTitle = 16;
constexpr int kFoot = 26;  // for the numbers and the name of x
constexpr int kScaleRow = 44;
constexpr int kAcross = 2;  // panels in a row

// Without what the raster's letters lack.
std::string plain(std::string text) {
  std::erase(text, '\'');
  return text;
}

double fraction(double error) {
  return std::clamp(std::log(std::max(error, kLowError) / kLowError) / std::log(kHighError / kLowError), 0.0, 1.0);
}

int edge(int size, std::size_t i, std::size_t n) {
  return static_cast<int>(std::lround(static_cast<double>(size) * static_cast<double>(i) / static_cast<double>(n)));
}

// Numbers along an axis wherever there is room; place(i) is the middle of cell i.
void write_columns(Raster& raster, int left, int top, const Sweep& sweep) {
  int free_from = left;
  for (std::size_t i = 0; i < sweep.xs.size(); ++i) {
    const std::string text = rounded(sweep.xs[i], 3);
    const int middle = left + (edge(kPanelWidth, i, sweep.xs.size()) + edge(kPanelWidth, i + 1, sweep.xs.size())) / 2;
    const int width = text_width(text, 1);
    const int start = std::max(left - kLeft / 2, middle - width / 2);
    if (start >= free_from && start + width <= left + kPanelWidth + kMargin) {
      raster.write(start, top, 1, kInk, text);
      free_from = start + width + kGlyphWidth;
    }
  }
  raster.write(left, top + kGlyphHeight + 4, 1, kInk, quantity_name(sweep.x));
}

void write_rows(Raster& raster, int left, int top, const Sweep& sweep) {
  int free_below = top + kPanelHeight + kGlyphHeight;
  for (std::size_t i = 0; i < sweep.ys.size(); ++i) {
    const std::string text = rounded(sweep.ys[i], 3);
    const int middle =
        top + kPanelHeight - (edge(kPanelHeight, i, sweep.ys.size()) + edge(kPanelHeight, i + 1, sweep.ys.size())) / 2;
    if (middle + kGlyphHeight / 2 < free_below) {
      raster.write(left - kMargin / 2 - text_width(text, 1), middle - kGlyphHeight / 2, 1, kInk, text);
      free_below = middle - kGlyphHeight / 2 - 1;
    }
  }
}

void draw_cells(Raster& raster, int left, int top, const Sweep& sweep, const Block& block) {
  const std::size_t width = sweep.xs.size();
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const Cell& cell = block.cells[i];
    const int x0 = edge(kPanelWidth, i % width, width);
    const int x1 = edge(kPanelWidth, i % width + 1, width);
    const int y0 = kPanelHeight - edge(kPanelHeight, i / width + 1, sweep.ys.size());
    const int y1 = kPanelHeight - edge(kPanelHeight, i / width, sweep.ys.size());
    const double shade = fraction(cell.error);
    raster.fill({left + x0, top + y0, x1 - x0, y1 - y0}, cell.not_finite > 0 ? kNotANumber : error_colour(shade));
    if (!cell.symptoms.empty()) {
      raster.write(left + (x0 + x1 - kGlyphWidth + 1) / 2, top + (y0 + y1 - kGlyphHeight) / 2, 1,
                   shade > 0.6 ? kDark : kInk, cell.symptoms.substr(0, 1));
    }
  }
}

void draw_scale(Raster& raster, int top) {
  for (int x = 0; x < kPanelWidth; ++x) {
    raster.fill({kLeft + x, top, 1, kGlyphHeight + 2}, error_colour(static_cast<double>(x) / (kPanelWidth - 1)));
  }
  for (double value = kLowError; value <= 1.01 * kHighError; value *= 10.0) {
    const std::string text = rounded(value, 3);
    const int middle = kLeft + static_cast<int>(std::lround(fraction(value) * (kPanelWidth - 1)));
    raster.write(middle - text_width(text, 1) / 2, top + kGlyphHeight + 5, 1, kInk, text);
  }
  std::string letters = "MEAN RELATIVE ERROR.";
  for (const Symptom& symptom : kSymptoms) {
    letters += std::string("  ") + symptom.letter + " " + std::string(symptom.name);
  }
  raster.write(kMargin, top + 2 * kGlyphHeight + 12, 1, kInk, letters);
}

}  // namespace

Raster heat_map(const Examination& examination, const Sweep& sweep) {
  std::vector<const Block*> shown;
  for (const Block& block : examination.blocks) {
    if (block.sweep == sweep.name) {
      shown.push_back(&block);
    }
  }
  const int across = kAcross;
  const int down = (static_cast<int>(shown.size()) + across - 1) / across;
  constexpr int kStrideX = kLeft + kPanelWidth + kMargin;
  constexpr int kStrideY = kTitle + kPanelHeight + kFoot + kMargin;
  Raster raster(across * kStrideX, kTitle + down * kStrideY + kScaleRow, kPaper);
  raster.write(kMargin, kMargin / 2, 1, kInk,
               plain(sweep.name + ": " + sweep.title + ", " + std::string(quantity_name(sweep.y)) + " upward"));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const int left = static_cast<int>(i) % across * kStrideX + kLeft;
    const int top = kTitle + static_cast<int>(i) / across * kStrideY + kTitle;
    raster.write(left, top - kGlyphHeight - 3, 1, kInk, shown[i]->subject);
    draw_cells(raster, left, top, sweep, *shown[i]);
    write_rows(raster, left, top, sweep);
    write_columns(raster, left, top + kPanelHeight + 4, sweep);
  }
  draw_scale(raster, kTitle + down * kStrideY + kMargin / 2);
  return raster;
}

}  // namespace airlight::stability
