"""The explorer in headless Chromium: its numbers against the package's, and what a visitor does with it.

In:  docs/explorer.html as it is committed.
Out: verdicts; without Playwright or Chromium what needs them is skipped with a word.
"""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import io
import re
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from explorer.__main__ import HERE, MOST, PAGE, ROOT, digest
from explorer.about import EXCITED_BY, LIBRARY, MOUNT, MOUNT_FORCE, PRESETS, designs, messages
from slowflow import Duffing, Isolator, Remark, derive, example
from slowflow.oscillators.oscillator import Oscillator
from slowflow_kernels.table_1 import TABLE_1

ASK = """([name, numbers, F_0, excitation]) => {
  const { solvers } = explorer.app, plain = (one) => Object.fromEntries(Object.entries(one).map(
    ([key, value]) => [key, ArrayBuffer.isView(value) ? Array.from(value) : value]));
  const breaks = solvers.choose(name, numbers, excitation);
  const found = { onset: solvers.onset(), off: solvers.detachment(), peak: solvers.peak(F_0),
                  folds: plain(solvers.folds(F_0)), curve: plain(solvers.respond(F_0, 0, 2, 300)),
                  states: [0.3, 0.7, 0.9, 1.5].map((Omega) => plain(solvers.states(F_0, Omega))) };
  const mu = numbers[numbers.length - 2];
  found.errors = found.curve.Omega.map(
    (Omega, i) => explorer.errorsOf(name, excitation, breaks, mu, F_0, Omega, found.curve.A[i]));
  explorer.app.dirty = true;
  return found;
}"""


#: an address of the paper's isolator
PAPER = "&".join(("#mechanism=rod_spring&F_0=0.04", *(f"{name}={value!r}" for name, value in TABLE_1.items())))
#: the mount's place among the designs of the page: the last
LAST = len(PRESETS) + len(LIBRARY)


def cases() -> list[tuple[Oscillator, float]]:
    """The package's oscillators at forcings at which something changes, or with extreme numbers."""
    return [
        *((one, F_0) for _, one, F_0, _ in PRESETS),
        *((example.isolator(), F_0) for F_0 in (0.0153, 0.0217, 0.0218, 0.03, 0.0301, 0.3)),
        (example.isolator(mu=0.0, zeta=0.0), 0.02),
        (example.isolator(zeta=0.0), 0.04),
        (example.isolator(r=3.0, delta_h=0.2), 0.05),
        (Isolator(lam=3, r=1e-6, delta_h=1e-6, mu=1e-9, zeta=1e-9), 1e-8),
        (Isolator(lam=300, r=50.0, delta_h=0.9, mu=0.5, zeta=3.0), 10.0),
        (Duffing(alpha=-1.0, beta=1.0, mu=0.01, zeta=0.05), 0.2),
        (Duffing(alpha=1.0, beta=1e6, mu=0.0, zeta=1e-4), 1e-3),
        (Duffing(alpha=1.0, beta=-1.0, mu=0.0, zeta=0.01), 0.008),
        (Duffing(alpha=1.0, beta=0.3, mu=0.02, zeta=0.05, excitation="base"), 0.1),
        (example.isolator(force="untruncated", mu=0.0, zeta=0.01, excitation="unbalance"), 0.3),
    ]


@contextlib.contextmanager
def opened(browser: Any, address: str = PAPER, **about: Any) -> Iterator[Any]:
    """The page, ready, by default at the paper's isolator; any error, warning or request of it fails the test."""
    page = browser.new_page(**about)
    complaints: list[str] = []
    page.on(
        "console", lambda message: complaints.append(message.text) if message.type in ("error", "warning") else None
    )
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("request", lambda request: complaints.append(request.url) if not _is_own(request.url) else None)
    page.goto(PAGE.as_uri() + address)
    page.wait_for_selector("body[data-ready]")
    yield page
    page.close()
    assert complaints == []


def _is_own(url: str) -> bool:
    return url.startswith((PAGE.as_uri(), "blob:", "data:"))


def test_the_page_was_made_from_these_sources_and_is_small() -> None:
    text = PAGE.read_text()
    assert f'"digest":"{digest()}"' in text, "docs/explorer.html was made from other sources: make explorer"
    assert len(text.encode()) < MOST
    # the name of SVG is an address that nobody asks
    assert set(re.findall(r"https?://[^\s\"'<]+", text)) <= {"http://www.w3.org/2000/svg"}


#: letters that a mount in SI units does not have: those of (4) that are measured in something, and of displacements
DIMENSIONLESS = re.compile(
    r"(?<![A-Za-z_])(?:mu|Omega|F_0|tau|u|u_0|u_cr|u<sub>cr</sub>|lam|delta_h)(?![A-Za-z_])|[μΩ]"
)
#: whichever of its words a script shows
MESSAGE_NAMES = re.compile(r"(?:words|wordsIn\(state\))\.([A-Z_]+)")


def test_words_in_si_units_have_no_dimensionless_letters() -> None:
    shown = {name for script in HERE.glob("*.js") for name in MESSAGE_NAMES.findall(script.read_text())}
    assert {"BEYOND_REACH", "NEAR_STICKING_BELOW", "STICKS", "STOPS"} <= shown
    texts = messages()
    assert set(texts["si"]) == set(EXCITED_BY) and [
        name for name in shown if DIMENSIONLESS.search(texts["plain"][name])
    ]
    for excitation, letter in {"force": "F", "base": "Y", "acceleration": "a", "unbalance": "U"}.items():
        in_si = {name: texts["si"][excitation][name] for name in shown}
        assert {name: text for name, text in in_si.items() if DIMENSIONLESS.search(text)} == {}
        assert in_si["STICKS"].startswith(f"sticks: {letter} = ")
        # no number is put in yet, of whatever size
        fields = [(re.findall(r"\{.*?\}", texts["plain"][name]), re.findall(r"\{.*?\}", in_si[name])) for name in shown]
        assert all(plain == si for plain, si in fields)
        # attributes of Python's answers are none of the page's
        assert not [text for text in in_si.values() if ".validity" in text]


def test_fixed_text_of_the_page_has_no_letters_and_no_force() -> None:
    """What is excited by a base has no force, and letters are those of the units that are shown."""
    left_out = r"<(script|style).*?</\1>|<p class=.note.*?</p>|<footer.*?</footer>|<[^>]*>"
    fixed = re.sub(left_out, " ", (HERE / "page.html").read_text(), flags=re.DOTALL)
    assert not DIMENSIONLESS.search(fixed)
    assert re.findall("force", fixed.replace("Force over displacement", ""), re.IGNORECASE) == []


@pytest.mark.slow
def test_the_page_is_made_again_byte_for_byte() -> None:
    if importlib.util.find_spec("ziglang") is None:
        pytest.skip("no ziglang here: the solvers are not compiled to WebAssembly")
    done = subprocess.run([sys.executable, "-m", "explorer", "--check"], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.slow
def test_its_numbers_are_those_of_the_package(browser: Any) -> None:
    hold(browser, [(one.model.mechanism.name, one, F_0) for one, F_0 in cases()])


@pytest.mark.slow
def test_library_numbers_are_those_derived_and_compiled(browser: Any) -> None:
    pytest.importorskip("flint", reason="what derives is not installed")
    found = [one for one in designs() if one.oscillator.model.mechanism.name != one.mechanism]
    stated = importlib.import_module("slowflow.derivation.library")
    assert {one.mechanism for one in found} == set(stated.names())
    found = [one for one in found if one.oscillator.model.mechanism.odd]
    hold(browser, [(one.mechanism, one.oscillator, part * one.F_0) for one in found for part in (1, 0.5, 10)])
    same_curve(browser, len(PRESETS) + 2)


#: stiffness of the stop, gap, mu, zeta, F_0: free at rest, pressed on, just touching; with one state and with three
STOPS = (
    (8.0, 0.2, 0.005, 0.03, 0.05),
    (8.0, -0.1, 0.005, 0.03, 0.05),
    (100.0, 0.05, 0.002, 0.05, 0.03),
    (0.5, 0.2, 0.0, 0.05, 0.05),
    (3.0, 0.0, 0.002, 0.05, 0.03),
    (0.6, -0.45, 0.0, 0.014, 0.13),
)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:overflow encountered")
def test_one_sided_stop_has_the_answers_of_the_search(browser: Any) -> None:
    """Two methods: along the balance by the compiled solvers here, boxes in A and B there."""
    pytest.importorskip("flint", reason="what derives is not installed")
    stop = derive.library("one_sided_stop")
    near = {"rtol": 1e-12, "atol": 1e-300}
    with opened(browser) as page:
        for kappa, delta, mu, zeta, F_0 in STOPS:
            one = stop(kappa=kappa, delta=delta, mu=mu, zeta=zeta)
            found = page.evaluate(ASK, ["one_sided_stop", [kappa, delta, mu, zeta], F_0, "force"])
            onset, off, folds = one.saddle_node_onset(), one.detachment(), one.saddle_nodes(F_0)
            assert (found["onset"]["status"] == 0) == (onset.F_SN is not None), one
            if onset.F_SN is not None:
                mine = [found["onset"][name] for name in ("F_SN", "Omega", "A")]
                # an amplitude is the less certain where the forcing hardly moves with it
                np.testing.assert_allclose(mine, [onset.F_SN, onset.Omega, onset.A], rtol=1e-6)
                np.testing.assert_allclose(mine[0], onset.F_SN, **near)
            if off.F_cr is not None:
                np.testing.assert_allclose(
                    [found["off"][name] for name in ("F_cr", "Omega")], [off.F_cr, off.Omega_cr], **near
                )
            np.testing.assert_allclose(found["peak"]["A"], one.peak(F_0).A, **near)
            for name in ("Omega", "A"):
                np.testing.assert_allclose(found["folds"][name], getattr(folds, name), **near)
            for Omega, states in zip((0.3, 0.7, 0.9, 1.5), found["states"], strict=True):
                theirs = one.amplitudes(Omega=Omega, F_0=F_0)
                assert states["stable"] == theirs.stable.tolist(), one
                for name, values in {"A": theirs.A, "phi": theirs.phi, "T": theirs.transmissibility}.items():
                    np.testing.assert_allclose(states[name], values, **near)
                np.testing.assert_allclose(states["B"], theirs.B, rtol=1e-12, atol=1e-13)
    with opened(browser) as page:
        page.select_option("#mechanism", "one_sided_stop")
        page.evaluate("explorer.step(16)")
        lines = page.evaluate("explorer.inPython(explorer.app.state)")
        about = page.inner_text("#states")
        assert page.locator("#excitation option[disabled]").count() == 2 and "about" in about
    names: dict[str, Any] = {}
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(lines, names)
    assert "jump-up" in printed.getvalue() and len(names["curve"]) > 800


def hold(browser: Any, cases: list[tuple[str, Oscillator, float]]) -> None:
    """Compare the page's numbers of a mechanism with those of an oscillator."""
    with opened(browser) as page:
        for name, one, F_0 in cases:
            numbers = [*one.model.design, one.mu, one.zeta]
            found = page.evaluate(ASK, [name, numbers, F_0, one.excitation])
            case = f"{one!r} at {F_0}"
            onset, off, peak = one.saddle_node_onset(), one.detachment(), one.peak(F_0)
            assert (found["onset"]["status"] == 0) == (onset.F_SN is not None), case
            if onset.F_SN is not None:
                assert [found["onset"][name] for name in ("F_SN", "Omega", "A")] == [onset.F_SN, onset.Omega, onset.A]
            if off.F_cr is not None:
                assert [found["off"][name] for name in ("F_cr", "Omega", "u_cr")] == [off.F_cr, off.Omega_cr, off.u_cr]
            if peak.A is not None:
                assert [found["peak"][name] for name in ("A", "Omega")] == [peak.A, peak.Omega], case
            folds, curve = one.saddle_nodes(F_0), one.frequency_response(F_0, samples=300)
            assert found["folds"]["Omega"] == folds.Omega.tolist() and found["folds"]["A"] == folds.A.tolist(), case
            for Omega, states in zip((0.3, 0.7, 0.9, 1.5), found["states"], strict=True):
                theirs = one.amplitudes(Omega=Omega, F_0=F_0)
                # of a mass that friction holds the page has no state, but words
                slips = theirs.A > 0
                assert states["A"] == theirs.A[slips].tolist(), case
                for name, values in {"phi": theirs.phi[slips], "T": theirs.transmissibility[slips]}.items():
                    np.testing.assert_array_max_ulp(np.array(states[name], float), values, maxulp=2)
            assert found["curve"]["branch"] == curve.branch.tolist(), case
            assert np.array(found["curve"]["stable"], bool).tolist() == curve.stable.tolist(), case
            assert any(found["curve"]["beyond"]) == (Remark.BEYOND_WELL in curve.remarks), case
            # between folds and peaks points lie where cos() of the C library puts them, which is not the same; Omega
            # moves with A as the curve is steep
            mine = {name: np.array(found["curve"][name], float) for name in ("A", "Omega")}
            np.testing.assert_array_max_ulp(mine["A"], curve.A, maxulp=8)
            if curve.A.size:
                spacings = {
                    name: np.abs(np.gradient(values)) for name, values in (("A", curve.A), ("Omega", curve.Omega))
                }
                most = np.spacing(curve.Omega) * spacings["A"] + np.spacing(curve.A) * spacings["Omega"]
                assert (np.abs(mine["Omega"] - curve.Omega) * spacings["A"] <= 8 * most).all(), case
            if curve.A.size and found["errors"][0] is not None:
                validity = curve.validity
                assert [error["error"] for error in found["errors"]] == validity.error.tolist(), case
                truncation = [error["truncation"] for error in found["errors"]]
                np.testing.assert_allclose(truncation, validity.truncation, rtol=1e-12, atol=1e-18)


@pytest.mark.slow
def test_it_compares_itself_and_measures_its_frames(browser: Any) -> None:
    with opened(browser) as page:
        page.click("#check")
        page.wait_for_selector("#check-result:not(:empty)")
        result = re.match(
            r"(\d+) of (\d+) numbers equal .* Drawing all plots takes [\d.]+ ms", page.inner_text("#check-result")
        )
        assert result and result[1] == result[2] and int(result[1]) > 50


@pytest.mark.slow
def test_dragging_the_force_passes_sticking_onset_and_detachment(browser: Any) -> None:
    with opened(browser) as page:
        box = page.locator("#range-F_0").bounding_box()
        page.mouse.move(box["x"] + 1, box["y"] + box["height"] / 2)
        page.mouse.down()
        cards = set()
        for k in range(41):
            page.mouse.move(box["x"] + box["width"] * k / 40, box["y"] + box["height"] / 2)
            page.evaluate("explorer.step(16)")
            cards.add(page.locator(".card.passed").count())
            sticks = "Sticks" in page.inner_text("#remarks")
            assert sticks == (float(page.input_value("#number-F_0")) <= example.isolator().sticking_forcing)
        page.mouse.up()
        assert {0, 1, 2} <= cards


@pytest.mark.slow
def test_a_sweep_jumps_where_the_fold_is(browser: Any) -> None:
    folds = example.isolator().saddle_nodes(F_0=0.04)
    with opened(browser) as page:
        for button, kind in (("#sweep-up", "jump-down"), ("#sweep-down", "jump-up")):
            page.click(button)
            page.evaluate("() => { for (let k = 0; k < 160; k++) explorer.step(80) }")
            at = float(re.search(r"at Ω = ([\d.]+)", page.inner_text("#events"))[1])  # type: ignore[index]
            (fold,) = folds.Omega[folds.kind == kind]
            # a frame of 80 ms moves by 0.0114, in 24 steps
            assert abs(at - fold) < 0.0006


FILL = """() => {
  for (const field of document.querySelectorAll("#fields input[type=text]")) {
    const kept = field.value;
    for (const text of ["0", "1e-300", "1e300", "-1", "nonsense", kept]) {
      field.value = text;
      field.dispatchEvent(new Event("input"));
      explorer.step(16);
    }
  }
}"""


@pytest.mark.slow
def test_extreme_numbers_are_shown_without_a_complaint(browser: Any) -> None:
    kinds = [(one.model.mechanism.name, one.excitation) for _, one, _, _ in PRESETS]
    with opened(browser) as page:
        for preset in (*sorted(map(kinds.index, set(kinds))), *range(len(PRESETS), LAST + 1)):
            page.select_option("#preset", str(preset))
            page.evaluate("explorer.step(16)")
            page.evaluate(FILL)
            assert page.locator("#answers .card").count() == 5


@pytest.mark.slow
def test_an_address_and_lines_of_python_give_the_same_curve(browser: Any) -> None:
    for preset in (1, 6, 7):
        same_curve(browser, preset)
    names = same_curve(browser, LAST)
    assert names["mount"].oscillator == MOUNT.oscillator and MOUNT_FORCE == names["curve"].F


def same_curve(browser: Any, preset: int) -> dict[str, Any]:
    """The names of the lines of a design, whose curve is that of the page, and of the page at its address."""
    with opened(browser) as page:
        page.select_option("#preset", str(preset))
        page.evaluate("explorer.step(16)")
        lines = page.evaluate("explorer.inPython(explorer.app.state)")
        table = page.evaluate("explorer.inCSV(explorer.app.answer)")
        address = page.evaluate("explorer.toAddress(explorer.app.state)")
    names: dict[str, Any] = {}
    with contextlib.redirect_stdout(io.StringIO()):
        exec(lines, names)
    rows = np.genfromtxt(io.StringIO(table), delimiter=",", skip_header=1)
    curve = names["curve"]
    for column, values in enumerate((curve.f, curve.A) if preset == LAST else (curve.Omega, curve.A)):
        # with units the window's end is rounded on its way there and back; of the library NumPy answers
        np.testing.assert_allclose(rows[:, column], values, rtol=1e-13 if preset >= len(PRESETS) else 2e-15)
    with opened(browser, address) as page:
        assert page.evaluate("explorer.inCSV(explorer.app.answer)") == table
    return names


@pytest.mark.slow
def test_a_base_is_given_by_its_acceleration(browser: Any) -> None:
    """The curve of a force m a, in Python's lines by its letter; without dimensions it is a force."""
    with opened(browser, f"{AT}&F_0=0.42&excitation=acceleration") as page:
        lines = page.evaluate("explorer.inPython(explorer.app.state)")
        table = page.evaluate("explorer.inCSV(explorer.app.answer)")
        assert page.inner_text("label[for=number-F_0]") == "a" and "m/s²" in page.inner_text("#fields")
        page.click("label[for=units-one]")
        page.evaluate("explorer.step(16)")
        assert "excitation" not in page.evaluate("explorer.inPython(explorer.app.state)")
    names: dict[str, Any] = {}
    with contextlib.redirect_stdout(io.StringIO()):
        exec(lines, names)
    mount = Isolator.physical(**MOUNT.given | {"excitation": "acceleration", "force": "truncated"})
    rows = np.genfromtxt(io.StringIO(table), delimiter=",", skip_header=1)
    np.testing.assert_allclose(rows[:, 1], names["curve"].A, rtol=1e-13)
    assert rows[:, 1].max() == pytest.approx(mount.peak(a=0.42).A, rel=1e-12)


#: a density by points in Hz and g^2/Hz, with a step, and one without dimensions
FLOOR = ([1.0, 8.0, 8.0, 100.0], [1e-5, 1e-5, 4e-6, 1e-7])
PLAIN = ([0.3, 1.1, 6.0], [2e-4, 2e-4, 1e-5])
RANDOM = """([name, numbers, psd]) => {
  const { solvers } = explorer.app, [mu, zeta] = numbers.slice(-2);
  if (solvers.choose(name, numbers, "force") === null) return null;
  const found = explorer.randomOf(solvers, { mechanism: name, si: false, psd }, { mu, zeta });
  return Object.fromEntries(["u", "v", "k", "friction"].map((key) => [key, Array.from(found[key] || [])]));
}"""


@pytest.mark.slow
def test_root_mean_squares_are_those_of_the_package(browser: Any) -> None:
    """White noise and a table, every mechanism whose force is odd; several stationary motions, and none."""
    with opened(browser) as page:
        for one in designs():
            mechanism = one.oscillator.model.mechanism
            if not mechanism.odd or one.oscillator.excitation != "force":
                continue
            numbers = [*one.oscillator.model.design, one.oscillator.mu, one.oscillator.zeta]
            for points in ([[4e-4]], np.transpose(PLAIN).tolist()):
                found = page.evaluate(RANDOM, [one.mechanism, numbers, points])
                white = {"S_0": points[0][0] / 2} if len(points) == 1 else {"psd": PLAIN}
                theirs = one.oscillator.random(**white)
                for name, values in {"u": theirs.u_rms, "v": theirs.v_rms, "k": theirs.stiffness}.items():
                    np.testing.assert_allclose(found[name], values, rtol=1e-9, err_msg=f"{one.title}, {white}")
                np.testing.assert_allclose(found["friction"], theirs.dry, rtol=1e-9)
        assert page.evaluate(RANDOM, ["duffing", [1.0, 1.0, 0.5, 0.01], [[1.0, 1e-9], [2.0, 1e-9]]])["u"] == []


@pytest.mark.slow
@pytest.mark.parametrize("width", [1280, 390])
def test_a_density_on_a_floor_has_a_root_mean_square(browser: Any, width: int) -> None:
    with opened(browser, f"{AT}&F_0=5", viewport={"width": width, "height": 844}) as page:
        assert page.locator("#answers .card").count() == 5 and page.locator("#response .rms").count() == 0
        page.fill("#psd", "; ".join(f"{f} {G}" for f, G in np.transpose(FLOOR).tolist()))
        page.evaluate("explorer.step(16)")
        mount = Isolator.physical(**MOUNT.given | {"force": "truncated"})
        found = mount.random(psd=FLOOR)
        card = page.locator("#answers .card").last.inner_text()
        assert f"{1000 * found.x_rms[0]:.4g} mm" in card and f"natural frequency {found.f_e[0]:.4g} Hz" in card
        assert DIMENSIONLESS.search(card) is None and page.locator("#response .rms").count() == 1
        address = page.evaluate("explorer.toAddress(explorer.app.state)")
        names: dict[str, Any] = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(page.evaluate("explorer.inPython(explorer.app.state)"), names)
        assert "x_rms" in printed.getvalue()
        page.click("label[for=units-one]")
        page.evaluate("explorer.step(16)")
        plain = page.evaluate("Array.from(explorer.app.answer.random.u)")
        np.testing.assert_allclose(plain, found.x_rms / mount.scales.sizes["length"], rtol=1e-9)
        for wrong in ("1 1e-5", "2 1e-5; 1 1e-5", "1 -1; 2 1", "one"):
            page.fill("#psd", wrong)
            assert page.get_attribute("#psd", "aria-invalid") == "true"
        assert page.evaluate("document.documentElement.scrollWidth") <= width
    with opened(browser, address) as page:
        assert page.locator("#answers .card").last.inner_text() == card


def test_the_page_opens_with_the_mount_of_the_readme_in_si_units(browser: Any) -> None:
    with opened(browser, "") as page:
        cards = page.eval_on_selector_all("#answers .card", "all => all.map((one) => one.innerText)")
        assert [one for one in cards if DIMENSIONLESS.search(one)] == []
        assert f"{MOUNT.saddle_node_onset().F_SN:.4g} N" in cards[0]


#: an address of the mount of the README at an amplitude in SI units, by what excites it
AT = "#mechanism=rod_spring&lam=3&r=1700&delta_h=0.009&mu=0.4&zeta=0.02&m=12&k_v=2500&L=0.08&units=si&shown=2&at=0.999"


@pytest.mark.slow
@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize(
    ("excitation", "letter", "within", "beyond"),
    [
        ("force", "F", 5.0, 40.0),
        ("base", "Y", 0.002, 0.005),
        ("acceleration", "a", 0.42, 3.3),
        ("unbalance", "U", 0.024, 0.08),
    ],
)
def test_si_units_name_the_excitation_and_no_peak_beyond_the_rod(
    browser: Any, excitation: str, letter: str, within: float, beyond: float, width: int
) -> None:
    mount = Isolator.physical(**MOUNT.given | {"excitation": excitation, "force": "truncated"})
    for amplitude in (within, beyond):
        address = f"{AT}&F_0={amplitude}&excitation={excitation}"
        with opened(browser, address, viewport={"width": width, "height": 844}) as page:
            cards = page.eval_on_selector_all("#answers .card", "all => all.map((one) => one.innerText)")
            text = [*cards, page.inner_text("#remarks"), page.text_content(".legend"), page.inner_text("#map-quantity")]
            text += page.eval_on_selector_all("svg text, svg title", "all => all.map((one) => one.textContent)")
            assert [one for one in text if DIMENSIONLESS.search(one)] == []
            assert cards[0].startswith(f"{letter}SN") and cards[-1].startswith(f"jumps at {letter} = ")
            assert f"{letter}_SN" in page.inner_text("#map-quantity")
            A = mount.peak(amplitude).A
            assert (A > MOUNT.scales.L) == (amplitude == beyond)
            title = page.text_content("#response title")
            if amplitude == within:
                assert f"{1000 * A:.4g} mm" in cards[3] and f"peak {1000 * A:.4g} mm" in title
                continue
            assert "not reached" in cards[3] and f"{1000 * A:.4g}" not in cards[3] + title
            assert "Amplitudes above 80 mm are not reached" in page.inner_text("#remarks")
            # at resonance the mass would be beyond the rod as well
            assert "not reached" in page.inner_text("#states tr.here")


@pytest.mark.slow
def test_a_mass_that_friction_holds_transmits_all(browser: Any) -> None:
    """On a base it rides with the floor, under a force all of that is passed on: 0 dB."""
    for part in ("&F_0=0.004&excitation=base&at=0.1", "&F_0=0.5&at=1"):
        with opened(browser, AT.replace("&at=0.999", part)) as page:
            assert page.inner_text("#states").startswith("Held by friction")
            assert "0 dB" in page.inner_text("#states")
    with opened(browser, f"{AT}&F_0=0.52") as page:
        assert "Held" not in page.inner_text("#states")


def peak_of(page: Any, address: str) -> str:
    """What the card of the highest peak says of a mechanism and its numbers."""
    opens = "(address) => explorer.open(explorer.fromAddress(address))"
    page.evaluate(opens, f"#mechanism={address}&zeta=0.05&shown=3")
    page.evaluate("explorer.step(16)")
    return page.locator("#answers .card dd").nth(3).inner_text()


@pytest.mark.slow
def test_peak_beyond_the_well_or_the_reach_is_said(browser: Any) -> None:
    three = next(i for i, (_, name, *_) in enumerate(LIBRARY) if name == "three_spring")
    with opened(browser) as page:
        # softening: the force gives way at A^2 = alpha/|beta| = 2, the average at 4/3 of that
        shown = peak_of(page, "duffing&alpha=1&beta=-0.5&mu=0.01&F_0=0.2").split()[0]
        assert shown in ("beyond", "–") or float(shown) <= 2**0.5
        # hardening: beyond its reach, without a breakpoint
        assert peak_of(page, "three_spring&alpha=1&ell=1.5&mu=0&F_0=0.3").startswith("not reached")
        page.select_option("#preset", str(len(PRESETS) + three))
        page.evaluate("explorer.step(16)")
        assert "not reached" not in page.locator("#answers .card").nth(3).inner_text()


@pytest.mark.slow
def test_the_map_is_painted_and_a_click_goes_there(browser: Any) -> None:
    with opened(browser) as page:
        page.wait_for_selector("#map[data-whole=yes]")
        i, j = 30, 12
        x, y, value = page.evaluate(
            """([i, j]) => {
              const { request, values } = explorer.app.map;
              return [request.xs[i], request.ys[j], values[j * request.xs.length + i]];
            }""",
            [i, j],
        )
        assert value == example.isolator(r=x, delta_h=y).saddle_node_onset().F_SN
        page.locator("#map").focus()
        before = float(page.input_value("#number-r"))
        page.keyboard.press("ArrowRight")
        page.evaluate("explorer.step(16)")
        assert float(page.input_value("#number-r")) > before


#: letters of the longest option of a list that its box has no room for, and which
TOO_LONG = """one => {
  const { font, paddingLeft, paddingRight } = getComputedStyle(one);
  const pen = document.createElement("canvas").getContext("2d");
  pen.font = font;
  const room = one.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - 16;  // 16: the arrow
  return [...one.options].map((option) => option.text).filter((text) => pen.measureText(text).width > room);
}"""


@pytest.mark.slow
@pytest.mark.parametrize("width", [1280, 390])
def test_lists_of_the_map_have_room_for_what_they_say(browser: Any, width: int) -> None:
    with opened(browser, viewport={"width": width, "height": 844}) as page:
        for mechanism in page.eval_on_selector_all("#mechanism option", "all => all.map((one) => one.value)"):
            page.select_option("#mechanism", mechanism)
            page.evaluate("explorer.step(16)")
            for name in ("#map-x", "#map-y"):
                assert page.eval_on_selector(name, TOO_LONG) == [], mechanism
                assert "Delta" not in page.text_content(name)


@pytest.mark.slow
def test_letters_of_pictures_stand_below_the_line(browser: Any) -> None:
    with opened(browser) as page:
        page.wait_for_selector("#map[data-whole=yes]")
        assert not [
            text
            for text in page.eval_on_selector_all("svg text", "all => all.map((one) => one.textContent)")
            if "_" in text
        ]


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_wider_than_a_phone(browser: Any, scheme: str) -> None:
    with opened(browser, viewport={"width": 390, "height": 844}, color_scheme=scheme) as page:
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        naming = """all => all.map((one) => one.id + (one.labels?.length ? " named" : "")
          + (one.getAttribute("aria-label") || one.getAttribute("aria-labelledby") || one.textContent.trim()))"""
        named = page.eval_on_selector_all("input, select, button, textarea", naming)
        ids = page.eval_on_selector_all("input, select, button, textarea", "all => all.map((one) => one.id)")
        assert all(len(name) > len(id) for name, id in zip(named, ids, strict=True))
        paper = page.evaluate("getComputedStyle(document.body).backgroundColor")
        assert (paper == "rgb(20, 23, 28)") == (scheme == "dark")
