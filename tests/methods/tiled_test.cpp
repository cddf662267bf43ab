// A picture in tiles equals the whole picture, bit for bit, for any tiles.

#include <algorithm>

#include "core/render/bands.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

struct Whole {
  Rendering rendering;
  std::vector<float> rgba;
  std::vector<std::vector<float>> layers;  // bands one after the other
  std::vector<float> bloom, standard_error;
  std::vector<std::vector<float>> spectrum;
  std::vector<std::uint16_t> encoded;
  std::vector<double> exposures;  // as each band knew it
};

Whole in_tiles(const Scene& scene, ImageSize tile, const RenderRequest& picture = {}, bool exposure_first = false) {
  Whole whole;
  BandsRequest request{.tile = tile, .picture = picture, .exposure_first = exposure_first, .sink = {}};
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  request.sink = [&](const Band& band) {
    EXPECT_EQ(static_cast<std::size_t>(band.y) * static_cast<std::size_t>(4 * scene.image.width), whole.rgba.size());
    const Rendering& rows = band.rows;
    append(whole.rgba, rows.radiance.rgba);
    append(whole.bloom, rows.bloom ? rows.bloom->rgba : std::vector<float>());
    append(whole.standard_error, rows.standard_error ? rows.standard_error->rgba : std::vector<float>());
    append(whole.encoded, rows.encoded);
    whole.spectrum.resize(rows.spectrum ? rows.spectrum->planes.size() : 0);
    for (std::size_t k = 0; k < whole.spectrum.size(); ++k) {
      append(whole.spectrum[k], rows.spectrum->planes[k]);
    }
    whole.exposures.push_back(rows.exposure);
    whole.layers.resize(rows.layers.size());
    for (std::size_t i = 0; i < rows.layers.size(); ++i) {
      append(whole.layers[i], rows.layers[i].planes);
    }
  };
  whole.rendering = render_bands([]() -> Executor& { return executor(); }, scene, request);
  return whole;
}

Scene sky(const std::string& method, Projection projection) {
  Scene scene = earth();
  scene.camera.projection = projection;
  scene.camera.vertical_fov = projection == Projection::fisheye ? 3.0 : 1.2;
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.sun.disc.angular_radius = 3.0 * kDegree;
  scene.camera.pitch = 20.0 * kDegree;
  scene.image = {41, 23};
  return with_method(std::move(scene), *find_method(method), true);
}

void expect_the_same(const Scene& scene, const std::string& what) {
  const Rendering whole = render_now(scene);
  for (const ImageSize& tile : {ImageSize{41, 7}, ImageSize{13, 5}, ImageSize{1, 23}, ImageSize{64, 64}}) {
    const Whole tiles = in_tiles(scene, tile);
    const std::string which = what + " in " + std::to_string(tile.width) + "x" + std::to_string(tile.height);
    EXPECT_EQ(tiles.rgba, whole.radiance.rgba) << which;
    EXPECT_EQ(tiles.rendering.exposure, whole.exposure) << which;
    EXPECT_EQ(tiles.rendering.picture.max_luminance, whole.picture.max_luminance) << which;
    EXPECT_EQ(tiles.rendering.left_out, whole.left_out) << which;
    EXPECT_EQ(tiles.rendering.tables_statistics.size(), whole.tables_statistics.size()) << which;
  }
}

TEST(Tiled, IsThePictureInEveryProjection) {
  for (const Projection projection : {Projection::perspective, Projection::equirectangular, Projection::fisheye}) {
    expect_the_same(sky("march", projection), "projection " + std::to_string(static_cast<int>(projection)));
  }
}

TEST(Tiled, IsThePictureOfMaps) {
  Scene cube = sky("march", Projection::cube);
  cube.camera.pitch = 0.0;
  cube.image = {12, 72};
  expect_the_same(cube, "cube");
  Scene octahedral = sky("march", Projection::octahedral);
  octahedral.camera.pitch = 0.0;
  octahedral.image = {24, 24};
  expect_the_same(octahedral, "octahedral");
}

TEST(Tiled, IsThePictureByEveryMethod) {
  for (const SkyMethod& method : methods()) {
    if (method.add_passes != nullptr) {
      expect_the_same(sky(std::string(method.info.name), Projection::equirectangular), std::string(method.info.name));
    }
  }
  Scene tabulated = sky("orders", Projection::equirectangular);
  tabulated.render.parameters.insert_or_assign("tabulate", std::string("always"));
  expect_the_same(tabulated, "orders by a table");
}

// Corners of pixels two apart and the mask of noise have the same places as in the whole picture.
TEST(Tiled, KeysOfTheMarchKnowNoTiles) {
  Scene scene = sky("march", Projection::perspective);
  scene.camera.vertical_fov = 0.6;  // pixels fine enough to go between
  scene.render.parameters.insert_or_assign("resolution", std::string("half"));
  expect_the_same(scene, "half resolution");
  scene.render.parameters.insert_or_assign("jitter", std::string("blue-noise"));
  expect_the_same(scene, "half resolution and blue noise");
}

// Two successive pictures must not share what belongs to one of them.
TEST(Tiled, TablesOfAPictureAreItsOwn) {
  Scene scene = sky("sky-view", Projection::equirectangular);
  in_tiles(scene, {41, 7});
  scene.sun.elevation = 5.0 * kDegree;
  expect_the_same(scene, "the second picture");
}

TEST(Tiled, LayersAreThoseOfThePicture) {
  const Scene scene = sky("orders", Projection::fisheye);
  RenderRequest request;
  request.layers = LayerSet::light;
  const Rendering whole = render_now(scene, request);
  const Whole bands = in_tiles(scene, {13, 23}, request);
  ASSERT_EQ(bands.layers.size(), whole.layers.size());
  for (std::size_t i = 0; i < whole.layers.size(); ++i) {
    EXPECT_EQ(bands.layers[i], whole.layers[i].planes) << whole.layers[i].name;
  }
}

// Whether the spectrum's wavelengths tell the colours or are too few, its planes go in bands like all others.
TEST(Tiled, ASpectrumIsThatOfThePicture) {
  Scene scene = scene_of(clear_air(R"({"named": "air"})", "{}"));
  scene.image = {12, 7};
  std::vector<double> many(41);
  std::ranges::generate(many, [x = 370.0]() mutable { return x += 10.0; });
  for (const std::vector<double>& nm : {std::vector<double>{450.0, 550.0}, many}) {
    const RenderRequest request{.spectrum = listed_nodes(nm, 10.0)};
    const Rendering whole = render_now(scene, request);
    const Whole bands = in_tiles(scene, {5, 3}, request);
    EXPECT_EQ(whole.spectrum->tells_colours, nm.size() > 2);
    EXPECT_EQ(bands.rgba, whole.radiance.rgba) << nm.size();
    EXPECT_EQ(bands.spectrum, whole.spectrum->planes) << nm.size();
  }
}

// Bloom, tone curve and exposure depend on the whole picture, so the tiles are gone through twice. The picture is finer
// than the bloom's grid, so that texels of the grid lie across bands.
void expect_same_bloom(Projection projection) {
  Scene scene = sky("march", projection);
  scene.camera.vertical_fov = 0.01;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.sun.disc.angular_radius = projection == Projection::perspective ? 0.002 : 0.05;
  scene.bloom.enabled = true;
  scene.bloom.intensity = 0.3;
  RenderRequest request;
  request.bloom = true;
  request.gpu_tone = true;
  const Rendering whole = render_now(scene, request);
  ASSERT_TRUE(whole.bloom.has_value());
  ASSERT_GT(*std::max_element(whole.bloom->rgba.begin(), whole.bloom->rgba.end()), 0.0F);
  for (const ImageSize& tile : {ImageSize{41, 7}, ImageSize{13, 5}, ImageSize{41, 1}, ImageSize{64, 64}}) {
    const Whole tiles = in_tiles(scene, tile, request, true);
    EXPECT_EQ(tiles.rgba, whole.radiance.rgba) << tile.width;
    EXPECT_EQ(tiles.bloom, whole.bloom->rgba) << tile.width;
    EXPECT_EQ(tiles.encoded, whole.encoded) << tile.width;
    EXPECT_EQ(tiles.exposures, std::vector<double>(tiles.exposures.size(), whole.exposure)) << tile.width;
    EXPECT_EQ(tiles.rendering.left_out, whole.left_out) << tile.width;
  }
}

TEST(Tiled, BloomAndToneAreThoseOfThePicture) {
  for (const Projection projection : {Projection::perspective, Projection::equirectangular}) {
    expect_same_bloom(projection);
  }
}

TEST(Tiled, ADimPictureHasNoBloomAndSaysSo) {
  Scene scene = sky("march", Projection::perspective);
  scene.sun.disc.visible = false;
  scene.bloom.enabled = true;
  scene.bloom.threshold = 1e6;
  RenderRequest request;
  request.bloom = true;
  request.gpu_tone = true;
  const Rendering whole = render_now(scene, request);
  const Whole tiles = in_tiles(scene, {41, 7}, request, true);
  EXPECT_TRUE(tiles.bloom.empty());
  EXPECT_EQ(tiles.encoded, whole.encoded);
  EXPECT_EQ(tiles.rendering.left_out, whole.left_out);
  EXPECT_TRUE(whole.left_out.back().starts_with("bloom: ")) << whole.left_out.back();
}

// The picture of a method on the host goes through the same passes in bands.
TEST(Tiled, AMethodOnTheHostGoesInBandsToo) {
  Scene scene = sky("path-trace", Projection::fisheye);
  scene.image = {12, 11};
  scene.bloom.enabled = true;
  RenderRequest request;
  request.bloom = true;
  request.gpu_tone = true;
  const Rendering whole = render_now(scene, request);
  const Whole tiles = in_tiles(scene, {5, 3}, request, true);
  EXPECT_EQ(tiles.rgba, whole.radiance.rgba);
  EXPECT_EQ(tiles.standard_error, whole.standard_error->rgba);
  EXPECT_EQ(tiles.encoded, whole.encoded);
  EXPECT_EQ(tiles.rendering.exposure, whole.exposure);
}

TEST(Tiled, TablesComeWithTheFirstTile) {
  const Scene scene = sky("march", Projection::perspective);
  RenderRequest request;
  request.tables = true;
  const Rendering whole = render_now(scene, request);
  const Whole tiles = in_tiles(scene, {13, 5}, request);
  ASSERT_EQ(tiles.rendering.tables.size(), whole.tables.size());
  for (std::size_t i = 0; i < whole.tables.size(); ++i) {
    EXPECT_EQ(tiles.rendering.tables[i].rgba, whole.tables[i].rgba) << whole.tables[i].name;
  }
}

TEST(Tiled, AFaultEndsItAndIsTold) {
  Scene scene = sky("march", Projection::equirectangular);
  scene.sun.irradiance = {1e38, 1e38, 1e38};
  scene.sun.disc.radiance_scale = 1e30;
  const Whole tiles = in_tiles(scene, {41, 7});
  EXPECT_EQ(tiles.rendering.fault().substr(0, 17), "the picture holds");
  EXPECT_LT(tiles.rgba.size(), 4U * 41 * 23);
}

// Default tiles keep the memory of both device and host small.
TEST(Tiled, UsualTilesFillNoMoreThanTheirBudget) {
  Scene scene = earth();
  for (const ImageSize& size : {ImageSize{32768, 16384}, ImageSize{65536, 65536}, ImageSize{3, 65536}}) {
    scene.image = size;
    for (const LayerSet layers : {LayerSet::none, LayerSet::light, LayerSet::stokes}) {
      const ImageSize tile = usual_tile(ready(scene), layers);
      const auto pixels = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
      EXPECT_GE(tile.height, 1);
      EXPECT_LE(pixels * tile_pixel_bytes(ready(scene), layers), kTileBytes);
      EXPECT_LE(pixels * band_pixel_bytes(ready(scene), layers), kBandBytes);
    }
  }
}

// A medium that scatters at few wavelengths has a layer; so tiles have room for it.
TEST(Tiled, TilesHaveRoomForEveryLayer) {
  const Stage stage =
      ready(scene_of(clear_air(R"({"wavelengths_nm": [400, 401, 409, 410], "values": [0, 0.1, 0.1, 0]})", "{}",
                               R"(, "render": {"method": "march", "wavelengths": 48})")));
  for (const LayerSet set : {LayerSet::light, LayerSet::stokes}) {
    const std::vector<Layer> layers = layers_of(stage, set);
    EXPECT_EQ(layers.front().name, "air");
    const auto is_of_light = [](const Layer& layer) { return layer.channels == "RGB" && layer.name != "sun"; };
    const auto planes = static_cast<std::size_t>(3 * std::ranges::count_if(layers, is_of_light));
    EXPECT_EQ(tile_pixel_bytes(stage, set), planes * sizeof(float));
  }
}

}  // namespace
}  // namespace airlight::test
