"""The slow flow of an oscillator, by which of its damping terms vanish. Takes mu and zeta; returns a module.

Written by `make derive` from derivations/paper/slow_flow.py; never edit.
"""

from functools import cache


def flow_of(mu, zeta):
    """The module of the scene, loaded when it is first wanted: most oscillators need one."""
    return _without(mu == 0, zeta == 0)


@cache
def _without(no_mu, no_zeta):
    """The module by which terms vanish."""
    if no_mu and no_zeta:
        from slowflow_kernels import slow_flow_mu0_zeta0

        return slow_flow_mu0_zeta0
    if no_mu:
        from slowflow_kernels import slow_flow_mu0

        return slow_flow_mu0
    if no_zeta:
        from slowflow_kernels import slow_flow_zeta0

        return slow_flow_zeta0
    from slowflow_kernels import slow_flow

    return slow_flow
