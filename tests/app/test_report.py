"""The report: one page that needs nothing else, with the numbers of the questions, readable by machines and people."""

from __future__ import annotations

import base64
import functools
import html
import itertools
import re
import shutil
import subprocess
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from slowflow import Isolator
from slowflow.answers import files
from slowflow.answers.results import Remark
from slowflow.app import cli, scenes
from tests.files import ROOT, Lazily

pieces, report = map(Lazily, ("slowflow.answers.page", "slowflow.app.report"))

MOUNT = ROOT / "scenes" / "mount.toml"


class Page(HTMLParser):
    """Tags with their attributes in order, and the text of each table's cells."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags, self.open, self.cells, self.inside = [], [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in {"meta"}:
            self.open.append(tag)
        if tag in {"td", "th", "caption"}:
            self.cells.append("")
        self.inside = tag

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data):
        if {"td", "th", "caption"} & set(self.open):
            self.cells[-1] += data

    def handle_endtag(self, tag):
        assert self.open.pop() == tag
        self.inside = ""

    def every(self, tag):
        return [attrs for name, attrs in self.tags if name == tag]


@pytest.fixture(autouse=True, scope="module")
def with_matplotlib():
    pytest.importorskip("matplotlib")


@pytest.fixture(scope="module")
def text():
    return report.html(scenes.read(MOUNT))


@pytest.fixture(scope="module")
def page(text):
    return Page(text)


@pytest.mark.slow
def test_the_page_is_well_formed_and_needs_no_network(page, text):
    assert not page.open and text.startswith("<!DOCTYPE html>")
    for _, attributes in page.tags:
        for name in ("src", "href", "xlink:href"):
            assert attributes.get(name, "#").startswith(("#", "data:")), attributes
    assert not re.search(r"@import|url\((?!#)|<script|<link", text)


@pytest.mark.slow
def test_headings_pictures_and_tables_can_be_read_aloud(page):
    levels = [int(tag[1]) for tag, _ in page.tags if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1 and levels.count(1) == 1 and set(levels) == {1, 2}
    assert page.every("html") == [{"lang": "en"}] and len(page.every("title")) >= 1 and len(page.every("main")) == 1
    drawings = page.every("svg")
    assert len(drawings) == 6 and all(one["role"] == "img" and len(one["aria-label"]) > 30 for one in drawings)
    assert len(page.every("caption")) == len(page.every("table"))
    assert all(one["scope"] == "col" for one in page.every("th"))
    # what is scrolled can be reached by keys, and says what it is
    regions = [one for one in page.every("div") if one.get("class") == "wide"]
    assert len(regions) == len(page.every("table"))
    assert all(one["role"] == "region" and one["tabindex"] == "0" and one["aria-label"] for one in regions)
    headings = {one["id"] for one in page.every("h2")}
    assert {one["aria-labelledby"] for one in page.every("section")} == headings
    assert {one["href"].removeprefix("#") for one in page.every("a") if one["href"].startswith("#")} == headings
    names = [attributes["id"] for _, attributes in page.tags if "id" in attributes]
    assert len(names) == len(set(names))


def test_text_has_enough_contrast_on_both_grounds():
    """WCAG 2: 4.5 for text, 3 for lines, light and dark."""

    def luminance(colour):
        channels = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in channels]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    def contrast(one, other):
        high, low = sorted((luminance(one), luminance(other)), reverse=True)
        return (high + 0.05) / (low + 0.05)

    themes = re.findall(r"--text: (#\w+); --ground: (#\w+); --line: (#\w+); --head: (#\w+)", pieces.STYLE)
    assert len(themes) == 2
    for text, ground, line, head in themes:
        assert contrast(text, ground) > 7 and contrast(text, head) > 7 and contrast(line, ground) > 3


@pytest.mark.slow
def test_numbers_are_those_of_the_questions(page):
    mount = scenes.read(MOUNT).oscillator
    cells = page.cells
    assert f"{mount.saddle_node_onset().F_SN:.4g}" in cells and f"{1e3 * mount.at_rest().x_cr:.4g}" in cells
    for fold in mount.saddle_nodes(5):
        at = cells.index(f"{fold.f:.5g}")
        assert cells[at - 2 : at] == ["5", fold.kind]
    (up, down) = mount.saddle_nodes(5).answer.measure()
    assert f"{up.Omega * mount.scales.sizes['frequency']:.5g}" in cells and f"{100 * down.error:+.2g} %" in cells
    assert "Tolerances at F = 5 N" in cells and "resultant for Fcr" in cells
    # and what is said twice is said in one unit
    assert all(cells[k + 1] == "mm" for k, cell in enumerate(cells) if cell == "Apeak")
    assert cells[cells.index("Apeak") + 2] == f"{1e3 * mount.peak(3).A:.4g}"


@pytest.mark.slow
def test_names_and_equations_are_typeset(text, page):
    """Letters with what stands below them, in words and in MathML; nothing has an underscore, or a power of Python."""
    read = re.sub(r"<(style|svg|title|a)\b.*?</\1>|<[^>]+>", " ", text, flags=re.DOTALL)
    assert not re.search(r"\w_\w|\*\*|\b(Omega|delta|zeta|lam)\b", html.unescape(read))
    formulas = page.every("math")
    assert len(formulas) > 15 and "<code" not in text
    heads = [cell for cell in page.cells if cell.startswith("margin to")]
    assert "margin to jumps" in heads and "margin to detachment" in heads


def test_paper_is_white_whatever_the_screen_is():
    assert "@media screen and (prefers-color-scheme: dark)" in pieces.STYLE
    assert re.search(r"@media print \{ :root \{ color-scheme: light; \}", pieces.STYLE)


@pytest.mark.slow
def test_data_on_the_page_is_what_run_writes(page, tmp_path):
    links = {one["download"]: one["href"] for one in page.every("a") if "download" in one}
    assert cli.main(["run", str(MOUNT), "-o", str(tmp_path), "--quiet"]) == 0
    csv_text = base64.b64decode(links["saddle_nodes.csv"].partition("base64,")[2]).decode()
    assert csv_text == (tmp_path / "saddle_nodes.csv").read_text()
    assert base64.b64decode(links["mount.toml"].partition("base64,")[2]).decode() == MOUNT.read_text()


@pytest.mark.slow
def test_lengths_with_tolerances_are_in_millimetres(text):
    """Their table is no answer in units, but prints lengths in millimetres."""
    tables = text.partition('<h2 id="tolerances"')[2].partition("<h2")[0]
    assert "<td>mm</td>" in tables and "<td>m</td>" not in tables
    stated = scenes.read(MOUNT).content["tolerances"]
    shown = {name: float(percent) for name, percent in re.findall(r"(\w+)(?:</\w+>)? within ([\d.]+) %", tables)}
    assert sorted(shown.values()) == pytest.approx(sorted(100 * percent for percent in stated.values()))


@pytest.mark.slow
def test_jumps_of_three_depths_share_a_unit_and_show_the_error(text):
    table = text.partition("<caption>Jump frequencies by averaging")[2].partition("</table>")[0]
    rows = [re.findall(r"<td>(.*?)</td>", row) for row in table.split("<tr>")[2:]]
    assert len(rows) == 4
    for _, _, averaged, second, exact, error in rows:
        one, two, three = map(float, (averaged, second, exact))
        assert two == pytest.approx(three, rel=2e-4)
        assert float(error.removesuffix(" %")) == pytest.approx(100 * (one / three - 1), abs=5e-3)


@pytest.mark.slow
def test_the_page_says_in_short_what_happens_at_each_force(text):
    items = re.findall(r"<li>(At .*?)</li>", text.replace("\xa0", " "))
    assert items == [
        "At 3 N the isolator jumps up at 2.12 Hz and down at 2.128 Hz. Its springs stay attached up to 4.078 N. "
        "Its peak amplitude is 26.97 mm, at 2.121 Hz. Above 2.852 Hz its transmissibility is below 0 dB. "
        "At 5 Hz its transmissibility is -11.37 dB.",
        "At 5 N the isolator jumps up at 2.182 Hz and down at 2.275 Hz. Its springs detach. "
        "Its peak amplitude is 45.53 mm, at 2.265 Hz. Above 2.853 Hz its transmissibility is below 0 dB. "
        "At 5 Hz its transmissibility is -12.8 dB.",
    ]


@pytest.mark.slow
@pytest.mark.parametrize("scene", sorted((ROOT / "scenes").glob("*.toml")), ids=lambda path: path.stem)
def test_axe_finds_nothing_on_the_page(scene, tmp_path):
    """Deque's checker in a headless browser; both are found where a developer has them: `npm install axe-core`."""
    axe, browser = ROOT / "node_modules" / "axe-core" / "axe.min.js", shutil.which("chromium") or shutil.which("chrome")
    if not axe.exists() or browser is None:
        pytest.skip("axe-core in node_modules, or chromium, is not there")
    script = "addEventListener('load', () => axe.run().then(found => { document.title = 'axe:' + JSON.stringify("
    script += "found.violations.map(one => [one.id, one.nodes[0].html])) + ':' + found.passes.length }))"
    scripts = f"<script>{axe.read_text().replace('</script>', '')}</script><script>{script}</script>"
    page = tmp_path / "page.html"
    page.write_text(report.html(scenes.read(scene)).replace("</body>", scripts + "</body>"))
    for scheme, width in itertools.product((0, 1), (1100, 390)):
        options = ["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=60000", "--dump-dom"]
        options += [f"--blink-settings=preferredColorScheme={scheme}", f"--window-size={width},900"]
        done = subprocess.run([browser, *options, page.as_uri()], capture_output=True, text=True, check=True)
        ((found, passed),) = re.findall(r"<title>axe:(.*?):(\d+)</title>", done.stdout)
        assert found == "[]" and int(passed) > 30


@pytest.mark.slow
def test_the_same_scene_gives_the_same_page(text):
    assert report.html(scenes.read(MOUNT)) == text


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["table_1", "frictionless", "quasi_zero", "coulomb", "shock", "machine", "shaking_floor"]
)
@pytest.mark.part(3)
def test_other_scenes_have_a_report_too(name, tmp_path, capsys):
    out = tmp_path / "page.html"
    assert cli.main(["report", str(ROOT / "scenes" / f"{name}.toml"), "-o", str(out)]) == 0
    assert capsys.readouterr().err.endswith(f"{out} is written\n") and not Page(out.read_text()).open
    assert ("Displacements are relative to the base" in out.read_text()) == (name == "shaking_floor")


def lines_of(path):
    """What is read on the page of a scene, line by line, but for its drawings."""
    text = re.sub(r"<(style|svg).*?</\1>", "", report.html(scenes.read(path)), flags=re.DOTALL)
    return [html.unescape(line).replace("\xa0", " ") for line in re.sub(r"<[^>]+>", "\n", text).splitlines() if line]


@pytest.mark.slow
def test_what_is_undecided_of_isolation_is_said_in_short_too(monkeypatch):
    plain, ask = " ".join(report.Report(scenes.read(MOUNT)).in_short(5.0)), Isolator.isolation

    @functools.wraps(ask)
    def undecided(*at, **arguments):
        return replace(ask(*at, **arguments), remarks=Remark.UNDECIDED)

    monkeypatch.setattr(Isolator, "isolation", undecided)
    expected = plain.replace("is below 0 dB.", "is below 0 dB, as far as resolved.")
    assert " ".join(report.Report(scenes.read(MOUNT)).in_short(5.0)) == expected != plain


@pytest.mark.slow
@pytest.mark.parametrize(
    "design, F",
    [
        ("[spring]\nm = 12.0\nk_1 = 2000.0\nk_3 = 3e6\nzeta = 0.03\nfriction = 3.0\n[ask]\nF", 10.0),
        ("[duffing]\nalpha = 1.0\nbeta = 1.0\nzeta = 0.03\nmu = 0.02\n[ask]\nF_0", 0.2),
    ],
)
def test_report_of_a_spring_is_without_rods(design, F, tmp_path):
    path = tmp_path / "spring.toml"
    files.write(path, f'{design} = [{F}]\nquestions = ["saddle_nodes", "peak"]\n')
    scene, lines = scenes.read(path), lines_of(path)
    folds = scene.oscillator.saddle_nodes(F)
    up, down = (f"{one.f:.4g}\xa0Hz" if F > 1 else f"Omega = {one.Omega:.4g}" for one in folds)
    summary = " ".join(report.Report(scene).in_short(F))
    assert f"the isolator jumps up at {up} and down at {down}. Its peak amplitude is" in summary
    assert any(line.startswith("Lowest force with jumps, over") for line in lines)
    assert not any(re.search("detach the|detaches the|such isolators|Krishna|Left out: a map", line) for line in lines)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["mount", "table_1"])
def test_a_report_asks_each_question_once_and_none_that_was_run(name, monkeypatch, tmp_path):
    """Counted at the scene's methods, for run and report together."""
    queries, method = [], scenes.Scene._method

    def counted(scene, question):
        ask = method(scene, question)
        return lambda **arguments: queries.append((question, repr(sorted(arguments.items())))) or ask(**arguments)

    monkeypatch.setattr(scenes.Scene, "_method", counted)
    path, out = ROOT / "scenes" / f"{name}.toml", tmp_path / "report.html"
    command = ["run", str(path), "--quiet", "-o", str(tmp_path / "out"), "--report", str(out)]
    assert cli.main(command) == 0 and not Page(out.read_text()).open
    assert len(queries) == len(set(queries)) > len(scenes.read(path).queries)
    assert out.read_text() == report.html(scenes.read(path))  # the page of a report by itself


@pytest.mark.slow
def test_report_under_a_load_leaves_out_centred_questions(tmp_path):
    path = tmp_path / "scene.toml"
    text = (ROOT / "scenes" / "off_centre.toml").read_text().replace("[3.0, 5.0]", "[3.0]").replace("[2.2, 5.0]", "2.2")
    files.write(path, text)
    mount, lines = scenes.read(path).oscillator, lines_of(path)
    up, down = mount.saddle_nodes(3.0)
    peak, begins = mount.peak(3.0), mount.isolation(3.0)
    expected = (
        f"At 3 N the isolator jumps up at {up.f:.4g} Hz and down at {down.f:.4g} Hz. Its springs stay attached "
        f"up to {mount.detachment().F_cr:.4g} N. Its peak amplitude is {1e3 * peak.A:.4g} mm, at {peak.f:.4g} Hz. "
        f"Above {begins.f:.4g} Hz its transmissibility is below 0 dB. "
        f"At 2.2 Hz its transmissibility is {mount.amplitudes(f=2.2, F=3.0).transmissibility_dB[0]:.4g} dB."
    )
    assert expected in lines and f"{1e3 * peak.x_max:.4g}" in lines
    assert f"{1e3 * mount.rest().x[0]:.4g}" in lines and f"{mount.saddle_node_onset().F_SN:.4g}" in lines
    assert any(line.startswith("Left out: a map of designs under a load") for line in lines)
    # the largest displacement of both is compared, the mean included
    (state,) = mount.amplitudes(f=2.2, F=3.0)
    largest = (1e3 * (state.A + abs(state.B)), 1e3 * mount.steady_state(f=2.2, F=3.0).A)
    at = lines.index(f"{largest[0]:.5g}")
    assert lines[at + 1] == f"{largest[1]:.5g}" and "error of averaging" in lines


@pytest.mark.slow
def test_report_with_other_laws_leaves_out_plain_questions(tmp_path):
    lines = lines_of(ROOT / "scenes" / "rubber.toml")
    assert any(line.startswith("Lowest force with jumps, over") for line in lines)
    assert any(line.startswith("Left out: second approximation is not available with η = 0.01, ") for line in lines)
    assert any(line.startswith("At 5 N the isolator jumps up at 2.183 Hz") for line in lines)


@pytest.mark.slow
def test_shocks_say_which_are_beyond_the_stroke_and_are_in_short():
    lines = lines_of(ROOT / "scenes" / "shock.toml")
    mount = scenes.read(ROOT / "scenes" / "shock.toml").oscillator
    found = [
        mount.transient(acceleration=a, duration=d) for a in (10, 30) for d in (0.005, 0.011, 0.025, 0.05, 0.1, 0.2)
    ]
    leave = [one.A > one.x_cr for one in found]
    assert f"In {sum(leave)} of 12 shocks the springs detach." in lines
    assert [one.detaches for one in found] == leave
    begin = lines.index("acceleration of the pulse / (m/s²)")
    assert f"the springs detach at {1e3 * found[0].x_cr:.4g} mm" in lines[begin - 1]
    first = lines.index("10", begin)
    rows = [lines[first + 7 * k : first + 7 * k + 7] for k in range(12)]
    assert lines[begin + 1] == "duration of the pulse / ms" and rows[1][:3] == ["10", "11", f"{1e3 * found[1].A:.4g}"]
    assert [row[4] for row in rows] == ["yes" if one else "no" for one in leave]
    # 100 and 200 ms at 30 m/s^2 go beyond the rod: said of these only
    (remark,) = [line for line in lines if "the push-rod stands vertical" in line]
    assert remark.startswith("At acceleration = 30 m/s² and duration = 100 ms, ")


def test_letters_units_and_minus_signs_are_typeset():
    assert pieces.inline("friction is near pi/4, of dF/dOmega") == "friction is near π/4, of dF/dΩ"
    assert pieces.inline("43.9 m/s^2, k u^3, (friction/(m A omega^2) >= 0.7)") == (
        "43.9 m/s², k u³, (friction/(m A ω²) ≥ 0.7)"
    )
    # a letter and its unit stay on one line, and a unit of two is in brackets
    assert pieces.term("U", "kg m").endswith("<i>U</i>\xa0/\xa0(kg\xa0m)")
    assert pieces.term("acceleration", "m/s^2").endswith("\xa0/\xa0(m/s²)")
    assert pieces.formula(["<mn>1</mn><mo>-</mo><mi>u</mi>"], "").endswith("<mo>\u2212</mo><mi>u</mi></math>")


@pytest.mark.slow
def test_report_of_a_machine_has_no_raw_letters_or_powers():
    path = ROOT / "scenes" / "machine.toml"
    lines = lines_of(path)
    assert not [line for line in lines if re.search(r"\bpi\b|dOmega|\de-\d", line)]
    # at 25 Hz averaging is off by less than what five digits show
    exact = scenes.read(path).oscillator
    averaged = exact.amplitudes(f=25.0, U=0.03).A[0]
    assert abs(averaged / exact.steady_state(f=25.0, U=0.03, A=averaged).A - 1) < 1e-5
    assert lines[lines.index("2.5163") + 2] == "below 0.001 %"


@pytest.mark.slow
def test_a_page_is_named_in_words(tmp_path):
    path = tmp_path / "a_mount.toml"
    files.write(path, (ROOT / "scenes" / "shock.toml").read_text())
    assert "<h1>Vibration isolator: a mount</h1>" in report.html(scenes.read(path))


@pytest.mark.slow
def test_what_has_no_number_has_no_empty_table():
    lines = lines_of(ROOT / "scenes" / "coulomb.toml")
    at = lines.index("Peak of the response curve")  # at 0.4 N it sticks, at 0.6 N it has no bound
    assert lines[at + 1].startswith("sticks: F = 0.4 N")
    at = lines.index("Lowest force with jumps")
    assert lines[at + 1].startswith("no lowest forcing")
    assert any(line.startswith("Left out: a map of designs, none of which has") for line in lines)
    assert not any(".validity" in line for line in lines)


def test_what_has_no_report_is_said(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    text = MOUNT.read_text().partition("questions")[0]
    files.write(path, re.sub("(?m)^F = .*$", "", text) + 'questions = ["detachment"]\n')
    assert cli.main(["report", str(path)]) == 2 and "needs forcings" in capsys.readouterr().err
