"""PyDSTool: continuation in Python. Its last release needs NumPy before 1.24 and two modules that Python 3.10 removed.

It asks these only for parse trees of symbolic derivatives, which are not used here: empty ones stand in for them.
"""

NAME = "PyDSTool"
PACKAGES = ("PyDSTool", "numpy<1.24", "scipy<1.10")
WHAT = "continuation of the equilibria of the slow flow, with the tool's fold detection"

STEPS = {"large steps": 0.01, "small steps": 0.003}


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    import sys
    import types

    parser, symbol = (sys.modules.setdefault(name, types.ModuleType(name)) for name in ("parser", "symbol"))
    parser.STType, symbol.sym_name = type("STType", (), {}), {}
    from PyDSTool import ContClass, Generator, args

    from benchmarks.peers.problem import (
        ALPHA,
        BETA,
        F_0,
        GAMMA,
        OMEGA_MAX,
        OMEGA_MIN,
        PI,
        START_A,
        START_PHI,
        U_CR,
        ZETA,
        M,
        answer,
    )

    # the same formulas as in `problem`, in PyDSTool's own language
    functions = {
        "c": (["A"], f"min(1.0, {U_CR!r}/A)"),
        "s": (["A"], "sqrt(1 - c(A)*c(A))"),
        "c_2": (["A"], "(acos(c(A)) + s(A)*c(A))/2"),
        "c_4": (["A"], "(3*c_2(A) + s(A)*pow(c(A), 3))/4"),
        "c_6": (["A"], "(5*c_4(A) + s(A)*pow(c(A), 5))/6"),
        "detached": (["A"], f"({ALPHA - 1!r})*A*c_2(A) + {BETA!r}*pow(A, 3)*c_4(A) + {GAMMA!r}*pow(A, 5)*c_6(A)"),
        "attached": (["A"], f"-{ALPHA!r}*A - {0.75 * BETA!r}*pow(A, 3) - {0.625 * GAMMA!r}*pow(A, 5)"),
    }
    force = f"(attached(A) + {4 / PI!r}*detached(A))"
    flow = Generator.Vode_ODEsystem(
        args(
            name="slow_flow",
            tdata=[0, 1],
            pars={"Omega": OMEGA_MIN},
            pdomain={"Omega": [OMEGA_MIN - 0.1, OMEGA_MAX]},
            fnspecs=functions,
            varspecs={
                "A": f"-({F_0}*sin(phi) + 2*{ZETA}*Omega*A + {M!r})/(2*Omega)",
                "phi": f"-({F_0}*cos(phi) + Omega*Omega*A + {force})/(2*Omega*A)",
            },
            ics={"A": START_A, "phi": START_PHI},
        )
    )

    def curve(step):
        continuation = ContClass(flow)
        settings = args(name="response", type="EP-C", freepars=["Omega"], LocBifPoints=["LP", "B"], StopAtPoints=["B"])
        settings.update({"StepSize": step / 2, "MinStepSize": 1e-6, "MaxStepSize": step, "MaxNumPoints": 5000})
        settings.update({"VarTol": 1e-10, "FuncTol": 1e-10, "TestTol": 1e-10, "verbosity": 0})
        continuation.newCurve(settings)
        found = continuation["response"]
        found.forward()
        folds = [found.getSpecialPoint("LP", f"LP{i}") for i in (1, 2, 3)]
        return len(found.sol), [(fold["Omega"], fold["A"]) for fold in folds if fold]

    return {name: (lambda step=step: curve(step), answer) for name, step in STEPS.items()}
