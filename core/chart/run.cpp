#include "core/chart/run.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/clock.h"
#include "core/base/hash.h"
#include "core/chart/qualities.h"
#include "core/chart/truth.h"
#include "core/choice/cost.h"
#include "core/gpu/embedded_shaders.h"
#include "core/measure/sample_error.h"
#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/render/sky.h"
#include "core/scene/preset.h"
#include "core/scene/thing_kinds.h"

namespace airlight::chart {
namespace {

using Clock = std::chrono::steady_clock;

struct SceneTruth {
  Stage stage;
  PixelSet pixels;
  Truth truth;
  double noise = 0.0;
};

// One thing to measure.
struct Task {
  const SkyMethod* method = nullptr;
  std::string quality;  // its label
  Stage stage;
  std::string key = {};
  double cost = 0.0;
};

// The code that runs on the device: a changed shader makes every point stale.
std::string shader_text() {
  std::string text;
  for (const EmbeddedShader& shader : embedded_shaders()) {
    text.append(reinterpret_cast<const char*>(shader.spirv.data()), shader.spirv.size_bytes());
  }
  return text;
}

double cost_of(const Stage& stage, const PixelSet& pixels) {
  if (samples(stage)) {
    constexpr double kSample = 500.0;  // 10 us
    return kSample * static_cast<double>(pixels.places.size()) * stage.scene().render.get<int>("samples");
  }
  Plan plan;
  add_sky(plan, stage, View{}, false);
  return choice::predicted_cost(plan).total();
}

// Time to measure a point, given the time of one picture. `is_cpu`: the device is a processor.
double measuring_s(double picture_s, const Task& task, bool is_cpu) {
  const TimingRules rules;
  if (task.method->render_on_host != nullptr) {
    return picture_s;
  }
  const double timed = picture_s > rules.long_s ? picture_s : std::max(rules.enough_s, rules.fewest_runs * picture_s);
  return picture_s + timed + (is_cpu ? 0.0 : rules.warm_s);
}

class ChartRun {
 public:
  explicit ChartRun(const RunOrder& order) : order_(order), shaders_(hash_text(shader_text())) {}

  RunOutcome run() {
    open();
    out_.device = device_->device();
    out_.cpu_time = out_.device.is_cpu;
    find_truths();
    for (std::size_t i = 0; i < order_.scenes.size(); ++i) {
      measure_scene(i);
    }
    return std::move(out_);
  }

 private:
  double seconds() const { return seconds_since(began_); }
  bool limited() const { return order_.budget_s > 0.0; }
  void open() {
    device_.reset();
    device_ = order_.open_device();
  }

  void report(double done) {
    if (order_.progress) {
      order_.progress(limited() ? std::min(1.0, std::max(done, seconds() / order_.budget_s)) : done);
    }
  }

  // About a third of the work; the true share is unknown beforehand.
  static constexpr double kTruthShare = 0.35;

  void find_truths() {
    const std::size_t count = order_.scenes.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Scene& scene = order_.scenes[i].scene;
      SceneTruth found{.stage = ready(scene), .pixels = {}, .truth = {}};
      const PixelSet all = lattice(scene, order_.settings.compared_columns, order_.settings.compared_rows);
      found.pixels = judged(scene, without_edges_of_things(found.stage, all));
      TruthRules rules;
      rules.target_error = order_.settings.truth_error;
      if (limited()) {
        rules.time_limit_s = std::max(0.5, (0.5 * order_.budget_s - seconds()) / static_cast<double>(count - i));
      }
      const auto progress = [&](double done) {
        report(kTruthShare * (static_cast<double>(i) + done) / static_cast<double>(count));
        return true;
      };
      found.truth = find_truth(found.stage, found.pixels, order_.truth_folder, rules, progress);
      found.noise = measure::sample_noise(found.truth.radiance, found.truth.standard_error);
      truths_.push_back(std::move(found));
    }
  }

  std::vector<Task> tasks_of(std::size_t i) const {
    std::vector<Task> tasks;
    for (const std::string& name : order_.methods) {
      const SkyMethod& method = *find_method(name);
      if (!knows_things_of(method.info, order_.scenes[i].scene)) {
        continue;
      }
      for (ChartedQuality& quality : charted_qualities(order_.scenes[i].scene, method)) {
        Task task{&method, std::move(quality.label), ready(quality.scene, truths_[i].stage)};
        task.cost = cost_of(task.stage, truths_[i].pixels);
        task.key = hash_text(to_json(task.stage.scene()) + truth_name(task.stage, truths_[i].pixels) + shaders_ +
                             order_.version + out_.device.name + out_.device.driver +
                             std::to_string(truths_[i].truth.samples));
        tasks.push_back(std::move(task));
      }
    }
    return tasks;
  }

  const Point* known(const std::string& scene, const Task& task) const {
    for (const Point& point : order_.known) {
      if (point.scene == scene && point.quality == task.quality && point.key == task.key) {
        return &point;
      }
    }
    return nullptr;
  }

  // Tasks go by rising cost, so that a short budget charts the cheap end of every scene. Each method has its own
  // device.
  void measure_scene(std::size_t i) {
    const std::string& name = order_.scenes[i].name;
    std::vector<Task> tasks = tasks_of(i);
    double total = 0.0;
    for (const Task& task : tasks) {
      total += task.cost;
    }
    const double began = seconds();
    const double share = (order_.budget_s - began) / static_cast<double>(order_.scenes.size() - i);
    double done = 0.0;
    for (const std::string& method : order_.methods) {
      std::vector<Task*> mine;
      for (Task& task : tasks) {
        if (task.method->info.name == method) {
          mine.push_back(&task);
        }
      }
      std::ranges::stable_sort(mine, {}, [](const Task* task) { return task->cost; });
      bool fresh = false;
      TableTimes tables;
      std::optional<double> picture_s;  // per cost
      double method_share = 0.0;
      for (const Task* task : mine) {
        method_share += task->cost;
      }
      // Time that other methods left over is available to this one. When time is short, a method omits its dearest
      // qualities.
      const double limit = share * (done + method_share) / total;
      for (const Task* task : mine) {
        done += task->cost;
        if (const Point* point = known(name, *task)) {
          out_.points.push_back(*point);
          ++out_.resumed;
        } else if (limited() && picture_s &&
                   seconds() - began + measuring_s(*picture_s * task->cost, *task, out_.cpu_time) > limit) {
          out_.left_out.push_back(name + " " + method + " " + task->quality);
        } else {
          if (!fresh && task->method->render_on_host == nullptr) {
            open();
            fresh = true;
          }
          double wall_ms = 0.0;
          out_.points.push_back(measure(i, *task, tables, wall_ms));
          picture_s = 1e-3 * wall_ms / task->cost;
          order_.keep(out_.points);
        }
        report(kTruthShare + (1.0 - kTruthShare) * (static_cast<double>(i) + done / total) /
                                 static_cast<double>(order_.scenes.size()));
      }
    }
  }

  Point measure(std::size_t i, const Task& task, TableTimes& tables, double& wall_ms) {
    const SceneTruth& truth = truths_[i];
    const bool host = task.method->render_on_host != nullptr;
    const Timing timing =
        host ? time_on_host(task.stage, truth.pixels) : time_on_device(*device_, task.stage, truth.pixels, {}, tables);
    const measure::SampleError error = measure::sample_error(timing.pixels, truth.truth.radiance);
    wall_ms = timing.wall_ms;
    Point point;
    point.scene = order_.scenes[i].name;
    point.method = task.method->info.name;
    point.quality = task.quality;
    point.cpu_ms = timing.cpu_ms;
    point.device_ms = timing.device_ms;
    point.time_ms = out_.cpu_time ? timing.cpu_ms : timing.device_ms;
    point.tables_ms = timing.tables_ms;
    point.first_ms = timing.first_ms;
    point.runs = timing.runs;
    point.share_timed = timing.share;
    point.error_mean = error.mean;
    point.error_p95 = error.p95;
    point.floor = truth.noise;
    point.key = task.key;
    return point;
  }

  const RunOrder& order_;
  std::string shaders_;
  Clock::time_point began_ = Clock::now();
  std::unique_ptr<Executor> device_;
  std::vector<SceneTruth> truths_;
  RunOutcome out_;
};

}  // namespace

RunOutcome run_chart(const RunOrder& order) {
  return ChartRun(order).run();
}

}  // namespace airlight::chart
