"""Resonances so sharp that rounding of A Omega^2 alone takes a point off the response.

Expected values are of the polynomial that a Duffing oscillator's response is the zeros of: its roots, and those of its
discriminant and resultants, were isolated exactly with FLINT (each number below to the digits of doubles).
"""

import numpy as np
import pytest

import slowflow


@pytest.mark.parametrize(
    ("design", "F_0"),
    [
        ((0.2543601615170644, -696.3954715444415, 0.0, 1.135210438886413e-12), 1.2634756230650652e-14),
        (
            (9.414903136812962, -2.205438429755391e-05, 2.153208361866587e-11, 1.7901419137932593e-12),
            4.171467694620174e-09,
        ),
        ((60.92238944088056, -1.2190823789808312, 0.0, 2.64885172514092e-12), 1.6876695642575007e-10),
    ],
)
def test_an_isola_point_has_the_digits_of_its_level(design, F_0):
    found = slowflow.Duffing(*design).isola_points(A_max=600.0).F_0[-1]

    assert found == pytest.approx(F_0, rel=1e-15)


@pytest.mark.parametrize(
    ("design", "F_0", "Omega", "A"),
    [
        (
            (-0.03601501955524581, 1.2235657549374968e-06, 0.0, 2.4954432881958944e-12),
            0.003523890841618822,
            822.4216071513582,
            858519.6403630562,
        ),
        (
            (-4.370316084063971, 3.727535036130135e-05, 9.562176825809111e-07, 1.2528959315005995e-11),
            0.009816515252482682,
            1439.1291248588313,
            272181.5744022246,
        ),
    ],
)
def test_the_fold_of_a_sharp_peak_has_its_digits(design, F_0, Omega, A):
    folds = slowflow.Duffing(*design).saddle_nodes(F_0)

    assert folds.Omega == pytest.approx([Omega], rel=2e-15) and folds.A == pytest.approx([A], rel=2e-15)
    many = slowflow.Duffing.many(**dict(zip(("alpha", "beta", "mu", "zeta"), design, strict=True))).saddle_nodes(F_0)
    assert many.A[0] == folds.A[0] and many.undecided == 0


@pytest.mark.parametrize(
    ("design", "F_0", "Omega", "signs"),
    [
        (
            (0.0020371097908668365, 60.19614191540625, 0.0, 2.4038931428287364e-09),
            0.1385473279177703,
            13915.024407702716,
            [True, False, True],
        ),
        (
            (0.3453815689776624, 1.0743747620068033e-05, 0.7276220534628569, 4.682727357220659e-10),
            71.6860938391557,
            14644.774535735238,
            [True, False, True],
        ),
    ],
)
def test_of_two_states_within_a_rounding_the_lower_one_is_the_saddle(design, F_0, Omega, signs):
    mount = slowflow.Duffing(*design)

    states = mount.amplitudes(Omega=Omega, F_0=F_0)

    assert states.stable.tolist() == signs
    assert (np.diff(states.A) >= 0).all()


#: Duffing oscillators with a cusp next to Omega = 0, as friction far exceeds what the spring has there: at the double
#: next to its amplitude Omega^2 from F_AA = 0 exceeds it by far, or is negative. From exact algebra: F_0, Omega, A
NEXT_TO_REST = (
    # was 8 % off on NumPy, and none otherwise
    (
        (0.000851181307780771, -170.14399503133887, 8.362562395973274, 0.2724363742646413),
        (10.647545137868523, 8.90767182004742e-11, 0.002169312688520841),
    ),
    # 2.8 % off
    (
        (-0.0004075408420264791, 3171.2896077882606, 0.27962343122676186, 0.014648987411895499),
        (0.3560276102724673, 1.8203316372242992e-09, 0.00034768587506578755),
    ),
    # none
    (
        (0.0006460651908889042, -1120.3362292711977, 88.2907240692041, 4.441208426955776),
        (112.4152413182113, 1.0123302677344342e-13, 0.000736518078783563),
    ),
)


@pytest.mark.both_backends
@pytest.mark.parametrize(("design", "cusp"), NEXT_TO_REST)
def test_a_cusp_next_to_rest_is_found_with_its_frequency(design, cusp):
    found = slowflow.Duffing(*design).cusps(A_max=1.5 * cusp[2])[0]
    assert (found.F_0, found.Omega, found.A) == pytest.approx(cusp, rel=1e-13, abs=0) and not found.minimum
