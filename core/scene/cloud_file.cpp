#include "core/scene/cloud_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/named_file.h"
#include "core/spectra/drops.h"

namespace airlight {

namespace {

constexpr double kMostFileWater = 100.0;  // g/m3
constexpr double kMostFileRadius = 1e4;   // um
constexpr double kUnevenLevels = 0.01;    // of the distance between levels
constexpr std::size_t kMostCloudLevels = 4096;

// Words of the text, line by line.
class CloudLines {
 public:
  explicit CloudLines(std::string_view text) : text_(text) {}

  // The next line that has any words; false at the end.
  bool next() {
    words_.clear();
    while (words_.empty() && !text_.empty()) {
      ++line_;
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      split(text_.substr(0, std::min(text_.find('#'), end)));
      text_.remove_prefix(std::min(end + 1, text_.size()));
    }
    return !words_.empty();
  }
  const std::vector<std::string_view>& words() const { return words_; }
  int line() const { return line_; }

  // All words as numbers; nothing where one is none.
  std::optional<std::vector<double>> numbers() const {
    std::vector<double> list;
    for (const std::string_view word : words_) {
      const auto value = number_from<double>(word);
      if (!value || !std::isfinite(*value)) {
        return std::nullopt;
      }
      list.push_back(*value);
    }
    return list;
  }

 private:
  void split(std::string_view line) {
    constexpr std::string_view kSpace = " \t\r,";
    for (std::size_t from = line.find_first_not_of(kSpace); from != std::string_view::npos;) {
      const std::size_t to = std::min(line.find_first_of(kSpace, from), line.size());
      words_.push_back(line.substr(from, to - from));
      from = line.find_first_not_of(kSpace, to);
    }
  }

  std::string_view text_;
  std::vector<std::string_view> words_;
  int line_ = 0;
};

class CloudText {
 public:
  CloudText(std::string name, std::string_view text, CloudFile& cloud)
      : name_(std::move(name)), lines_(text), cloud_(cloud) {}

  std::string read() {
    if (head()) {
      points();
    }
    return problem_;
  }

 private:
  bool refuse(const std::string& what) {
    problem_ = name_ + ":" + std::to_string(lines_.line()) + ": " + what;
    return false;
  }

  // The numbers of the next line, `count` of them; empty after a report.
  std::vector<double> row(std::size_t count, const std::string& expected) {
    const bool more = lines_.next();
    const auto values = lines_.numbers();
    if (!more || !values || values->size() != count) {
      refuse((more ? "" : "the file ends here; ") + ("expected " + expected));
      return {};
    }
    return *values;
  }

  bool head() {
    constexpr std::string_view kShdom = "LWC";
    if (!lines_.next()) {
      return refuse("nothing in it; expected the numbers of points toward east, north and up");
    }
    const bool shdom = std::ranges::find(lines_.words(), kShdom) != lines_.words().end();
    if (shdom) {
      lines_.next();
    }
    const auto counts = lines_.numbers();
    const auto whole = [](double n) { return n >= 1.0 && n <= 4096.0 && n == std::floor(n); };
    if (!counts || counts->size() != 3 || !std::ranges::all_of(*counts, whole) ||
        (*counts)[0] * (*counts)[1] * (*counts)[2] > static_cast<double>(kMostCloudCells)) {
      return refuse(
          "expected three whole numbers of points, toward east, north and up, 1 to 4096, of product at most " +
          std::to_string(kMostCloudCells));
    }
    cloud_.nx = static_cast<int>((*counts)[0]);
    cloud_.ny = static_cast<int>((*counts)[1]);
    cloud_.nz = static_cast<int>((*counts)[2]);
    const std::vector<double> distances = row(2, "the points' distances toward east and north, km");
    if (distances.empty()) {
      return false;
    }
    cloud_.dx = distances[0];
    cloud_.dy = distances[1];
    if (!(std::min(cloud_.dx, cloud_.dy) >= 1e-4 && std::max(cloud_.dx, cloud_.dy) <= 100.0)) {
      return refuse("expected distances of 0.0001 to 100 km");
    }
    return levels() && rest_of_head(shdom);
  }

  bool levels() {
    const auto count = static_cast<std::size_t>(cloud_.nz);
    const std::vector<double> list = row(count, "the altitudes of " + std::to_string(count) + " levels, km");
    if (list.empty()) {
      return false;
    }
    if (count < 2 || count > kMostCloudLevels) {
      return refuse("one level; expected at least two");
    }
    cloud_.lowest = list.front();
    cloud_.dz = (list.back() - list.front()) / static_cast<double>(count - 1);
    for (std::size_t k = 0; k < count; ++k) {
      const double even = cloud_.lowest + cloud_.dz * static_cast<double>(k);
      if (!(cloud_.dz >= 1e-4) || std::abs(list[k] - even) > kUnevenLevels * cloud_.dz) {
        return refuse("level " + std::to_string(k + 1) + " is at " + format_number(list[k]) +
                      " km; expected ascending levels, evenly spaced to 1 % of their distance");
      }
    }
    return true;
  }

  // Temperatures or names, which say nothing here.
  bool rest_of_head(bool shdom) {
    if (shdom) {
      return !row(static_cast<std::size_t>(cloud_.nz), "a temperature for each level").empty();
    }
    if (!lines_.next() || lines_.numbers()) {
      return refuse("expected the names of the columns: i,j,k,lwc,reff");
    }
    return true;
  }

  void points() {
    cloud_.extinction.assign(
        static_cast<std::size_t>(cloud_.nx) * static_cast<std::size_t>(cloud_.ny) * static_cast<std::size_t>(cloud_.nz),
        0.0F);
    double sum = 0.0;
    double radii = 0.0;
    while (problem_.empty() && lines_.next()) {
      const auto values = lines_.numbers();
      if (!values || values->size() != 5) {
        refuse("expected i j k, water in g/m3 and effective radius in um: five numbers; is the file cut short?");
        return;
      }
      take(*values, sum, radii);
    }
    if (problem_.empty() && !(sum > 0.0)) {
      refuse("no water in it; expected lines of i j k, water and effective radius");
    }
    cloud_.effective_radius = sum > 0.0 ? radii / sum : 0.0;
  }

  void take(const std::vector<double>& point, double& sum, double& radii) {
    const std::array<int, 3> most{cloud_.nx, cloud_.ny, cloud_.nz};
    std::array<std::size_t, 3> at{};
    for (std::size_t d = 0; d < 3; ++d) {
      if (!(point[d] >= 1.0 && point[d] <= most[d] && point[d] == std::floor(point[d]))) {
        refuse("the point " + format_number(point[d]) + " is outside 1 to " + std::to_string(most[d]));
        return;
      }
      at[d] = static_cast<std::size_t>(point[d]) - 1;
    }
    const double water = point[3];
    const double radius = point[4];
    if (!(water >= 0.0 && water <= kMostFileWater)) {
      refuse("water of " + format_number(water) + " g/m3 is outside 0 to 100");
    } else if (!(radius > 0.0 && radius <= kMostFileRadius)) {
      refuse("an effective radius of " + format_number(radius) + " um is not above 0 and at most 10000");
    } else {
      const double extinction = drop_extinction(water, radius);
      cloud_.extinction[at[0] +
                        static_cast<std::size_t>(cloud_.nx) * (at[1] + static_cast<std::size_t>(cloud_.ny) * at[2])] =
          static_cast<float>(extinction);
      sum += extinction;
      radii += extinction * radius;
    }
  }

  std::string name_;
  CloudLines lines_;
  CloudFile& cloud_;
  std::string problem_;
};

}  // namespace

std::string read_cloud_file(const std::filesystem::path& file, CloudFile& cloud) {
  const NamedText named = read_named_text(file);
  if (!named.problem.empty()) {
    return file.filename().string() + " cannot be read: " + named.problem;
  }
  const std::string problem = CloudText(file.filename().string(), named.text, cloud).read();
  // FNV-1a over the bytes: two files of one text are one cloud.
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : named.text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  cloud.identity = std::to_string(named.text.size()) + ":" + std::to_string(hash);
  return problem;
}

}  // namespace airlight
