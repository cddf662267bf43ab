#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "app/cli/preset_source.h"
#include "app/cli/seekable_file.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "app/commands/diff_json.h"
#include "app/commands/diff_update.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/measure/compare.h"
#include "core/measure/frames.h"
#include "core/measure/judge.h"
#include "core/measure/page.h"
#include "core/measure/report.h"
#include "core/measure/words.h"
#include "core/methods/method.h"
#include "core/output/atomic_file.h"
#include "core/output/last_words.h"
#include "core/scene/printable.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;
using measure::NamedReport;
using measure::Verdict;

struct DiffGiven {
  std::string a;
  std::string b;
  measure::ComparisonRequest request;
  std::string channels;
  std::string camera_from;
  std::string heatmap;
  std::string side_by_side;
  std::string junit;
  std::string html;
  bool allow_files = false;
  bool update = false;
  bool json = false;
  bool verbose = false;
  bool quiet = false;
};

std::vector<std::string> split_at_commas(const std::string& list) {
  if (list.empty()) return {};
  std::vector<std::string> words = split(list, ',');
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (word->empty()) throw InputError("diff: --channels: '" + list + "' holds an empty name; expected e.g. R,G,B");
    if (std::find(words.begin(), word, *word) != word) {
      throw InputError("diff: --channels: '" + *word + "' is named twice");
    }
  }
  return words;
}

// "heat.png" of the pair "day/sky.0007.exr" -> "heat.day_sky.0007.png".
std::string picture_for(const std::string& file, const measure::FilePairs& pairs, const measure::FilePair& pair) {
  if (!pairs.several || file.empty()) return file;
  std::string name = fs::path(pair.name).replace_extension().string();
  std::replace(name.begin(), name.end(), '/', '_');
  const fs::path path(file);
  return (path.parent_path() / (path.stem().string() + "." + name + path.extension().string())).string();
}

// Checks all names of output files before any work.
void require_outputs(const DiffGiven& given, const measure::FilePairs& pairs) {
  std::vector<std::string> outputs;
  for (const measure::FilePair& pair : pairs.pairs) {
    for (const std::string& file : {given.heatmap, given.side_by_side}) {
      if (!file.empty()) outputs.push_back(picture_for(file, pairs, pair));
    }
  }
  for (const std::string& file : outputs) {
    if (fs::path(file).extension() != ".png") throw InputError(file + ": pictures are written as PNG; name it *.png");
  }
  for (const std::string& file : {given.junit, given.html}) {
    if (!file.empty()) outputs.push_back(file);
  }
  for (const std::string& file : outputs) {
    if (std::ranges::count(outputs, file) > 1) {
      throw InputError(file + ": is to be written twice; give each output a name of its own");
    }
    require_writable(file);
    for (const measure::FilePair& pair : pairs.pairs) {
      std::error_code ignored;
      if (fs::equivalent(file, pair.a, ignored) || fs::equivalent(file, pair.b, ignored)) {
        throw InputError(file + ": is one of the pictures compared; write to another name");
      }
    }
  }
}

std::string resolved_preset(const std::string& source, bool any_file) {
  return source.empty() ? std::string() : to_json(resolve(find_preset(source, any_file), method_infos()));
}

// Writes a text or a PNG; does nothing where there is none.
template <class Contents>
void write(const std::string& file, const Contents& contents, std::vector<std::string>& written) {
  if (contents.empty()) return;
  write_file(file, contents);
  written.push_back(file);
}

// Names the pair's files as the user named them.
void tell_by_name(const std::vector<SeekableFile>& inputs, NamedReport& entry) {
  for (const SeekableFile& input : inputs) {
    entry.report.problem = input.told(entry.report.problem);
    for (std::string& note : entry.report.notes) note = input.told(note);
    for (std::string* name : {&entry.name, &entry.a, &entry.b}) *name = input.told(*name);
  }
}

NamedReport compare_pair(const DiffGiven& given, const measure::FilePairs& pairs, const measure::FilePair& pair,
                         std::vector<std::string>& written) {
  NamedReport entry{.name = pair.name, .a = pair.a, .b = pair.b, .report = {}, .pictures = {}};
  if (!pair.problem.empty()) {
    entry.report.problem = pair.problem;
    return entry;
  }
  measure::ComparisonRequest request = given.request;
  request.a = pair.a;
  request.b = pair.b;
  request.standard_errors = pair.standard_errors;
  request.heatmap = !given.heatmap.empty();
  request.side_by_side = !given.side_by_side.empty();
  if (!given.html.empty()) request.shown_pixels = measure::page_pixels(pairs.pairs.size());
  entry.report = measure::compare(request);
  write(picture_for(given.heatmap, pairs, pair), entry.report.heatmap_png, entry.pictures);
  write(picture_for(given.side_by_side, pairs, pair), entry.report.side_by_side_png, entry.pictures);
  written.insert(written.end(), entry.pictures.begin(), entry.pictures.end());
  entry.report.heatmap_png = {};
  entry.report.side_by_side_png = {};
  return entry;
}

// Prints figures to standard output, or to standard error beside --json. A single pair that cannot be compared is an
// error of one line.
void tell_people(const DiffGiven& given, bool several, const NamedReport& entry, const measure::Limits& in_force) {
  const auto say = [&](const std::string& text) {
    const std::string shown = printable(text, true);
    given.json ? tell(shown) : print(shown);
  };
  if (!several && entry.report.verdict == Verdict::cannot_compare) {
    complain(entry.report.problem);
  } else if (given.quiet) {
    if (entry.report.verdict != Verdict::pass) say(measure::describe_briefly(entry));
  } else {
    say(several && !given.verbose ? measure::describe_briefly(entry) : measure::describe(entry, in_force));
  }
}

int exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
    case Verdict::warn:
      return 0;
    case Verdict::differ:
      return 1;
    case Verdict::cannot_compare:
      break;
  }
  return 2;
}

void tell_replaced(const DiffGiven& given, const std::vector<std::string>& replaced) {
  if (given.quiet && replaced.empty()) return;
  std::string text;
  for (const std::string& file : replaced) text += "Replaced the reference " + file + "\n";
  if (replaced.empty()) text = "No reference needed replacing\n";
  given.json ? tell(text) : print(text);
}

std::string compared_so_far(std::size_t done, std::size_t all, const std::string& junit) {
  return std::to_string(done) + " of " + std::to_string(all) +
         (all == 1 ? " pair was compared" : " pairs were compared") +
         (junit.empty() ? "" : "; " + printable(shortened(junit, 200)) + " was not written");
}

int diff(DiffGiven given) {
  const bool in_sigmas = !given.request.standard_errors.empty();
  if (given.request.limits.chi_square && !in_sigmas) {
    throw InputError("diff: --chi-square needs --standard-error FILE");
  }
  given.request.channels = split_at_commas(given.channels);
  if (given.update && (!given.channels.empty() || !given.request.layer.empty())) {
    throw InputError("diff: --update takes whole files; compare them whole, without --layer and --channels");
  }
  given.request.version = AIRLIGHT_VERSION;
  given.request.view_preset = resolved_preset(given.camera_from, given.allow_files);
  // Pipes are read once, in the order given.
  std::vector<SeekableFile> inputs;
  for (std::string* name : {&given.a, &given.b}) {
    inputs.emplace_back(*name);
    *name = inputs.back().path();
  }
  if (given.update && given.b != inputs[1].name()) {
    throw InputError("diff: --update: " + inputs[1].name() + " is no file that could be replaced; name one");
  }
  for (std::string& name : given.request.standard_errors) {
    inputs.emplace_back(name);
    name = inputs.back().path();
  }
  const measure::FilePairs pairs = measure::pair_files(given.a, given.b, given.request.standard_errors);
  require_outputs(given, pairs);
  std::optional<ReferenceUpdate> update;
  if (given.update) update.emplace(pairs, given.b);
  const measure::Limits in_force = measure::limits_in_force(given.request.limits, in_sigmas);

  std::vector<NamedReport> entries;
  std::vector<std::string> written;
  say_when_ended(compared_so_far(0, pairs.pairs.size(), given.junit));
  for (const measure::FilePair& pair : pairs.pairs) {
    entries.push_back(compare_pair(given, pairs, pair, written));
    tell_by_name(inputs, entries.back());
    tell_people(given, pairs.several, entries.back(), in_force);
    say_when_ended(compared_so_far(entries.size(), pairs.pairs.size(), given.junit));
  }
  if (pairs.several && !given.quiet) {
    const std::string summary = printable(measure::describe_all(entries), true);
    given.json ? tell(summary) : print(summary);
  }
  // The files are written from here on: the words claim nothing of them.
  say_when_ended(compared_so_far(entries.size(), pairs.pairs.size(), {}));
  if (!given.junit.empty()) write(given.junit, measure::junit_xml(entries), written);
  if (!given.html.empty()) write(given.html, measure::html_page(entries, inputs[0].name(), inputs[1].name()), written);
  // If a pair cannot be compared the update throws, after all reports are written.
  const auto finish = [&](const std::vector<std::string>& replaced) {
    if (given.json) print(diff_json(entries, in_force, written, replaced));
  };
  if (!update) {
    finish({});
    return exit_code(measure::overall(entries));
  }
  if (measure::overall(entries) == Verdict::cannot_compare) finish({});
  const std::vector<std::string> replaced = update->take(entries);
  finish(replaced);
  tell_replaced(given, replaced);
  return 0;
}

const char* const kDescription =
    "airlight compares A with the reference B. Both are EXR files, or folders of them, or frame patterns such as "
    "sky.####.exr. It compares each channel, the luminance, and the colour channels pooled. It reports relative and "
    "absolute error, RMS, PSNR and the worst pixel.\n\n"
    "If a preset tells the camera, it reports them for each region of the sky too: sky, sun aureole (10 degrees around "
    "the sun), horizon band (3 degrees above the true horizon), zenith (15 degrees) and ground. That preset is "
    "--camera-from's, otherwise B's own, otherwise A's. If both files carry a preset, airlight compares the presets "
    "first. It says which file another version of airlight made.\n\n"
    "Relative error is |a-b| / max(|b|, 0.001 mean|b|), with the mean over the whole picture of a channel. PSNR is "
    "relative to B's largest value. NaN and infinity equal nothing unless --allow-nonfinite is given, and fail under "
    "any limits. airlight does not compare the colours of files whose chromaticities differ.\n\n"
    "Without limits, two pictures pass if no channel of any pixel differs by more than 1e-6. This is the default of "
    "--fail, as in idiff. If only --rel-... limits are given, only these decide. With --standard-error, the values of "
    "--fail, --hardfail, --warn and --hardwarn are in standard errors. These limits then hold if none is given: --fail "
    "4 --failpercent 0.5 --chi-square 1.5. A pixel whose standard error is 0 must be equal.\n\n"
    "--html writes one file that needs no network. It lists all pairs, the largest error first. It shows A, B and the "
    "error under a wipe slider, with exposure and zoom. It lists limits, regions, the worst pixel and the keys of the "
    "presets that differ. Its pictures have linear values. They are reduced by a whole factor if one has more than "
    "518400 pixels, or if all together have more than 1.5 million. The figures are those of the whole pictures.\n\n"
    "--update replaces each reference that differs with its new picture: all of them or none. It compares and reports "
    "first, and does not ask before it replaces. If one pair cannot be compared, or if writing fails, every reference "
    "stays as it was. A reference that is a link out of its folder is refused. References that pass stay too. If the "
    "run is killed between two renames, each file is whole; the "
    "same command continues from there.\n\n"
    "The exit code is 0 if the pictures pass, perhaps with warnings; 1 if they differ; 2 if they cannot be compared. "
    "With --update it is 0 if the references are up to date; 1 if writing failed; 2 if a pair cannot be compared.";

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// The limits that decide the verdict.
std::vector<Option> limit_options(measure::Limits& limits) {
  const Range positive{0.0, kNoLimit};
  const Range share{0.0, 100.0};
  const auto number = [](const char* name, const char* metavar, const char* help, Target target, Range range) {
    return Option{name, metavar, help, target, Completes::nothing, range, {}, {}};
  };
  const auto in_percent = [](Option option, Percent percent) {
    option.percent = percent;
    return option;
  };
  return {
      number("--fail", "VALUE", "A pixel fails if a channel differs by more than this", &limits.fail, positive),
      in_percent(
          number("--failpercent", "PERCENT", "Percentage of the pixels that may fail", &limits.fail_percent, share),
          Percent::points),
      number("--hardfail", "VALUE", "No pixel may differ by more than this", &limits.hard_fail, positive),
      number("--warn", "VALUE", "Like --fail, but for a warning", &limits.warn, positive),
      in_percent(
          number("--warnpercent", "PERCENT", "Like --failpercent, but for a warning", &limits.warn_percent, share),
          Percent::points),
      number("--hardwarn", "VALUE", "Like --hardfail, but for a warning", &limits.hard_warn, positive),
      in_percent(number("--rel-mean", "ERROR", "Largest mean relative error that passes, e.g. 0.5%",
                        &limits.relative_mean, positive),
                 Percent::share),
      in_percent(number("--rel-p95", "ERROR", "Largest 95th percentile of the relative error that passes",
                        &limits.relative_p95, positive),
                 Percent::share),
      in_percent(number("--rel-max", "ERROR", "Largest relative error that passes", &limits.relative_max, positive),
                 Percent::share),
      number("--chi-square", "VALUE", "Largest chi-square per value that passes; needs --standard-error",
             &limits.chi_square, positive),
  };
}

// The choice of what is compared, and the outputs.
std::vector<Option> other_options(DiffGiven& given) {
  const auto text = [](const char* name, const char* metavar, const char* help, Target target,
                       Completes completes = Completes::nothing) {
    return Option{name, metavar, help, target, completes, {}, {}, {}};
  };
  return {
      text("--layer", "NAME", "Compare this layer instead of the main picture", &given.request.layer),
      text("--channels", "LIST", "Compare only these channels, e.g. R,G,B", &given.channels),
      text("--allow-nonfinite", "", "Let NaN equal NaN, and infinity equal infinity of the same sign",
           &given.request.allow_nonfinite),
      text("--standard-error", "FILE.exr",
           "Judge in units of the standard error in this file; several files add in quadrature",
           &given.request.standard_errors, Completes::file),
      text("--standard-error-layer", "NAME",
           "Layer of the standard error in its file (default: standard_error, standard-error or stderr; without these, "
           "the main picture)",
           &given.request.standard_error_layer),
      text("--camera-from", "PRESET",
           "Take camera, sun and planet from this preset, or from an EXR or PNG written by airlight",
           &given.camera_from, Completes::file),
      allow_files_option(given.allow_files),
      text("--heatmap", "FILE.png",
           "Write a picture of the error with its scale. With several pairs, FILE.NAME.png is that of each pair",
           &given.heatmap, Completes::file),
      text("--side-by-side", "FILE.png", "Write A, B and the error in a row", &given.side_by_side, Completes::file),
      Option{"--heatmap-max",
             "VALUE",
             "Top of the error's scale (default: the power of ten above the largest error, or 6 standard errors)",
             &given.request.heatmap_max,
             Completes::nothing,
             Range{1e-30, 1e30},
             {},
             {}},
      text("--html", "FILE.html", "Write one page for any browser, with pictures, limits, regions and preset keys",
           &given.html, Completes::file),
      text("--update", "", "Replace the references that differ with the pictures of A, after the report; see above",
           &given.update),
      text("--junit", "FILE.xml", "Write the result as JUnit XML", &given.junit, Completes::file),
      text("--json", "", "Print one JSON object. The text for people then goes to standard error", &given.json),
      text("-q,--quiet", "", "Report only what does not pass", &given.quiet),
      text("-v,--verbose", "", "Report all figures of each pair when there are several", &given.verbose),
  };
}

}  // namespace

Command diff_command() {
  const auto given = std::make_shared<DiffGiven>();
  Command command;
  command.name = "diff";
  command.summary = "Compare two EXR files, folders or frame sequences";
  command.description = kDescription;
  command.examples = {
      {"airlight diff out/sky.exr expected.exr", "Fail on any difference above 1e-6"},
      {"airlight diff march.exr truth.exr --rel-mean 2% --rel-p95 5% --heatmap error.png",
       "Judge a method, and show where it is wrong"},
      {"airlight diff a.exr truth.exr --standard-error truth.exr", "Judge in units of the truth's noise"},
      {"airlight diff 'new/sky.####.exr' 'old/sky.####.exr' --junit diff.xml", "Compare two sequences for CI"},
      {"airlight diff new references --rel-mean 0.1% --html report.html",
       "Compare two folders, and show the result in one page"},
      {"airlight diff new references --rel-mean 0.1% --update", "Take the changed pictures as references"}};
  command.positionals = {
      {"A", "picture (- for standard input), folder or frame pattern", &given->a, true, Completes::file, {}, {}},
      {"B", "the reference, of the same kind", &given->b, true, Completes::file, {}, {}}};
  command.options = grouped("Limits", limit_options(given->request.limits));
  append(command.options, other_options(*given));
  command.run = [given] { return diff(*given); };
  return command;
}

}  // namespace airlight::cli
