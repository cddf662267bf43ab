#include "core/render/bands.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "core/methods/ready.h"
#include "core/plan/bytes.h"
#include "core/post/host_post.h"
#include "core/post/night_sky.h"
#include "core/render/after_sky.h"
#include "core/render/picture_key.h"
#include "core/render/sky.h"
#include "core/render/spectrum.h"
#include "core/render/tile_sizes.h"
#include "core/render/timings.h"
#include "core/stage/sums.h"

namespace airlight {
namespace {

// By each light in turn. Their noise is independent.
HostPicture picture_on_host(const Stage& stage, const HostOptions& options) {
  const std::span<const Stage> others = stage.others();
  GroupRuns runs(options, 1 + others.size(), ".light");
  Scene sun = stage.scene();
  HostPicture all = stage.method().render_on_host(stage, View{}, others.empty() ? options : runs.start(sun, 0));
  if (others.empty()) {
    return all;
  }
  RadianceImage variance;
  add_error(variance, all.standard_error, kAsTheyAre);
  for (std::size_t i = 0; i < others.size(); ++i) {
    Scene scene = others[i].scene();
    const HostOptions its = runs.start(scene, i + 1);
    const HostPicture more = stage.method().render_on_host(ready(scene, others[i]), View{}, its);
    add_part(all.radiance, more.radiance, kAsTheyAre);
    add_error(variance, more.standard_error, kAsTheyAre);
    add_new_lines(all.notes, more.notes);
  }
  take_roots(variance);
  all.standard_error = std::move(variance);
  return all;
}

// A band on its way.
struct InWork {
  Tile tile;
  Rendering rows = {};
  std::optional<BufferDesc> carried = {};  // its radiance, where a plan has left it on the device
};

// One round through the picture: to measure it, or to deliver it.
enum class Round { measuring, delivering };

class Bands {
 public:
  Bands(const DeviceOnDemand& device, const Stage& stage, const BandsRequest& request, Rendering given);

  Rendering run();

 private:
  bool stops() const { return !request_.past_faults && !out_.fault().empty(); }
  int tile_width() const {
    return request_.tile ? std::min(request_.tile->width, scene_.image.width) : scene_.image.width;
  }
  bool is_whole(const Tile& band) const { return band.height == scene_.image.height; }
  Tile band_at(int y) const;

  void prepare();
  void trace();
  void go_through(Round round, double from, double to);
  InWork begun(const Tile& band);
  void process(InWork& band, bool measured, bool finished);
  Picture begin_plan(Plan& plan, InWork& band);
  Picture begin_plan_without(Plan& plan, const InWork& band);
  Picture add_sky_of(Plan& plan, const Tile& tile, bool carried);
  void render_columns(InWork& band);
  void add_statistics(std::span<const std::byte> rows) { rows_.insert(rows_.end(), rows.begin(), rows.end()); }
  void find_bloom();
  void add_layers(InWork& band);
  void deliver(InWork& band);
  RunResult run_plan(const Plan& plan, const std::function<void(double)>& report = {});
  std::function<void(double)> report_of(const Tile& tile) const;

  const DeviceOnDemand& device_;
  const Stage stage_;
  const Scene& scene_;
  const BandsRequest& request_;
  const RenderRequest& asked_;
  const std::string key_ = picture_key();
  Rendering out_;
  Pixels made_;           // of the whole picture, before its bands: by a method on the host, of a spectrum
  bool is_made_ = false;  // its radiance is there
  bool lacks_disc_ = false;
  bool is_measured_ = false;
  std::vector<std::byte> rows_;  // statistics of all rows so far
  std::optional<Bloomed> bloom_;
  std::optional<InWork> only_band_;  // measured and not yet delivered

  std::optional<TableReads> table_reads_;  // of the first tile's plan, which makes the tables
  bool tables_seen_ = false;
  bool ran_ = false;              // a plan on the device
  double from_ = 0.0, to_ = 1.0;  // this round's share of the report
};

// `given`: as of render_bands().
Bands::Bands(const DeviceOnDemand& device, const Stage& stage, const BandsRequest& request, Rendering given)
    : device_(device), stage_(stage), scene_(stage_.scene()), request_(request), asked_(request.picture) {
  made_ = std::exchange(static_cast<Pixels&>(given), {});
  out_ = std::move(given);
  is_made_ = !made_.radiance.rgba.empty();
}

// The band that begins at this row.
Tile Bands::band_at(int y) const {
  int rows = scene_.image.height - y;
  if (request_.tile) {
    const std::size_t row = band_pixel_bytes(stage_, asked_.layers) * static_cast<std::size_t>(scene_.image.width);
    rows = std::min({rows, request_.tile->height, std::max(1, static_cast<int>(kBandBytes / row))});
  }
  return {0, y, scene_.image.width, rows};
}

// The whole picture by a method on the host, but for the disc.
void Bands::trace() {
  open_for_post(device_, stage_, asked_);
  HostPicture host = picture_on_host(stage_, asked_.host);
  out_.undone = std::move(host.notes);
  made_.radiance = std::move(host.radiance);
  if (!host.standard_error.rgba.empty()) {
    made_.standard_error = std::move(host.standard_error);
  }
  is_made_ = true;
  lacks_disc_ = true;
}

void Bands::prepare() {
  if (is_made_) {
    return;
  }
  out_.left_out = spared_by(stage_);
  if (!sun_disc_shows(scene_, picture_of(BufferId{}, {0, 0, scene_.image.width, scene_.image.height}))) {
    out_.left_out.push_back("sun disc: switched off, outside the picture or behind the planet");
  }
  if (samples(stage_)) {
    trace();
  }
}

// Tells the share of this round that is done up to a share of the tile; empty where nobody listens.
std::function<void(double)> Bands::report_of(const Tile& tile) const {
  if (!asked_.host.report) {
    return {};
  }
  const auto all = static_cast<double>(pixels_of(scene_.image.width, scene_.image.height));
  const auto before = static_cast<double>(pixels_of(scene_.image.width, tile.y) + pixels_of(tile.x, tile.height));
  const auto pixels = static_cast<double>(pixels_of(tile));
  return [=, this](double done) { asked_.host.report(from_ + (to_ - from_) * (before + done * pixels) / all); };
}

RunResult Bands::run_plan(const Plan& plan, const std::function<void(double)>& report) {
  RunResult result = device_().run(plan, report);
  ran_ = true;
  if (request_.is_last && !request_.tile) {
    device_().free_pictures(true);  // bands would take their room again
  }
  Timings{out_.passes, out_.host}.add(result);
  if (table_reads_) {
    table_reads_->take(result, out_.tables_statistics, out_.tables);
    table_reads_.reset();
  }
  return result;
}

// Sky and disc of a tile, by a method on the device. `carried`: the tile is the picture, and stays on the device.
Picture Bands::add_sky_of(Plan& plan, const Tile& tile, bool carried) {
  View view{.directions = {}, .kept_as = request_.tile ? key_ : ""};
  view.all_lights = asked_.tables;
  if (!carried) {
    view.tile = tile;
  }
  const Sky sky = add_sky(plan, stage_, view, true);
  if (!std::exchange(tables_seen_, true)) {
    table_reads_.emplace(plan, sky, asked_.tables);
  }
  return picture_of(sky.radiance, tile);
}

void Bands::render_columns(InWork& band) {
  const Tile& whole = band.tile;
  band.rows.radiance = {whole.width, whole.height, std::vector<float>(4 * pixels_of(whole))};
  for (int x = 0; x < whole.width; x += tile_width()) {
    const Tile tile{x, whole.y, std::min(tile_width(), whole.width - x), whole.height};
    Plan plan;
    const Picture picture = add_sky_of(plan, tile, false);
    put(band.rows.radiance, run_plan(plan, report_of(tile)).contents(picture.buffer), tile);
  }
}

// A band with its rows of what is there as a whole; the only band takes all of it.
InWork Bands::begun(const Tile& band) {
  InWork work{.tile = band};
  static_cast<Pixels&>(work.rows) = is_whole(band) ? std::move(made_) : rows_of(made_, band);
  if (lacks_disc_) {
    draw_disc_over(work.rows.radiance, stage_, band);
    if (stage_.night() != nullptr) {
      draw_night_sky(work.rows.radiance, stage_, band);
    }
  }
  if (!is_made_ && tile_width() < band.width) {
    render_columns(work);
  }
  return work;
}

// Begins a plan that makes the band's radiance or finds it: the sky's passes, what an earlier plan has left on the
// device, or an upload.
Picture Bands::begin_plan(Plan& plan, InWork& band) {
  const RadianceImage& radiance = band.rows.radiance;
  if (radiance.rgba.empty()) {
    const Picture picture = add_sky_of(plan, band.tile, is_whole(band.tile));
    if (is_whole(band.tile)) {
      band.carried = plan.buffers()[picture.buffer.index];
    }
    return picture;
  }
  plan.scene_data = device_scene_bytes(stage_.whole().air, scene_, band.tile);
  BufferDesc buffer = band.carried.value_or(uploaded_radiance(band.tile));
  if (!band.carried) {
    buffer.contents_when_run = [&radiance] { return bytes_of(radiance.rgba); };
  }
  return picture_of(plan.add_buffer(std::move(buffer)), band.tile);
}

// Begins a plan for the sun's glare, which is found without the picture: the host has it.
Picture Bands::begin_plan_without(Plan& plan, const InWork& band) {
  plan.scene_data = device_scene_bytes(stage_.whole().air, scene_, band.tile);
  if (request_.is_last && ran_) {
    device_().free_pictures(false);
  }
  return picture_of(BufferId{}, band.tile);
}

// Makes the band's radiance where it is not there yet, its statistics where they are `measured`, and where it is
// `finished` what follows the exposure. Sums over rows are taken over whole rows, whatever tiles make them up.
void Bands::process(InWork& band, bool measured, bool finished) {
  Plan plan;
  const bool is_new = band.rows.radiance.rgba.empty();
  const bool is_read = is_new || measured || asked_.gpu_tone || !bloom_ || bloom_->glare.empty();
  const Picture picture = is_read ? begin_plan(plan, band) : begin_plan_without(plan, band);
  const bool host_counts = measured && (is_made_ || host_measures(device_()));
  std::optional<BufferId> statistics;
  if (measured && !host_counts) {
    statistics = add_picture_statistics(plan, picture, brightest_metered(scene_), stage_.in_colours());
  }
  // Glare over a picture of the host's needs no device.
  const bool host_glares = finished && bloom_ && !bloom_->glare.empty() && samples(stage_) && !asked_.gpu_tone;
  std::optional<PostPasses> post;
  if (finished && !host_glares) {
    post.emplace(plan, scene_, picture, asked_, bloom_, out_.exposure);
  }
  if (!plan.passes().empty()) {
    const RunResult result = run_plan(plan, is_new ? report_of(band.tile) : nullptr);
    if (is_new) {
      const std::span<const std::byte> radiance = result.contents(picture.buffer);
      band.rows.radiance = {band.tile.width, band.tile.height, values_of<float>(radiance)};
    }
    if (statistics) {
      add_statistics(result.contents(*statistics));
    }
    if (post) {
      post->take(result, band.rows);
    }
  }
  if (host_counts) {
    add_statistics(row_statistics_of(band.rows.radiance, brightest_metered(scene_), stage_.in_colours()));
  }
  if (host_glares) {
    band.rows.bloom = glare_picture(scene_, bloom_->glare, band.tile);
  }
}

// The layers of the band, on the device in pieces of at most kLayerBytes.
void Bands::add_layers(InWork& band) {
  const Tile& whole = band.tile;
  std::vector<Layer>& layers = band.rows.layers;
  layers = layers_of(stage_, asked_.layers);
  const std::size_t row =
      sizeof(float) * (layer_planes(stage_, asked_.layers) + 4) * static_cast<std::size_t>(tile_width());
  const int most_rows = static_cast<int>(std::max<std::size_t>(1, kLayerBytes / row));
  for (int y = whole.y; y < whole.y + whole.height; y += most_rows) {
    for (int x = 0; x < whole.width; x += tile_width()) {
      const Tile tile{x, y, std::min(tile_width(), whole.width - x), std::min(most_rows, whole.y + whole.height - y)};
      put(layers, whole, render_layers(device_(), stage_, asked_.layers, tile, key_, {out_.passes, out_.host}), tile);
    }
  }
  for (const Layer& layer : layers) {
    Statistics found = layer_statistics(layer, whole.width, stage_.in_colours());
    found.first_bad_y += static_cast<std::uint32_t>(whole.y);
    if (!found.sound() || whole.y == 0) {
      out_.layer_statistics.push_back({layer.name, found});
    }
  }
}

void Bands::deliver(InWork& band) {
  if (asked_.layers != LayerSet::none && out_.picture_fault().empty()) {
    add_layers(band);
  }
  if (!stops()) {
    band.rows.exposure = out_.exposure;
    band.rows.picture = out_.picture;
    band.rows.left_out = out_.left_out;
    Band rows{band.tile.y, std::move(band.rows)};
    if (request_.is_last && ran_ && band.tile.y + band.tile.height == scene_.image.height) {
      device_().free_pictures(false);
    }
    request_.sink(rows);
  }
}

void Bands::go_through(Round round, double from, double to) {
  from_ = from;
  to_ = to;
  const bool delivering = round == Round::delivering;
  for (Tile tile = band_at(0); tile.height > 0 && !stops(); tile = band_at(tile.y + tile.height)) {
    InWork band = only_band_ ? *std::exchange(only_band_, std::nullopt) : begun(tile);
    process(band, !is_measured_, delivering && out_.fault().empty());
    out_.picture = summarize(rows_, static_cast<std::uint32_t>(scene_.image.width));
    if (delivering) {
      deliver(band);
    } else if (is_whole(tile)) {
      only_band_ = std::move(band);
    }
    if (!is_made_ && request_.tile && asked_.host.report) {
      report_of(tile)(1.0);
    }
  }
  is_measured_ = true;
}

void Bands::find_bloom() {
  if (!asked_.bloom || !scene_.bloom.enabled) {
    return;
  }
  if (bloom_glows(scene_, scene_.bloom.model == BloomModel::glare && glares(stage_), out_.picture, out_.exposure)) {
    bloom_ = bloom_of(stage_);
  } else {
    out_.left_out.push_back(no_bloom(scene_));
  }
}

// Several bands whose exposure must be known are rendered twice; one band is kept while it is exposed.
Rendering Bands::run() {
  prepare();
  const bool one_band = is_whole(band_at(0));
  const bool two_rounds = !one_band && request_.exposure_first && !scene_.display.exposure;
  out_.exposure = scene_.display.exposure ? exposure_for(scene_, {}) : 1.0;
  if (one_band || two_rounds) {
    go_through(Round::measuring, 0.0, two_rounds ? 0.5 : 1.0);
    out_.exposure = exposure_for(scene_, out_.picture);
  }
  if (out_.fault().empty()) {
    find_bloom();
  }
  go_through(Round::delivering, two_rounds ? 0.5 : 0.0, 1.0);
  out_.exposure = exposure_for(scene_, out_.picture);
  return std::move(out_);
}

}  // namespace

bool needs_whole_picture(const Scene& scene, const RenderRequest& request) {
  return request.bloom && scene.bloom.enabled && scene.bloom.model == BloomModel::chain;
}

Rendering render_bands(const DeviceOnDemand& device, const Stage& stage, const BandsRequest& request) {
  if (request.picture.spectrum) {
    return render_spectrum(device, stage, request);
  }
  return render_bands(device, stage, request, {});
}

Rendering render_bands(const DeviceOnDemand& device, const Stage& stage, const BandsRequest& request, Rendering given) {
  assert(!request.tile || (request.tile->width > 0 && request.tile->height > 0));
  assert(!request.tile || !needs_whole_picture(stage.scene(), request.picture));
  return Bands(device, stage, request, std::move(given)).run();
}

}  // namespace airlight
