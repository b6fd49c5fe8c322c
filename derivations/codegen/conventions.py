"""What the solvers of every language have in common and no formula gives: how an answer fared, and where methods stop.

In:  decisions.
Out: `CONVENTIONS`: tables of words by number, and numbers of the methods, for averaged and for exact motions.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..forces.quadrature import DENSE, NODES
from ..systems.gradients import KINDS, SYSTEMS


@dataclass(frozen=True)
class Word:
    """A name for the number that is its place in a table, and what it means, in one line."""

    name: str
    doc: str


@dataclass(frozen=True)
class Table:
    """Words by number.

    name   -- of the type in Python and in C
    doc    -- one line
    words  -- from number 0 on
    suffix -- to a word's name in C, where it would be another table's too
    """

    name: tuple[str, str]
    doc: str
    words: tuple[Word, ...]
    suffix: str = ""


@dataclass(frozen=True)
class Number:
    """A name for a number, exact, an `int` where it counts; and what it is, in one line."""

    name: str
    value: sp.Rational | int
    doc: str


@dataclass(frozen=True)
class Rows:
    """A name for rows of small integers, and what they are."""

    name: str
    values: tuple[tuple[int, ...], ...]
    doc: str


@dataclass(frozen=True)
class Conventions:
    """Tables and numbers of one file in each language."""

    name: str
    title: str
    tables: tuple[Table, ...]
    numbers: tuple[Number, ...]
    rows: tuple[Rows, ...] = ()


STATUS = Table(
    ("Status", "sf_status"),
    "How a solver fared.",
    (
        Word("OK", "an answer"),
        Word("INVALID", "a parameter outside its domain"),
        Word("STICKS", "sticks: F_0 <= 4 mu/pi"),
        Word("NONE", "there is none (no fold, no breakpoint)"),
        Word("UNBOUNDED", "no viscous damping: no end of the response, no lowest forcing"),
        Word("NO_BOUND", "no amplitude was found that bounds the response"),
        Word("TOO_MANY", "more of them than places"),
        Word("UNRESOLVED", "branches coincide within rounding"),
        Word("NO_MEMORY", "out of memory"),
    ),
)

ONSET_KIND = Table(
    ("OnsetKind", "sf_onset_kind"),
    "What the lowest forcing with a fold is.",
    (
        Word("NO", "there is none"),
        Word("CUSP", "two folds meet: the response gets a vertical inflection"),
        Word("ISOLA", "an isolated curve is born"),
        Word("CORNER", "at a breakpoint"),
    ),
    "_KIND",
)

FOLD_KIND = Table(
    ("FoldKind", "sf_fold_kind"),
    "Where a sweep goes that leaves a fold.",
    (
        Word("EMPTY", "an empty place"),
        Word("JUMP_UP", "to a larger amplitude"),
        Word("JUMP_DOWN", "to a smaller one"),
        Word("JUMP_UP_AT_CORNER", "to a larger amplitude, from a corner at a breakpoint"),
        Word("JUMP_DOWN_AT_CORNER", "to a smaller one, from a corner at a breakpoint"),
    ),
)

PINNED = Table(
    ("Pinned", "sf_pinned"),
    "What an answer is whose gradient is asked for.",
    tuple(Word(name.upper(), doc) for name, (_, doc) in KINDS.items()),
    "_PINNED",
)

MOVES = Table(
    ("MovesStatus", "sf_moves_status"),
    "Whether an answer has a gradient.",
    (
        Word("OK", "it has"),
        Word("NOTHING", "there is no answer"),
        Word("MEETS", "it meets another one there: beyond it there is none, and before it moves without bound"),
        Word("TURNS", "it comes to a breakpoint there: on either side it moves in its own way"),
        Word("BOUNDLESS", "a slope is not finite, or a forcing 0, as at the end of a parameter's domain"),
    ),
    "_MOVES",
)

OUTCOME = Table(
    ("Outcome", "sf_outcome"),
    "How a motion or a cycle fared.",
    (
        Word("GOOD", "an answer"),
        Word("STALLS", "more steps than allowed, or numbers that are not finite"),
        Word("CHATTERS", "more phases in a turn than allowed"),
        Word("ESCAPES", "the restoring force does not hold the mass"),
        Word("SINGULAR", "equations without a single solution"),
        Word("DIVERGES", "Newton's iteration does not converge"),
        Word("NO_MEMORY", "out of memory"),
    ),
)

EVENT = Table(
    ("Event", "sf_event"),
    "What ends smooth motion.",
    (
        Word("TIME", "the end that was asked for"),
        Word("STOP", "the velocity vanishes"),
        Word("EDGE", "a breakpoint"),
        Word("NOTHING", "not ended"),
    ),
)

EXTRA = Table(
    ("ExtraKind", "sf_extra_kind"),
    "A cycle's further equation, by which Omega is free.",
    (
        Word("NO_MORE", "none: Omega is given"),
        Word("ROW", "row z = value"),
        Word("BORDER", "a border's margin vanishes"),
    ),
)

WANTED = Table(
    ("Wanted", "sf_wanted"),
    "What a curve of the second approximation is followed for.",
    (
        Word("EVERY_POINT", "all of its points"),
        Word("FOLDS_ONLY", "those beside which F_A may vanish"),
        Word("TOP_ONLY", "those beside which u_max may be largest"),
    ),
)

OPERATION = Table(
    ("Operation", "sf_operation"),
    "What a program does with one or two numbers.",
    (
        Word("ADD", "a + b"),
        Word("SUB", "a - b"),
        Word("MUL", "a b"),
        Word("DIV", "a/b"),
        Word("NEG", "-a"),
        Word("SQRT", "square root"),
        Word("ATAN2", "angle of (b, a)"),
        Word("ATAN2_SWAPPED", "angle of (a, b), which shares its arctangent with the other"),
        Word("SQUARE", "a^2"),
        Word("INVERSE", "1/a"),
        Word("TIMES", "the double a times b"),
        Word("WITHIN", "a, known to a relative error of the double b"),
        Word("ROOT", "square root of what may be negative"),
        Word("POWER", "a^b"),
        Word("ABS", "|a|"),
        Word("COPYSIGN", "|a| with the sign of b"),
        *(
            Word(name.upper(), name)
            for name in ("exp log log1p cbrt sin cos tan sinh cosh tanh asin acos atan asinh acosh atanh hypot".split())
        ),
    ),
    suffix="_OPERATION",
)

#: of the data that programs are; others are refused
PROGRAM_FORM = 1

CONVENTIONS = (
    Conventions(
        "program_conventions",
        "What programs are made of, which are interpreted",
        (OPERATION,),
        (
            Number("PROGRAM_FORM", PROGRAM_FORM, "of the data that programs are; others are refused"),
            Number("MOST_REGISTERS", 1024, "of a program"),
            Number("LANES", 8, "numbers side by side in a register"),
        ),
    ),
    Conventions(
        "conventions",
        "What the solvers of averaged motions have in common",
        (STATUS, ONSET_KIND, FOLD_KIND, PINNED, MOVES),
        (
            Number(
                "HIGHEST_OMEGA",
                sp.Integer(10) ** 40,
                "highest frequency: for F_0 >= 1e-70 the square of A is in the range of doubles up to it",
            ),
            Number(
                "LARGEST",
                sp.Integer(10) ** 300,
                "size of a force's parameter and of 4 mu/pi: beyond it ordinary amplitudes leave the range of doubles",
            ),
            Number("STATIC_MULTIPLE", sp.Integer(100), "an undamped response without a reach is cut at this times F_0"),
            Number("RAISE", sp.Integer(4), "the forcing is raised by this factor until the onset lies below it"),
            Number("RAISES", 30, "how often, at most"),
            Number(
                "FAR_RAISE",
                sp.Integer(2**20),
                "by this factor from there on, where the force is still nearly its slope at rest",
            ),
            Number("FAR_RAISES", 15, "how often, at most: fourth powers of it are in the range of doubles"),
            Number(
                "NEAR_BOUND",
                sp.Rational(1, 2**16),
                "how nearly the forcing is known beyond which motions go ever farther",
            ),
            Number("FINE_RUNGS", 12, "bounds that are tried on an amplitude, each twice the last"),
            Number("RUNGS", 100, "and in all, in steps that double too"),
            Number("COARSEST", sp.Integer(10**4), "until they exceed this"),
            Number(
                "NEAR_ENDLESS",
                sp.Integer(2**20),
                "multiple of the last breakpoint from which on a force that levels off does not rise any more",
            ),
            Number("ENDLESS", sp.Integer(2**60), "stands for an infinite amplitude, and an infinite multiple of one"),
            Number("DOUBT", sp.Rational(1, 2**48), "relative error that is taken for granted in a kernel's value"),
            Number("CANCELLED", sp.Rational(1, 4), "share of its first term below which a sum of two has lost digits"),
            Number(
                "SOFT",
                sp.Rational(1, 100),
                "share of |h| below which A h_A may have lost digits, and Omega^2 = h_A with it",
            ),
            Number(
                "BESIDE",
                sp.Rational(1, 1000),
                "a root is the one meant if it lies, relatively, this near to what has lost digits",
            ),
            Number("LAST_STEP", sp.Rational(1, 10**8), "relative step of A up to which Newton's last step is taken"),
            Number("FIRST", sp.Rational(1, 2**200), "where a search begins that cannot begin at A = 0"),
            Number(
                "FAR_ABOVE",
                sp.Integer(2) ** 30,
                "an amplitude beside that where its piece begins, from which h is smooth",
            ),
            Number("NARROW", sp.Rational(1, 2**50), "relative width of an interval of A that is not cut any more"),
            Number("MOST_CELLS", 50000, "intervals of A, after which a search is given up: numbers overflow"),
            Number("NO_WIDTH", sp.Rational(1, 2**51), "relative width of an interval that holds no amplitude"),
            Number(
                "SLOW",
                sp.Rational(3, 5),
                "share of the last step up to which a step is taken in a bracket",
            ),
            Number("AT_ROOT", sp.Rational(1, 2**50), "relative distance from an amplitude that rounding makes of none"),
            Number("FIRST_F_0", sp.Rational(1, 10**6), "forcing that is raised first where there is no friction"),
            Number("FAR_OUT", sp.Integer(2**30), "an amplitude beside `ENDLESS`, to tell what a level tends to"),
            Number("FALL", sp.Rational(1, 2**20), "amplitudes at which the rest is looked at fall by this"),
            Number("FALLS", 6, "how many of these there are"),
            Number("TENDS", sp.Rational(1, 2**20), "share by which what tends to 0 falls from there to `ENDLESS`"),
            Number(
                "STEEP",
                sp.Integer(2**24),
                "about h_A at the next double above a breakpoint b, over J/b, where the force jumps by J",
            ),
            Number(
                "TOLD_APART",
                sp.Rational(1, 1000),
                "frequencies farther apart than this, relatively, are told apart by any rounding",
            ),
            Number("SPREAD", sp.Rational(1, 1000), "of a curve's points: the length that each part has beside its own"),
            Number("HARDLY", sp.Rational(1, 2**26), "share of Omega's change below which A hardly changes, relatively"),
            Number(
                "COINCIDE", sp.Rational(1, 2**44), "events closer than this, relatively, may have changed their order"
            ),
            Number("CLOSE", sp.Rational(1, 2**40), "share of its size that rounding may add to a value"),
            Number("NEAR_END", sp.Rational(1, 2**40), "frequencies closer than this are one where a curve ends"),
            Number(
                "MEETING",
                sp.Rational(1, 2**25),
                "share of its size below which what vanishes where answers meet leaves no digit of a gradient",
            ),
            Number("SAME", sp.Rational(1, 2**49), "amplitudes closer than this, relatively, are one"),
            Number("MAY_MEET", sp.Rational(1, 2**26), "distance of rho from 1, where critical points meet"),
            Number("SIMPLE", sp.Rational(1, 2**10), "relative step up to which a critical point is not a double one"),
            Number("POLISHED", sp.Rational(1, 2**58), "what Newton's iteration leaves of a critical point, relatively"),
            Number("BY_RISE", sp.Rational(1, 2**40), "share of its terms beyond which a value is its rise"),
            Number("NEAR_ROOT", sp.Rational(1, 2**12), "relative step, share of the way to a fold, of Halley's last"),
            Number("CORRECTED", sp.Rational(1, 2**57), "what Newton's last step leaves of a root, relatively"),
            Number("POLISHING", 8, "steps at most, of Newton's iteration to a critical point"),
            Number("NEARING", 12, "of Halley's to a root"),
            Number("CORRECTING", 100, "of Newton's after that, kept in its bracket"),
        ),
        (
            Rows(
                "SYSTEMS",
                SYSTEMS,
                "by what an answer is: three conditions in the order in which they are solved, for which unknowns, "
                "whether the last two together, and slopes that vanish",
            ),
        ),
    ),
    Conventions(
        "quadrature_conventions",
        "What integrals over the quarter cycle and their enclosures have in common",
        (),
        (
            Number("AGREED", sp.Rational(1, 2**46), "what halving may change of a sum that has settled, of its size"),
            Number("MOVED_BY", sp.Rational(1, 2**50), "what stands for a rounding of A and of a parameter, relatively"),
            Number("SHORT_PART", sp.Rational(1, 2**20), "a part of the quarter that one panel is enough for"),
            Number("FEWEST_PANELS", 16, "from which on rounding is looked at"),
            Number("MOST_PANELS", 512, "after which a sum is given up"),
            Number("NODES", NODES, "of Gauss's rule on a panel"),
            Number("DENSE", DENSE, "power of what is divided into panels that the angle from a piece's begin is"),
            Number("NEXT_TO_ZERO", sp.Rational(1, 2**400), "an amplitude next to 0"),
            Number("PARTS", 24, "of the quarter cycle, of each piece, in which an average by quadrature is enclosed"),
            Number("HALVED", 64, "how often the first of them is halved at most"),
            Number("ANGLE", sp.Rational(1, 2**48), "relative error of an angle in an enclosure"),
            Number("LARGEST_SUM", sp.Integer(2**960), "of an enclosure, beyond which it is not known"),
            Number("CONTACT_SUMS", 5, "integrals of a contact in an enclosure"),
        ),
    ),
    Conventions(
        "second_conventions",
        "What the solvers of the second approximation have in common",
        (WANTED,),
        (
            Number(
                "SMALL", sp.Rational(1, 5), "change of ln A, ln Omega up to which it is a correction, share of A too"
            ),
            Number(
                "HARMONICS",
                sp.Rational(1, 10),
                "the same of the spring's harmonics: from 1/8 on the mass might not turn where they add up",
            ),
            Number("STEPS", 25, "of Newton's iteration, at most"),
            Number("LONGEST", sp.Rational(1, 10), "longest step in ln A, R/F_0 and ln Omega"),
            Number("DONE", sp.Rational(1, 10**11), "the step that ends the iteration"),
            Number("MOVED", sp.Rational(1, 10**8), "the last step of a point of a curve, where the next is its square"),
            Number("ROUNDING", sp.Rational(1, 2**49), "of R, over A Omega^2"),
            Number("WEIGHT", sp.Integer(2), "of ln Omega in the distance beside ln A and R/F_0"),
            Number("MATCHING", 5, "steps to the frequency of a given R"),
            Number("SETTLED", sp.Rational(1, 10**7), "relative distance up to which two answers are one"),
            Number(
                "VANISHED", sp.Rational(1, 1000), "size of F_A where it has vanished, over that at the points beside"
            ),
            Number("SAMPLES", 600, "points of the curve on which folds and states are looked for"),
            Number(
                "BEYOND", sp.Rational(13, 10), "how far that curve reaches beyond the frequencies that are asked for"
            ),
        ),
    ),
    Conventions(
        "exact_conventions",
        "What the integrators of the equation of motion have in common",
        (OUTCOME, EVENT, EXTRA),
        (
            Number("FAR", sp.Integer(10**6), "stands for no breakpoint ahead: no motion of an isolator comes near"),
            Number(
                "GRAZING",
                sp.Rational(1, 10**13),
                "a velocity at a breakpoint that cannot be told from rest: the way beyond is its square",
            ),
            Number(
                "ON_TIME",
                sp.Rational(1, 10**5),
                "phase of the forcing within which a motion switches when the cycle's equations say",
            ),
            Number("MOST_PHASES", 400, "in one turn of the forcing; more means that switches accumulate"),
            Number("TIGHT", sp.Rational(1, 10**9), "relative step of u_0 at which Newton's iteration ends"),
            Number(
                "LOOSE",
                sp.Rational(1, 10**6),
                "relative step beyond which it has not converged where rounding ends it",
            ),
            Number("TOLERANCE", sp.Rational(1, 10**13), "of a cycle's equations, where Newton's iteration ends"),
            Number("MOST_NEWTON", 12, "steps of Newton's iteration to a cycle, at most"),
            Number("ALONG", 8, "steps of Newton's iteration to the next point of a curve, at most"),
            Number("OVER_END", sp.Rational(1, 10**6), "phase beyond a cycle's end in which its last switch is counted"),
            Number("OF_TURN", sp.Rational(1, 10**14), "share of a turn by which rounding may miss its end"),
            Number("MOST_TURNS", 3000, "after a shock, after which it is given up to see the mass turn twice"),
            Number(
                "MOST_DEGREE", 64, "of a polynomial by which motions are followed where values tell a force, at most"
            ),
            Number(
                "CREEPS",
                sp.Rational(1, 10**9),
                "speed over distance at which a mass that creeps back is at rest, or both over A",
            ),
            Number(
                "BALANCED",
                sp.Rational(1, 2**50),
                "of load and shock, by which a mass at rest may be off balance",
            ),
            Number("BACK", sp.Rational(1, 2**47), "of these, by which it begins behind its place of rest then"),
            Number("POINTS", 17, "along a phase at which its acceleration is looked at"),
            Number("ROUNDS", 3, "of twice as many about the largest of these"),
            Number("NEAR", sp.Rational(19, 20), "of the largest, from which on a phase may have the largest of all"),
            Number(
                "SAME", 1 - sp.Rational(1, 10**12), "of a peak, from which on one is as high: the first of them is told"
            ),
        ),
    ),
)

#: numbers that C alone asks: Python does not have them
C_ALONE = frozenset(
    (
        "AT_ROOT BESIDE BY_RISE CANCELLED COARSEST COINCIDE CORRECTED CORRECTING DOUBT FALL FALLS FAR_ABOVE FAR_OUT "
        "FAR_RAISE FAR_RAISES FINE_RUNGS FIRST_F_0 HARDLY LAST_STEP MAY_MEET MOST_CELLS NARROW NEARING NEAR_BOUND "
        "NEAR_END NEAR_ENDLESS NEAR_ROOT NO_WIDTH POLISHED POLISHING RAISE RAISES RUNGS SIMPLE SLOW SOFT STEEP TENDS "
        "TOLD_APART ANGLE CONTACT_SUMS DENSE HALVED LARGEST_SUM HARMONICS LONGEST MATCHING MOVED SETTLED SMALL "
        "VANISHED WEIGHT DONE CREEPS NEAR OF_TURN POINTS BALANCED ROUNDS AGREED MOVED_BY SHORT_PART FEWEST_PANELS "
        "MOST_PANELS NEXT_TO_ZERO"
    ).split()
)
