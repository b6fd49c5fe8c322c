"""Resonances so sharp that rounding of A Omega^2 alone takes a point off the response.

Expected values are of the polynomial that a Duffing oscillator's response is the zeros of: its roots, and those of its
discriminant and resultants, were isolated exactly with FLINT (each number below to the digits of doubles).
"""

import mpmath
import numpy as np
import pytest

import slowflow
from slowflow.averaged import solvers


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


@pytest.mark.parametrize(("design", "cusp"), NEXT_TO_REST)
def test_a_cusp_next_to_rest_is_found_with_its_frequency(design, cusp):
    found = slowflow.Duffing(*design).cusps(A_max=1.5 * cusp[2])[0]
    assert (found.F_0, found.Omega, found.A) == pytest.approx(cusp, rel=1e-13, abs=0) and not found.minimum


@pytest.mark.parametrize("excitation", ["base", "unbalance"])
@pytest.mark.parametrize(
    ("design", "F_0", "folds"),
    [
        (  # h is 0 but for 1e-17 of its terms at the lower one, whose amplitude is the double next to where h vanishes
            (24.385136404012684, -81.12766266934281, 0.0, 1.0810898401412928e-06),
            434.5,
            [(3.1502823632243324e-09, 0.6330638009890452), (0.11689150237488066, 0.3653971421344502)],
        ),
        (
            (-3.53380923989328, 1.513271295366812e-05, 0.0, 2.058742435489848e-11),
            222.01750264031827,
            [(1.0348498024515065e-10, 557.997845644648)],
        ),
        (
            (23.028435253865972, -6770.7361633321725, 0.0, 4.34945209014e-05),
            171656.37860710084,
            [(3.4126224110015636e-11, 0.0673416320591206), (0.0018647390603326829, 0.03887970646161926)],
        ),
        (  # of a sharp peak
            (-0.020320730073893307, 3.0702744280843666, 2.7242015272123092e-05, 3.299050768215736e-11),
            8.681660259283265e-10,
            [(205.0834572064054, 135.1485857657214)],
        ),
        (
            (-0.02068582878939144, 0.0020611287322159057, 0.006285351646735414, 1.5868330063427211e-12),
            473281.523706005,
            [
                (0.0001300349437542943, 3.65808211426762),
                (0.00025262750612914256, 2.111997088190292),
                (48345.340942497074, 709922.2855527244),
            ],
        ),
        (  # two branches of the fold locus that all but cross where it begins
            (0.00012223489416793594, -4.194232628399483, 0.0, 1.4514874356382633e-12),
            4.282247679037371e-11,
            [(0.00042227483421100685, 0.006229077098145243), (0.011055951309998108, 9.405316505329826e-06)],
        ),
        (  # h all but A^3 for most of the way
            (0.0007299071781955587, 28.70221291937318, 0.0, 0.006456331126528536),
            6.710658737381811,
            [(80.89197204054874, 10.065989132715492)],
        ),
    ],
)
def test_folds_by_inertia_have_their_digits(design, F_0, folds, excitation):
    Omega, A = np.array(folds).T

    found = slowflow.Duffing(*design, excitation=excitation).saddle_nodes(F_0)

    assert found.Omega == pytest.approx(Omega, rel=1e-14, abs=0) and found.A == pytest.approx(A, rel=1e-14, abs=0)
    given = dict(zip(("alpha", "beta", "mu", "zeta"), design, strict=True))
    many = slowflow.Duffing.many(**given, excitation=excitation).saddle_nodes(F_0)
    assert (many.Omega[: len(folds)] == found.Omega).all() and (many.A[: len(folds)] == found.A).all()
    assert many.undecided == 0


@pytest.mark.parametrize(
    ("design", "F_0", "Omega"),
    [
        ((-10.99748294033345, 11.970056903782066, 0.0, 9.675128034420492e-10), 1.1067968368662073, 4.689879090196985),
        (
            (-0.807652864051542, 110.45614954492217, 1.5019183112444228e-11, 1.2841305464947507e-05),
            0.09873855955134225,
            1.2709467842647448,
        ),
    ],
)
def test_an_isola_point_by_inertia_beside_a_zero_of_h_is_found(design, F_0, Omega):
    """It lies nearer to it than the next double. There is no other candidate: that it is no onset is no doubt."""
    mount = slowflow.Duffing(*design, excitation="base")

    found = mount.isola_points(A_max=10.0)

    assert found.F_0 == pytest.approx([F_0], rel=1e-15) and found.Omega == pytest.approx([Omega], rel=1e-14)
    assert found.kind.tolist() == ["merger"]
    assert mount.saddle_node_onset().F_SN is None


def test_the_onset_by_inertia_below_amplitudes_at_which_h_is_all_but_a_cube():
    onset = slowflow.Duffing(
        -0.0005733252201321912, 0.06208677058945224, 0.0, 0.10773897290215424, excitation="base"
    ).saddle_node_onset()

    assert (onset.F_SN, onset.Omega, onset.A) == pytest.approx(
        (0.9433997200477158, 0.3716762105864352, 1.4092508735479263), rel=1e-14
    )


@pytest.mark.parametrize("excitation", ["force", "base"])
@pytest.mark.parametrize(
    ("design", "F_0", "Omega", "A"),
    [
        (  # Omega^2 is 2e-13 of h_A
            (0.0007088040325831721, -13.621088767675495, 0.32104680770736754, 0.050456830710668026),
            0.40876949130639684,
            2.8018378846545696e-08,
            0.006996431860430683,
        ),
        (  # and nearer to 0 than the next double
            (0.0016735384224566508, -50.1156387207955, 51.20352679471929, 5.379791675679887),
            65.19435514494359,
            7.357987405349278e-12,
            0.0056046776510399335,
        ),
    ],
)
def test_a_cusp_next_to_Omega_0_has_its_digits(design, F_0, Omega, A, excitation):
    mount = slowflow.Duffing(*design, excitation=excitation)
    level = F_0 if excitation == "force" else F_0 / Omega**2

    cusps = mount.cusps(A_max=1.0)

    assert cusps.Omega == pytest.approx([Omega], rel=1e-13, abs=0) and cusps.A == pytest.approx([A], rel=1e-14)
    assert cusps.F_0 == pytest.approx([level], rel=1e-13)
    if excitation == "base":
        onset = mount.saddle_node_onset()
        assert (onset.F_SN, onset.Omega, onset.A) == pytest.approx((level, Omega, A), rel=1e-13, abs=0)


def test_a_peak_by_inertia_beside_a_zero_of_h_is_found():
    """The branches that meet there are the ones that the states lie on."""
    mount = slowflow.Duffing(
        0.5458758695736523, -0.001181373076817857, 0.0, 7.894001479905327e-12, excitation="unbalance"
    )

    assert (
        mount.peak(8.298060153609718).A is None
    )  # it turns beyond the well, whose top is at sqrt(alpha/|beta|) = 21.5
    peak = solvers.peak(mount.model, 8.298060153609718)
    states = mount.amplitudes(Omega=0.2133004675098253, F_0=8.298060153609718)

    assert peak.A == pytest.approx(24.82120046422046, rel=1e-15)
    assert peak.Omega == pytest.approx(4.7940521170256493e-11, rel=1e-14, abs=0)
    assert states.A == pytest.approx([0.7552664571615544, 23.377677392673924, 24.132943849835478], rel=1e-14)


@pytest.mark.parametrize(
    ("design", "F_0", "Omega", "A"),
    [
        (
            (0.0006608772906922332, -0.14732792149632207, 0.00036167136263417024, 2.1592817574176304e-11),
            3.353305055455534e-10,
            2000.0,
            3.149493793439107e-10,
        ),
        (
            (0.274826669803216, -27.699243075979357, 0.00041624527217125297, 0.0002788972373001397),
            6.845338528996432e-12,
            1e6,
            6.845338508481958e-12,
        ),
    ],
)
def test_a_peak_by_inertia_that_is_below_F_0_by_rounding_leaves_the_states(design, F_0, Omega, A):
    """The response tends to F_0, an amplitude that the peak exceeds by less than a double."""
    states = slowflow.Duffing(*design, excitation="base").amplitudes(Omega=Omega, F_0=F_0)

    assert states.stable.tolist() == [True]
    assert states.A == pytest.approx([A], rel=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 1e-9])
@pytest.mark.parametrize("zeta", [1e-6, 1e-12, 1e-20, 1e-30, 1e-50])
def test_the_fold_locus_of_a_force_has_the_digits_of_its_level(zeta, mu):
    """F_A = 0 as a polynomial in Omega by mpmath, at each A: on one branch R is far below rounding of A Omega^2."""
    alpha, beta = 2.0, 0.5
    found = slowflow.Duffing(alpha, beta, mu=mu, zeta=zeta).fold_locus(A_max=3.0, samples=60)
    # what damping is too weak to hide begins at rest at the stiffness there
    assert found.Omega[found.A == 0] == pytest.approx(np.sqrt(alpha), rel=1e-15) and (found.Omega > 0.5).all()
    checked = set()
    with mpmath.workdps(150):
        m = 4 * mpmath.mpf(mu) / mpmath.pi
        for Omega, A, F_0 in zip(
            found.Omega.tolist(), map(mpmath.mpf, found.A.tolist()), found.F_0.tolist(), strict=True
        ):
            if not 0.05 < A < 3:
                continue
            h, h_A = -alpha * A - 0.75 * beta * A**3, -alpha - 2.25 * beta * A**2
            polynomial = [A, 0, h + A * h_A + 4 * mpmath.mpf(zeta) ** 2 * A, 2 * zeta * m, h * h_A]
            roots = mpmath.polyroots(polynomial, maxsteps=500, extraprec=1000)
            Omega = min((mpmath.re(root) for root in roots), key=lambda root: abs(root - Omega))
            level = mpmath.hypot(A * Omega**2 + h, 2 * mpmath.mpf(zeta) * A * Omega + m)
            assert F_0 == pytest.approx(float(level), rel=1e-13, abs=0)
            checked.add(bool(abs(A * Omega**2 + h) < 1e-3 * A))
    assert checked == {True, False}


@pytest.mark.parametrize("mu", [0.0, 0.0625])
@pytest.mark.parametrize("zeta", [1e-16, 1e-17, 1e-18, 1e-20, 1e-25])
def test_a_softening_fold_next_to_no_damping_has_its_frequency_and_the_curve_all_its_branches(mu, zeta):
    """Neither I nor R gave the fold's frequency a digit: it was that of another state, and two states were missing.

    What such damping changes of the undamped closed forms is less than a rounding: 1.5 A^3 = k at the fold, where
    Omega^2 = 2 - 2.25 A^2, and Omega^2 = 2 - .75 A^2 -+ k/A at the states.
    """
    oscillator, k = slowflow.Duffing(2.0, -1.0, mu, zeta), 0.25
    F_0 = float(np.hypot(k, oscillator.sticking_forcing))
    folds = oscillator.saddle_nodes(F_0)

    A = (k / 1.5) ** (1 / 3)
    assert folds.A == pytest.approx([A], rel=1e-14)
    assert folds.Omega == pytest.approx([np.sqrt(2 - 2.25 * A**2)], rel=1e-14)
    assert list(folds.kind) == ["jump-up"]
    curve = oscillator.frequency_response(F_0, samples=60)
    assert len(np.unique(curve.branch)) == 2
    for Omega, count in ((0.5, 3), (1.3, 1)):
        states = oscillator.amplitudes(Omega=Omega, F_0=F_0)
        at = np.array(states.A)
        assert len(at) == count
        np.testing.assert_allclose(np.abs((Omega**2 - 2 + 0.75 * at**2) * at), k, rtol=1e-13)


@pytest.mark.parametrize("zeta", [1e-14, 1e-12, 1e-10, 1e-8])
def test_an_isola_point_next_to_no_damping_is_off_by_its_rounding(zeta):
    """Newton's method in Omega and A divided by a difference of which nothing was left: A was off by 13 u.

    Against the root in A of Omega R = -zeta I with Omega^2 = h_A, which F_A = F_Omega = 0 are, to sixty digits.
    """
    rng, u = np.random.default_rng(1), mpmath.mpf(2) ** -53
    designs = [(rng.uniform(0.1, 3), -(10 ** rng.uniform(-3, 1)), 10 ** rng.uniform(-6, -1)) for _ in range(12)]
    designs += [(1.4980195101765232, -0.062511901945525, 0.00045200404964629135)]
    with mpmath.workdps(60):
        for alpha, beta, mu in designs:
            found = slowflow.Duffing(alpha, beta, mu, zeta).isola_points(A_max=200.0)
            m = 4 * mpmath.mpf(mu) / mpmath.pi

            def Omega_at(A, alpha=alpha, beta=beta):
                return mpmath.sqrt(-alpha - mpmath.mpf(9) / 4 * beta * A**2)

            def missing(A, alpha=alpha, beta=beta, m=m, Omega_at=Omega_at):
                w = Omega_at(A)
                R = A * w**2 - alpha * A - mpmath.mpf(3) / 4 * beta * A**3
                return R + zeta / w * (m + 2 * zeta * w * A)

            (k,) = np.flatnonzero(found.Omega > 1e-3)
            A = mpmath.findroot(missing, found.A[k])
            w = Omega_at(A)
            F_0 = (m + 2 * zeta * w * A) * mpmath.sqrt(1 + (zeta / w) ** 2)
            assert abs(found.A[k] / A - 1) <= 1.5 * u  # kappa is 1 between alpha and beta
            assert abs(found.Omega[k] / w - 1) <= 1.5 * u
            assert abs(found.F_0[k] / F_0 - 1) <= 2 * u


@pytest.mark.parametrize("zeta", [1e-7, 1e-9, 1e-12])
def test_all_of_a_resonance_so_sharp_that_rounding_leaves_nothing_of_R_is_stable(zeta):
    """A linear mount has one motion at each frequency, which is stable, and the closed form's height."""
    found = slowflow.Duffing(1.0, 0.0, zeta=zeta).frequency_response(1e-2, samples=400, Omega=(0.5, 1.5))
    assert found.stable.all() and len(found) > 400
    assert found.A.max() == pytest.approx(1e-2 / (2 * zeta), rel=1e-6)
