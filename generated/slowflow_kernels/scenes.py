"""The slow flow of an oscillator, by which of its damping terms vanish: in go mu and zeta, out comes a module.

Written by `make derive`; never edit.
Input: derivations/slow_flow.py
"""


def flow_of(mu, zeta):
    """The module of the scene, loaded when it is first wanted: most oscillators need one."""
    if mu == 0 and zeta == 0:
        from slowflow_kernels import slow_flow_mu0_zeta0

        return slow_flow_mu0_zeta0
    if mu == 0:
        from slowflow_kernels import slow_flow_mu0

        return slow_flow_mu0
    if zeta == 0:
        from slowflow_kernels import slow_flow_zeta0

        return slow_flow_zeta0
    from slowflow_kernels import slow_flow

    return slow_flow
