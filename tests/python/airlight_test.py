"""The Python package: python3 airlight_test.py TOOL, with the package's folder on PYTHONPATH."""

import ast
import datetime
import importlib.util
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy

import airlight

TOOL = sys.argv.pop(1)
SMALL = {"size": (16, 8), "projection": "latlong"}


def by_the_tool(*options):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "sky.npy")
        subprocess.run([TOOL, "render", "earth-noon", "-q", "-o", file, *options], check=True)
        return numpy.load(file)


class Render(unittest.TestCase):
    def test_is_the_tools_picture_to_the_bit(self):
        sky = airlight.render("earth-noon", sun_elevation=4, **SMALL)
        self.assertEqual((sky.shape, sky.dtype), ((8, 16, 3), numpy.float32))
        there = by_the_tool("--sun-elevation", "4", "--projection", "latlong", "--size", "16x8")
        self.assertTrue(numpy.array_equal(sky, there))

    def test_takes_the_long_options(self):
        given = {"pitch": 20, "azimuth": -30.5, "fov": 40, "altitude": 2, "sun_azimuth": 200, "method": "march"}
        words = [word for name, value in given.items() for word in (f"--{name.replace('_', '-')}", str(value))]
        there = by_the_tool(*words, "--size", "16x9", "--set", "/planet/ground_albedo=0.8")
        here = airlight.render("earth-noon", size="16x9", set={"/planet/ground_albedo": 0.8}, **given)
        self.assertTrue(numpy.array_equal(here, there))

    def test_takes_a_date_and_a_place(self):
        there = by_the_tool("--projection", "latlong", "--size", "16x8", "--date", "2026-06-21", "--time", "21:30:00",
                            "--lat", "48.85", "--lon", "2.35", "--tz", "Europe/Paris")
        when = {"date": datetime.date(2026, 6, 21), "time": datetime.time(21, 30), "tz": "Europe/Paris"}
        here = airlight.render("earth-noon", lat=48.85, lon=2.35, **when, **SMALL)
        self.assertTrue(numpy.array_equal(here, there))
        words = airlight.render("earth-noon", lat=48.85, lon=2.35, date="2026-06-21", time="19:30", **SMALL)
        self.assertTrue(numpy.array_equal(words, there))

    def test_a_spectrum_is_that_of_the_tool(self):
        sky, spectrum = airlight.render("earth-noon", spectral=(400, 700, 50), size=(8, 4))
        self.assertEqual((spectrum.radiance.shape, spectrum.radiance.dtype), ((4, 8, 7), numpy.float32))
        self.assertEqual(list(spectrum.wavelengths), list(range(400, 701, 50)))
        self.assertEqual((spectrum.sunlight.shape, spectrum.unit), ((7,), "W.m^-2.sr^-1.nm^-1"))
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "sky.exr")
            subprocess.run([TOOL, "render", "earth-noon", "-q", "-o", file, "--size", "8x4", "--spectral", "400:700:50"],
                           check=True)
            try:
                import OpenImageIO
            except ImportError:
                self.skipTest("OpenImageIO for Python is not installed")
            picture = OpenImageIO.ImageInput.open(file)
            planes = dict(zip(picture.spec().channelnames, numpy.moveaxis(picture.read_image("float"), 2, 0)))
        for i, nm in enumerate(range(400, 701, 50)):
            self.assertTrue(numpy.array_equal(spectrum.radiance[..., i], planes[f"S0.{nm},000000nm"]), nm)
        both = airlight.render("earth-noon", spectral="400:700:100", layers="light", size=(8, 4))
        self.assertEqual(len(both), 3)
        self.assertTrue(numpy.array_equal(both[0], sky))

    def test_takes_a_preset_as_a_dictionary_and_as_a_file(self):
        preset = {"airlight": 1, "extends": "earth", "sun": {"elevation_deg": 7}}
        sky = airlight.render(preset, **SMALL)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mine.json")
            with open(file, "w", encoding="utf-8") as out:
                out.write('{"airlight": 1, "extends": "earth", "sun": {"elevation_deg": 7}}')
            self.assertTrue(numpy.array_equal(airlight.render(file, **SMALL), sky))
        self.assertTrue(numpy.array_equal(airlight.render("earth", sun_elevation=7, **SMALL), sky))

    def test_layers_add_up(self):
        sky, layers = airlight.render("earth-sunset", layers="light", set={"/sun/disc/visible": False}, **SMALL)
        self.assertEqual(layers["depth"].shape, (8, 16))
        light = [plane for name, plane in layers.items() if name not in ("transmittance", "depth", "N")]
        numpy.testing.assert_allclose(sum(light), sky, rtol=5e-4)

    def test_several_threads_get_their_own_skies(self):
        alone = [airlight.render("earth-noon", sun_elevation=e, **SMALL) for e in (3, 30)]
        found = [None, None]

        def work(i):
            found[i] = airlight.render("earth-noon", sun_elevation=(3, 30)[i], **SMALL)

        threads = [threading.Thread(target=work, args=(i,)) for i in (0, 1)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i in (0, 1):
            self.assertTrue(numpy.array_equal(found[i], alone[i]))

    def test_other_threads_run_while_it_renders(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.01)

        thread = threading.Thread(target=tick)
        thread.start()
        start = time.monotonic()
        airlight.render("earth-noon", method="path-trace", samples=64, **SMALL)
        end = time.monotonic()
        done.set()
        thread.join()
        self.assertGreater(sum(start < t < end for t in ticks), 5)

    def test_control_c_ends_it(self):
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            airlight.render("earth-noon", method="path-trace", samples=1000000, size=(64, 36))
        self.assertLess(time.monotonic() - start, 20)
        timer.join()
        self.assertEqual(airlight.render("earth-noon", **SMALL).shape, (8, 16, 3))

    def test_progress_may_end_it_or_raise(self):
        with self.assertRaisesRegex(airlight.RunError, "stopped"):
            airlight.render("earth-noon", progress=lambda done: False, **SMALL)
        with self.assertRaises(ZeroDivisionError):
            airlight.render("earth-noon", progress=lambda done: 1 / 0, **SMALL)
        shares = []
        airlight.render("earth-noon", progress=shares.append, **SMALL)
        self.assertTrue(shares and all(0 <= share <= 1 for share in shares))


class Values(unittest.TestCase):
    def test_probe_is_the_light_along_a_pixel(self):
        options = {"projection": "latlong", "size": (32, 16), "set": {"/sun/disc/visible": False}}
        sky = airlight.render("earth-noon", **options)
        direction = (90 - 180 * 3.5 / 16, 360 * 20.5 / 32 - 180)
        found = airlight.probe("earth-noon", [direction, (90, 0)], **options)
        self.assertEqual(found.radiance.shape, (2, 3))
        numpy.testing.assert_allclose(sky[3, 20], found.radiance[0], rtol=0.01)
        self.assertEqual(found.q.shape, (2, 3))

    def test_irradiance(self):
        found = airlight.irradiance("earth-noon")
        self.assertEqual(found.map.shape, (32, 64, 3))
        self.assertEqual(found.harmonics.shape, (9, 3))
        self.assertIsNone(found.moon)
        weights = numpy.cos(numpy.pi * ((numpy.arange(32) + 0.5) / 32 - 0.5))
        mean = numpy.average(found.map.mean(axis=1), axis=0, weights=weights)
        numpy.testing.assert_allclose(mean, found.harmonics[0] * numpy.sqrt(4 * numpy.pi) / 4, rtol=2e-3)

    def test_presets(self):
        self.assertIn("earth-noon", airlight.presets())
        self.assertEqual(airlight.preset("earth-noon")["airlight"], 1)
        airlight.check(airlight.preset("earth-noon"))


class Example(unittest.TestCase):
    def test_light_over_a_day(self):
        script = os.path.join(os.path.dirname(__file__), "../../core/library/examples/day_of_light.py")
        with tempfile.TemporaryDirectory() as folder:
            # A short day. Where matplotlib is installed a picture too.
            picture = [os.path.join(folder, "day.png")] if importlib.util.find_spec("matplotlib") else []
            done = subprocess.run([sys.executable, script, "2026-12-21", "66", "0", "4", *picture], check=True,
                                  capture_output=True, text=True)
            self.assertTrue(all(os.path.getsize(file) > 1000 for file in picture))
        rows = [line.split() for line in done.stdout.splitlines()]
        level = {row[0]: float(row[-2]) for row in rows}
        self.assertEqual(max(level, key=level.get), "12:00")  # on this meridian, with the equation of time 2 minutes
        # CIE's and measured sums for a sun half a degree high: 500 to 1500 lux on level ground.
        self.assertTrue(300 < level["12:00"] < 2000, level)


class Refusals(unittest.TestCase):
    def refused(self, error, words, function, *args, **options):
        with self.assertRaises(error) as caught:
            function(*args, **options)
        self.assertIn(words, str(caught.exception))

    def test_keywords(self):
        self.refused(TypeError, "no keyword sun_elevatoin (did you mean sun_elevation?)", airlight.render, "earth-noon",
                     sun_elevatoin=4)
        self.refused(TypeError, "check() has no keyword layers", airlight.check, "earth-noon", layers="light")

    def test_types(self):
        self.refused(TypeError, "expected a number", airlight.render, "earth-noon", sun_elevation="low")
        self.refused(TypeError, "expected a number", airlight.render, "earth-noon", sun_elevation=True)
        self.refused(TypeError, "expected (width, height)", airlight.render, "earth-noon", size=(64.5, 32))
        self.refused(TypeError, "expected (width, height)", airlight.render, "earth-noon", size=64)
        self.refused(TypeError, "built-in preset's name", airlight.render, 7)
        self.refused(TypeError, "expected a dictionary", airlight.render, "earth-noon", set="/sun/elevation_deg=4")
        self.refused(ValueError, "expected (N, 2)", airlight.probe, "earth-noon", [90, 0])

    def test_places_and_spectra(self):
        self.refused(ValueError, "needs time, lon as well", airlight.check, "earth", date="2026-06-21", lat=48)
        self.refused(TypeError, "expected True or False", airlight.check, "earth", refraction=1)
        self.refused(TypeError, "expected a text", airlight.check, "earth", tz=2)
        self.refused(TypeError, "expected (first, last, step)", airlight.render, "earth", spectral=(400, 700))
        self.refused(TypeError, "expected (first, last, step)", airlight.render, "earth", spectral=500)
        self.refused(ValueError, "must be below the last", airlight.render, "earth", spectral=(700, 400, 10))

    def test_stubs_name_every_keyword(self):
        stub = os.path.join(os.path.dirname(airlight.__file__), "__init__.pyi")
        with open(stub, encoding="utf-8") as text:
            tree = ast.parse(text.read())
        wanted = {name.replace("-", "_") for name in airlight._airlight.option_names()} | {"set"}
        own = {"layers", "progress", "spectral"}
        functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)
                     and node.name in ("render", "probe", "irradiance", "check")]
        self.assertEqual(len(functions), 14)
        for function in functions:
            names = {argument.arg for argument in function.args.kwonlyargs}
            self.assertEqual(names - own, wanted, function.name)
            self.assertEqual(names & own, own if function.name == "render" else set())

    def test_values(self):
        self.refused(ValueError, "did you mean 'earth-noon'?", airlight.render, "earth-non")
        self.refused(airlight.InputError, "sun_elevation=400", airlight.check, "earth-noon", sun_elevation=400)
        self.refused(ValueError, "did you mean 'light'?", airlight.render, "earth-noon", layers="lihgt")


if __name__ == "__main__":
    unittest.main()
