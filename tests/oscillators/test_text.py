"""Sentences that carry their numbers: dimensionless as they are, and in the symbols and units of a mount."""

import ast
import copy
import math
import pickle
import re

import numpy as np
import pytest

from slowflow import Isolator, SlowflowError
from slowflow.answers.answer import joined, sentences
from slowflow.answers.quantities import Scales
from slowflow.answers.table import QUANTITIES
from slowflow.averaged import messages
from slowflow.support.text import Sentence, Text, in_units, text, together
from tests import files
from tests.files import ROOT

SOURCE = ROOT / "src" / "slowflow"
#: m such that Omega = 1 is 1 Hz, F_0 = 1 is 100 N, A = 1 is 100 mm
SCALES = Scales(m=1000 / math.tau**2, k_v=1000.0, L=0.1)
#: what a mount has other symbols for
SYMBOLS = re.compile(r"\b(?:F_0|F_SN|F_cr|Omega|mu|mu_s|tau|u|u_0|u_cr)\b")
#: where sentences have symbols of their own: published formulas, pictures, the table itself, and what a record or a
#: function of one's own is refused for, in the terms that it is stated in
OWN = ("answers/pictures.py", "answers/table.py", "derive.py", "sampled/")
#: sentences that are never shown with units: a plan of rounding, help of the command line, a defect's message
PLAIN = ("averaged/balls/questions.py", "app/cli.py", "app/report.py")


def strings(path):
    """Strings of a module that are no docstrings: as they are written."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    for node in ast.walk(tree):
        above = parents.get(node)
        if isinstance(node, ast.JoinedStr):
            yield "".join(part.value if isinstance(part, ast.Constant) else "{}" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and not isinstance(above, ast.JoinedStr):
            documents = isinstance(above, ast.Expr) or "__doc__" in ast.unparse(
                getattr(above, "targets", [ast.Pass()])[0]
            )
            names = isinstance(parents.get(above), ast.ClassDef)  # columns of a table's entry
            if not (documents or names):
                yield node.value


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(SOURCE.rglob("*.py")), ids=lambda path: str(path.relative_to(SOURCE)))
def test_symbols_in_sentences_are_quantities(path):
    """In places, so that each symbol and its number have a known kind; that of no quantity would keep its size."""
    own = str(path.relative_to(SOURCE)).startswith((*OWN, *PLAIN))
    for sentence in strings(path):
        bare = re.sub(r"\{[^{}]*\}", "", sentence)
        if not own and " " in bare.strip() and "\n" not in bare:  # docstrings that are put together have lines
            assert not SYMBOLS.search(bare), sentence
        for symbol in re.findall(r"\{([A-Za-z_0-9]+) = :[^}]*\}", sentence):
            assert symbol in QUANTITIES or symbol in ("theta", "start"), sentence


def test_a_sentence_is_a_string_with_its_numbers():
    sentence = Sentence("no saddle node at {F_0 = :g}: of {count:d}").format(0.04, 3)
    assert sentence == "no saddle node at F_0 = 0.04: of 3" and isinstance(sentence, str)
    assert sentence.in_units(SCALES) == "no saddle node at F = 4 N: of 3"
    assert Sentence("{F_0 = :g}, {A = :g}").format(A=0.5, F_0=0.25) == "F_0 = 0.25, A = 0.5"


@pytest.mark.parametrize(
    ("pattern", "values", "plain", "units"),
    [
        ("{Omega} in [{Omega:g}]", [(0.5, 2.0)], "Omega in [0.5, 2]", "f in [0.5, 2 Hz]"),
        ("{Omega = :r}", [(0.5, 2.0)], "Omega = (0.5, 2.0)", "f = (0.5, 2) Hz"),
        ("from {Omega[0]:g} to {Omega[1]:g}", [(0.5, 2.0)], "from 0.5 to 2", "from 0.5 Hz to 2 Hz"),
        ("{A = :.3g}", [np.array([0.1, 0.2])], "A = 0.1, 0.2", "A = 10, 20 mm"),
        ("{A = :r}", ["wide"], "A = 'wide'", "A = 'wide'"),
        ("{A = :r}", [True], "A = True", "A = True"),
        ("{A = :g}", [math.inf], "A = inf", "A = inf mm"),
        ("{u_cr = :g}", [0.25], "u_cr = 0.25", "x_cr = 25 mm"),
        ("{mu = :g}, {tau = :g}", [0.01, math.tau], "mu = 0.01, tau = 6.28319", "friction = 1 N, t = 1000 ms"),
        ("f({Omega=:g}, {A=:g})", [0.5, 0.25], "f(Omega=0.5, A=0.25)", "f(f=0.5, A=0.025)"),
        ("{mu/A|friction/length} {why:s}", ["as it is"], "mu/A as it is", "friction/length as it is"),
        ("{why:s}!", [text("{u} = 0")], "u = 0!", "x = 0!"),
        # as many digits as it is written with, four at least, rounded once
        ("{F_0 = :.17g}", [1 / 3], "F_0 = 0.33333333333333331", "F = 33.3333333333333 N"),
        ("{F_0 = :.2g}", [0.123456], "F_0 = 0.12", "F = 12.35 N"),
        ("{A = :g}", [0.00704545e-10], "A = 7.04545e-13", "A = 7.04545e-11 mm"),
    ],
)
def test_places_of_each_kind(pattern, values, plain, units):
    sentence = text(pattern, *values)
    assert (sentence, sentence.in_units(SCALES)) == (plain, units)


@pytest.mark.parametrize(("excitation", "letter", "kind"), [("base", "Y", "mm"), ("unbalance", "U", "kg m")])
def test_the_amplitude_of_an_excitation_has_its_symbol(excitation, letter, kind):
    scales = Scales(m=10.0, k_v=1000.0, L=0.1, excitation=excitation)
    sentence = text("{F_SN} and {F_0 = :g}", 0.5).in_units(scales)
    assert sentence.startswith(f"{letter}_SN and {letter} = ") and sentence.endswith(kind)


def test_a_load_is_the_mass_that_was_given():
    assert text("{load = :g}", 0.02).in_units(Scales(m=12.5, k_v=1000.0, L=0.1)) == "load = 12.5 kg"


def test_what_is_put_together_keeps_the_numbers():
    one, other = text("{A = :g}", 0.5), text("{u} = 0")
    assert (one + "; " + other).in_units(SCALES) == "A = 50 mm; x = 0"
    assert ("at " + one).in_units(SCALES) == "at A = 50 mm" and one + "" is one
    assert together(", ", (one, "b")).in_units(SCALES) == "A = 50 mm, b"
    message = joined("", joined(one, "plain; words"), other)
    assert message == "A = 0.5; plain; words; u = 0" and message.in_units(SCALES) == "A = 50 mm; plain; words; x = 0"
    assert sentences(message) == ("A = 0.5", "plain", "words", "u = 0")
    assert [in_units(part, SCALES) for part in sentences(message)] == ["A = 50 mm", "plain", "words", "x = 0"]
    assert type(joined("a", "b")) is str and in_units("u = 0", SCALES) == "u = 0"


def test_a_sentence_is_copied_and_pickled_with_its_numbers():
    sentence = joined(text("{A = :g}", 0.5), text("{Omega = :g}", [1.0, 2.0]))
    for again in (pickle.loads(pickle.dumps(sentence)), copy.deepcopy(sentence), copy.copy(sentence)):
        assert again == sentence and again.in_units(SCALES) == "A = 50 mm; f = 1, 2 Hz"
    refused = pickle.loads(pickle.dumps(SlowflowError(sentence)))
    assert refused.args[0].in_units(SCALES) == "A = 50 mm; f = 1, 2 Hz"


def test_an_answer_in_plain_python_has_plain_strings():
    found = Isolator(lam=3, r=2.0, delta_h=0.0, mu=0.01, zeta=0.02).peak(0.001)
    assert isinstance(found.message, Text) and type(found.to_dict()["message"]) is str


MOUNT = {"m": 12.0, "k_v": 2500.0, "k_h": 5000.0, "n": 3, "L": 0.08, "preload": 0.006, "friction": 0.4, "zeta": 0.02}


def test_frequencies_that_are_left_out_are_in_hertz():
    """They were called f and stayed numbers of Omega."""
    mount = Isolator.physical(**MOUNT)
    found = mount.second_approximation.frequency_response(0.51)
    low, high = re.search(r"at f from (\S+) Hz to (\S+) Hz", found.message).groups()
    first = re.search(r"at Omega from (\S+) to (\S+);", found.answer.message).groups()
    size = mount.scales.sizes["frequency"]
    assert (float(low), float(high)) == pytest.approx([float(one) * size for one in first], rel=1e-2)


def test_base_has_its_own_letter_in_plans_and_isola_onsets():
    mount = Isolator.physical(**MOUNT, excitation="base")
    assert "Y_SN, found once" in str(mount.explain("margins", 0.004)) and "F_SN" not in messages.NO_ONSET


def test_intervals_a_proof_looked_at_are_lengths():
    assert messages.intervals([(0.5, 1.0)]).in_units(SCALES) == "[50, 100 mm]"
    assert messages.NOT_BOUNDED.format(0.5).in_units(SCALES) == "only amplitudes up to 50 mm are searched"


def test_offset_motions_are_those_of_the_mount_s_oscillator():
    with pytest.warns(UserWarning, match="negative stiffness"):
        mount = Isolator.physical(**files.MOUNT | {"preload": 0.04})
    found = mount.amplitudes(f=2.0, F=5.0)
    assert "; .oscillator.off_centre has" in found.message and "; .off_centre has" in found.answer.message
    assert hasattr(mount.oscillator, "off_centre") and not hasattr(mount, "off_centre")


def test_bounds_of_what_is_allowed_are_in_units_too():
    mount = Isolator.physical(**MOUNT)
    with pytest.raises(ValueError) as refused:
        mount.cusps(A_max=-0.01)
    assert str(refused.value) == "A_max = -10 mm is not allowed: A_max must be a finite real number > 0"


PSD = ([1.0, 50.0], [1e-4, 1e-6])
ATTACHED = dict(lam=3, r=2.0, delta_h=0.08, mu=0.012, zeta=0.02, contact="attached")
REFUSALS = {
    "load = 12.1 kg is not available with c_xx = 0.1 N s/m^3, only with friction, zeta, eta and c_2": lambda: (
        Isolator.physical(**files.MOUNT, load=12.1, c_xx=0.1)
    ),
    "load is not available with c_xx, only with friction, zeta, eta and c_2": lambda: (
        Isolator.physical(**files.MOUNT).many(m=[11.0, 12.0], load=12.1, c_xx=1.0).rest()
    ),
    "certify is not available with an array of c_xx, only with friction and zeta": lambda: (
        Isolator.physical(**files.MOUNT).many(c_xx=[3.0, 4.0]).certify(5)
    ),
    "limit_envelope is not available with contact = 'attached', only with mu, zeta, eta, c_2, c_3 and zeta_2": lambda: (
        Isolator(**ATTACHED, eta=0.1).limit_envelope(Omega=1.0, F_0=0.1)
    ),
    "duration = -1000 ms is not allowed: duration must be a finite real number > 0": lambda: (
        Isolator.physical(**files.MOUNT).random(psd=PSD).largest(-1)
    ),
    "f = -3 Hz is not allowed: f must be a finite real number > 0, or an array of such": lambda: (
        Isolator.physical(**files.MOUNT).random(psd=PSD).response_psd([1, -3])
    ),
}


@pytest.mark.parametrize("refusal", REFUSALS)
def test_a_refusal_lists_what_is_allowed_in_the_mount_s_terms(refusal):
    with pytest.raises(SlowflowError) as raised:
        REFUSALS[refusal]()
    assert str(raised.value) == refusal
