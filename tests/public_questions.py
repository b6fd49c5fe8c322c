"""Every public question with its arguments: strategies of bad and extreme values, by class and by name.

A question that is not among them fails `tests/oscillators/test_any_input.py`.
"""

from __future__ import annotations

import math

import numpy as np
from hypothesis import strategies as st

from slowflow.grid.many import Designs
from slowflow.off_centre.many import OffCentreDesigns
from slowflow.off_centre.questions import OffCentre
from slowflow.oscillators.isolator import Isolator
from slowflow.oscillators.physical import Physical
from slowflow.oscillators.physical_designs import PhysicalDesigns
from slowflow.second import SecondApproximation
from slowflow.second.many import SecondDesigns

#: zero, subnormal, near one, the ends of the range: where formulas break
HARD = [0.0, -0.0, 5e-324, 1e-310, 1e-160, 1e-20, 1e-8, 0.99, 1 - 2**-53, 1.0, 1 + 2**-52, 1e8, 1e150, 1.7e308]
#: what no argument may be
WRONG = [math.nan, math.inf, -math.inf, -1.0, None, "1", [1.0], np.array([1.0, 2.0]), 1j, True, 10**400, object()]

usual = st.floats(1e-6, 2.0) | st.floats(-6, 1).map(lambda exponent: 10.0**exponent)
numbers = usual | st.sampled_from(HARD)


#: numbers at which formulas break, and what is no number
bad = st.sampled_from(HARD) | st.sampled_from(WRONG)


def mostly(usually, otherwise=bad, among=8):
    """One in so many is another: were each of ten numbers as often wrong as right, nothing would be answered."""
    return st.integers(1, among).flatmap(lambda k: otherwise if k == among else usually)


def seldom(usually, otherwise):
    """Few of those that take longer, or that most questions refuse."""
    return mostly(st.just(usually), otherwise)


anything = mostly(usual)
#: a word that a name may take, or none it may
FORCES = mostly(st.sampled_from([None, "truncated", "untruncated"]), st.just("exact"))
EXCITATIONS = st.sampled_from(["force", "base", "unbalance", "acceleration of the base", 1.0])
CONTACTS = st.sampled_from(["throughout", "attached", "nowhere"])


DAMPING = {
    "mu": mostly(st.floats(0, 0.05)),
    "zeta": mostly(st.floats(0, 0.2)),
    "excitation": mostly(st.sampled_from(["force", "force", "base", "unbalance"]), EXCITATIONS),
}
SETTINGS = {
    "eta": seldom(0.0, mostly(st.floats(0, 0.2))),
    "c_2": seldom(0.0, mostly(st.floats(0, 0.2))),
    "load": seldom(0.0, mostly(st.floats(-0.1, 0.1))),
}
STATIC = {"mu_s": seldom(0.0, mostly(st.floats(0.05, 0.1)))}
DESIGN = {"lam": mostly(st.sampled_from([1, 2, 3, 4])), "r": mostly(st.floats(0.2, 4))}
DESIGN["delta_h"] = mostly(st.floats(0, 0.6))
ISOLATORS = DESIGN | DAMPING | SETTINGS | STATIC
ISOLATORS |= {
    "force": mostly(st.sampled_from(["truncated", "untruncated"]), st.just("exact")),
    "contact": seldom("throughout", CONTACTS),
}
DUFFINGS = {"alpha": mostly(st.floats(-0.5, 2)), "beta": mostly(st.floats(-1, 3)), **DAMPING, **SETTINGS, **STATIC}
#: a data sheet in SI units
SHEETS = {
    "m": mostly(st.floats(0.1, 100)),
    "k_v": mostly(st.floats(10, 1e5)),
    "k_h": mostly(st.floats(10, 1e5)),
    "n": seldom(3, anything),
    "L": mostly(st.floats(0.01, 1)),
    "preload": mostly(st.floats(0, 0.01)),
    "friction": mostly(st.floats(0, 1)),
    "static_friction": seldom(None, anything),
    "zeta": mostly(st.floats(0, 0.2)),
    "c": seldom(None, anything),
    "eta": seldom(0.0, anything),
    "c_2": seldom(0.0, anything),
    "contact": seldom("throughout", CONTACTS),
    "load": seldom(None, anything),
    "force": seldom("truncated", st.just("untruncated")),
    "excitation": seldom("force", EXCITATIONS),
}
#: of batches: their parameters are arrays of what single oscillators take
columns = mostly(st.lists(numbers, min_size=3, max_size=3), st.lists(numbers, max_size=4) | anything, among=5)
BATCHES = {name: columns for name in ("lam", "r", "delta_h", "mu", "zeta")}
BATCHES |= {name: seldom(0.0, columns) for name in ("eta", "c_2", "load")}
BATCHES |= {"contact": seldom("throughout", CONTACTS), "excitation": DAMPING["excitation"]}
BATCHES["force"] = mostly(st.sampled_from(["truncated", "untruncated"]), st.just("exact"))

other_windows = st.tuples(numbers, numbers) | st.sampled_from([None, (1.0,), (2.0, 1.0)])
windows = mostly(st.sampled_from([(0.0, 2.0), (0.5, 1.5)]), other_windows, among=4)
samples = mostly(st.sampled_from([2, 10, 300]), st.sampled_from([1, 0, -3, 2.5, "many"]))
steps = mostly(st.sampled_from([0.1, 0.3]))
#: a row of frequencies, of times or of accelerations
rows = mostly(st.lists(st.floats(0.5, 1.5), max_size=3), st.lists(numbers, max_size=3) | anything, among=4)

#: a table of a spectral density
spectra = mostly(
    st.sampled_from([([0.5, 2.0], [1e-3, 1e-4]), ([0.1, 1.0, 9.0], [1e-4] * 3)]), st.tuples(rows, rows), among=4
)


def query(*arguments, **named):
    """Strategy of a question's positional and keyword arguments, from strategies of each."""
    return st.tuples(st.tuples(*arguments), st.fixed_dictionaries(named))


def shocks(times):
    """A pulse, a record or something of both: times are called so."""
    pulse = {"acceleration": anything, "duration": mostly(st.floats(0.5, 4.0))}
    record = {"acceleration": rows, times: rows, "after": mostly(st.just(1.0))}
    return query(**pulse) | query(**record)


FOLDS = {"saddle_node_onset": query(), "detachment": query(), "saddle_nodes": query(anything), "peak": query(anything)}
LOADS = {name: query(anything) for name in ("margins", "hysteresis", "isolation")}
CURVE = {"frequency_response": query(anything, Omega=windows, samples=samples)}
AT = {"amplitudes": query(Omega=anything, F_0=anything)}
SPECTRUM = {"spectrum": query(Omega=rows, F_0=anything)}
OF_FORCE = {name: query(anything) for name in ("force", "stiffness", "backbone", "transmissibility_floor")}
LOCUS = {"fold_locus": query(A_max=anything, samples=samples)}
LOCUS |= {name: query(A_max=anything) for name in ("cusps", "isola_points")}

AVERAGED = {
    **FOLDS,
    **LOADS,
    **CURVE,
    **AT,
    **SPECTRUM,
    **OF_FORCE,
    **LOCUS,
    "at_rest": query(),
    "rest": query(),
    "certify": query(anything, Omega=anything),
    "limit_envelope": query(Omega=anything, F_0=anything),
    "stability": query(Omega=anything, A=anything),
    "equivalent_damping": query(Omega=anything, A=anything),
    "closes": query(anything),
    "restoring_force": query(FORCES),
    "equation_of_motion": query(FORCES),
    "replace": st.sampled_from(["mu", "zeta", "excitation", "load", "mass"]).flatmap(
        lambda name: query(**{name: anything})
    ),
    "explain": query(st.sampled_from(["saddle_nodes", "certify", "sweep", "cusps", "isolas", 1.0]), anything),
    # of what other questions start from
    "states": query(Omega=anything, F_0=anything),
    "folds": query(anything),
    "onset": query(),
    "curve": query(anything, samples=samples, Omega=windows),
}
#: motions of the equation itself, each of them some seconds at most
MOTIONS = {
    "steady_state": query(Omega=anything, F_0=anything, A=st.none() | anything, force=FORCES),
    "exact_response": query(anything, Omega=mostly(st.just((0.9, 1.1)), windows, among=4), step=steps, force=FORCES),
    "sweep": query(Omega=rows, F_0=anything, force=FORCES),
    "transient": shocks("tau"),
    "shock_spectrum": query(acceleration=rows, duration=rows, force=FORCES),
    "random": query(S_0=anything) | query(psd=spectra),
}
PICTURES = {"plot": query(anything, Omega=windows, of=st.sampled_from(["A", "phi", "transmissibility_dB", "B"]))}
OFF_CENTRE = {**FOLDS, **LOADS, **CURVE, **AT, **SPECTRUM, "rest": query(), "A_max": query(anything)}
EXPLAIN = {"explain": query(st.sampled_from(["saddle_nodes", "cusps"]), anything)}
SECOND = {**FOLDS, **CURVE, **AT, **EXPLAIN}
IN_UNITS = {
    **FOLDS,
    **LOADS,
    **OF_FORCE,
    **LOCUS,
    **EXPLAIN,
    "frequency_response": query(anything, f=windows, samples=samples),
    "amplitudes": query(f=anything, F=anything),
    "spectrum": query(f=rows, F=anything),
    "limit_envelope": query(f=anything, F=anything),
    "certify": query(anything, f=anything),
    "at_rest": query(),
    "rest": query(),
    "sag": query(anything),
    "replace": st.sampled_from(["m", "zeta", "c", "load", "mu"]).flatmap(lambda name: query(**{name: anything})),
}
MOTIONS_IN_UNITS = {
    "steady_state": query(f=anything, F=anything, A=st.none() | anything, samples=samples),
    "exact_response": query(anything, f=windows, step=steps),
    "sweep": query(f=rows, F=anything),
    "transient": shocks("t"),
    "shock_spectrum": query(acceleration=rows, duration=rows),
    "random": query(psd=spectra, unit=mostly(st.just("g^2/Hz"), st.just("V^2/Hz"))),
}
PICTURES_IN_UNITS = {"plot": query(anything, f=windows, of=st.sampled_from(["A", "phi", "B"]))}
BATCHED = {"max_count": st.sampled_from([1, 6, 0, "all"]), "workers": st.sampled_from([1, 2, 0, None])}
PULSES = {name: query(acceleration=columns, duration=columns) for name in ("transient", "shock_spectrum")}
MANY = {
    **{name: query() for name in ("saddle_node_onset", "detachment")},
    **{name: query(columns) for name in ("peak", "margins", "isolation")},
    **{name: query(columns, **BATCHED) for name in ("saddle_nodes", "hysteresis")},
    **PULSES,
    "amplitudes": query(Omega=columns, F_0=columns),
    "frequency_response": query(columns, samples=st.sampled_from([5, 1]), Omega=st.just((0.5, 1.5)) | windows),
    "spectrum": query(Omega=columns, F_0=columns),
}
OF_BATCHES = {**MANY, "certify": query(columns, Omega=st.none() | columns), "at_rest": query()}
OF_BATCHES["random"] = query(S_0=columns) | query(psd=spectra)
OF_MOUNTS = {name: how for name, how in MANY.items() if name not in ("amplitudes", "frequency_response", "spectrum")}
OF_MOUNTS |= {name: query(f=columns, F=columns) for name in ("amplitudes", "spectrum")}
OF_MOUNTS["frequency_response"] = query(columns, samples=st.sampled_from([5, 1]), f=st.just((0.5, 1.5)) | windows)
OF_MOUNTS |= {"certify": query(columns, f=st.none() | columns), "at_rest": query(), "rest": query()}
OF_MOUNTS["random"] = query(psd=spectra, unit=mostly(st.just("g^2/Hz"), st.just("V^2/Hz")))
OF_LOADED_BATCHES = {**MANY, "rest": query(), "random": OF_BATCHES["random"]}
OF_SECOND_BATCHES = {name: MANY[name] for name in ("saddle_node_onset", "detachment", "peak", "saddle_nodes")}
OF_SECOND_BATCHES |= {name: MANY[name] for name in ("amplitudes", "frequency_response")}

#: every question of each class
OF_CLASS = {
    Isolator: {**AVERAGED, **MOTIONS, **PICTURES},
    OffCentre: OFF_CENTRE,
    SecondApproximation: SECOND,
    Physical: {**IN_UNITS, **MOTIONS_IN_UNITS, **PICTURES_IN_UNITS},
    Designs: OF_BATCHES,
    PhysicalDesigns: OF_MOUNTS,
    OffCentreDesigns: OF_LOADED_BATCHES,
    SecondDesigns: OF_SECOND_BATCHES,
}
#: public, and tested by other methods: what makes oscillators, what measures answers, what refuses, what draws maps
NO_QUESTIONS = {"many", "physical", "measured", "at_centre"}
NO_QUESTIONS |= {"ask", "model", "remarks", "untruncated_onset"}


def any_of(questions):
    """One of the questions: its name, arguments and named ones."""
    return st.one_of(*(st.tuples(st.just(name), how) for name, how in questions.items()))
