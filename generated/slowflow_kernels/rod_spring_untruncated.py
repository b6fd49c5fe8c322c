"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not
truncated.

Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
never edit.

Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them 21/20 times.
Rounding errors were measured with A, F_0 1e-09 to 1000; Omega 0.001 to 1000; alpha 1e-16 to 1000 of either sign or
0; beta 1e-12 to 1000 of either sign or 0; delta_h 1e-12 to 1; lam 1 to 100; mu, zeta 1e-12 to 1 or 0; r 1e-06 to
1e+06; u 1e-09 to 1000 of either sign or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow_kernels import slow_flow as flow
from slowflow.support.backend import NATIVE, compiled
from slowflow.support.broadcast import broadcast_outputs, by_regime, floats, number_by_regime
from slowflow.support.record import Curved, Law, Mechanism, Parameter, Scale

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

__all__ = [
    "F_A", "H_A", "H_AA", "MECHANISM", "F", "H", "averaged", "averaged_2", "averaged_H", "averaged_all", "backbone",
    "breakpoints", "by_design", "by_parameter", "coefficients", "detachment", "equivalent_damping", "fold_quartic",
    "force", "force_1", "force_1_u", "force_2", "force_2_u", "h", "h_A", "h_AA", "h_AAA", "hardening", "harmonics",
    "intercept", "jacobian", "jumps", "level", "limit_envelope", "peak_cubic", "phase", "response_quartic",
    "stability", "transmissibility",
]

#: x, X2, less, both, K at the nodes of a rule
_NODES_1 = (
    (0.99689348407464951, 0.99379661859049351, 0.0031065159253504597, 0.0030968654841560038, 0.007968192496166605),
    (0.53662414814201986, 0.28796547636914854, 0.46337585185798008, 0.24865867177287138, 0.086899787201082976),
    (0.44703376953808915, 0.19983919110743342, 0.55296623046191085, 0.24719457843065576, 0.092122522237786122),
    (0.35270472553087812, 0.12440062341181206, 0.64729527446912194, 0.22830410211906604, 0.096368737174644253),
    (0.25463692616788985, 0.064839964168231387, 0.7453630738321102, 0.18979696199965845, 0.099593420586795267),
    (0.15386991360858354, 0.023675950313912963, 0.8461300863914164, 0.13019396329467059, 0.1017623897484055),
    (0.051471842555317698, 0.0026493505760394136, 0.94852815744468233, 0.048822491979278279, 0.10285265289355884),
    (0.98366812327974718, 0.96760297675669993, 0.01633187672025279, 0.016065146523047254, 0.018466468311090958),
    (0.96002186496830755, 0.92164198121722729, 0.039978135031692487, 0.03837988375108025, 0.028784707883323369),
    (0.92620004742927431, 0.85784652785798998, 0.073799952570725677, 0.068353519571284313, 0.03879919256962705),
    (0.88256053579205274, 0.77891309933755515, 0.11743946420794732, 0.10364743645449757, 0.048402672830594053),
    (0.82956576238276836, 0.68817935411770381, 0.17043423761723162, 0.14138640826506463, 0.057493156217619065),
    (0.76777743210482619, 0.58948218524948104, 0.23222256789517381, 0.1782952468553452, 0.065974229882180491),
    (0.69785049479331585, 0.4869953130832757, 0.30214950520668421, 0.21085518171004011, 0.073755974737705204),
    (0.62052618298924289, 0.38505274377519932, 0.37947381701075716, 0.23547343921404354, 0.080755895229420213),
)

#: x, X2, less, both, K at the nodes of a rule
_NODES_2 = (
    (0.99877100725242607, 0.99754352492802578, 0.0012289927475738814, 0.0012274823244002922, 0.0031533460523058385),
    (0.80706620402944262, 0.65135585768649396, 0.19293379597055738, 0.15571034634294872, 0.038241351065830709),
    (0.76715903251574036, 0.58853298117048669, 0.23284096748425967, 0.17862605134525358, 0.041545082943464748),
    (0.72403413092381463, 0.52422542274260353, 0.27596586907618537, 0.19980870818121108, 0.04467456085669428),
    (0.67787237963266389, 0.45951096306885042, 0.32212762036733611, 0.2183614165638135, 0.047616658492490478),
    (0.6288673967765136, 0.395474202728469, 0.3711326032234864, 0.23339319404804459, 0.050359035553854473),
    (0.57722472608397268, 0.33318838440271731, 0.42277527391602732, 0.24403634168125538, 0.052890189485193667),
    (0.523160974722233, 0.27369740547231697, 0.47683902527776695, 0.24946356924991608, 0.055199503699984165),
    (0.46690290475095841, 0.21799832246488254, 0.53309709524904159, 0.24890458228607587, 0.057277292100403214),
    (0.40868648199071672, 0.16702464056194843, 0.59131351800928322, 0.24166184142876829, 0.059114839698395635),
    (0.34875588629216075, 0.12163066822343055, 0.6512441137078393, 0.22712521806873018, 0.060704439165893881),
    (0.99353017226635076, 0.98710220320360464, 0.0064698277336492421, 0.0064279690627461455, 0.0073275539012762625),
    (0.28736248735545555, 0.082577199139114363, 0.71263751264454445, 0.2047852882163412, 0.062039423159892665),
    (0.22476379039468905, 0.050518761472587721, 0.77523620960531092, 0.17424502892210134, 0.06311419228625402),
    (0.16122235606889171, 0.025992648096404506, 0.83877764393110832, 0.13522970797248721, 0.063924238584648185),
    (0.097004699209462697, 0.0094099116687183324, 0.90299530079053725, 0.087594787540744359, 0.064466164435950088),
    (0.03238017096286936, 0.0010484754715846482, 0.96761982903713062, 0.031331695491284714, 0.064737696812683918),
    (0.98412458372282685, 0.96850119628762721, 0.015875416277173142, 0.015623387435199608, 0.01147723457923454),
    (0.97059159254624727, 0.94204803952146043, 0.029408407453752748, 0.028543553024786811, 0.015579315722943849),
    (0.95298770316043091, 0.90818556237499348, 0.047012296839569138, 0.044802140785437379, 0.019616160457355529),
    (0.93138669070655433, 0.86748116762530669, 0.068613309293445668, 0.063905523081247625, 0.02357076083932438),
    (0.90587913671556963, 0.82061701033654577, 0.094120863284430326, 0.085262126379023903, 0.027426509708356948),
    (0.87657202027424785, 0.76837850672767649, 0.12342797972575212, 0.10819351354657145, 0.03116722783279809),
    (0.84358826162439349, 0.71164115515046622, 0.15641173837560646, 0.13194710647392729, 0.034777222564770442),
)

#: X2, K2 at the nodes of a rule
_NODES_3 = (
    (0.99379661859049351, 0.0079187627589685176),
    (0.28796547636914854, 0.025024138617737494),
    (0.19983919110743342, 0.018409690326775727),
    (0.12440062341181206, 0.011988330981934815),
    (0.064839964168231387, 0.0064576338222394032),
    (0.023675950313912963, 0.0024093212835082948),
    (0.0026493505760394136, 0.00027249273519073196),
    (0.96760297675669993, 0.017868209707994881),
    (0.92164198121722729, 0.026529195202345292),
    (0.85784652785798998, 0.033283752629548087),
    (0.77891309933755515, 0.037701475910699687),
    (0.68817935411770381, 0.039565603112029335),
    (0.58948218524948104, 0.038890633201099367),
    (0.4869953130832757, 0.035918814009150916),
    (0.38505274377519932, 0.031095279034110784),
)

#: s, cosine at the nodes of a rule
_NODES_4 = (
    (0.03925981575906861, 0.9992290362407229),
    (0.67880074553294178, 0.73432250943568556),
    (0.73432250943568556, 0.67880074553294178),
    (0.78531693088074495, 0.61909394930983397),
    (0.83146961230254524, 0.55557023301960218),
    (0.87249600707279706, 0.48862124149695496),
    (0.90814317382508125, 0.41865973753742808),
    (0.93819133592248416, 0.34611705707749296),
    (0.96245523645364728, 0.27144044986507426),
    (0.98078528040323043, 0.19509032201612828),
    (0.99306845695492629, 0.11753739745783764),
    (0.11753739745783764, 0.99306845695492629),
    (0.9992290362407229, 0.03925981575906861),
    (0.19509032201612828, 0.98078528040323043),
    (0.27144044986507426, 0.96245523645364728),
    (0.34611705707749296, 0.93819133592248416),
    (0.41865973753742808, 0.90814317382508125),
    (0.48862124149695496, 0.87249600707279706),
    (0.55557023301960218, 0.83146961230254524),
    (0.61909394930983397, 0.78531693088074495),
)

#: x, x2, less, weight at the nodes of a rule
_NODES_5 = (
    (0.99839961899006247, 0.99680179919950185, 0.0016003810099375849, 0.0041059986046490847),
    (0.75127993568948048, 0.56442154176958992, 0.24872006431051952, 0.048778140792803244),
    (0.70049459055617125, 0.49069267139845796, 0.29950540944382881, 0.052746295699174071),
    (0.64588338886924779, 0.41716535201722399, 0.35411661113075216, 0.056426369358018383),
    (0.58774459748510932, 0.34544371187293316, 0.41225540251489068, 0.059798262227586656),
    (0.52639574993119231, 0.27709248554562232, 0.47360425006880769, 0.062843558045002579),
    (0.46217191207042191, 0.21360287630682981, 0.53782808792957804, 0.065545624364908975),
    (0.39542385204297503, 0.15636002276450464, 0.60457614795702497, 0.067889703376521948),
    (0.32651612446541151, 0.1066127795359121, 0.67348387553458844, 0.069862992492594159),
    (0.25582507934287907, 0.065446471220790378, 0.74417492065712088, 0.071454714265170985),
    (0.18373680656485455, 0.033759214086650779, 0.81626319343514542, 0.072656175243804105),
    (0.9915772883408609, 0.9832255187534148, 0.0084227116591390795, 0.0095362203017485027),
    (0.11064502720851987, 0.012242322045974101, 0.88935497279148013, 0.073460813453467527),
    (0.036948943165351779, 0.0013652244010363957, 0.9630510568346482, 0.073864234232172879),
    (0.97934250806374823, 0.95911174810059274, 0.020657491936251805, 0.014922443697357493),
    (0.9617593653382045, 0.92498107681574593, 0.03824063466179551, 0.020227869569052644),
    (0.93892355735498823, 0.88157744655614578, 0.061076442645011823, 0.025422959526113047),
    (0.91095972490412747, 0.82984762039740356, 0.089040275095872548, 0.030479240699603467),
    (0.87802056981217269, 0.77092012101329255, 0.12197943018782725, 0.03536907109759211),
    (0.84028598326181692, 0.70608053366627843, 0.15971401673818311, 0.040065735180692265),
    (0.79796205325548741, 0.63674343843571335, 0.20203794674451259, 0.044543577771965881),
)


def _arc_node(X2, K2, T2, W):
    """The term of int sin^2 at a node."""
    g = 1.0 / (T2 * X2 + 1.0)
    g2 = g * g
    g3 = g * g2
    return W + K2 * g3


def _duplication(x_0, x_1, x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3, total_0, total_1, total_2, total_3, turns):
    """Duplications of the arguments of R_D, and the sum of what they take off over 3, as Taylor series."""
    for _ in range(turns):
        a_0 = np.sqrt(x_0)
        a_half_0 = 0.5 / a_0
        a1_0 = a_half_0 * x_1
        a2_0 = a_half_0 * (-a1_0 * a1_0 + x_2)
        a3_0 = a_half_0 * (-2.0 * a1_0 * a2_0 + x_3)
        b_0 = np.sqrt(y_0)
        b_half_0 = 0.5 / b_0
        b1_0 = b_half_0 * y_1
        b2_0 = b_half_0 * (-b1_0 * b1_0 + y_2)
        b3_0 = b_half_0 * (-2.0 * b1_0 * b2_0 + y_3)
        c_0 = np.sqrt(z_0)
        c_half_0 = 0.5 / c_0
        c1_0 = c_half_0 * z_1
        c2_0 = c_half_0 * (-c1_0 * c1_0 + z_2)
        c3_0 = c_half_0 * (-2.0 * c1_0 * c2_0 + z_3)
        lam_0 = a_0 * b_0 + c_0 * (a_0 + b_0)
        lam_1 = a1_0 * b_0 + a_0 * b1_0 + c1_0 * (a_0 + b_0) + c_0 * (a1_0 + b1_0)
        lam_2 = (
            a1_0 * b1_0 + a2_0 * b_0 + a_0 * b2_0 + c1_0 * (a1_0 + b1_0) + c2_0 * (a_0 + b_0) + c_0 * (a2_0 + b2_0)
        )
        lam_3 = (
            a1_0 * b2_0 + a2_0 * b1_0 + a3_0 * b_0 + a_0 * b3_0 + c1_0 * (a2_0 + b2_0) + c2_0 * (a1_0 + b1_0) + c3_0 *
            (a_0 + b_0) + c_0 * (a3_0 + b3_0)
        )
        q_0 = lam_0 + z_0
        q_1 = lam_1 + z_1
        q_2 = lam_2 + z_2
        q_3 = lam_3 + z_3
        below_0 = c_0 * q_0
        below_1 = c1_0 * q_0 + c_0 * q_1
        below_2 = c1_0 * q_1 + c2_0 * q_0 + c_0 * q_2
        below_3 = c1_0 * q_2 + c2_0 * q_1 + c3_0 * q_0 + c_0 * q_3
        term_0 = 1.0 / below_0
        term1_0 = -below_1 * term_0 * term_0
        term2_0 = -term_0 * (below_1 * term1_0 + below_2 * term_0)
        term3_0 = -term_0 * (below_1 * term2_0 + below_2 * term1_0 + below_3 * term_0)
        X_0 = 0.25 * lam_0 + 0.25 * x_0
        X_1 = 0.25 * lam_1 + 0.25 * x_1
        X_2 = 0.25 * lam_2 + 0.25 * x_2
        X_3 = 0.25 * lam_3 + 0.25 * x_3
        Y_0 = 0.25 * lam_0 + 0.25 * y_0
        Y_1 = 0.25 * lam_1 + 0.25 * y_1
        Y_2 = 0.25 * lam_2 + 0.25 * y_2
        Y_3 = 0.25 * lam_3 + 0.25 * y_3
        Z_0 = 0.25 * lam_0 + 0.25 * z_0
        Z_1 = 0.25 * lam_1 + 0.25 * z_1
        Z_2 = 0.25 * lam_2 + 0.25 * z_2
        Z_3 = 0.25 * lam_3 + 0.25 * z_3
        x_0, x_1, x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3, total_0, total_1, total_2, total_3 = (
            X_0, X_1, X_2, X_3, Y_0, Y_1, Y_2, Y_3, Z_0, Z_1, Z_2, Z_3, term_0 + 4.0 * total_0, term1_0 + 4.0 *
            total_1, term2_0 + 4.0 * total_2, term3_0 + 4.0 * total_3,
        )
    return x_0, x_1, x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3, total_0, total_1, total_2, total_3


def _remainder(x_0, x_1, x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3):
    """R_D of arguments that are nearly equal, as a Taylor series."""
    mean_0 = 0.20000000000000001 * x_0 + 0.20000000000000001 * y_0 + 0.59999999999999998 * z_0
    mean_1 = 0.20000000000000001 * x_1 + 0.20000000000000001 * y_1 + 0.59999999999999998 * z_1
    mean_2 = 0.20000000000000001 * x_2 + 0.20000000000000001 * y_2 + 0.59999999999999998 * z_2
    mean_3 = 0.20000000000000001 * x_3 + 0.20000000000000001 * y_3 + 0.59999999999999998 * z_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    dx_0 = over_0 * (mean_0 - x_0)
    dx_1 = over1_0 * (mean_0 - x_0) + over_0 * (mean_1 - x_1)
    dx_2 = over1_0 * (mean_1 - x_1) + over2_0 * (mean_0 - x_0) + over_0 * (mean_2 - x_2)
    dx_3 = (
        over1_0 * (mean_2 - x_2) + over2_0 * (mean_1 - x_1) + over3_0 * (mean_0 - x_0) + over_0 * (mean_3 - x_3)
    )
    dy_0 = over_0 * (mean_0 - y_0)
    dy_1 = over1_0 * (mean_0 - y_0) + over_0 * (mean_1 - y_1)
    dy_2 = over1_0 * (mean_1 - y_1) + over2_0 * (mean_0 - y_0) + over_0 * (mean_2 - y_2)
    dy_3 = (
        over1_0 * (mean_2 - y_2) + over2_0 * (mean_1 - y_1) + over3_0 * (mean_0 - y_0) + over_0 * (mean_3 - y_3)
    )
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E3_3 = (
        dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 - 8.0 * zz_1) +
        dz_3 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E4_3 = (
        zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 - 3.0 * zz_1) +
        zz_3 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    E5_3 = (
        dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 *
        zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 + 0.20454545454545456 * E2_1 * E2_2 -
        0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 - 0.13636363636363635 * E4_3 + 0.11538461538461539 *
        E5_3
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0
    return (
        power_0 * series_0,
        power_0 * series_1 + power_1 * series_0,
        power_0 * series_2 + power_1 * series_1 + power_2 * series_0,
        power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0,
    )


def _duplications(X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, Y0_2, Y0_3, Z0_0, Z0_1, Z0_2, Z0_3, term0_0, term0_1, term0_2, term0_3):
    """R_D by what one duplication has made of its arguments and has taken off, as a Taylor series."""
    X_0, X_1, X_2, X_3, Y_0, Y_1, Y_2, Y_3, Z_0, Z_1, Z_2, Z_3, total_0, total_1, total_2, total_3 = _duplication(
        X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, Y0_2, Y0_3, Z0_0, Z0_1, Z0_2, Z0_3, term0_0, term0_1, term0_2, term0_3,
        5
    )
    last_0, last_1, last_2, last_3 = _remainder(X_0, X_1, X_2, X_3, Y_0, Y_1, Y_2, Y_3, Z_0, Z_1, Z_2, Z_3)
    return (
        0.000244140625 * last_0 + 0.0029296875 * total_0,
        0.000244140625 * last_1 + 0.0029296875 * total_1,
        0.000244140625 * last_2 + 0.0029296875 * total_2,
        0.000244140625 * last_3 + 0.0029296875 * total_3,
    )


def _common_1(A, delta_h):
    """What averaged_all_passed_1_steep_far, averaged_all_passed_1_steep_away have in common."""
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    c2 = c * c
    lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0)
    half = 0.5 * (A - u_cr) * (A + u_cr)
    root = np.sqrt(2.0 * half - 0.5 * np.abs(half - lacking) + 0.5 * np.abs(half + lacking))
    A2 = A * A
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    a03_0 = -2.0 * a02_0 * a0_half_0_2
    b0_0 = np.sqrt(c2)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    lam0_3 = a03_0 * b0_0 + a03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    X0_2 = 0.25 * lam0_2
    X0_3 = 0.25 * lam0_3
    Y0_0 = 0.25 * c2 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Z0_0 = 0.25 * lam0_0 + 0.25
    R_0, R_1, R_2, R_3 = _duplications(
        X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, X0_2, X0_3, Z0_0, Y0_1, X0_2, X0_3, term0_0, term01_0, term02_0,
        term03_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    x2_2 = x2 * x2
    V6 = 2.6666666666666665 * R_2 * third * x2_2
    x2_3 = x2 * x2_2
    V8 = -3.2000000000000002 * R_3 * third * x2_3
    return u_cr, c, root, V2, V4, V6, V8


def _common_2(A, T, beta, c, root, sum_0, sum_1, sum_2, sum_3, u_cr):
    """The outputs of averaged_all_passed_1, averaged_all_passed_1_steeper."""
    t0 = T * T
    A2 = A * A
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    T4 = t0 * t0
    T5 = T * T4
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    root2 = root * root
    root3 = root * root2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0,
        -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root)),
        -2.5464790894703255 * beta * (96.0 * T5 * sum_3 - 3.0 * u_cr5 / (A4 * c5 * root) + 3.0 * u_cr5 / (A4 * c3 *
        root) + u_cr5 / (A2 * c3 * root3)),
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c,
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c),
        81.487330863050417 * A3 * T5 * beta * sum_1,
    )


def _far_node(x, X2, less, both, K, c, T2, U2, W, Wq, Wq_2, Wq_3):
    """Terms of int sin^2 tan^(2n) (1/c - 1/Delta) at a node, by n."""
    g = 1.0 / (T2 * X2 + 1.0)
    v2 = X2 * g * g
    square = -U2 * v2 + 1.0
    delta = np.sqrt(square)
    f = K * g * v2 / delta
    term = f * g * (-T2 * both + less) * (g * (T2 * x + x) + 1.0) / (c + delta)
    t0 = -T2 * X2 + 1.0
    q = 4.0 * T2 * X2 / (t0 * t0)
    q2 = q * q
    q3 = q * q2
    return W + term, Wq + q * term, Wq_2 + q2 * term, Wq_3 + q3 * term


def _harmonic_node(x, x2, less, weight, T, T2, c, A, u_cr, sum_3_0, sum_3_1, sum_3_2, sum_3_3, sum_5_0, sum_5_1, sum_5_2, sum_5_3):
    """Terms of int g^(j)(A s) s^j T_n dt at a node, by n, then by j."""
    g = 1.0 / (T2 * x2 + 1.0)
    s = 2.0 * T * g * x
    v = A * s
    square = (1.0 - v) * (v + 1.0)
    delta = np.sqrt(square)
    below = g * less * (-T2 * x + 1.0)
    above = g * x * (T2 + 1.0) + 1.0
    inverse = -above * below * u_cr * u_cr / (c * delta * (c + delta))
    scale = 2.0 * T * g * weight
    s2 = s * s
    v2 = v * v
    s3 = s * s2
    square2 = square * square
    s4 = s2 * s2
    square3 = square * square2
    return (
        sum_3_0 + (inverse * s * scale * v * (4.0 * s2 - 3.0)),
        sum_3_1 + (s2 * scale * (inverse + v2 / (delta * square)) * (4.0 * s2 - 3.0)),
        sum_3_2 + (3.0 * s3 * scale * v * (4.0 * s2 - 3.0) / (delta * square2)),
        sum_3_3 + (s4 * scale * (4.0 * s2 - 3.0) * (12.0 * v2 + 3.0) / (delta * square3)),
        sum_5_0 + (inverse * s * scale * v * (s2 * (16.0 * s2 - 20.0) + 5.0)),
        sum_5_1 + (s2 * scale * (inverse + v2 / (delta * square)) * (s2 * (16.0 * s2 - 20.0) + 5.0)),
        sum_5_2 + (3.0 * s3 * scale * v * (s2 * (16.0 * s2 - 20.0) + 5.0) / (delta * square2)),
        sum_5_3 + (s4 * scale * (12.0 * v2 + 3.0) * (s2 * (16.0 * s2 - 20.0) + 5.0) / (delta * square3)),
    )


def _means(a, b, e, total, squares, quarter, turns):
    """Steps of the arithmetic-geometric mean, with the sum of its differences and that of their squares by weight."""
    for _ in range(turns):
        mean = 0.5 * a + 0.5 * b
        difference = e * e * quarter / mean
        a, b, e, total, squares = (
            mean, np.sqrt(a) * np.sqrt(b), difference, difference + total, difference * difference + 0.5 * squares,
        )
    return a, b, e, total, squares


def _midpoint(s, cosine, A, moment_3_0, moment_3_1, moment_3_2, moment_3_3, moment_5_0, moment_5_1, moment_5_2, moment_5_3):
    """Terms of int f^(n + j)(A s) s^j cos^(2n) t dt at a point, by n, then by j."""
    v = A * s
    delta = np.sqrt(1.0 - v) * np.sqrt(v + 1.0)
    cosine2 = cosine * cosine
    cosine3 = cosine * cosine2
    cosine6 = cosine3 * cosine3
    delta2 = delta * delta
    delta3 = delta * delta2
    delta6 = delta3 * delta3
    delta7 = delta * delta6
    v2 = v * v
    delta4 = delta2 * delta2
    delta8 = delta4 * delta4
    delta9 = delta * delta8
    delta5 = delta * delta4
    delta10 = delta5 * delta5
    delta11 = delta * delta10
    s2 = s * s
    delta12 = delta6 * delta6
    delta13 = delta * delta12
    s3 = s * s2
    cosine4 = cosine2 * cosine2
    cosine5 = cosine * cosine4
    cosine10 = cosine5 * cosine5
    delta14 = delta7 * delta7
    delta15 = delta * delta14
    delta16 = delta8 * delta8
    delta17 = delta * delta16
    return (
        moment_3_0 + (cosine6 * (12.0 * v2 + 3.0) / delta7),
        moment_3_1 + (cosine6 * s * v * (60.0 * v2 + 45.0) / delta9),
        moment_3_2 + (cosine6 * s2 * (v2 * (360.0 * v2 + 540.0) + 45.0) / delta11),
        moment_3_3 + (cosine6 * s3 * v * (v2 * (2520.0 * v2 + 6300.0) + 1575.0) / delta13),
        moment_5_0 + (cosine10 * (v2 * (360.0 * v2 + 540.0) + 45.0) / delta11),
        moment_5_1 + (cosine10 * s * v * (v2 * (2520.0 * v2 + 6300.0) + 1575.0) / delta13),
        moment_5_2 + (cosine10 * s2 * (v2 * (v2 * (20160.0 * v2 + 75600.0) + 37800.0) + 1575.0) / delta15),
        moment_5_3 + (cosine10 * s3 * v * (v2 * (v2 * (181440.0 * v2 + 952560.0) + 793800.0) + 99225.0) / delta17),
    )


def _near_node(x, X2, less, both, K, c, T2, U2, W, V3, V5, V7):
    """Terms of int sin^2 (1/c - 1/Delta), sin^4/Delta^3, sin^4/Delta^5, sin^4 (1 + 4 u^2)/Delta^7 at a node."""
    g = 1.0 / (T2 * X2 + 1.0)
    v2 = X2 * g * g
    square = -U2 * v2 + 1.0
    delta = np.sqrt(square)
    f = K * g * v2 / delta
    fall = f * v2 / square
    return (
        W + (f * g * (-T2 * both + less) * (g * (T2 * x + x) + 1.0) / (c + delta)),
        V3 + fall,
        V5 + fall / square,
        V7 + (fall * (4.0 * U2 * v2 + 1.0) / (square * square)),
    )


def _tangent_node(X2, K2, T2, W, Wq, Wq_2, Wq_3):
    """Terms of int sin^2 tan^(2n) at a node, by n."""
    g = 1.0 / (T2 * X2 + 1.0)
    g2 = g * g
    g3 = g * g2
    term = K2 * g3
    t0 = -T2 * X2 + 1.0
    q = 4.0 * T2 * X2 / (t0 * t0)
    q2 = q * q
    q3 = q * q2
    return W + term, Wq + q * term, Wq_2 + q2 * term, Wq_3 + q3 * term


def _averaged_all_passed_0_end(A, alpha, beta, delta_h):
    m = A * A
    k_c = 1.0 - delta_h
    k = k_c * k_c
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    square = e_1 * e_1
    quarter = 0.25 * m
    a_8, b_8, e_8, total, squares = _means(a_1, b_1, e_1, e_1, square, quarter, 7)
    a_9 = 0.5 * a_8 + 0.5 * b_8
    t0 = 1.0 / a_9
    e_9 = e_8 * e_8 * quarter * t0
    e = e_9 + total
    tau = 512.0 * e_9 * e_9 + 256.0 * squares
    P = m * t0 * (e + tau)
    B = t0 * (-m * tau + 1.0)
    C = 2.0 * t0 * tau
    t1 = 2.0 * beta
    t2 = A * t1
    t3 = P * t2
    t4 = 1.0 / k
    t5 = B * t4
    t6 = alpha + t1 * (-C * m + P + m * t5)
    k2 = k * k
    t7 = 1.0 / k2
    k3 = k * k2
    return (
        -A * alpha - t3,
        -t6,
        -t2 * (2.0 * B * t7 + C * t4),
        -t1 * (B * (5.0 * m + 3.0) / k3 + C * t7 * (7.0 * m - 3.0)),
        -A * (alpha - 1.0) - t3,
        1.0 - t6,
        4.0 * A * beta * m * (-0.5 * C + 0.5 * t5),
    )


def _averaged_all_passed_0(A, alpha, beta, delta_h):
    m = A * A
    t0 = 1.0 - m
    k_c = np.sqrt(t0)
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    square = e_1 * e_1
    quarter = 0.25 * m
    a_3, b_3, e_3, total, squares = _means(a_1, b_1, e_1, e_1, square, quarter, 2)
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t1 = 1.0 / a_4
    e_4 = e_3 * e_3 * quarter * t1
    e = e_4 + total
    tau = 16.0 * e_4 * e_4 + 8.0 * squares
    P = m * t1 * (e + tau)
    B = t1 * (-m * tau + 1.0)
    C = 2.0 * t1 * tau
    t2 = 2.0 * beta
    t3 = A * t2
    t4 = P * t3
    t5 = 1.0 / t0
    t6 = B * t5
    t7 = alpha + t2 * (-C * m + P + m * t6)
    k2 = t0 * t0
    t8 = 1.0 / k2
    k3 = k2 * t0
    return (
        -A * alpha - t4,
        -t7,
        -t3 * (2.0 * B * t8 + C * t5),
        -t2 * (B * (5.0 * m + 3.0) / k3 + C * t8 * (7.0 * m - 3.0)),
        -A * (alpha - 1.0) - t4,
        1.0 - t7,
        4.0 * A * beta * m * (-0.5 * C + 0.5 * t6),
    )


def _averaged_all_passed_0_steep(A, alpha, beta, delta_h):
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    square = e_1 * e_1
    quarter = 0.25 * m
    a_7, b_7, e_7, total, squares = _means(a_1, b_1, e_1, e_1, square, quarter, 6)
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t2 = 1.0 / a_8
    e_8 = e_7 * e_7 * quarter * t2
    e = e_8 + total
    tau = 256.0 * e_8 * e_8 + 128.0 * squares
    P = m * t2 * (e + tau)
    B = t2 * (-m * tau + 1.0)
    C = 2.0 * t2 * tau
    t3 = 2.0 * beta
    t4 = A * t3
    t5 = P * t4
    t6 = 1.0 / k
    t7 = B * t6
    t8 = alpha + t3 * (-C * m + P + m * t7)
    k2 = k * k
    t9 = 1.0 / k2
    k3 = k * k2
    return (
        -A * alpha - t5,
        -t8,
        -t4 * (2.0 * B * t9 + C * t6),
        -t3 * (B * (5.0 * m + 3.0) / k3 + C * t9 * (7.0 * m - 3.0)),
        -A * (alpha - 1.0) - t5,
        1.0 - t8,
        4.0 * A * beta * m * (-0.5 * C + 0.5 * t7),
    )


def _averaged_all_passed_1_far(A, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    root = np.sqrt((A - u_cr) * (A + u_cr))
    T = u_cr / (A + root)
    t0 = T * T
    A2 = A * A
    U2 = 4.0 * A2 * t0
    sum_0 = sum_1 = sum_2 = sum_3 = 0.0
    for x, X2, less, both, K in _NODES_1:
        sum_0, sum_1, sum_2, sum_3 = _far_node(x, X2, less, both, K, c, t0, U2, sum_0, sum_1, sum_2, sum_3)
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 * T3 *
        sum_2 * u_cr2 / c) / A,
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0 * T3 *
        sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2,
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c),
        2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 * u_cr2 / c + 8.0 * T3 * sum_1 * u_cr2 / c),
    )


def _averaged_all_passed_1(A, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    root = np.sqrt((A - u_cr) * (A + u_cr))
    T = u_cr / (A + root)
    t0 = T * T
    A2 = A * A
    U2 = 4.0 * A2 * t0
    sum_0 = sum_1 = sum_2 = sum_3 = 0.0
    for x, X2, less, both, K in _NODES_1:
        sum_0, sum_1, sum_2, sum_3 = _near_node(x, X2, less, both, K, c, t0, U2, sum_0, sum_1, sum_2, sum_3)
    result_0, result_1, result_2, result_3, result_4, result_5, result_6 = _common_2(
        A, T, beta, c, root, sum_0, sum_1, sum_2, sum_3, u_cr
    )
    return result_0, result_1, result_2, result_3, result_4, result_5, result_6


def _averaged_all_passed_1_steeper_far(A, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    root = np.sqrt((A - u_cr) * (A + u_cr))
    T = u_cr / (A + root)
    t0 = T * T
    A2 = A * A
    U2 = 4.0 * A2 * t0
    sum_0 = sum_1 = sum_2 = sum_3 = 0.0
    for x, X2, less, both, K in _NODES_2:
        sum_0, sum_1, sum_2, sum_3 = _far_node(x, X2, less, both, K, c, t0, U2, sum_0, sum_1, sum_2, sum_3)
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 * T3 *
        sum_2 * u_cr2 / c) / A,
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0 * T3 *
        sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2,
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c),
        2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 * u_cr2 / c + 8.0 * T3 * sum_1 * u_cr2 / c),
    )


def _averaged_all_passed_1_steeper(A, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    c2 = c * c
    lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0)
    half = 0.5 * (A - u_cr) * (A + u_cr)
    root = np.sqrt(2.0 * half - 0.5 * np.abs(half - lacking) + 0.5 * np.abs(half + lacking))
    T = u_cr / (A + root)
    t0 = T * T
    A2 = A * A
    U2 = 4.0 * A2 * t0
    sum_0 = sum_1 = sum_2 = sum_3 = 0.0
    for x, X2, less, both, K in _NODES_2:
        sum_0, sum_1, sum_2, sum_3 = _near_node(x, X2, less, both, K, c, t0, U2, sum_0, sum_1, sum_2, sum_3)
    result_0, result_1, result_2, result_3, result_4, result_5, result_6 = _common_2(
        A, T, beta, c, root, sum_0, sum_1, sum_2, sum_3, u_cr
    )
    return result_0, result_1, result_2, result_3, result_4, result_5, result_6


def _averaged_all_passed_1_steep_far(A, alpha, beta, delta_h):
    u_cr, c, root, V2, V4, V6, V8 = _common_1(A, delta_h)
    T = u_cr / (A + root)
    t0 = T * T
    A2 = A * A
    sum_0 = sum_1 = sum_2 = sum_3 = 0.0
    for X2, K2 in _NODES_3:
        sum_0, sum_1, sum_2, sum_3 = _tangent_node(X2, K2, t0, sum_0, sum_1, sum_2, sum_3)
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c - 6.0 *
        V2 - 7.0 * V4 - 3.0 * V6) / A,
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 / c - 384.0 * T3 * sum_1 / c - 360.0 * T3 * sum_2 / c -
        120.0 * T3 * sum_3 / c + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8) / A2,
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2),
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4),
        2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 / c + 8.0 * T3 * sum_1 / c - 3.0 * V2 - V4),
    )


def _averaged_all_passed_1_steep_away(A, alpha, beta, delta_h):
    u_cr, c, root, V2, V4, V6, V8 = _common_1(A, delta_h)
    A2 = A * A
    theta = np.arctan2(u_cr, root)
    tangent = u_cr / root
    sum_0 = 0.5 * theta - 0.5 * root * u_cr / A2
    tangents_1 = tangent - theta
    sum_1 = -sum_0 + tangents_1
    tangent2 = tangent * tangent
    tangent3 = tangent * tangent2
    tangents_2 = 0.33333333333333331 * tangent3 - tangents_1
    sum_2 = -sum_1 + tangents_2
    tangent4 = tangent2 * tangent2
    tangent5 = tangent * tangent4
    tangents_3 = 0.20000000000000001 * tangent5 - tangents_2
    sum_3 = -sum_2 + tangents_3
    return (
        2.5464790894703255 * A * beta * (-V2 + sum_0 / c) - A,
        2.5464790894703255 * beta * (2.0 * V2 + V4 - 2.0 * sum_0 / c - sum_1 / c) - 1.0,
        2.5464790894703255 * beta * (-6.0 * V2 - 7.0 * V4 - 3.0 * V6 + 6.0 * sum_0 / c + 7.0 * sum_1 / c + 3.0 *
        sum_2 / c) / A,
        2.5464790894703255 * beta * (24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8 - 24.0 * sum_0 / c - 48.0 * sum_1
        / c - 45.0 * sum_2 / c - 15.0 * sum_3 / c) / A2,
        2.5464790894703255 * A * beta * (-V2 + sum_0 / c),
        2.5464790894703255 * beta * (2.0 * V2 + V4 - 2.0 * sum_0 / c - sum_1 / c),
        2.5464790894703255 * A * beta * (-3.0 * V2 - V4 + 3.0 * sum_0 / c + sum_1 / c),
    )


def _averaged_all_passed_1_steep(A, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    c2 = c * c
    lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0)
    half = 0.5 * (A - u_cr) * (A + u_cr)
    root = np.sqrt(2.0 * half - 0.5 * np.abs(half - lacking) + 0.5 * np.abs(half + lacking))
    T = u_cr / (A + root)
    t0 = T * T
    u_cr2 = u_cr * u_cr
    A2 = A * A
    x2 = u_cr2 / A2
    root2 = root * root
    y2 = root2 / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(c2)
    b0_half_0 = 0.5 / b0_0
    b0_half_0_2 = b0_half_0 * b0_half_0
    b0_half_0_3 = b0_half_0 * b0_half_0_2
    b02_0 = -b0_half_0_3
    b03_0 = -2.0 * b02_0 * b0_half_0_2
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    lam0_2 = a0_0 * b02_0 + b02_0
    lam0_3 = a0_0 * b03_0 + b03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    X0_2 = 0.25 * lam0_2
    X0_3 = 0.25 * lam0_3
    Y0_0 = 0.25 * c2 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Z0_0 = 0.25 * lam0_0 + 0.25
    R_0, R_1, R_2, R_3 = _duplications(
        X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, X0_2, X0_3, Z0_0, X0_1, X0_2, X0_3, term0_0, term01_0, term02_0,
        term03_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    x2_2 = x2 * x2
    V6 = 2.6666666666666665 * R_2 * third * x2_2
    x2_3 = x2 * x2_2
    V8 = -3.2000000000000002 * R_3 * third * x2_3
    sum_0 = 0.0
    for X2, K2 in _NODES_3:
        sum_0 = _arc_node(X2, K2, t0, sum_0)
    T3 = T * t0
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c3 = c * c2
    root3 = root * root2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0,
        -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root)),
        -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 - 3.0 * u_cr5 / (A4 * c5 *
        root) + 3.0 * u_cr5 / (A4 * c3 * root) + u_cr5 / (A2 * c3 * root3)),
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2),
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2),
        2.5464790894703255 * A3 * V4 * beta,
    )


def averaged_all(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """h, h_A, h_AA, h_AAA, H, H_A, h - A h_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 162 in passed_0_end, 97 in passed_0, 153 in
    passed_0_steep, 655 in passed_1_far, 615 in passed_1, 988 in passed_1_steeper_far, 944 in passed_1_steeper, 1673
    in passed_1_steep_far, 1357 in passed_1_steep_away, 1444 in passed_1_steep. Error / u (1 + kappa): measured 3.8.
    """
    A, alpha, beta, delta_h = arguments = floats(A, alpha, beta, delta_h)
    bodies = (_averaged_all_passed_0_end, _averaged_all_passed_0, _averaged_all_passed_0_steep, _averaged_all_passed_1_far, _averaged_all_passed_1, _averaged_all_passed_1_steeper_far, _averaged_all_passed_1_steeper, _averaged_all_passed_1_steep_far, _averaged_all_passed_1_steep_away, _averaged_all_passed_1_steep)
    return by_regime(((A <= np.sqrt(-delta_h * delta_h + 2.0 * delta_h)) & (np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A), (A <= np.sqrt(-delta_h * delta_h + 2.0 * delta_h)) & (A <= 0.69999999999999996), A <= np.sqrt(-delta_h * delta_h + 2.0 * delta_h), (np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75) & (1.05 * np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A), np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75, (np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004) & (1.05 * np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A), np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004, 1.05 * np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A, np.sqrt(-0.75 * delta_h * delta_h + 1.5 * delta_h + 0.25) <= A), bodies, arguments, 7)


def _harmonics_passed_0(A, alpha, beta, delta_h):
    moment_3_0 = moment_3_1 = moment_3_2 = moment_3_3 = moment_5_0 = moment_5_1 = moment_5_2 = moment_5_3 = 0.0
    for s, cosine in _NODES_4:
        moment_3_0, moment_3_1, moment_3_2, moment_3_3, moment_5_0, moment_5_1, moment_5_2, moment_5_3 = _midpoint(
            s, cosine, A, moment_3_0, moment_3_1, moment_3_2, moment_3_3, moment_5_0, moment_5_1, moment_5_2,
            moment_5_3
        )
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    A5 = A * A4
    return (
        -0.013333333333333334 * A3 * beta * moment_3_0,
        -0.013333333333333334 * beta * (3.0 * A2 * moment_3_0 + A3 * moment_3_1),
        -0.013333333333333334 * beta * (6.0 * A * moment_3_0 + 6.0 * A2 * moment_3_1 + A3 * moment_3_2),
        -0.013333333333333334 * beta * (18.0 * A * moment_3_1 + 9.0 * A2 * moment_3_2 + A3 * moment_3_3 + 6.0 *
        moment_3_0),
        -0.00021164021164021165 * A5 * beta * moment_5_0,
        -0.00021164021164021165 * beta * (5.0 * A4 * moment_5_0 + A5 * moment_5_1),
        -0.00021164021164021165 * beta * (20.0 * A3 * moment_5_0 + 10.0 * A4 * moment_5_1 + A5 * moment_5_2),
        -0.00021164021164021165 * beta * (60.0 * A2 * moment_5_0 + 60.0 * A3 * moment_5_1 + 15.0 * A4 * moment_5_2 +
        A5 * moment_5_3),
    )


def _harmonics_passed_1(A, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    c = 1.0 - delta_h
    root = np.sqrt((A - u_cr) * (A + u_cr))
    T = u_cr / (A + root)
    T2 = T * T
    sum_3_0 = sum_3_1 = sum_3_2 = sum_3_3 = sum_5_0 = sum_5_1 = sum_5_2 = sum_5_3 = 0.0
    for x, x2, less, weight in _NODES_5:
        sum_3_0, sum_3_1, sum_3_2, sum_3_3, sum_5_0, sum_5_1, sum_5_2, sum_5_3 = _harmonic_node(
            x, x2, less, weight, T, T2, c, A, u_cr, sum_3_0, sum_3_1, sum_3_2, sum_3_3, sum_5_0, sum_5_1, sum_5_2,
            sum_5_3
        )
    u_cr2 = u_cr * u_cr
    u_cr4 = u_cr2 * u_cr2
    A2 = A * A
    c2 = c * c
    c3 = c * c2
    u_cr3 = u_cr * u_cr2
    A3 = A * A2
    root2 = root * root
    root3 = root * root2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    u_cr5 = u_cr * u_cr4
    A5 = A * A4
    A6 = A3 * A3
    return (
        -2.5464790894703255 * beta * sum_3_0,
        -2.5464790894703255 * beta * sum_3_1,
        0.63661977236758138 * beta * (-4.0 * sum_3_2 + 4.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) / (A2 * c3
        * root)),
        0.63661977236758138 * beta * (-4.0 * sum_3_3 + 12.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) / (A3 * c5
        * root) - 8.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) / (A3 * c3 * root) + 4.0 * u_cr4 * (-12.0 *
        u_cr3 / A4 + 3.0 * u_cr / A2) / (A2 * c3 * root) - 4.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) / (A *
        c3 * root3)),
        -2.5464790894703255 * beta * sum_5_0,
        -2.5464790894703255 * beta * sum_5_1,
        0.63661977236758138 * beta * (-4.0 * sum_5_2 + 4.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 *
        u_cr / A) / (A2 * c3 * root)),
        0.63661977236758138 * beta * (-4.0 * sum_5_3 + 12.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 *
        u_cr / A) / (A3 * c5 * root) - 8.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 * u_cr / A) / (A3
        * c3 * root) + 4.0 * u_cr4 * (-80.0 * u_cr5 / A6 + 60.0 * u_cr3 / A4 - 5.0 * u_cr / A2) / (A2 * c3 * root) -
        4.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 * u_cr / A) / (A * c3 * root3)),
    )


def harmonics(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any]:
    """Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.

    Equation beyond (20). Domain: A >= 0, u_cr <= 3/4. Operations: 1995 in passed_0, 2537 in passed_1. Error / u (1
    + kappa): measured 5.9.
    """
    A, alpha, beta, delta_h = arguments = floats(A, alpha, beta, delta_h)
    bodies = (_harmonics_passed_0, _harmonics_passed_1)
    return by_regime((A <= np.sqrt(-delta_h * delta_h + 2.0 * delta_h),), bodies, arguments, 8)


def _by_parameter_passed_0(A, h, h_A, h_AA, alpha, beta, delta_h):
    t0 = 1.0 / beta
    return -A, -1.0, 0.0, t0 * (A * alpha + h), t0 * (alpha + h_A), h_AA * t0, 0.0, 0.0, 0.0


def _by_parameter_passed_1(A, h, h_A, h_AA, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    t0 = 1.0 - delta_h
    inner = -1.0 / (t0 * t0)
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t1 = 1.0 / A
    x = t1 * u_cr
    y = root * t1
    theta = np.arctan2(u_cr, root)
    M2 = 0.5 * theta - 0.5 * x * y
    t2 = 1.0 / beta
    t3 = 2.5464790894703255 * beta * inner
    t4 = 1.0 / (A * A)
    t5 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    return (
        0.0, 0.0, 0.0,
        t2 * (A + h),
        t2 * (h_A + 1.0),
        h_AA * t2,
        -A * M2 * t3,
        t3 * (-M2 + t4 * t5 * u_cr3),
        -t1 * t3 * t5 * u_cr3 * (t4 + 1.0 / (root * root)),
    )


def _by_parameter_passed_1_far_1(A, h, h_A, h_AA, alpha, beta, delta_h):
    u_cr = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    t0 = 1.0 - delta_h
    inner = -1.0 / (t0 * t0)
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t1 = 1.0 / A
    x = t1 * u_cr
    y = root * t1
    x2 = x * x
    z = x2 / (y * y)
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    M2 = (
        s3 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (-0.00024001561371391354 * s4 - 0.00028620151974909129) - 0.00034586114026712993) - 0.00042450462722033023)
        - 0.00053066957722573227) - 0.00067810320704266795) - 0.00088998368261633694) - 0.001207644289190119) -
        0.0017101353612439386) - 0.0025628662109375001) - 0.0041562034970238099) - 0.0075827205882352941) -
        0.016826923076923076) - 0.055555555555555552) - 0.80000000000000004) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.0002616872854606552 * s4 - 0.00031405642701878893) -
        0.0003823663002536063) - 0.00047344553674152619) - 0.00059807125876960886) - 0.0007739815359505323) -
        0.0010318889149597713) - 0.0014283964710850869) - 0.0020763962357132522) - 0.0032255753226902175) -
        0.0055124383223684207) - 0.010937499999999999) - 0.028409090909090908) - 0.14285714285714285) +
        2.6666666666666665)
    )
    t2 = 1.0 / beta
    t3 = 2.5464790894703255 * beta * inner
    x3 = x * x2
    t4 = x3 / y
    return (
        0.0, 0.0, 0.0,
        t2 * (A + h),
        t2 * (h_A + 1.0),
        h_AA * t2,
        -A * M2 * t3,
        -t3 * (M2 - t4),
        -t1 * t3 * t4 * (z + 2.0),
    )


def by_parameter(A: Any, h: Any, h_A: Any, h_AA: Any, alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.

    Equation from (20)-(22), (31). Domain: A > 0. Operations: 7 in passed_0, 44 in passed_1, 100 in passed_1_far_1.
    Error / u (1 + kappa): proved in passed_0 3.01 at most.
    """
    A, h, h_A, h_AA, alpha, beta, delta_h = arguments = floats(A, h, h_A, h_AA, alpha, beta, delta_h)
    bodies = (_by_parameter_passed_0, _by_parameter_passed_1, _by_parameter_passed_1_far_1)
    return by_regime((A <= np.sqrt(-delta_h * delta_h + 2.0 * delta_h), A <= 1.05 * np.sqrt(-delta_h * delta_h + 2.0 * delta_h)), bodies, arguments, 9)


def by_design(lam: Any, r: Any, delta_h: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """d/d of each number of the design: of each parameter in turn, then of each breakpoint.

    Equation (5), (7). Domain: any design that has a breakpoint. Operations: 13. Error / u (1 + kappa): proved 0.34,
    0.34, 0.34, 4.01, 4.01, 0.34, 0.0, 0.0, 0.0, 0.0, 0.0, -.
    """
    lam, r, delta_h = floats(lam, r, delta_h)
    t0 = lam * r
    t1 = delta_h - 1.0
    t2 = 0.5 * t1
    return broadcast_outputs((lam, r, delta_h),
        -delta_h * r,
        -delta_h * lam,
        -t0,
        -r * t2,
        -lam * t2,
        -0.5 * t0,
        0.0, 0.0, 1.0, 0.0, 0.0,
        -t1 / (np.sqrt(delta_h) * np.sqrt(2.0 - delta_h)),
    )


def coefficients(lam: ArrayLike, r: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any]:
    """The parameters alpha, beta, delta_h from the design.

    Equation (5), (7). Domain: any design. Operations: 6. Error / u (1 + kappa): proved 1.34, 6.01, 0.0.
    """
    lam, r, delta_h = floats(lam, r, delta_h)
    t0 = lam * r
    return broadcast_outputs((lam, r, delta_h), -delta_h * t0 + 1.0, -0.5 * t0 * (delta_h - 1.0), delta_h)


def breakpoints(alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any]:
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters. Operations: 4. Error / u (1 + kappa): measured 0.96.
    """
    alpha, beta, delta_h = floats(alpha, beta, delta_h)
    return broadcast_outputs((alpha, beta, delta_h), np.sqrt(-delta_h * delta_h + 2.0 * delta_h))


def jumps(alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any]:
    """What the force loses at each breakpoint: f below less f above.

    Equation (5). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0.
    """
    alpha, beta, delta_h = floats(alpha, beta, delta_h)
    return broadcast_outputs((alpha, beta, delta_h), 0.0)


def hardening(alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any]:
    """The force over the displacement, f(u)/u, rises with |u| where none of these is negative.

    Equation from (3). Domain: any parameters. Operations: 1. Error / u (1 + kappa): proved 0.0.
    """
    alpha, beta, delta_h = floats(alpha, beta, delta_h)
    return broadcast_outputs((alpha, beta, delta_h), 2.0 * beta)


def force_1(u: Any, alpha: Any, beta: Any, delta_h: Any) -> Any:
    """Piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (5). Domain: where it holds. Operations: 12. Error / u (1 + kappa): measured 0.85.
    """
    t0 = np.sqrt((1.0 - u) * (u + 1.0))
    return u * (alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0)))


def force_1_u(u: Any, alpha: Any, beta: Any, delta_h: Any) -> Any:
    """d/du of piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (5). Domain: where it holds. Operations: 23. Error / u (1 + kappa): measured 1.5.
    """
    root_1 = np.sqrt((1.0 - u) * (u + 1.0))
    t0 = root_1 + 1.0
    t1 = 1.0 / t0
    t2 = u * u
    t3 = t2 / root_1
    t4 = 2.0 * beta
    return alpha + 6.0 * beta * t1 * t3 - t3 * (-t3 * t4 / (t0 * t0) - t1 * t2 * t4 / (root_1 * root_1))


def force_2(u: Any, alpha: Any, beta: Any, delta_h: Any) -> Any:
    """Piece 2 of the whole restoring force u + F_k(u).

    Equation (3), (5). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0.
    """
    return u


def force_2_u(u: Any, alpha: Any, beta: Any, delta_h: Any) -> Any:
    """d/du of piece 2 of the whole restoring force u + F_k(u).

    Equation (3), (5). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0.
    """
    return 1.0


def force(u: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """Whole dimensionless restoring force u + F_k(u), untruncated.

    Equation (3), (5). Domain: |u| < 1. Error / u (1 + kappa): measured 0.86.
    """
    u, alpha, beta, delta_h = arguments = floats(u, alpha, beta, delta_h)
    bodies = (force_2, force_1)
    return number_by_regime((np.sqrt(-delta_h * delta_h + 2.0 * delta_h) <= np.abs(u),), bodies, arguments)


def _gained(alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any]:
    """What the force and two derivatives gain at each breakpoint.

    Equation (3). Domain: any parameters. Operations: 18. Error / u (1 + kappa): proved 0.0, -, -.
    """
    t0 = 1.0 - delta_h
    t1 = t0 * t0
    t2 = t0 * t1
    t3 = t1 * t1
    t4 = t0 * t3
    return (
        0.0,
        -alpha + 2.0 * beta - 2.0 * beta / t2 + 1.0,
        -6.0 * beta * np.sqrt(-delta_h * delta_h + 2.0 * delta_h) / t4,
    )


def _curved_1(beyond: Any, alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any, Any]:
    """Piece 1 of the force at u, and 3 derivatives.

    Equation (3). Domain: where it holds. Operations: 33.
    """
    t0 = 2.0 * beta
    t1 = beyond * beyond
    t2 = 1.0 - t1
    t3 = alpha - t0 + t0 / np.sqrt(t2)
    t4 = beyond + 1.0
    t5 = np.power(t4, -2.5)
    t6 = 6.0 * beta
    t7 = 1.0 - beyond
    t8 = beyond / np.power(t7, 2.5)
    t9 = 15.0 * beta
    return (
        beyond * t3,
        t0 * t1 / np.power(t2, 1.5) + t3,
        t5 * t6 * t8,
        beyond * t5 * t9 / np.power(t7, 3.5) - t8 * t9 / np.power(t4, 3.5) + t6 / np.power(t2, 2.5),
    )


def _curved_2(beyond: Any, alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any, Any]:
    """Piece 2 of the force at u, and 3 derivatives.

    Equation (3). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0.
    """
    return beyond, 1.0, 0.0, 0.0


def _gained_by(alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """At each breakpoint, by each parameter in turn: what the force and its slope gain more.

    Equation (3). Domain: any parameters. Operations: 12.
    """
    t0 = np.sqrt(-delta_h * delta_h + 2.0 * delta_h)
    t1 = 1.0 - delta_h
    t2 = t1 * t1
    t3 = t1 * t2
    return -t0, -1.0, -2.0 * delta_h * t0 / t1, 2.0 - 2.0 / t3, 0.0, 0.0


def _moved_1_1(beyond: Any, alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any]:
    """Piece 1 by parameter 1 at u, and two derivatives.

    Equation (3). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0.
    """
    return beyond, 1.0, 0.0


def _moved_1_2(beyond: Any, alpha: Any, beta: Any, delta_h: Any) -> tuple[Any, Any, Any]:
    """Piece 1 by parameter 2 at u, and two derivatives.

    Equation (3). Domain: where it holds. Operations: 20.
    """
    t0 = beyond * beyond
    t1 = 1.0 - t0
    t2 = 1.0 / np.sqrt(t1)
    return (
        beyond * (2.0 * t2 - 2.0),
        2.0 * t0 / np.power(t1, 1.5) + 2.0 * t2 - 2.0,
        6.0 * beyond / (np.power(1.0 - beyond, 2.5) * np.power(beyond + 1.0, 2.5)),
    )


def _held_1(around, beyond, alpha, beta, delta_h):
    """Piece 1 of the force at u, and 3 derivatives.

    On intervals; `around` makes one of a number that no double is equal to. Equation (3).
    """
    t0 = 2.0 * beta
    t1 = beyond.square()
    t2 = 1.0 - t1
    t3 = alpha - t0 + t0 / t2.root()
    t4 = beyond + 1.0
    t5 = 1.0 / t4.power(2.5)
    t6 = 6.0 * beta
    t7 = 1.0 - beyond
    t8 = beyond / t7.power(2.5)
    t9 = 15.0 * beta
    return (
        beyond * t3,
        t0 * t1 / t2.power(1.5) + t3,
        t5 * t6 * t8,
        beyond * t5 * t9 / t7.power(3.5) - t8 * t9 / t4.power(3.5) + t6 / t2.power(2.5),
    )


def _held_2(around, beyond, alpha, beta, delta_h):
    """Piece 2 of the force at u, and 3 derivatives.

    On intervals; `around` makes one of a number that no double is equal to. Equation (3).
    """
    return beyond, 1.0, 0.0, 0.0


def averaged(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 3.3.
    """
    values = averaged_all(A, alpha, beta, delta_h)
    return values[0], values[1], values[2], values[3]


def averaged_2(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any]:
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 1.7.
    """
    values = averaged_all(A, alpha, beta, delta_h)
    return values[0], values[1]


def averaged_H(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any]:
    """H, H_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 3.
    """
    values = averaged_all(A, alpha, beta, delta_h)
    return values[4], values[5]


def intercept(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """h - A h_A, where the tangent of h meets A = 0; linear terms are none.

    Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.9.
    """
    return averaged_all(A, alpha, beta, delta_h)[6]


def h(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: A >= 0. Error / u (1 + kappa): measured 1.1.
    """
    return averaged_2(A, alpha, beta, delta_h)[0]


def h_A(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.1.
    """
    return averaged_2(A, alpha, beta, delta_h)[1]


def h_AA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 1.7.
    """
    return averaged(A, alpha, beta, delta_h)[2]


def h_AAA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 3.5.
    """
    return averaged(A, alpha, beta, delta_h)[3]


def H(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: A >= 0. Error / u (1 + kappa): measured 3.1.
    """
    return averaged_H(A, alpha, beta, delta_h)[0]


def H_A(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.
    """
    return averaged_H(A, alpha, beta, delta_h)[1]


def H_AA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.4.
    """
    return averaged(A, alpha, beta, delta_h)[2]


def F(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.5.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 4.2.
    """
    average, average_A = averaged_2(A, alpha, beta, delta_h)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def level(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """The forcing F_0 for which (Omega, A) is a steady state.

    Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.5.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.level(Omega, A, flow.friction(mu), zeta, average)


def phase(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.4.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.8.
    """
    average, average_A = averaged_2(A, alpha, beta, delta_h)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 4.4.
    """
    average, average_A = averaged_2(A, alpha, beta, delta_h)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. Error / u (1 + kappa): measured 1.4.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Any:
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0. Error / u (1 + kappa): measured 1.6.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.backbone(A, average)


def limit_envelope(Omega: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike) -> Any:
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Error / u (1 + kappa): measured 0.66.
    """
    return flow.limit_envelope(Omega, F_0, flow.friction(mu), zeta)


def equivalent_damping(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike) -> Any:
    """Viscous damping ratio that dissipates as much as zeta and friction together.

    Equation (38). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.65.
    """
    return flow.equivalent_damping(Omega, A, flow.friction(mu), zeta)


def response_quartic(A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24). Domain: A > 0. Error / u (1 + kappa): measured 1.4.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.response_quartic(A, F_0, flow.friction(mu), zeta, average)


def fold_quartic(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 3.7.
    """
    average, average_A = averaged_2(A, alpha, beta, delta_h)
    return flow.fold_quartic(A, flow.friction(mu), zeta, average, average_A)


def peak_cubic(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any]:
    """F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.

    Equation (34). Domain: A > 0. Error / u (1 + kappa): measured 2.3.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.peak_cubic(A, flow.friction(mu), zeta, average)


def detachment(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, delta_h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Error / u (1 + kappa): measured 1.6. One array, coefficients by rising power along
    its first axis.
    """
    average, _ = averaged_2(A, alpha, beta, delta_h)
    return flow.detachment(A, flow.friction(mu), zeta, average)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.rod_spring_untruncated()))


def _load_balls():
    from slowflow_kernels import rod_spring_untruncated_balls

    return rod_spring_untruncated_balls


_PIECES = (
    Law(force_1, force_1_u, "rod_spring_untruncated.force_1"),
    Law(force_2, force_2_u, "rod_spring_untruncated.force_2"),
)
_DESIGN = (
    Parameter("lam", "number of horizontal springs", "1", above=0.0),
    Parameter("r", "stiffness k_h of one of them", "k_v", above=0.0),
    Parameter("delta_h", "their preload Delta_h; 0 is a linear oscillator", "L", least=0.0, below=1.0),
)
_PARAMETERS = (
    Parameter("alpha", "coefficient of u in the Taylor series of piece 1 of the force", "k_v"),
    Parameter("beta", "coefficient of u^3 in the Taylor series of piece 1 of the force", "k_v/L^2"),
    Parameter("delta_h", "their preload Delta_h; 0 is a linear oscillator", "L", least=0.0, below=1.0),
)
MECHANISM = Mechanism(
    name="rod_spring_untruncated",
    title="Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated",
    design=_DESIGN,
    parameters=_PARAMETERS,
    coefficients=coefficients,
    pieces=_PIECES,
    breakpoints=breakpoints,
    jumps=jumps,
    hardening=hardening,
    averaged=averaged,
    intercept=intercept,
    harmonics=harmonics,
    harmonics_up_to=0.75,
    by_parameter=by_parameter,
    by_design=by_design,
    reach=1.0,
    reach_reason="the push-rod stands vertical",
    truncated=False,
    curved=Curved(
        _gained,
        (_curved_1, _curved_2),
        (_held_1, _held_2),
        _gained_by,
        (
            (_moved_1_1, _moved_1_2, None),
            (None, None, None),
        ),
    ),
    load_untruncated=None,
    load_balls=_load_balls,
    scales=(
        Scale("lam", 1.0, (0.0, 0.0, 0.0)),
        Scale("k_h", 1.0, (1.0, 0.0, 0.0)),
        Scale("Delta_h", 1.0, (0.0, 1.0, 0.0)),
    ),
)
