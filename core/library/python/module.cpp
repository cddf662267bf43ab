// airlight._airlight: libairlight for Python. The package's __init__.py takes keywords apart; here are numbers alone.
#include <airlight/airlight.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>

namespace py = pybind11;

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

airlight::Scene scene_of(const airlight::Session& session, const std::string& preset, bool is_text,
                         const Pairs& options, const Pairs& sets) {
  airlight::Scene scene = is_text ? session.parse(preset) : session.load(preset);
  for (const auto& [name, value] : options) {
    scene.option(name, value);
  }
  for (const auto& [pointer, value] : sets) {
    scene.set(pointer, value);
  }
  return scene;
}

py::array_t<float> array_of(const std::vector<float>& values, const std::vector<py::ssize_t>& shape) {
  py::array_t<float> array(shape);
  std::memcpy(array.mutable_data(), values.data(), values.size() * sizeof(float));
  return array;
}

py::array_t<float> array_of(const airlight::Image& image) {
  return array_of(image.rgb, {image.height, image.width, 3});
}

// `count` planes as the last axis.
py::array_t<float> interleaved(const std::vector<float>& planes, std::size_t count, py::ssize_t height,
                               py::ssize_t width) {
  py::array_t<float> array({height, width, static_cast<py::ssize_t>(count)});
  float* out = array.mutable_data();
  const auto plane = static_cast<std::size_t>(height * width);
  for (std::size_t i = 0; i < plane; ++i) {
    for (std::size_t c = 0; c < count; ++c) {
      *out++ = planes[c * plane + i];
    }
  }
  return array;
}

// The planes of a layer as the last axis; a single plane without it.
py::array_t<float> array_of(const airlight::Layer& layer, py::ssize_t height, py::ssize_t width) {
  return layer.channels.size() == 1 ? array_of(layer.planes, {height, width})
                                    : interleaved(layer.planes, layer.channels.size(), height, width);
}

py::object array_of(const std::optional<airlight::Spectrum>& spectrum, py::ssize_t height, py::ssize_t width) {
  if (!spectrum) {
    return py::none();
  }
  const auto count = static_cast<py::ssize_t>(spectrum->nm.size());
  return py::make_tuple(py::array_t<double>(count, spectrum->nm.data()),
                        interleaved(spectrum->planes, spectrum->nm.size(), height, width),
                        py::array_t<double>(count, spectrum->sunlight.data()), spectrum->unit);
}

// Runs `work` without the interpreter's lock. `work` gets a function for RenderOptions::progress, which takes the lock
// a few times a second to see whether Ctrl-C was pressed, or whether the caller's own function ends the render.
template <class Work>
auto unlocked(const py::object& progress, Work work) {
  std::optional<py::error_already_set> raised;
  const auto goes_on = [&](double done) {
    const py::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
      }
      return progress.is_none() || !progress(done).equal(py::bool_(false));
    } catch (py::error_already_set& error) {
      raised.emplace(error);
      return false;
    }
  };
  try {
    const py::gil_scoped_release release;
    return work(goes_on);
  } catch (const airlight::RunError&) {
    if (raised) {
      throw py::error_already_set(*raised);
    }
    throw;
  }
}

py::tuple rendered(airlight::Session& session, const std::string& preset, bool is_text, const Pairs& options,
                   const Pairs& sets, const std::string& layers, const std::string& spectral,
                   const py::object& progress) {
  const airlight::Image image = unlocked(progress, [&](const std::function<bool(double)>& goes_on) {
    return session.render(scene_of(session, preset, is_text, options, sets), {layers, spectral, goes_on});
  });
  py::dict planes;
  for (const airlight::Layer& layer : image.layers) {
    planes[py::str(layer.name)] = array_of(layer, image.height, image.width);
  }
  return py::make_tuple(array_of(image), planes, array_of(image.spectrum, image.height, image.width), image.exposure,
                        image.warnings, image.undone);
}

using Triples = py::array_t<double, py::array::c_style | py::array::forcecast>;

Triples triples(std::size_t count) {
  return Triples({static_cast<py::ssize_t>(count), py::ssize_t{3}});
}

py::tuple probed(airlight::Session& session, const std::string& preset, bool is_text, const Pairs& options,
                 const Pairs& sets, const Triples& directions) {
  std::vector<airlight::Direction> asked;
  for (py::ssize_t i = 0; i < directions.shape(0); ++i) {
    asked.push_back({directions.at(i, 0), directions.at(i, 1)});
  }
  const std::vector<airlight::Probe> probes = unlocked(
      py::none(), [&](const auto&) { return session.probe(scene_of(session, preset, is_text, options, sets), asked); });
  const auto table = [&](const auto& value_of) {
    Triples values = triples(probes.size());
    double* out = values.mutable_data();
    for (const airlight::Probe& probe : probes) {
      out = std::copy_n(value_of(probe).data(), 3, out);
    }
    return values;
  };
  const bool polarised = !probes.empty() && probes.front().q && probes.front().u;
  const py::object none = py::none();
  return py::make_tuple(table([](const airlight::Probe& p) { return p.radiance; }),
                        table([](const airlight::Probe& p) { return p.transmittance; }),
                        polarised ? py::object(table([](const airlight::Probe& p) { return *p.q; })) : none,
                        polarised ? py::object(table([](const airlight::Probe& p) { return *p.u; })) : none);
}

py::object light(const std::optional<airlight::DirectionalLight>& given) {
  if (!given) {
    return py::none();
  }
  return py::make_tuple(given->direction, given->elevation_deg, given->azimuth_deg, given->angular_radius_deg,
                        given->irradiance, given->irradiance_above_air, given->visible_share);
}

py::tuple lit(airlight::Session& session, const std::string& preset, bool is_text, const Pairs& options,
              const Pairs& sets) {
  const airlight::Irradiance found = unlocked(
      py::none(), [&](const auto&) { return session.irradiance(scene_of(session, preset, is_text, options, sets)); });
  Triples harmonics = triples(found.harmonics.size());
  double* out = harmonics.mutable_data();
  for (const airlight::Rgb& rgb : found.harmonics) {
    out = std::copy_n(rgb.data(), 3, out);
  }
  return py::make_tuple(array_of(found.map), harmonics, light(found.sun), light(found.moon));
}

}  // namespace

PYBIND11_MODULE(_airlight, module) {
  py::register_exception<airlight::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<airlight::RunError>(module, "RunError", PyExc_RuntimeError);
  module.def("version", &airlight::version);
  module.def("presets", &airlight::presets);
  module.def("preset_text", &airlight::preset_text);
  module.def("option_names", &airlight::option_names);
  py::class_<airlight::Session>(module, "Session")
      .def(py::init([](const std::string& device, const std::string& cache_folder, unsigned int threads) {
        return std::make_unique<airlight::Session>(airlight::SessionOptions{device, cache_folder, threads});
      }))
      .def("render", &rendered)
      .def("probe", &probed)
      .def("irradiance", &lit)
      .def("check", [](const airlight::Session& session, const std::string& preset, bool is_text, const Pairs& options,
                       const Pairs& sets) { scene_of(session, preset, is_text, options, sets).check(); })
      .def("device", &airlight::Session::device, py::call_guard<py::gil_scoped_release>());
}
