"""The pages in a real browser: complete without a network, readable by everybody, and equal to the results they show.

    report_test.py STICKSLIP [--update]     --update stores the screenshots anew
"""
import base64
import csv
import json
import math
import os
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

import netCDF4
import numpy
from PIL import Image

from browser import Browser

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
UPDATE = "--update" in sys.argv
LARGEST_PAGE = 3_000_000
FLOAT = 1.2e-7  # relative step of a float
COARSE = 1.6e-5   # of the layers behind the slider: 15 bits of mantissa


def stickslip(*arguments, cwd=ROOT):
    done = subprocess.run([PROGRAM, *arguments], cwd=cwd, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name)
        stickslip("sweep", "-o", cls.out / "linear")
        stickslip("sweep", "examples/03-bistable-strip/spec.toml", "-o", cls.out / "nonlinear")
        stickslip("simulate", cls.out / "linear/joint.toml", "--set", "control.k_p=2e4", "-o", cls.out / "motion")
        linear = (ROOT / "examples/03-bistable-strip/spec.toml").read_text().replace("enabled = true", "enabled = false")
        for name, text in (("before", linear), ("after", linear.replace("L = 1.0e-5", "L = 1.1e-5"))):
            (cls.out / f"{name}.toml").write_text(text)
            stickslip("sweep", cls.out / f"{name}.toml", "-o", cls.out / name)
        stickslip("report", "before", "after", "-o", "comparison", cwd=cls.out)
        stickslip("boundary", "examples/03-bistable-strip/spec.toml", "--kind", "linear", "fold", "--over",
                  "control.k_p", "control.k_v", "-o", cls.out / "boundary")
        stickslip("design", "examples/04-design/spec.toml", "-o", cls.out / "design")
        stickslip("evaluate", "examples/01-reference-joint/spec.toml", "--set", "control.period=1e-3", "--set", "control.delay=1e-3",
                  "--set", 'control.velocity_estimate.form="backward-difference"', "-o", cls.out / "loop")
        cls.diagnose()
        names = ("loop", "linear", "nonlinear", "motion", "comparison", "boundary", "design", "gap")
        cls.pages = {name: cls.out / name / "report.html" for name in names}
        cls.pages["robot"] = cls.out / "robot/robot.html"
        cls.results = netCDF4.Dataset(cls.out / "linear/results.nc")
        cls.browser = Browser()

    @classmethod
    def diagnose(cls):
        """An arm whose weight the joint file does not state, along a motion that turns round."""
        joint = ("[joint]\nmotion = \"revolute\"\ninertia = 1.1\n[control]\nk_p = 4000\nk_v = 120\nperiod = 1e-3\n"
                 "velocity_estimate = { form = \"backward-difference\", tau = 1e-3 }\n"
                 "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 2.0\nviscous = 0.5\n"
                 "[sensor]\nencoder_quantum = 1e-6\nposition_noise = 1e-6\n")
        (cls.out / "arm.toml").write_text(joint)
        rows = [(i / 500, 0.3 * (1 - math.cos(math.pi * i / 500))) for i in range(2000)]
        (cls.out / "arm.csv").write_text("time,reference_position\n" + "".join(f"{t:.6g},{r:.9g}\n" for t, r in rows))
        stickslip("simulate", "arm.toml", "--reference", "arm.csv", "--set", "load.gravity_amplitude=6", "--seed", "3",
                  "-o", "arm", cwd=cls.out)
        stickslip("diagnose", "arm.toml", "arm/record.csv", "-o", "gap", cwd=cls.out)
        # the same record as that of two joints, of which one file states the weight
        (cls.out / "joints").mkdir()
        (cls.out / "joints/elbow.toml").write_text(joint)
        (cls.out / "joints/shoulder.toml").write_text(joint + "[load]\ngravity_amplitude = 6\n")
        rows = [row.split(",") for row in (cls.out / "arm/record.csv").read_text().splitlines() if not row.startswith("#")]
        rows[0] = [name if name == "time" else f"elbow_{name}" for name in rows[0]]
        names = [name.replace("elbow", "shoulder") for name in rows[0][1:]]
        (cls.out / "robot.csv").write_text("\n".join(",".join(row + (names if row is rows[0] else row[1:])) for row in rows) + "\n")
        stickslip("diagnose", "joints", "robot.csv", "--all-joints", "-o", "robot", cwd=cls.out)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def test_nothing_is_logged_and_nothing_is_asked_for(self):
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.browser.open(page)
                strangers = [url for url in self.browser.requests() if not url.startswith(("file:", "data:", "blob:"))]
                self.assertEqual(strangers, [])
                self.assertEqual(self.browser.complaints(), [])

    def test_a_policy_forbids_what_the_page_did_not_bring(self):
        self.browser.open(self.pages["linear"])
        policy = self.browser.run("return document.querySelector('meta[http-equiv=Content-Security-Policy]').content")
        self.assertTrue(policy.startswith("default-src 'none'"))
        self.assertNotIn("unsafe", policy)
        ran = self.browser.run("const s = document.createElement('script'); s.textContent = 'window.intruder = 1';"
                               "document.body.append(s); return window.intruder")
        self.assertIsNone(ran)

    def test_the_page_is_small(self):
        self.assertLess(self.pages["linear"].stat().st_size, LARGEST_PAGE)

    def test_the_first_screen_answers(self):
        self.browser.open(self.pages["linear"])
        self.assertTrue(self.browser.run("return document.querySelector('.verdict').innerText").startswith("Slides smoothly"))
        cards = self.browser.run("return document.querySelectorAll('.card').length")
        self.assertTrue(3 <= cards <= 5)
        bottom = self.browser.run("return Math.max(...[...document.querySelectorAll('.card')].map(c => c.getBoundingClientRect().bottom))")
        self.assertLess(bottom, 900)

    def test_data_behind_a_chart_are_those_of_the_file(self):
        self.browser.open(self.pages["linear"])
        field = self.browser.run_async(
            "Array.from((await unpack(JSON.parse(document.querySelector('#map-k-p-k-v script').textContent))).readings[0].values)")
        k_p, k_v, V0 = (self.results[name][:] for name in ("k_p", "k_v", "V0"))
        plane = self.results["spectral_abscissa"][:, :, numpy.argmin(abs(V0 - 1e-3))].T.ravel()
        self.assertEqual(len(field), len(k_p) * len(k_v))
        numpy.testing.assert_allclose(field, plane, rtol=FLOAT)

    def test_layers_behind_the_slider_are_those_of_the_file(self):
        self.browser.open(self.pages["linear"])
        field, velocities = self.browser.run_async(
            "{ const d = JSON.parse(document.querySelector('#map-k-p-k-v script').textContent).depth;"
            "  return [Array.from(await floats(d.field)), await doubles(d.axis.values)]; }")
        V0 = self.results["V0"][:]
        planes = [self.results["spectral_abscissa"][:, :, numpy.argmin(abs(V0 - v))].T.ravel() for v in velocities]
        self.assertGreater(len(planes), 10)
        numpy.testing.assert_allclose(field, numpy.concatenate(planes), rtol=COARSE)

    def test_small_multiples_are_those_of_the_file(self):
        self.browser.open(self.pages["linear"])
        data = self.browser.run_async(
            "{ const d = await unpack(JSON.parse(document.querySelector('#panels-k-p-k-v script').textContent));"
            "  return { field: Array.from(d.field), x: d.x.values, y: d.y.values, places: d.places.map(p => p.across) }; }")
        k_p, k_v, V0 = (self.results[name][:] for name in ("k_p", "k_v", "V0"))
        at = lambda axis, values: [int(numpy.argmin(abs(axis - v))) for v in values]
        self.assertEqual(len(data["places"]), 6)
        self.assertTrue(set(data["places"]) <= set(V0.tolist()) and 1e-3 in [float(f"{v:.9g}") for v in data["places"]])
        planes = [self.results["spectral_abscissa"][:, :, n].T[numpy.ix_(at(k_v, data["y"]), at(k_p, data["x"]))].ravel()
                  for n in at(V0, data["places"])]
        numpy.testing.assert_allclose(data["field"], numpy.concatenate(planes), rtol=COARSE)
        self.browser.run("document.querySelectorAll('#panels-k-p-k-v .reader')[5].focus({focusVisible: true})")
        self.browser.key("ArrowLeft")
        self.assertIn("V0 = 100 mm/s", self.said("return document.querySelector('#panels-k-p-k-v .tip.on').innerText"))
        self.browser.key("Enter")
        command = self.browser.run("return document.querySelector('#panels-k-p-k-v .place code').textContent")
        self.assertIn("control.V0=0.1", command)
        self.assertEqual(self.browser.complaints(), [])

    def area(self, figure):
        return self.browser.run("const e = document.querySelector(arguments[0] + ' .reader'); e.scrollIntoView({block: 'center'});"
                                "const r = e.getBoundingClientRect(); return [r.left, r.top, r.width, r.height]", figure)

    def tip(self, figure):
        return self.said("return document.querySelector(arguments[0] + ' .tip').innerText", figure)

    def said(self, script, *arguments):
        """What a script returns as words, numbers apart from their units by ordinary spaces."""
        return self.browser.run(script, *arguments).replace("\u00a0", " ")

    def test_the_pointer_reads_the_values_of_the_file(self):
        self.browser.open(self.pages["linear"])
        left, top, width, height = self.area("#map-k-p-k-v")
        shape = [self.results.dimensions[n].size for n in ("k_p", "k_v")]
        V0 = numpy.argmin(abs(self.results["V0"][:] - 1e-3))
        chance = random.Random(7)
        for _ in range(20):
            i, j = (chance.randrange(n) for n in shape)
            self.browser.move(left + width * min(0.999, i / (shape[0] - 1)), top + height * max(0.001, 1 - j / (shape[1] - 1)))
            lines = self.tip("#map-k-p-k-v").split("\n")
            abscissa = next(line for line in lines if line.startswith("max Re s"))
            said = float(abscissa.split("=")[1].split(" 1/s")[0].replace("−", "-").replace("×10", "e").translate(
                str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")))
            true = float(self.results["spectral_abscissa"][i, j, V0])
            self.assertAlmostEqual(said / true, 1, delta=6e-3, msg=f"node {i}, {j}: {lines}")

    def test_arrow_keys_read_and_enter_gives_a_command_that_runs(self):
        self.browser.open(self.pages["linear"])
        self.browser.run("document.querySelector('#map-k-p-k-v .reader').focus({focusVisible: true})")
        self.browser.key("ArrowLeft")
        before = self.tip("#map-k-p-k-v")
        self.browser.key("ArrowLeft", shift=True)
        after = self.tip("#map-k-p-k-v")
        self.assertNotEqual(before, after)
        self.browser.key("Enter")
        command = self.browser.run("return document.querySelector('#map-k-p-k-v .place code').textContent")
        words = shlex.split(command)
        self.assertEqual(words[:3], ["stickslip", "simulate", "joint.toml"])
        self.assertIn("trajectory", stickslip(*words[1:], cwd=self.out / "linear"))
        self.assertEqual(self.browser.run("return document.querySelectorAll('#map-k-p-k-v .place canvas').length"), 1)
        self.browser.key("Escape")
        self.assertFalse(self.browser.run("return document.querySelector('#map-k-p-k-v .tip').classList.contains('on')"))

    def test_the_slider_moves_the_chart(self):
        self.browser.open(self.pages["linear"])
        self.browser.run("const s = document.querySelector('#map-k-p-k-v input'); s.value = s.max; s.dispatchEvent(new Event('input'))")
        self.assertEqual(self.said("return document.querySelector('#map-k-p-k-v output').textContent"), "100 mm/s")
        left, top, width, height = self.area("#map-k-p-k-v")
        self.browser.move(left + width / 2, top + height / 2)
        self.assertIn("V0 = 100 mm/s", self.tip("#map-k-p-k-v"))
        # what is said beside the map is said of this layer, from the file, axes as drawn
        k_p, k_v, V0 = (self.results[name][:] for name in ("k_p", "k_v", "V0"))
        weights = lambda v: (lambda u: (numpy.append(u[1:], u[-1]) - numpy.insert(u[:-1], 0, u[0])) / 2 / (u[-1] - u[0]))(numpy.log(v))
        region = self.results["region"][:, :, -1]
        shares = numpy.outer(weights(k_p), weights(k_v))
        said = self.said("return document.querySelector('#map-k-p-k-v .layer-words').textContent")
        for codes, words in (((0, 1), "smooth on"), ((1, 2), "models differ on")):
            share = 100 * shares[numpy.isin(region, codes)].sum()
            self.assertAlmostEqual(float(said.split(words + " ")[1].split(" ")[0]), share, delta=0.006 * share + 0.1, msg=said)
        # a place that was chosen before the slider moves is told anew
        self.browser.run("document.querySelector('#map-k-p-k-v .reader').focus({focusVisible: true})")
        self.browser.key("Enter")
        panel = "return document.querySelector('#map-k-p-k-v .place').innerText"
        self.assertIn("control.V0=0.1 ", self.browser.run(panel))
        self.browser.run("const s = document.querySelector('#map-k-p-k-v input'); s.value = 0; s.dispatchEvent(new Event('input'))")
        self.assertIn("control.V0=0.00001 ", self.browser.run(panel).replace("1e-5", "0.00001").replace("1e-05", "0.00001"))
        self.assertEqual(self.browser.complaints(), [])

    def test_a_time_series_can_be_looked_into(self):
        self.browser.open(self.pages["motion"])
        self.browser.run("[...document.querySelectorAll('#velocity button')].find(b => b.textContent === 'Zoom in time').click()")
        self.assertGreater(self.browser.run("return document.querySelectorAll('#velocity .zoom canvas').length"), 1)
        self.assertFalse(self.browser.run("return document.querySelector('#velocity svg').getClientRects().length > 0"))
        box = self.browser.run("const e = document.querySelector('#velocity .zoom'); e.scrollIntoView({block: 'center'});"
                               "const r = e.getBoundingClientRect(); return [r.left, r.top, r.width, r.height]")
        self.assertFalse(self.browser.run("return document.querySelector('#velocity .reader').getClientRects().length > 0"))
        self.browser.move(box[0] + box[2] / 2, box[1] + box[3] / 3)
        self.assertIn("V =", self.browser.run("return document.querySelector('#velocity .zoom-values').textContent"))
        self.assertEqual(self.browser.complaints(), [])

    def test_lines_are_read_from_their_own_samples(self):
        self.browser.open(self.pages["linear"])
        samples = [line.split(",") for line in (self.out / "linear/charts/k-v-demanded.csv").read_text().splitlines()[1:]]
        left, top, width, height = self.area("#k-v-demanded")
        self.browser.move(left + width / 4, top + height / 4)
        lines = self.tip("#k-v-demanded").split("\n")
        self.assertEqual(lines[0], "velocity-only model")
        said = [float(line.split("= ")[1].split(" ")[0]) for line in lines[1:3]]
        near = min(samples, key=lambda s: abs(float(s[1]) / (said[0] * 1e-6) - 1) + (s[0] != lines[0]))
        self.assertIn("µm/s", lines[1])
        self.assertAlmostEqual(said[1] * 1e3 / float(near[2]), 1, delta=6e-3, msg=f"{lines} {near}")
        self.assertEqual(lines[3], "with memory: 0 N·s/m")
        self.browser.run("document.querySelector('#k-v-demanded .reader').focus({focusVisible: true})")
        self.browser.key("ArrowDown")
        self.assertEqual(self.tip("#k-v-demanded").split("\n")[0], "with memory")
        before = self.tip("#k-v-demanded")
        self.browser.key("ArrowRight", shift=True)
        self.assertNotEqual(self.tip("#k-v-demanded"), before)
        self.assertEqual(self.browser.complaints(), [])

    def test_the_contents_show_the_place(self):
        for page in self.pages.values():
            self.browser.open(page)
            self.browser.wait("return document.querySelector('nav [aria-current]') !== null")
            self.assertEqual(self.browser.run("return [...document.querySelectorAll('nav [aria-current]')].map(a => a.textContent)"), ["Summary"])

    def test_data_can_be_taken_home(self):
        self.browser.open(self.pages["linear"])
        for figure in self.browser.run("return [...document.querySelectorAll('figure')].map(f => f.id)"):
            for kind in ("svg", "png"):
                self.assertGreater((self.out / "linear/charts" / f"{figure}.{kind}").stat().st_size, 10_000)
            buttons = self.browser.run(f"return [...document.querySelectorAll('#{figure} button')].map(b => b.textContent)")
            numbers = (self.out / "linear/charts" / (figure + ".csv")).exists()
            self.assertEqual("Data (CSV)" in buttons, numbers, figure)
            if not numbers:
                self.assertEqual(figure, "lumped-model")  # a drawing, whose numbers stand in it
                continue
            text = self.browser.run_async(f"csv(await unpack(JSON.parse(document.querySelector('#{figure} script').textContent)))")
            kept = (self.out / "linear/charts" / (figure + ".csv")).read_text()
            self.assertEqual(text.splitlines()[0], kept.splitlines()[0])
            self.assertEqual(len(text.splitlines()), len(kept.splitlines()), figure)

    def test_two_sweeps_are_compared_on_a_page(self):
        self.browser.open(self.pages["comparison"])
        self.assertEqual(self.browser.complaints(), [])
        figures = self.browser.run("return [...document.querySelectorAll('figure')].map(f => f.id)")
        self.assertIn("change-k-p-k-v", figures)
        self.browser.run("document.querySelector('#change-k-p-k-v .reader').focus({focusVisible: true})")
        self.browser.key("ArrowLeft")
        self.assertRegex(self.tip("#change-k-p-k-v"), "^(smooth|stick-slip|became|bistable)")

    def test_the_page_reads_for_everybody(self):
        rules = (HERE / "accessibility.js").read_text()
        for name, page in self.pages.items():
            for scheme in ("light", "dark"):
                with self.subTest(page=name, scheme=scheme):
                    self.browser.open(page, scheme=scheme)
                    self.assertEqual(self.browser.run(rules), [])

    @unittest.skipUnless("AXE_CORE" in os.environ, "tests/browser/axe.sh brings axe-core and sets AXE_CORE")
    def test_axe_core_finds_nothing(self):
        axe = pathlib.Path(os.environ["AXE_CORE"]).read_text()
        for name, page in self.pages.items():
            for scheme in ("light", "dark"):
                with self.subTest(page=name, scheme=scheme):
                    self.browser.open(page, scheme=scheme)
                    self.browser.run(axe)
                    found = self.browser.run_async(
                        "(await axe.run(document, { resultTypes: ['violations'] })).violations.map(v => v.id + ': ' + v.nodes[0].html.slice(0, 120))")
                    self.assertEqual(found, [])

    def test_it_prints_on_few_sheets(self):
        """Figures of A4, two to a sheet with their captions; a page in the dark theme prints black on white, too."""
        self.browser.open(self.pages["linear"], scheme="dark")
        self.browser.cdp("Emulation.setEmulatedMedia", media="", features=[])
        paper = self.browser.cdp("Page.printToPDF", paperWidth=8.27, paperHeight=11.69, preferCSSPageSize=True, printBackground=True)
        sheets = base64.b64decode(paper["data"]).count(b"/Type /Page\n")
        figures = self.browser.run("return document.querySelectorAll('figure').length")
        self.assertLessEqual(sheets, figures / 2 + 4)

    def test_it_fits_a_phone_and_paper(self):
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.browser.open(page, width=400)
                self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 400)
                self.browser.open(page, media="print")
                seen = self.browser.run("return [...document.querySelectorAll('.reader, .tip, .slider, .tools, nav, button')]"
                                        ".filter(e => e.getClientRects().length > 0).length")
                self.assertEqual(seen, 0)

    def test_a_pair_of_names_fits_a_card_on_a_phone(self):
        self.browser.open(self.pages["linear"], width=400)
        self.browser.run("document.querySelectorAll('.card b').forEach("
                         "b => { b.textContent = 'stribeck with asymmetric-friction'; b.className = 'words'; })")
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 400)

    def test_a_picture_is_saved_with_its_text_on_request(self):
        self.browser.open(self.pages["linear"])
        said = self.browser.run("const s = withText(document.querySelector('#k-v-demanded .sheet > svg'));"
                                "return [...s.querySelectorAll('text')].map(t => t.textContent).join(' ')")
        for words in ("Velocity gain that each theory requires", "velocity-only model", "[N·s/m]", "commanded velocity"):
            self.assertIn(words, said)
        self.assertEqual(self.browser.run("return withText(document.querySelector('#k-v-demanded .sheet > svg'))"
                                          ".querySelectorAll('path[data-text]').length"), 0)

    def test_data_begin_with_a_byte_order_mark_on_request(self):
        self.browser.open(self.pages["linear"])
        first = "return csvFile(prepared[0]).charCodeAt(0)"
        self.assertNotEqual(self.browser.run(first), 0xFEFF)
        self.browser.run("document.getElementById('csv-mark').click()")
        self.assertEqual(self.browser.run(first), 0xFEFF)

    def test_a_chart_fits_a_phone_whole_and_is_enlarged_on_request(self):
        ends = ("const s = document.querySelector('.stage');"
                "return [s.classList.contains('more-before'), s.classList.contains('more-after')]")
        hint = "return document.querySelector('.fit').getClientRects().length"
        width = "return document.querySelector('.sheet > svg').getBoundingClientRect().width"
        self.browser.open(self.pages["boundary"], width=400)
        self.browser.wait("return document.querySelector('.fit').getClientRects().length")
        self.assertEqual(self.browser.run(ends), [False, False])
        self.assertLess(self.browser.run(width), 400)
        self.browser.run("document.querySelector('.fit button').click()")
        self.assertGreaterEqual(self.browser.run(width), 600)
        self.browser.wait("return document.querySelector('.stage').classList.contains('more-after')")
        self.assertEqual(self.browser.run(hint), 1)
        self.assertEqual(self.browser.run(ends), [False, True])
        self.browser.run("document.querySelector('.stage').scrollLeft = 1e4")
        self.browser.wait("return document.querySelector('.stage').classList.contains('more-before')")
        self.assertEqual(self.browser.run(ends), [True, False])
        self.browser.open(self.pages["boundary"])
        self.assertEqual(self.browser.run(ends) + [self.browser.run(hint)], [False, False, 0])

    def test_the_choices_beside_a_front_are_read_by_keys(self):
        self.browser.open(self.pages["design"])
        self.browser.run("document.querySelector('#noise-against-margin .reader').focus({focusVisible: true})")
        read = []
        for _ in range(4):
            read.append(self.tip("#noise-against-margin"))
            self.browser.key("ArrowDown")
        for name in ("best", "velocity-only model", "as in the joint"):
            self.assertTrue(any(name in text for text in read), (name, read))

    def test_numbers_never_part_from_their_units(self):
        """In all words of all pages: no ordinary space between a number and a unit, and no hyphen for a minus."""
        unit = re.compile(r"[0-9] (?:[pnµmkMG]?(?:m|N|s|Hz|rad|V|A)\b|%|1/s)")
        words = "return [...document.querySelectorAll('p, li, td, th, figcaption, .card b, .card span')].map(e => e.textContent)"
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.browser.open(page)
                for text in self.browser.run(words):
                    self.assertIsNone(unit.search(text), text)
                    self.assertIsNone(re.search(r"(?:^|[ (])-[0-9]", text), text)
                    self.assertIsNone(re.search(r"[0-9]e[-+]?[0-9]", text), text)
                    self.assertIsNone(re.search("[█▒░]", text), text)

    def test_marks_on_lines_are_samples(self):
        """Every circle in a chart stands where the numbers behind it have a sample."""
        self.browser.open(self.pages["linear"])
        for figure in ("v-min", "root-locus"):
            with self.subTest(figure=figure):
                near = self.browser.run_async(f"""{{
                  const svg = document.querySelector('#{figure} .sheet > svg'), data = await unpack(JSON.parse(document.querySelector('#{figure} script').textContent));
                  const sheet = svg.getBoundingClientRect(), [left, top, width, height] = data.area.map((v, i) => v * (i % 2 ? sheet.height : sheet.width));
                  const at = (axis, v) => Math.max(0, position(axis, v)), line = data.lines[0];
                  const places = line.x.map((x, i) => [left + width * at(data.xAxis, x), top + height * (1 - at(data.yAxis, line.y[i]))]);
                  const marks = [...svg.querySelectorAll('path[fill="#0072b2"]')].map((p) => p.getBoundingClientRect())
                    .map((r) => [r.left + r.width / 2 - sheet.left, r.top + r.height / 2 - sheet.top]);
                  return marks.filter(([x, y]) => x <= left + width && y <= top + height)
                    .map(([x, y]) => Math.min(...places.map(([a, b]) => Math.hypot(a - x, b - y)).filter(Number.isFinite))); }}""")
                self.assertGreater(len(near), 0)
                self.assertLess(max(near), 0.5)

    def test_the_root_locus_says_its_gain(self):
        self.browser.open(self.pages["linear"])
        self.browser.run("document.querySelector('#root-locus .reader').focus({focusVisible: true})")
        self.browser.key("ArrowRight")
        self.assertRegex(self.tip("#root-locus"), r"kp = [0-9.]+ [kM]?N/m")
        rows = list(csv.reader((self.out / "linear/charts/root-locus.csv").read_text().splitlines()))
        self.assertEqual(rows[0][3], "kp [N/m]")
        gains = [float(row[3]) for row in rows[1:] if row[3] != "nan"]
        self.assertTrue(0.999e3 <= min(gains) and max(gains) <= 1.001e6, (min(gains), max(gains)))
        own = [row for row in rows[1:] if row[0].startswith("the design")]
        self.assertEqual({float(row[3]) for row in own}, {6e4})
        self.assertEqual(len(own), 2 if float(own[0][2]) else 1)

    def test_a_joint_of_a_robot_leads_to_its_page(self):
        answer = json.loads((self.out / "robot/robot.json").read_text())
        self.assertEqual([joint["verdict"] for joint in answer["joints"]], ["gap", "no-gap"])
        for scheme in ("light", "dark"):
            self.browser.open(self.pages["robot"], scheme=scheme)
            said = self.browser.run("return document.querySelector('.verdict').textContent").replace("\u00a0", " ")
            self.assertIn(answer["sentence"], said)
            self.browser.run("document.querySelector('#causes tbody th a').click()")
            self.browser.wait("return document.title === 'Sim-to-real gap of elbow'")

    def test_the_slider_takes_the_words_of_the_printed_slice_away(self):
        self.browser.open(self.pages["linear"])
        shown = ("return [...document.querySelectorAll('#map-k-p-k-v svg .held')].map(e => getComputedStyle(e).opacity)")
        self.assertGreater(len(self.browser.run(shown)), 0)
        self.assertEqual(set(self.browser.run(shown)), {"1"})
        self.browser.run("const s = document.querySelector('#map-k-p-k-v input'); s.value = s.max; s.dispatchEvent(new Event('input'))")
        self.assertEqual(set(self.browser.run(shown)), {"0"})

    def test_the_surface_can_be_turned(self):
        self.browser.open(self.pages["linear"])
        name = self.browser.run("return [...document.querySelectorAll('figure')].find(f => f.querySelector('canvas.turned')).id")
        self.browser.run(f"[...document.querySelectorAll('#{name} button')].find(b => b.textContent === 'Turn it').click()")
        canvas = f"document.querySelector('#{name} canvas.turned')"
        before = self.browser.run(f"{canvas}.focus(); return {canvas}.toDataURL()")
        self.browser.key("ArrowLeft")
        self.assertNotEqual(self.browser.run(f"return {canvas}.toDataURL()"), before)
        self.assertEqual(self.browser.run("return document.documentElement.scrollWidth <= innerWidth"), True)
        self.assertEqual(self.browser.complaints(), [])

    def test_values_are_read_in_the_units_of_a_workshop_on_request(self):
        self.browser.open(self.pages["gap"])
        self.browser.run("document.querySelector('#record-1-position .reader').focus({focusVisible: true})")
        self.browser.key("ArrowRight")
        pattern = r"position = (−?[0-9.×10⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+) (\S+)"
        number, unit = re.search(pattern, self.tip("#record-1-position")).groups()
        radians = float(number.replace("−", "-")) * {"rad": 1, "mrad": 1e-3, "µrad": 1e-6}[unit]
        self.browser.run("const s = document.querySelector('#units'); s.value = 'workshop'; s.dispatchEvent(new Event('change'));"
                         "document.querySelector('#record-1-position .reader').focus({focusVisible: true})")
        self.browser.key("ArrowRight"), self.browser.key("ArrowLeft")
        number, unit = re.search(pattern, self.tip("#record-1-position")).groups()
        self.assertEqual(unit, "°")
        self.assertAlmostEqual(float(number.replace("−", "-")) / math.degrees(radians), 1, delta=0.01)

    def test_a_picture_is_saved_with_300_dots_an_inch(self):
        self.browser.open(self.pages["linear"])
        width, dots = self.browser.run_async("""{
          const svg = document.querySelector('#k-v-demanded .sheet > svg'), bytes = new Uint8Array(await (await pngOf(svg)).arrayBuffer());
          const view = new DataView(bytes.buffer), at = 33, name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
          const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
          return [image.width / Number(svg.getAttribute('width')), name === 'pHYs' ? view.getUint32(at + 8) * 0.0254 : 0]; }""")
        self.assertAlmostEqual(width, 300 / 96, delta=0.01)
        self.assertAlmostEqual(dots, 300, delta=0.1)

    def test_the_first_screen_of_a_diagnosis_can_be_acted_on(self):
        self.browser.open(self.pages["gap"], width=1400)
        verdict = self.said("return document.querySelector('.verdict').innerText")
        amplitude = float(re.search(r"amplitude ([0-9.]+) ± [^ ]+ N·m", verdict)[1])
        self.assertAlmostEqual(amplitude, 6, delta=0.05)
        for question in ("cause:", "how much:", "how sure:", "location:"):
            self.assertIn(question, self.said("return document.querySelector('.cards').innerText"))
        lines = self.browser.run("return document.querySelector('.snippet pre').textContent")
        self.assertIn("[load]", lines)
        self.assertAlmostEqual(float(re.search(r"gravity_amplitude = ([0-9.e+-]+)", lines)[1]), 6, delta=0.05)
        # the whole file is the one beside the page, and the program reads it
        whole = self.browser.run("return document.querySelector('details.snippet pre').textContent")
        self.assertEqual(whole, (self.out / "gap/corrected-joint.toml").read_text())
        stickslip("simulate", self.out / "gap/corrected-joint.toml", "--reference", self.out / "arm.csv", "-o", self.out / "again")
        buttons = self.browser.run("return [...document.querySelectorAll('.snippet button')].map(b => b.textContent)")
        self.assertEqual(buttons, ["Copy", "Copy", "Save corrected-joint.toml"])
        self.assertLess(self.browser.run("return document.querySelector('.snippet pre').getBoundingClientRect().bottom"), 900)

    def test_a_record_is_played_from_its_own_numbers(self):
        self.browser.open(self.pages["gap"])
        box = "document.querySelector('#record-played')"
        self.assertEqual(self.browser.run(f"return {box}.querySelectorAll('canvas.played').length"), 1)
        self.browser.run(f"const s = {box}.querySelector('input[type=range]'); s.value = 500; s.dispatchEvent(new Event('input'))")
        said = self.said(f"return {box}.querySelector('.layer-words').textContent")
        rows = [line.split(",") for line in (self.out / "gap/charts/record-played.csv").read_text().splitlines()[1:]]
        measured = [(float(r[1]), float(r[2])) for r in rows if r[0] == "measured"]
        self.assertGreater(len(measured), 1000)
        self.assertRegex(said, r"position \S+ [mµ]?rad; off by: simulated before \S+ [mµ]?rad, simulated after \S+ [mµ]?rad")
        before = self.browser.run(f"return {box}.querySelector('canvas.played').toDataURL()")
        self.browser.run(f"[...{box}.querySelectorAll('button')].find(b => b.textContent === 'Play').click()")
        self.browser.wait(f"return {box}.querySelector('canvas.played').toDataURL() !== {json.dumps(before)}")
        self.assertEqual(self.browser.complaints(), [])

    def test_the_next_experiment_is_a_motion_that_the_machine_has_shown_to_survive(self):
        rows = numpy.genfromtxt(self.out / "gap/next-experiment.csv", delimiter=",", names=True)
        record = numpy.genfromtxt(self.out / "arm/record.csv", delimiter=",", names=True)
        time, motion = rows["time"], rows["reference_position"]
        speed = numpy.diff(motion) / numpy.diff(time)
        seen = numpy.diff(record["reference_position"]) / numpy.diff(record["time"])
        self.assertLess(abs(speed).max(), 1.05 * abs(seen).max())
        self.assertTrue(record["position"].min() - 1e-3 < motion.min() and motion.max() < record["position"].max() + 1e-3)
        self.assertLess(abs(speed[[0, -1]]).max(), 0.02 * abs(seen).max())  # from rest to rest
        self.browser.open(self.pages["gap"])
        text = self.said("return document.querySelector('#next').innerText")
        self.assertIn("next-experiment.csv", text)
        self.assertIn("check that the machine is free", text)

    def test_it_looks_as_it_did(self):
        """The first screen, reduced to a quarter, so that letters of another version of the typeface do not matter."""
        for name in self.pages:
            for kind, settings in (("light", {}), ("dark", {"scheme": "dark"}), ("narrow", {"width": 400})):
                self.browser.open(self.pages[name], **settings)
                shot = Image.fromarray(self.browser.picture())
                small = shot.resize((shot.width // 4, shot.height // 4), Image.LANCZOS).convert("P", palette=Image.ADAPTIVE, colors=64)
                kept = HERE / "reference" / f"{name}-{kind}.png"
                if UPDATE:
                    kept.parent.mkdir(exist_ok=True)
                    small.save(kept, optimize=True)
                with self.subTest(page=name, kind=kind):
                    then, now = Image.open(kept).convert("RGB"), small.convert("RGB")
                    self.assertEqual(then.size, now.size)
                    size = (then.width // 4, then.height // 4)
                    a, b = (numpy.asarray(i.resize(size, Image.BOX), dtype=float) for i in (then, now))
                    self.assertLess(numpy.mean(abs(a - b)), 6, "mean difference of 255")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + [a for a in sys.argv[2:] if a != "--update"], verbosity=1)
