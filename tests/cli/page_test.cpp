// The page of `airlight diff --html` in a browser: Chromium, where it is installed.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/measure/colour_map.h"
#include "tests/cli/diff_fixture.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

class Page : public DiffFixture {
 protected:
  void SetUp() override {
    if (run(scratch_.path(), {"sh", "-c", "command -v chromium"}).exit_code != 0) {
      GTEST_SKIP() << "chromium is not installed; scripts/setup test does it";
    }
  }

  // The object `told` after `steps`, which run after the page's own script with `v` as the first viewer. It also has
  // errors of the page's own script.
  Json in_browser(const std::string& steps) {
    std::string page = scratch_.read("r.html");
    page.insert(page.find("<script>"),
                "<script>const failures = []; onerror = text => { failures.push(text); };</script>\n");
    const std::string probe =
        "<script>const told = {}; const figure = document.querySelector('.view');\n"
        "const v = figure.viewer || (figure.viewer = new Viewer(figure));\n"
        "const at = (x, y) => [...v.canvas.getContext('2d').getImageData(x, y, 1, 1).data].slice(0, 3);\n"
        "const set = (name, value) => { v.part(name).value = value; v.part(name).dispatchEvent(new Event('input')); "
        "};\n"
        "const press = key => v.canvas.dispatchEvent(new KeyboardEvent('keydown', { key, cancelable: true }));\n" +
        steps +
        "\ntold.failures = failures; document.body.textContent = 'TOLD' + JSON.stringify(told) + 'END';</script>\n";
    page.insert(page.find("</body>"), probe);
    scratch_.write("probe.html", page);
    Start start;
    start.environment["HOME"] = scratch_.path().string();
    const Outcome outcome = run(scratch_.path(),
                                {"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                                 "--user-data-dir=" + (scratch_.path() / "profile").string(), "--dump-dom",
                                 "file://" + (scratch_.path() / "probe.html").string()},
                                start);
    const std::size_t from = outcome.out.find("TOLD");
    const std::size_t end = outcome.out.find("END", from);
    if (from == std::string::npos || end == std::string::npos) {
      ADD_FAILURE() << outcome.out.substr(0, 2000) << outcome.err;
      return Json::object();
    }
    return Json::parse(outcome.out.substr(from + 4, end - from - 4));
  }
};

// The page's value for an exposed value; the page has its own copy of the formula.
Json grey(double exposed) {
  const int code = measure::display_code(exposed);
  return Json{code, code, code};
}

TEST_F(Page, DrawsBothPicturesAndTheErrorWithExposureAndZoom) {
  // Steps that RGBE holds exactly. B's exposure brings 0.5 to 1.2, so that 0.75 comes to 1.8.
  write("a.exr", 0.5F, 0.75F);
  write("b.exr", 0.5F);
  ASSERT_EQ(diff({"a.exr", "b.exr", "--html", "r.html", "-q"}).exit_code, 1);
  const Json told = in_browser(R"(
    told.size = [v.canvas.width, v.canvas.height];
    set('wipe', 100); told.new = at(0, 0); told.rest = at(5, 3);
    set('wipe', 0); told.reference = at(0, 0);
    set('right', 'error'); told.error = at(0, 0); told.equal = at(5, 3);
    set('right', 'new'); set('exposure', -1); told.darker = at(0, 0); told.stops = v.part('stops').textContent;
    v.part('reset').click(); told.back = at(0, 0);
    set('left', 'reference'); set('wipe', 50); told.left = at(0, 2); told.right = at(7, 2); told.mark = at(4, 0);
    v.part('out').click(); const zoom = v.zoom; v.part('in').click(); told.zoomed = v.zoom / zoom;
    told.width = v.canvas.style.width === `${8 * v.zoom}px`;)");
  EXPECT_EQ(told["failures"], Json::array());
  EXPECT_EQ(told["size"], (Json{8, 4}));
  EXPECT_EQ(told["new"], grey(1.8));
  EXPECT_EQ(told["rest"], grey(1.2));
  EXPECT_EQ(told["reference"], grey(1.2));
  const measure::Colour worst = measure::error_colour(std::log(0.5 / 1e-3) / std::log(1e3));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(told["error"][k].get<int>(), worst[k], 2) << k;
  EXPECT_EQ(told["equal"], Json(measure::error_colour(0.0)));
  EXPECT_EQ(told["darker"], grey(0.9));
  EXPECT_EQ(told["stops"], "-1 EV");
  EXPECT_EQ(told["back"], grey(1.8));
  EXPECT_EQ(told["left"], grey(1.2));
  EXPECT_EQ(told["right"], grey(1.2));
  EXPECT_EQ(told["mark"], (Json{255, 0, 255}));
  EXPECT_EQ(told["zoomed"], 2);
  EXPECT_EQ(told["width"], true);
}

TEST_F(Page, WorksByKeyboardAndTellsValues) {
  write("a.exr", 0.5F, 0.75F);
  write("b.exr", 0.5F);
  ASSERT_EQ(diff({"a.exr", "b.exr", "--html", "r.html", "-q"}).exit_code, 1);
  const Json told = in_browser(R"(
    told.focus = v.canvas.tabIndex; told.label = v.canvas.getAttribute('aria-label');
    press('w'); told.worst = v.part('values').textContent; told.zoom = v.zoom;
    press('ArrowRight'); press('ArrowDown'); told.next = v.part('values').textContent;
    press('-'); told.smaller = v.zoom;
    told.controls = [...v.figure.querySelectorAll('select, input')].every(c => c.closest('label'));
    told.headings = [...document.querySelectorAll('h1, h2')].length;
    told.captions = [...document.querySelectorAll('table')].every(t => t.caption && t.tHead);)");
  EXPECT_EQ(told["failures"], Json::array());
  EXPECT_EQ(told["focus"], 0);
  EXPECT_TRUE(contains(told["label"], "Arrow keys")) << told["label"];
  EXPECT_TRUE(contains(told["worst"], "Pixel (0, 0): new 0.75 0.75 0.75; reference 0.5 0.5 0.5; error about 0.5"))
      << told["worst"];
  EXPECT_TRUE(contains(told["next"], "Pixel (1, 1): new 0.5 0.5 0.5; reference 0.5 0.5 0.5; error at most 0.001"))
      << told["next"];
  EXPECT_EQ(told["smaller"].get<double>() * 2.0, told["zoom"].get<double>());
  EXPECT_EQ(told["controls"], true);
  EXPECT_EQ(told["captions"], true);
  EXPECT_EQ(told["headings"], 2);
}

}  // namespace
}  // namespace airlight::test
