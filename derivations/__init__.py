"""The derivation: from an equation of motion to slow flow, polynomials and resultants, then to kernels and verdicts.

In:  a `Mechanism` from `mechanisms/`: pieces of a restoring force as SymPy expressions, names of its parameters.
Out: exact SymPy expressions, which `codegen/` prints as kernels and `ledger/` compares with the published formulas.

Each room needs only rooms above it:

    symbols       the paper's letters; `claims`, what is proved on the way
    mechanisms/   equations of motion (1), (2), one file each
    paper/        equations (1)-(38), section by section
    forces/       averaged restoring forces of every kind
    systems/      what is solved for each answer
    extensions/   other damping, other excitation, the second approximation, motion in time
    asymmetric/   offset motion
    library/      equations of motion that are derived on request
    results       all of it, run once
    codegen/      from expressions to NumPy and C
    document      the derivation of one mechanism as a document; `runtime`, of one that a program states
    ledger/       the published formulas, their proofs and verdicts

`python -m derivations.walkthrough` prints the paper, equation by equation, with its proofs: begin there.
`python -m derivations` runs all of it and writes `generated/`.
"""
