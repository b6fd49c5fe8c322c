/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   What arguments and comments mean is in inline.h. Regimes: passed_n where A exceeds n breakpoints, far_k where it
   exceeds k of them 21/20 times. */

#ifndef ROD_SPRING_UNTRUNCATED_H
#define ROD_SPRING_UNTRUNCATED_H

#include <math.h>

#include "inline.h"
#include "angles.h"
#include "slow_flow.h"

SF_FAMILY_BEGIN

/* alpha, beta, delta_h */
#define ROD_SPRING_UNTRUNCATED_PARAMETERS 3
#define ROD_SPRING_UNTRUNCATED_BREAKPOINTS 1

/* x, X2, less, both, K at the nodes of a rule */
static const double rod_spring_untruncated_nodes_1[][5] = {
    {0.99689348407464951, 0.99379661859049351, 0.0031065159253504597, 0.0030968654841560038, 0.007968192496166605},
    {0.53662414814201986, 0.28796547636914854, 0.46337585185798008, 0.24865867177287138, 0.086899787201082976},
    {0.44703376953808915, 0.19983919110743342, 0.55296623046191085, 0.24719457843065576, 0.092122522237786122},
    {0.35270472553087812, 0.12440062341181206, 0.64729527446912194, 0.22830410211906604, 0.096368737174644253},
    {0.25463692616788985, 0.064839964168231387, 0.7453630738321102, 0.18979696199965845, 0.099593420586795267},
    {0.15386991360858354, 0.023675950313912963, 0.8461300863914164, 0.13019396329467059, 0.1017623897484055},
    {0.051471842555317698, 0.0026493505760394136, 0.94852815744468233, 0.048822491979278279, 0.10285265289355884},
    {0.98366812327974718, 0.96760297675669993, 0.01633187672025279, 0.016065146523047254, 0.018466468311090958},
    {0.96002186496830755, 0.92164198121722729, 0.039978135031692487, 0.03837988375108025, 0.028784707883323369},
    {0.92620004742927431, 0.85784652785798998, 0.073799952570725677, 0.068353519571284313, 0.03879919256962705},
    {0.88256053579205274, 0.77891309933755515, 0.11743946420794732, 0.10364743645449757, 0.048402672830594053},
    {0.82956576238276836, 0.68817935411770381, 0.17043423761723162, 0.14138640826506463, 0.057493156217619065},
    {0.76777743210482619, 0.58948218524948104, 0.23222256789517381, 0.1782952468553452, 0.065974229882180491},
    {0.69785049479331585, 0.4869953130832757, 0.30214950520668421, 0.21085518171004011, 0.073755974737705204},
    {0.62052618298924289, 0.38505274377519932, 0.37947381701075716, 0.23547343921404354, 0.080755895229420213},
};

/* x, X2, less, both, K at the nodes of a rule */
static const double rod_spring_untruncated_nodes_2[][5] = {
    {0.99877100725242607, 0.99754352492802578, 0.0012289927475738814, 0.0012274823244002922,
        0.0031533460523058385},
    {0.80706620402944262, 0.65135585768649396, 0.19293379597055738, 0.15571034634294872, 0.038241351065830709},
    {0.76715903251574036, 0.58853298117048669, 0.23284096748425967, 0.17862605134525358, 0.041545082943464748},
    {0.72403413092381463, 0.52422542274260353, 0.27596586907618537, 0.19980870818121108, 0.04467456085669428},
    {0.67787237963266389, 0.45951096306885042, 0.32212762036733611, 0.2183614165638135, 0.047616658492490478},
    {0.6288673967765136, 0.395474202728469, 0.3711326032234864, 0.23339319404804459, 0.050359035553854473},
    {0.57722472608397268, 0.33318838440271731, 0.42277527391602732, 0.24403634168125538, 0.052890189485193667},
    {0.523160974722233, 0.27369740547231697, 0.47683902527776695, 0.24946356924991608, 0.055199503699984165},
    {0.46690290475095841, 0.21799832246488254, 0.53309709524904159, 0.24890458228607587, 0.057277292100403214},
    {0.40868648199071672, 0.16702464056194843, 0.59131351800928322, 0.24166184142876829, 0.059114839698395635},
    {0.34875588629216075, 0.12163066822343055, 0.6512441137078393, 0.22712521806873018, 0.060704439165893881},
    {0.99353017226635076, 0.98710220320360464, 0.0064698277336492421, 0.0064279690627461455,
        0.0073275539012762625},
    {0.28736248735545555, 0.082577199139114363, 0.71263751264454445, 0.2047852882163412, 0.062039423159892665},
    {0.22476379039468905, 0.050518761472587721, 0.77523620960531092, 0.17424502892210134, 0.06311419228625402},
    {0.16122235606889171, 0.025992648096404506, 0.83877764393110832, 0.13522970797248721, 0.063924238584648185},
    {0.097004699209462697, 0.0094099116687183324, 0.90299530079053725, 0.087594787540744359, 0.064466164435950088},
    {0.03238017096286936, 0.0010484754715846482, 0.96761982903713062, 0.031331695491284714, 0.064737696812683918},
    {0.98412458372282685, 0.96850119628762721, 0.015875416277173142, 0.015623387435199608, 0.01147723457923454},
    {0.97059159254624727, 0.94204803952146043, 0.029408407453752748, 0.028543553024786811, 0.015579315722943849},
    {0.95298770316043091, 0.90818556237499348, 0.047012296839569138, 0.044802140785437379, 0.019616160457355529},
    {0.93138669070655433, 0.86748116762530669, 0.068613309293445668, 0.063905523081247625, 0.02357076083932438},
    {0.90587913671556963, 0.82061701033654577, 0.094120863284430326, 0.085262126379023903, 0.027426509708356948},
    {0.87657202027424785, 0.76837850672767649, 0.12342797972575212, 0.10819351354657145, 0.03116722783279809},
    {0.84358826162439349, 0.71164115515046622, 0.15641173837560646, 0.13194710647392729, 0.034777222564770442},
};

/* X2, K2 at the nodes of a rule */
static const double rod_spring_untruncated_nodes_3[][2] = {
    {0.99379661859049351, 0.0079187627589685176},
    {0.28796547636914854, 0.025024138617737494},
    {0.19983919110743342, 0.018409690326775727},
    {0.12440062341181206, 0.011988330981934815},
    {0.064839964168231387, 0.0064576338222394032},
    {0.023675950313912963, 0.0024093212835082948},
    {0.0026493505760394136, 0.00027249273519073196},
    {0.96760297675669993, 0.017868209707994881},
    {0.92164198121722729, 0.026529195202345292},
    {0.85784652785798998, 0.033283752629548087},
    {0.77891309933755515, 0.037701475910699687},
    {0.68817935411770381, 0.039565603112029335},
    {0.58948218524948104, 0.038890633201099367},
    {0.4869953130832757, 0.035918814009150916},
    {0.38505274377519932, 0.031095279034110784},
};

/* s, cosine at the nodes of a rule */
static const double rod_spring_untruncated_nodes_4[][2] = {
    {0.03925981575906861, 0.9992290362407229},
    {0.67880074553294178, 0.73432250943568556},
    {0.73432250943568556, 0.67880074553294178},
    {0.78531693088074495, 0.61909394930983397},
    {0.83146961230254524, 0.55557023301960218},
    {0.87249600707279706, 0.48862124149695496},
    {0.90814317382508125, 0.41865973753742808},
    {0.93819133592248416, 0.34611705707749296},
    {0.96245523645364728, 0.27144044986507426},
    {0.98078528040323043, 0.19509032201612828},
    {0.99306845695492629, 0.11753739745783764},
    {0.11753739745783764, 0.99306845695492629},
    {0.9992290362407229, 0.03925981575906861},
    {0.19509032201612828, 0.98078528040323043},
    {0.27144044986507426, 0.96245523645364728},
    {0.34611705707749296, 0.93819133592248416},
    {0.41865973753742808, 0.90814317382508125},
    {0.48862124149695496, 0.87249600707279706},
    {0.55557023301960218, 0.83146961230254524},
    {0.61909394930983397, 0.78531693088074495},
};

/* x, x2, less, weight at the nodes of a rule */
static const double rod_spring_untruncated_nodes_5[][4] = {
    {0.99839961899006247, 0.99680179919950185, 0.0016003810099375849, 0.0041059986046490847},
    {0.75127993568948048, 0.56442154176958992, 0.24872006431051952, 0.048778140792803244},
    {0.70049459055617125, 0.49069267139845796, 0.29950540944382881, 0.052746295699174071},
    {0.64588338886924779, 0.41716535201722399, 0.35411661113075216, 0.056426369358018383},
    {0.58774459748510932, 0.34544371187293316, 0.41225540251489068, 0.059798262227586656},
    {0.52639574993119231, 0.27709248554562232, 0.47360425006880769, 0.062843558045002579},
    {0.46217191207042191, 0.21360287630682981, 0.53782808792957804, 0.065545624364908975},
    {0.39542385204297503, 0.15636002276450464, 0.60457614795702497, 0.067889703376521948},
    {0.32651612446541151, 0.1066127795359121, 0.67348387553458844, 0.069862992492594159},
    {0.25582507934287907, 0.065446471220790378, 0.74417492065712088, 0.071454714265170985},
    {0.18373680656485455, 0.033759214086650779, 0.81626319343514542, 0.072656175243804105},
    {0.9915772883408609, 0.9832255187534148, 0.0084227116591390795, 0.0095362203017485027},
    {0.11064502720851987, 0.012242322045974101, 0.88935497279148013, 0.073460813453467527},
    {0.036948943165351779, 0.0013652244010363957, 0.9630510568346482, 0.073864234232172879},
    {0.97934250806374823, 0.95911174810059274, 0.020657491936251805, 0.014922443697357493},
    {0.9617593653382045, 0.92498107681574593, 0.03824063466179551, 0.020227869569052644},
    {0.93892355735498823, 0.88157744655614578, 0.061076442645011823, 0.025422959526113047},
    {0.91095972490412747, 0.82984762039740356, 0.089040275095872548, 0.030479240699603467},
    {0.87802056981217269, 0.77092012101329255, 0.12197943018782725, 0.03536907109759211},
    {0.84028598326181692, 0.70608053366627843, 0.15971401673818311, 0.040065735180692265},
    {0.79796205325548741, 0.63674343843571335, 0.20203794674451259, 0.044543577771965881},
};

/* The term of int sin^2 at a node. */
SF_COMMON void rod_spring_untruncated_arc_node(const double *row, double T2, double *W) {
    const double X2 = row[0], K2 = row[1];
    const double g = 1.0 / (T2 * X2 + 1.0);
    const double g2 = g * g;
    const double g3 = g * g2;
    *W += K2 * g3;
}

/* Duplications of the arguments of R_D, and the sum of what they take off over 3, as Taylor series. */
SF_COMMON void rod_spring_untruncated_duplication(int turns, double *state) {
    SF_UNROLLED
    for (int turn = 0; turn < turns; turn++) {
        const double x_0 = state[0], x_1 = state[1], x_2 = state[2], x_3 = state[3], y_0 = state[4], y_1 = state[5],
            y_2 = state[6], y_3 = state[7], z_0 = state[8], z_1 = state[9], z_2 = state[10], z_3 = state[11],
            total_0 = state[12], total_1 = state[13], total_2 = state[14], total_3 = state[15];
        const double a_0 = sqrt(x_0);
        const double a_half_0 = 0.5 / a_0;
        const double a1_0 = a_half_0 * x_1;
        const double a2_0 = a_half_0 * (-a1_0 * a1_0 + x_2);
        const double a3_0 = a_half_0 * (-2.0 * a1_0 * a2_0 + x_3);
        const double b_0 = sqrt(y_0);
        const double b_half_0 = 0.5 / b_0;
        const double b1_0 = b_half_0 * y_1;
        const double b2_0 = b_half_0 * (-b1_0 * b1_0 + y_2);
        const double b3_0 = b_half_0 * (-2.0 * b1_0 * b2_0 + y_3);
        const double c_0 = sqrt(z_0);
        const double c_half_0 = 0.5 / c_0;
        const double c1_0 = c_half_0 * z_1;
        const double c2_0 = c_half_0 * (-c1_0 * c1_0 + z_2);
        const double c3_0 = c_half_0 * (-2.0 * c1_0 * c2_0 + z_3);
        const double lam_0 = a_0 * b_0 + c_0 * (a_0 + b_0);
        const double lam_1 = a1_0 * b_0 + a_0 * b1_0 + c1_0 * (a_0 + b_0) + c_0 * (a1_0 + b1_0);
        const double lam_2 = a1_0 * b1_0 + a2_0 * b_0 + a_0 * b2_0 + c1_0 * (a1_0 + b1_0) + c2_0 * (a_0 + b_0) + c_0 *
        (a2_0 + b2_0);
        const double lam_3 = a1_0 * b2_0 + a2_0 * b1_0 + a3_0 * b_0 + a_0 * b3_0 + c1_0 * (a2_0 + b2_0) + c2_0 * (a1_0 +
        b1_0) + c3_0 * (a_0 + b_0) + c_0 * (a3_0 + b3_0);
        const double q_0 = lam_0 + z_0;
        const double q_1 = lam_1 + z_1;
        const double q_2 = lam_2 + z_2;
        const double q_3 = lam_3 + z_3;
        const double below_0 = c_0 * q_0;
        const double below_1 = c1_0 * q_0 + c_0 * q_1;
        const double below_2 = c1_0 * q_1 + c2_0 * q_0 + c_0 * q_2;
        const double below_3 = c1_0 * q_2 + c2_0 * q_1 + c3_0 * q_0 + c_0 * q_3;
        const double term_0 = 1.0 / below_0;
        const double term1_0 = -below_1 * term_0 * term_0;
        const double term2_0 = -term_0 * (below_1 * term1_0 + below_2 * term_0);
        const double term3_0 = -term_0 * (below_1 * term2_0 + below_2 * term1_0 + below_3 * term_0);
        const double X_0 = 0.25 * lam_0 + 0.25 * x_0;
        const double X_1 = 0.25 * lam_1 + 0.25 * x_1;
        const double X_2 = 0.25 * lam_2 + 0.25 * x_2;
        const double X_3 = 0.25 * lam_3 + 0.25 * x_3;
        const double Y_0 = 0.25 * lam_0 + 0.25 * y_0;
        const double Y_1 = 0.25 * lam_1 + 0.25 * y_1;
        const double Y_2 = 0.25 * lam_2 + 0.25 * y_2;
        const double Y_3 = 0.25 * lam_3 + 0.25 * y_3;
        const double Z_0 = 0.25 * lam_0 + 0.25 * z_0;
        const double Z_1 = 0.25 * lam_1 + 0.25 * z_1;
        const double Z_2 = 0.25 * lam_2 + 0.25 * z_2;
        const double Z_3 = 0.25 * lam_3 + 0.25 * z_3;
        state[0] = X_0;
        state[1] = X_1;
        state[2] = X_2;
        state[3] = X_3;
        state[4] = Y_0;
        state[5] = Y_1;
        state[6] = Y_2;
        state[7] = Y_3;
        state[8] = Z_0;
        state[9] = Z_1;
        state[10] = Z_2;
        state[11] = Z_3;
        state[12] = term_0 + 4.0 * total_0;
        state[13] = term1_0 + 4.0 * total_1;
        state[14] = term2_0 + 4.0 * total_2;
        state[15] = term3_0 + 4.0 * total_3;
    }
}

/* R_D of arguments that are nearly equal, as a Taylor series. */
SF_COMMON void rod_spring_untruncated_remainder(double x_0, double x_1, double x_2, double x_3, double y_0,
    double y_1, double y_2, double y_3, double z_0, double z_1, double z_2, double z_3, double *last_0,
    double *last_1, double *last_2, double *last_3) {
    const double mean_0 = 0.20000000000000001 * x_0 + 0.20000000000000001 * y_0 + 0.59999999999999998 * z_0;
    const double mean_1 = 0.20000000000000001 * x_1 + 0.20000000000000001 * y_1 + 0.59999999999999998 * z_1;
    const double mean_2 = 0.20000000000000001 * x_2 + 0.20000000000000001 * y_2 + 0.59999999999999998 * z_2;
    const double mean_3 = 0.20000000000000001 * x_3 + 0.20000000000000001 * y_3 + 0.59999999999999998 * z_3;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0);
    const double dx_0 = over_0 * (mean_0 - x_0);
    const double dx_1 = over1_0 * (mean_0 - x_0) + over_0 * (mean_1 - x_1);
    const double dx_2 = over1_0 * (mean_1 - x_1) + over2_0 * (mean_0 - x_0) + over_0 * (mean_2 - x_2);
    const double dx_3 = over1_0 * (mean_2 - x_2) + over2_0 * (mean_1 - x_1) + over3_0 * (mean_0 - x_0) + over_0 *
        (mean_3 - x_3);
    const double dy_0 = over_0 * (mean_0 - y_0);
    const double dy_1 = over1_0 * (mean_0 - y_0) + over_0 * (mean_1 - y_1);
    const double dy_2 = over1_0 * (mean_1 - y_1) + over2_0 * (mean_0 - y_0) + over_0 * (mean_2 - y_2);
    const double dy_3 = over1_0 * (mean_2 - y_2) + over2_0 * (mean_1 - y_1) + over3_0 * (mean_0 - y_0) + over_0 *
        (mean_3 - y_3);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E2_3 = xy_3 - 6.0 * zz_3;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E3_3 = dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 -
        8.0 * zz_1) + dz_3 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E4_3 = zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 -
        3.0 * zz_1) + zz_3 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
    const double E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1
        * zz_1 + xy_2 * zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double series_2 = 0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 +
        0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 *
        E5_2;
    const double series_3 = 0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 +
        0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 -
        0.17307692307692307 * E2_3 * E3_0 - 0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0;
    *last_0 = power_0 * series_0;
    *last_1 = power_0 * series_1 + power_1 * series_0;
    *last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    *last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0;
}

/* R_D by what one duplication has made of its arguments and has taken off, as a Taylor series. */
SF_COMMON void rod_spring_untruncated_duplications(double X0_0, double X0_1, double X0_2, double X0_3, double Y0_0,
    double Y0_1, double Y0_2, double Y0_3, double Z0_0, double Z0_1, double Z0_2, double Z0_3, double term0_0,
    double term0_1, double term0_2, double term0_3, double *R_0, double *R_1, double *R_2, double *R_3) {
    double duplication[] = {X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, Y0_2, Y0_3, Z0_0, Z0_1, Z0_2, Z0_3, term0_0,
        term0_1, term0_2, term0_3};
    rod_spring_untruncated_duplication(5, duplication);
    const double X_0 = duplication[0], X_1 = duplication[1], X_2 = duplication[2], X_3 = duplication[3],
        Y_0 = duplication[4], Y_1 = duplication[5], Y_2 = duplication[6], Y_3 = duplication[7],
        Z_0 = duplication[8], Z_1 = duplication[9], Z_2 = duplication[10], Z_3 = duplication[11],
        total_0 = duplication[12], total_1 = duplication[13], total_2 = duplication[14], total_3 = duplication[15];
    double last_0, last_1, last_2, last_3;
    rod_spring_untruncated_remainder(X_0, X_1, X_2, X_3, Y_0, Y_1, Y_2, Y_3, Z_0, Z_1, Z_2, Z_3, &last_0, &last_1,
        &last_2, &last_3);
    *R_0 = 0.000244140625 * last_0 + 0.0029296875 * total_0;
    *R_1 = 0.000244140625 * last_1 + 0.0029296875 * total_1;
    *R_2 = 0.000244140625 * last_2 + 0.0029296875 * total_2;
    *R_3 = 0.000244140625 * last_3 + 0.0029296875 * total_3;
}

/* What averaged_all_passed_1_steep_far, averaged_all_passed_1_steep_away have in common. */
SF_COMMON void rod_spring_untruncated_common_1(double A, double delta_h, double *u_cr_out, double *c_out,
    double *root_out, double *V2_out, double *V4_out, double *V6_out, double *V8_out) {
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double c2 = c * c;
    const double lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0);
    const double half = 0.5 * (A - u_cr) * (A + u_cr);
    const double root = sqrt(2.0 * half - 0.5 * fabs(half - lacking) + 0.5 * fabs(half + lacking));
    const double A2 = A * A;
    const double x2 = u_cr * u_cr / A2;
    const double y2 = root * root / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double a03_0 = -2.0 * a02_0 * a0_half_0_2;
    const double b0_0 = sqrt(c2);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double lam0_2 = a02_0 * b0_0 + a02_0;
    const double lam0_3 = a03_0 * b0_0 + a03_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double X0_2 = 0.25 * lam0_2;
    const double X0_3 = 0.25 * lam0_3;
    const double Y0_0 = 0.25 * c2 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    double R_0, R_1, R_2, R_3;
    rod_spring_untruncated_duplications(X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, X0_2, X0_3, Z0_0, Y0_1, X0_2, X0_3,
        term0_0, term01_0, term02_0, term03_0, &R_0, &R_1, &R_2, &R_3);
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double x2_2 = x2 * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2_2;
    const double x2_3 = x2 * x2_2;
    const double V8 = -3.2000000000000002 * R_3 * third * x2_3;
    *u_cr_out = u_cr;
    *c_out = c;
    *root_out = root;
    *V2_out = V2;
    *V4_out = V4;
    *V6_out = V6;
    *V8_out = V8;
}

/* The outputs of averaged_all_passed_1, averaged_all_passed_1_steeper. */
SF_COMMON void rod_spring_untruncated_common_2(double A, double T, double beta, double c, double root, double sum_0,
    double sum_1, double sum_2, double sum_3, double u_cr, double *result_0, double *result_1, double *result_2,
    double *result_3, double *result_4, double *result_5, double *result_6) {
    const double t0 = T * T;
    const double A2 = A * A;
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    *result_0 = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    *result_1 = -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0;
    *result_2 = -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root));
    *result_3 = -2.5464790894703255 * beta * (96.0 * T5 * sum_3 - 3.0 * u_cr5 / (A4 * c5 * root) + 3.0 * u_cr5 / (A4
        * c3 * root) + u_cr5 / (A2 * c3 * root3));
    *result_4 = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c;
    *result_5 = -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c);
    *result_6 = 81.487330863050417 * A3 * T5 * beta * sum_1;
}

/* Terms of int sin^2 tan^(2n) (1/c - 1/Delta) at a node, by n. */
SF_COMMON void rod_spring_untruncated_far_node(const double *row, double c, double T2, double U2, double *W,
    double *Wq, double *Wq_2, double *Wq_3) {
    const double x = row[0], X2 = row[1], less = row[2], both = row[3], K = row[4];
    const double g = 1.0 / (T2 * X2 + 1.0);
    const double v2 = X2 * g * g;
    const double square = -U2 * v2 + 1.0;
    const double delta = sqrt(square);
    const double f = K * g * v2 / delta;
    const double term = f * g * (-T2 * both + less) * (g * (T2 * x + x) + 1.0) / (c + delta);
    const double t0 = -T2 * X2 + 1.0;
    const double q = 4.0 * T2 * X2 / (t0 * t0);
    const double q2 = q * q;
    const double q3 = q * q2;
    *W += term;
    *Wq += q * term;
    *Wq_2 += q2 * term;
    *Wq_3 += q3 * term;
}

/* Terms of int g^(j)(A s) s^j T_n dt at a node, by n, then by j. */
SF_COMMON void rod_spring_untruncated_harmonic_node(const double *row, double T, double T2, double c, double A,
    double u_cr, double *sum_3_0, double *sum_3_1, double *sum_3_2, double *sum_3_3, double *sum_5_0,
    double *sum_5_1, double *sum_5_2, double *sum_5_3) {
    const double x = row[0], x2 = row[1], less = row[2], weight = row[3];
    const double g = 1.0 / (T2 * x2 + 1.0);
    const double s = 2.0 * T * g * x;
    const double v = A * s;
    const double square = (1.0 - v) * (v + 1.0);
    const double delta = sqrt(square);
    const double below = g * less * (-T2 * x + 1.0);
    const double above = g * x * (T2 + 1.0) + 1.0;
    const double inverse = -above * below * u_cr * u_cr / (c * delta * (c + delta));
    const double scale = 2.0 * T * g * weight;
    const double s2 = s * s;
    const double v2 = v * v;
    const double s3 = s * s2;
    const double square2 = square * square;
    const double s4 = s2 * s2;
    const double square3 = square * square2;
    *sum_3_0 += inverse * s * scale * v * (4.0 * s2 - 3.0);
    *sum_3_1 += s2 * scale * (inverse + v2 / (delta * square)) * (4.0 * s2 - 3.0);
    *sum_3_2 += 3.0 * s3 * scale * v * (4.0 * s2 - 3.0) / (delta * square2);
    *sum_3_3 += s4 * scale * (4.0 * s2 - 3.0) * (12.0 * v2 + 3.0) / (delta * square3);
    *sum_5_0 += inverse * s * scale * v * (s2 * (16.0 * s2 - 20.0) + 5.0);
    *sum_5_1 += s2 * scale * (inverse + v2 / (delta * square)) * (s2 * (16.0 * s2 - 20.0) + 5.0);
    *sum_5_2 += 3.0 * s3 * scale * v * (s2 * (16.0 * s2 - 20.0) + 5.0) / (delta * square2);
    *sum_5_3 += s4 * scale * (12.0 * v2 + 3.0) * (s2 * (16.0 * s2 - 20.0) + 5.0) / (delta * square3);
}

/* Steps of the arithmetic-geometric mean, with the sum of its differences and that of their squares by weight. */
SF_COMMON void rod_spring_untruncated_means(double quarter, int turns, double *state) {
    SF_UNROLLED
    for (int turn = 0; turn < turns; turn++) {
        const double a = state[0], b = state[1], e = state[2], total = state[3], squares = state[4];
        const double mean = 0.5 * a + 0.5 * b;
        const double difference = e * e * quarter / mean;
        state[0] = mean;
        state[1] = sqrt(a) * sqrt(b);
        state[2] = difference;
        state[3] = difference + total;
        state[4] = difference * difference + 0.5 * squares;
    }
}

/* Terms of int f^(n + j)(A s) s^j cos^(2n) t dt at a point, by n, then by j. */
SF_COMMON void rod_spring_untruncated_midpoint(const double *row, double A, double *moment_3_0, double *moment_3_1,
    double *moment_3_2, double *moment_3_3, double *moment_5_0, double *moment_5_1, double *moment_5_2,
    double *moment_5_3) {
    const double s = row[0], cosine = row[1];
    const double v = A * s;
    const double delta = sqrt(1.0 - v) * sqrt(v + 1.0);
    const double cosine2 = cosine * cosine;
    const double cosine3 = cosine * cosine2;
    const double cosine6 = cosine3 * cosine3;
    const double delta2 = delta * delta;
    const double delta3 = delta * delta2;
    const double delta6 = delta3 * delta3;
    const double delta7 = delta * delta6;
    const double v2 = v * v;
    const double delta4 = delta2 * delta2;
    const double delta8 = delta4 * delta4;
    const double delta9 = delta * delta8;
    const double delta5 = delta * delta4;
    const double delta10 = delta5 * delta5;
    const double delta11 = delta * delta10;
    const double s2 = s * s;
    const double delta12 = delta6 * delta6;
    const double delta13 = delta * delta12;
    const double s3 = s * s2;
    const double cosine4 = cosine2 * cosine2;
    const double cosine5 = cosine * cosine4;
    const double cosine10 = cosine5 * cosine5;
    const double delta14 = delta7 * delta7;
    const double delta15 = delta * delta14;
    const double delta16 = delta8 * delta8;
    const double delta17 = delta * delta16;
    *moment_3_0 += cosine6 * (12.0 * v2 + 3.0) / delta7;
    *moment_3_1 += cosine6 * s * v * (60.0 * v2 + 45.0) / delta9;
    *moment_3_2 += cosine6 * s2 * (v2 * (360.0 * v2 + 540.0) + 45.0) / delta11;
    *moment_3_3 += cosine6 * s3 * v * (v2 * (2520.0 * v2 + 6300.0) + 1575.0) / delta13;
    *moment_5_0 += cosine10 * (v2 * (360.0 * v2 + 540.0) + 45.0) / delta11;
    *moment_5_1 += cosine10 * s * v * (v2 * (2520.0 * v2 + 6300.0) + 1575.0) / delta13;
    *moment_5_2 += cosine10 * s2 * (v2 * (v2 * (20160.0 * v2 + 75600.0) + 37800.0) + 1575.0) / delta15;
    *moment_5_3 += cosine10 * s3 * v * (v2 * (v2 * (181440.0 * v2 + 952560.0) + 793800.0) + 99225.0) / delta17;
}

/* Terms of int sin^2 (1/c - 1/Delta), sin^4/Delta^3, sin^4/Delta^5, sin^4 (1 + 4 u^2)/Delta^7 at a node. */
SF_COMMON void rod_spring_untruncated_near_node(const double *row, double c, double T2, double U2, double *W,
    double *V3, double *V5, double *V7) {
    const double x = row[0], X2 = row[1], less = row[2], both = row[3], K = row[4];
    const double g = 1.0 / (T2 * X2 + 1.0);
    const double v2 = X2 * g * g;
    const double square = -U2 * v2 + 1.0;
    const double delta = sqrt(square);
    const double f = K * g * v2 / delta;
    const double fall = f * v2 / square;
    *W += f * g * (-T2 * both + less) * (g * (T2 * x + x) + 1.0) / (c + delta);
    *V3 += fall;
    *V5 += fall / square;
    *V7 += fall * (4.0 * U2 * v2 + 1.0) / (square * square);
}

/* Terms of int sin^2 tan^(2n) at a node, by n. */
SF_COMMON void rod_spring_untruncated_tangent_node(const double *row, double T2, double *W, double *Wq,
    double *Wq_2, double *Wq_3) {
    const double X2 = row[0], K2 = row[1];
    const double g = 1.0 / (T2 * X2 + 1.0);
    const double g2 = g * g;
    const double g3 = g * g2;
    const double term = K2 * g3;
    const double t0 = -T2 * X2 + 1.0;
    const double q = 4.0 * T2 * X2 / (t0 * t0);
    const double q2 = q * q;
    const double q3 = q * q2;
    *W += term;
    *Wq += q * term;
    *Wq_2 += q2 * term;
    *Wq_3 += q3 * term;
}

/* h, h_A, h_AA, h_AAA, H, H_A, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 162 in passed_0_end, 97 in passed_0, 153 in passed_0_steep,
   655 in passed_1_far, 615 in passed_1, 988 in passed_1_steeper_far, 944 in passed_1_steeper, 1673 in
   passed_1_steep_far, 1357 in passed_1_steep_away, 1444 in passed_1_steep. Error / u (1 + kappa): measured 3.8. */
SF_KERNEL void rod_spring_untruncated_averaged_all_passed_0_end(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], delta_h = p[2];
    const double m = A * A;
    const double k_c = 1.0 - delta_h;
    const double k = k_c * k_c;
    const double a_1 = 0.5 * k_c + 0.5;
    const double b_1 = sqrt(k_c);
    const double e_1 = 0.25 / a_1;
    const double square = e_1 * e_1;
    const double quarter = 0.25 * m;
    double means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_means(quarter, 7, means);
    const double a_8 = means[0], b_8 = means[1], e_8 = means[2], total = means[3], squares = means[4];
    const double a_9 = 0.5 * a_8 + 0.5 * b_8;
    const double t0 = 1.0 / a_9;
    const double e_9 = e_8 * e_8 * quarter * t0;
    const double e = e_9 + total;
    const double tau = 512.0 * e_9 * e_9 + 256.0 * squares;
    const double P = m * t0 * (e + tau);
    const double B = t0 * (-m * tau + 1.0);
    const double C = 2.0 * t0 * tau;
    const double t1 = 2.0 * beta;
    const double t2 = A * t1;
    const double t3 = P * t2;
    const double t4 = 1.0 / k;
    const double t5 = B * t4;
    const double t6 = alpha + t1 * (-C * m + P + m * t5);
    const double k2 = k * k;
    const double t7 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - t3;
    out[1] = -t6;
    out[2] = -t2 * (2.0 * B * t7 + C * t4);
    out[3] = -t1 * (B * (5.0 * m + 3.0) / k3 + C * t7 * (7.0 * m - 3.0));
    out[4] = -A * (alpha - 1.0) - t3;
    out[5] = 1.0 - t6;
    out[6] = 4.0 * A * beta * m * (-0.5 * C + 0.5 * t5);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_0(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1];
    const double m = A * A;
    const double t0 = 1.0 - m;
    const double k_c = sqrt(t0);
    const double a_1 = 0.5 * k_c + 0.5;
    const double b_1 = sqrt(k_c);
    const double e_1 = 0.25 / a_1;
    const double square = e_1 * e_1;
    const double quarter = 0.25 * m;
    double means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_means(quarter, 2, means);
    const double a_3 = means[0], b_3 = means[1], e_3 = means[2], total = means[3], squares = means[4];
    const double a_4 = 0.5 * a_3 + 0.5 * b_3;
    const double t1 = 1.0 / a_4;
    const double e_4 = e_3 * e_3 * quarter * t1;
    const double e = e_4 + total;
    const double tau = 16.0 * e_4 * e_4 + 8.0 * squares;
    const double P = m * t1 * (e + tau);
    const double B = t1 * (-m * tau + 1.0);
    const double C = 2.0 * t1 * tau;
    const double t2 = 2.0 * beta;
    const double t3 = A * t2;
    const double t4 = P * t3;
    const double t5 = 1.0 / t0;
    const double t6 = B * t5;
    const double t7 = alpha + t2 * (-C * m + P + m * t6);
    const double k2 = t0 * t0;
    const double t8 = 1.0 / k2;
    const double k3 = k2 * t0;
    out[0] = -A * alpha - t4;
    out[1] = -t7;
    out[2] = -t3 * (2.0 * B * t8 + C * t5);
    out[3] = -t2 * (B * (5.0 * m + 3.0) / k3 + C * t8 * (7.0 * m - 3.0));
    out[4] = -A * (alpha - 1.0) - t4;
    out[5] = 1.0 - t7;
    out[6] = 4.0 * A * beta * m * (-0.5 * C + 0.5 * t6);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_0_steep(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1];
    const double m = A * A;
    const double t0 = A + 1.0;
    const double t1 = 1.0 - A;
    const double k_c = sqrt(t0) * sqrt(t1);
    const double k = t0 * t1;
    const double a_1 = 0.5 * k_c + 0.5;
    const double b_1 = sqrt(k_c);
    const double e_1 = 0.25 / a_1;
    const double square = e_1 * e_1;
    const double quarter = 0.25 * m;
    double means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_means(quarter, 6, means);
    const double a_7 = means[0], b_7 = means[1], e_7 = means[2], total = means[3], squares = means[4];
    const double a_8 = 0.5 * a_7 + 0.5 * b_7;
    const double t2 = 1.0 / a_8;
    const double e_8 = e_7 * e_7 * quarter * t2;
    const double e = e_8 + total;
    const double tau = 256.0 * e_8 * e_8 + 128.0 * squares;
    const double P = m * t2 * (e + tau);
    const double B = t2 * (-m * tau + 1.0);
    const double C = 2.0 * t2 * tau;
    const double t3 = 2.0 * beta;
    const double t4 = A * t3;
    const double t5 = P * t4;
    const double t6 = 1.0 / k;
    const double t7 = B * t6;
    const double t8 = alpha + t3 * (-C * m + P + m * t7);
    const double k2 = k * k;
    const double t9 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - t5;
    out[1] = -t8;
    out[2] = -t4 * (2.0 * B * t9 + C * t6);
    out[3] = -t3 * (B * (5.0 * m + 3.0) / k3 + C * t9 * (7.0 * m - 3.0));
    out[4] = -A * (alpha - 1.0) - t5;
    out[5] = 1.0 - t8;
    out[6] = 4.0 * A * beta * m * (-0.5 * C + 0.5 * t7);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1_far(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    double sum_0 = 0.0, sum_1 = 0.0, sum_2 = 0.0, sum_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 15; k++)
        rod_spring_untruncated_far_node(rod_spring_untruncated_nodes_1[k], c, t0, U2, &sum_0, &sum_1, &sum_2,
            &sum_3);
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
    out[3] = 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0
        * T3 * sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2;
    out[4] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c;
    out[5] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c);
    out[6] = 2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 * u_cr2 / c + 8.0 * T3 * sum_1 * u_cr2 / c);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    double sum_0 = 0.0, sum_1 = 0.0, sum_2 = 0.0, sum_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 15; k++)
        rod_spring_untruncated_near_node(rod_spring_untruncated_nodes_1[k], c, t0, U2, &sum_0, &sum_1, &sum_2,
            &sum_3);
    rod_spring_untruncated_common_2(A, T, beta, c, root, sum_0, sum_1, sum_2, sum_3, u_cr, &out[0], &out[1],
        &out[2], &out[3], &out[4], &out[5], &out[6]);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1_steeper_far(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    double sum_0 = 0.0, sum_1 = 0.0, sum_2 = 0.0, sum_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 24; k++)
        rod_spring_untruncated_far_node(rod_spring_untruncated_nodes_2[k], c, t0, U2, &sum_0, &sum_1, &sum_2,
            &sum_3);
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
    out[3] = 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0
        * T3 * sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2;
    out[4] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c;
    out[5] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c);
    out[6] = 2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 * u_cr2 / c + 8.0 * T3 * sum_1 * u_cr2 / c);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1_steeper(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double c2 = c * c;
    const double lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0);
    const double half = 0.5 * (A - u_cr) * (A + u_cr);
    const double root = sqrt(2.0 * half - 0.5 * fabs(half - lacking) + 0.5 * fabs(half + lacking));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    double sum_0 = 0.0, sum_1 = 0.0, sum_2 = 0.0, sum_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 24; k++)
        rod_spring_untruncated_near_node(rod_spring_untruncated_nodes_2[k], c, t0, U2, &sum_0, &sum_1, &sum_2,
            &sum_3);
    rod_spring_untruncated_common_2(A, T, beta, c, root, sum_0, sum_1, sum_2, sum_3, u_cr, &out[0], &out[1],
        &out[2], &out[3], &out[4], &out[5], &out[6]);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1_steep_far(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    double u_cr, c, root, V2, V4, V6, V8;
    rod_spring_untruncated_common_1(A, delta_h, &u_cr, &c, &root, &V2, &V4, &V6, &V8);
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double A2 = A * A;
    double sum_0 = 0.0, sum_1 = 0.0, sum_2 = 0.0, sum_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 15; k++)
        rod_spring_untruncated_tangent_node(rod_spring_untruncated_nodes_3[k], t0, &sum_0, &sum_1, &sum_2, &sum_3);
    const double T3 = T * t0;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c -
        6.0 * V2 - 7.0 * V4 - 3.0 * V6) / A;
    out[3] = 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 / c - 384.0 * T3 * sum_1 / c - 360.0 * T3 * sum_2 /
        c - 120.0 * T3 * sum_3 / c + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8) / A2;
    out[4] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2);
    out[5] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4);
    out[6] = 2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 / c + 8.0 * T3 * sum_1 / c - 3.0 * V2 - V4);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1_steep_away(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    double u_cr, c, root, V2, V4, V6, V8;
    rod_spring_untruncated_common_1(A, delta_h, &u_cr, &c, &root, &V2, &V4, &V6, &V8);
    const double A2 = A * A;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double tangent = u_cr / root;
    const double sum_0 = 0.5 * theta - 0.5 * root * u_cr / A2;
    const double tangents_1 = tangent - theta;
    const double sum_1 = -sum_0 + tangents_1;
    const double tangent2 = tangent * tangent;
    const double tangent3 = tangent * tangent2;
    const double tangents_2 = 0.33333333333333331 * tangent3 - tangents_1;
    const double sum_2 = -sum_1 + tangents_2;
    const double tangent4 = tangent2 * tangent2;
    const double tangent5 = tangent * tangent4;
    const double tangents_3 = 0.20000000000000001 * tangent5 - tangents_2;
    const double sum_3 = -sum_2 + tangents_3;
    out[0] = 2.5464790894703255 * A * beta * (-V2 + sum_0 / c) - A;
    out[1] = 2.5464790894703255 * beta * (2.0 * V2 + V4 - 2.0 * sum_0 / c - sum_1 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (-6.0 * V2 - 7.0 * V4 - 3.0 * V6 + 6.0 * sum_0 / c + 7.0 * sum_1 / c +
        3.0 * sum_2 / c) / A;
    out[3] = 2.5464790894703255 * beta * (24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8 - 24.0 * sum_0 / c - 48.0
        * sum_1 / c - 45.0 * sum_2 / c - 15.0 * sum_3 / c) / A2;
    out[4] = 2.5464790894703255 * A * beta * (-V2 + sum_0 / c);
    out[5] = 2.5464790894703255 * beta * (2.0 * V2 + V4 - 2.0 * sum_0 / c - sum_1 / c);
    out[6] = 2.5464790894703255 * A * beta * (-3.0 * V2 - V4 + 3.0 * sum_0 / c + sum_1 / c);
}

SF_KERNEL void rod_spring_untruncated_averaged_all_passed_1_steep(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double c2 = c * c;
    const double lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0);
    const double half = 0.5 * (A - u_cr) * (A + u_cr);
    const double root = sqrt(2.0 * half - 0.5 * fabs(half - lacking) + 0.5 * fabs(half + lacking));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double u_cr2 = u_cr * u_cr;
    const double A2 = A * A;
    const double x2 = u_cr2 / A2;
    const double root2 = root * root;
    const double y2 = root2 / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(c2);
    const double b0_half_0 = 0.5 / b0_0;
    const double b0_half_0_2 = b0_half_0 * b0_half_0;
    const double b0_half_0_3 = b0_half_0 * b0_half_0_2;
    const double b02_0 = -b0_half_0_3;
    const double b03_0 = -2.0 * b02_0 * b0_half_0_2;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double lam0_2 = a0_0 * b02_0 + b02_0;
    const double lam0_3 = a0_0 * b03_0 + b03_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double X0_2 = 0.25 * lam0_2;
    const double X0_3 = 0.25 * lam0_3;
    const double Y0_0 = 0.25 * c2 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    double R_0, R_1, R_2, R_3;
    rod_spring_untruncated_duplications(X0_0, X0_1, X0_2, X0_3, Y0_0, Y0_1, X0_2, X0_3, Z0_0, X0_1, X0_2, X0_3,
        term0_0, term01_0, term02_0, term03_0, &R_0, &R_1, &R_2, &R_3);
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double x2_2 = x2 * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2_2;
    const double x2_3 = x2 * x2_2;
    const double V8 = -3.2000000000000002 * R_3 * third * x2_3;
    double sum_0 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 15; k++)
        rod_spring_untruncated_arc_node(rod_spring_untruncated_nodes_3[k], t0, &sum_0);
    const double T3 = T * t0;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c3 = c * c2;
    const double root3 = root * root2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0;
    out[2] = -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root));
    out[3] = -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 - 3.0 * u_cr5 / (A4 *
        c5 * root) + 3.0 * u_cr5 / (A4 * c3 * root) + u_cr5 / (A2 * c3 * root3));
    out[4] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2);
    out[5] = -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2);
    out[6] = 2.5464790894703255 * A3 * V4 * beta;
}

SF_KERNEL void rod_spring_untruncated_averaged_all(double A, const double *p, double *out) {
    const double delta_h = p[2];
    if ((A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) && (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A))
        rod_spring_untruncated_averaged_all_passed_0_end(A, p, out);
    else if ((A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) && (A <= 0.69999999999999996))
        rod_spring_untruncated_averaged_all_passed_0(A, p, out);
    else if (A <= sqrt(-delta_h * delta_h + 2.0 * delta_h))
        rod_spring_untruncated_averaged_all_passed_0_steep(A, p, out);
    else if ((sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75) && (1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A))
        rod_spring_untruncated_averaged_all_passed_1_far(A, p, out);
    else if (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75)
        rod_spring_untruncated_averaged_all_passed_1(A, p, out);
    else if ((sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004) && (1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A))
        rod_spring_untruncated_averaged_all_passed_1_steeper_far(A, p, out);
    else if (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004)
        rod_spring_untruncated_averaged_all_passed_1_steeper(A, p, out);
    else if (1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A)
        rod_spring_untruncated_averaged_all_passed_1_steep_far(A, p, out);
    else if (sqrt(-0.75 * delta_h * delta_h + 1.5 * delta_h + 0.25) <= A)
        rod_spring_untruncated_averaged_all_passed_1_steep_away(A, p, out);
    else
        rod_spring_untruncated_averaged_all_passed_1_steep(A, p, out);
}

/* Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.
   Equation beyond (20). Domain: A >= 0, u_cr <= 3/4. Operations: 1995 in passed_0, 2537 in passed_1. Error / u (1 +
   kappa): measured 5.9. */
SF_KERNEL void rod_spring_untruncated_harmonics_passed_0(double A, const double *p, double *out) {
    const double beta = p[1];
    double moment_3_0 = 0.0, moment_3_1 = 0.0, moment_3_2 = 0.0, moment_3_3 = 0.0, moment_5_0 = 0.0, moment_5_1 =
        0.0, moment_5_2 = 0.0, moment_5_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 20; k++)
        rod_spring_untruncated_midpoint(rod_spring_untruncated_nodes_4[k], A, &moment_3_0, &moment_3_1, &moment_3_2,
            &moment_3_3, &moment_5_0, &moment_5_1, &moment_5_2, &moment_5_3);
    const double A2 = A * A;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    out[0] = -0.013333333333333334 * A3 * beta * moment_3_0;
    out[1] = -0.013333333333333334 * beta * (3.0 * A2 * moment_3_0 + A3 * moment_3_1);
    out[2] = -0.013333333333333334 * beta * (6.0 * A * moment_3_0 + 6.0 * A2 * moment_3_1 + A3 * moment_3_2);
    out[3] = -0.013333333333333334 * beta * (18.0 * A * moment_3_1 + 9.0 * A2 * moment_3_2 + A3 * moment_3_3 + 6.0
        * moment_3_0);
    out[4] = -0.00021164021164021165 * A5 * beta * moment_5_0;
    out[5] = -0.00021164021164021165 * beta * (5.0 * A4 * moment_5_0 + A5 * moment_5_1);
    out[6] = -0.00021164021164021165 * beta * (20.0 * A3 * moment_5_0 + 10.0 * A4 * moment_5_1 + A5 * moment_5_2);
    out[7] = -0.00021164021164021165 * beta * (60.0 * A2 * moment_5_0 + 60.0 * A3 * moment_5_1 + 15.0 * A4 *
        moment_5_2 + A5 * moment_5_3);
}

SF_KERNEL void rod_spring_untruncated_harmonics_passed_1(double A, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double T2 = T * T;
    double sum_3_0 = 0.0, sum_3_1 = 0.0, sum_3_2 = 0.0, sum_3_3 = 0.0, sum_5_0 = 0.0, sum_5_1 = 0.0, sum_5_2 = 0.0,
        sum_5_3 = 0.0;
    SF_UNROLLED
    for (int k = 0; k < 21; k++)
        rod_spring_untruncated_harmonic_node(rod_spring_untruncated_nodes_5[k], T, T2, c, A, u_cr, &sum_3_0,
            &sum_3_1, &sum_3_2, &sum_3_3, &sum_5_0, &sum_5_1, &sum_5_2, &sum_5_3);
    const double u_cr2 = u_cr * u_cr;
    const double u_cr4 = u_cr2 * u_cr2;
    const double A2 = A * A;
    const double c2 = c * c;
    const double c3 = c * c2;
    const double u_cr3 = u_cr * u_cr2;
    const double A3 = A * A2;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    const double u_cr5 = u_cr * u_cr4;
    const double A5 = A * A4;
    const double A6 = A3 * A3;
    out[0] = -2.5464790894703255 * beta * sum_3_0;
    out[1] = -2.5464790894703255 * beta * sum_3_1;
    out[2] = 0.63661977236758138 * beta * (-4.0 * sum_3_2 + 4.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) /
        (A2 * c3 * root));
    out[3] = 0.63661977236758138 * beta * (-4.0 * sum_3_3 + 12.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) /
        (A3 * c5 * root) - 8.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) / (A3 * c3 * root) + 4.0 * u_cr4 *
        (-12.0 * u_cr3 / A4 + 3.0 * u_cr / A2) / (A2 * c3 * root) - 4.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr /
        A) / (A * c3 * root3));
    out[4] = -2.5464790894703255 * beta * sum_5_0;
    out[5] = -2.5464790894703255 * beta * sum_5_1;
    out[6] = 0.63661977236758138 * beta * (-4.0 * sum_5_2 + 4.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 +
        5.0 * u_cr / A) / (A2 * c3 * root));
    out[7] = 0.63661977236758138 * beta * (-4.0 * sum_5_3 + 12.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3
        + 5.0 * u_cr / A) / (A3 * c5 * root) - 8.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 * u_cr /
        A) / (A3 * c3 * root) + 4.0 * u_cr4 * (-80.0 * u_cr5 / A6 + 60.0 * u_cr3 / A4 - 5.0 * u_cr / A2) / (A2 * c3
        * root) - 4.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 * u_cr / A) / (A * c3 * root3));
}

SF_KERNEL void rod_spring_untruncated_harmonics(double A, const double *p, double *out) {
    const double delta_h = p[2];
    if (A <= sqrt(-delta_h * delta_h + 2.0 * delta_h))
        rod_spring_untruncated_harmonics_passed_0(A, p, out);
    else
        rod_spring_untruncated_harmonics_passed_1(A, p, out);
}

/* d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.
   Equation from (20)-(22), (31). Domain: A > 0. Operations: 7 in passed_0, 44 in passed_1, 100 in passed_1_far_1.
   Error / u (1 + kappa): proved in passed_0 3.01 at most. */
SF_KERNEL void rod_spring_untruncated_by_parameter_passed_0(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double alpha = p[0], beta = p[1];
    const double t0 = 1.0 / beta;
    for (int k = 0; k < 9; k++)
        out[k] = 0.0;
    out[0] = -A;
    out[1] = -1.0;
    out[3] = t0 * (A * alpha + h);
    out[4] = t0 * (alpha + h_A);
    out[5] = h_AA * t0;
}

SF_KERNEL void rod_spring_untruncated_by_parameter_passed_1(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double t0 = 1.0 - delta_h;
    const double inner = -1.0 / (t0 * t0);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t1 = 1.0 / A;
    const double x = t1 * u_cr;
    const double y = root * t1;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double M2 = 0.5 * theta - 0.5 * x * y;
    const double t2 = 1.0 / beta;
    const double t3 = 2.5464790894703255 * beta * inner;
    const double t4 = 1.0 / (A * A);
    const double t5 = 1.0 / root;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    for (int k = 0; k < 9; k++)
        out[k] = 0.0;
    out[3] = t2 * (A + h);
    out[4] = t2 * (h_A + 1.0);
    out[5] = h_AA * t2;
    out[6] = -A * M2 * t3;
    out[7] = t3 * (-M2 + t4 * t5 * u_cr3);
    out[8] = -t1 * t3 * t5 * u_cr3 * (t4 + 1.0 / (root * root));
}

SF_KERNEL void rod_spring_untruncated_by_parameter_passed_1_far_1(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double beta = p[1], delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double t0 = 1.0 - delta_h;
    const double inner = -1.0 / (t0 * t0);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t1 = 1.0 / A;
    const double x = t1 * u_cr;
    const double y = root * t1;
    const double x2 = x * x;
    const double z = x2 / (y * y);
    const double s = x / sqrt(2.0 * y + 2.0);
    const double s2 = s * s;
    const double s4 = s2 * s2;
    const double s3 = s * s2;
    const double M2 = s3 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (-0.00024001561371391354 * s4 - 0.00028620151974909129) - 0.00034586114026712993) - 0.00042450462722033023)
        - 0.00053066957722573227) - 0.00067810320704266795) - 0.00088998368261633694) - 0.001207644289190119) -
        0.0017101353612439386) - 0.0025628662109375001) - 0.0041562034970238099) - 0.0075827205882352941) -
        0.016826923076923076) - 0.055555555555555552) - 0.80000000000000004) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.0002616872854606552 * s4 - 0.00031405642701878893) -
        0.0003823663002536063) - 0.00047344553674152619) - 0.00059807125876960886) - 0.0007739815359505323) -
        0.0010318889149597713) - 0.0014283964710850869) - 0.0020763962357132522) - 0.0032255753226902175) -
        0.0055124383223684207) - 0.010937499999999999) - 0.028409090909090908) - 0.14285714285714285) +
        2.6666666666666665);
    const double t2 = 1.0 / beta;
    const double t3 = 2.5464790894703255 * beta * inner;
    const double x3 = x * x2;
    const double t4 = x3 / y;
    for (int k = 0; k < 9; k++)
        out[k] = 0.0;
    out[3] = t2 * (A + h);
    out[4] = t2 * (h_A + 1.0);
    out[5] = h_AA * t2;
    out[6] = -A * M2 * t3;
    out[7] = -t3 * (M2 - t4);
    out[8] = -t1 * t3 * t4 * (z + 2.0);
}

SF_KERNEL void rod_spring_untruncated_by_parameter(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double delta_h = p[2];
    if (A <= sqrt(-delta_h * delta_h + 2.0 * delta_h))
        rod_spring_untruncated_by_parameter_passed_0(A, h, h_A, h_AA, p, out);
    else if (A <= 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h))
        rod_spring_untruncated_by_parameter_passed_1(A, h, h_A, h_AA, p, out);
    else
        rod_spring_untruncated_by_parameter_passed_1_far_1(A, h, h_A, h_AA, p, out);
}

/* d/d of each number of the design: of each parameter in turn, then of each breakpoint.
   Equation (5), (7). Domain: any design that has a breakpoint. Operations: 13. Error / u (1 + kappa): proved 0.34,
   0.34, 0.34, 4.01, 4.01, 0.34, 0.0, 0.0, 0.0, 0.0, 0.0, -. */
SF_KERNEL void rod_spring_untruncated_by_design(double lam, double r, double delta_h, double *out) {
    const double t0 = lam * r;
    const double t1 = delta_h - 1.0;
    const double t2 = 0.5 * t1;
    for (int k = 0; k < 12; k++)
        out[k] = 0.0;
    out[0] = -delta_h * r;
    out[1] = -delta_h * lam;
    out[2] = -t0;
    out[3] = -r * t2;
    out[4] = -lam * t2;
    out[5] = -0.5 * t0;
    out[8] = 1.0;
    out[11] = -t1 / (sqrt(delta_h) * sqrt(2.0 - delta_h));
}

/* The parameters alpha, beta, delta_h from the design.
   Equation (5), (7). Domain: any design. Operations: 6. Error / u (1 + kappa): proved 1.34, 6.01, 0.0. */
SF_KERNEL void rod_spring_untruncated_coefficients(double lam, double r, double delta_h, double *out) {
    const double t0 = lam * r;
    out[0] = -delta_h * t0 + 1.0;
    out[1] = -0.5 * t0 * (delta_h - 1.0);
    out[2] = delta_h;
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters. Operations: 4. Error / u (1 + kappa): measured 0.96. */
SF_KERNEL void rod_spring_untruncated_breakpoints(const double *p, double *out) {
    const double delta_h = p[2];
    out[0] = sqrt(-delta_h * delta_h + 2.0 * delta_h);
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (5). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL void rod_spring_untruncated_jumps(const double *p, double *out) {
    out[0] = 0.0;
}

/* The force over the displacement, f(u)/u, rises with |u| where none of these is negative.
   Equation from (3). Domain: any parameters. Operations: 1. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL void rod_spring_untruncated_hardening(const double *p, double *out) {
    const double beta = p[1];
    out[0] = 2.0 * beta;
}

/* Piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 12. Error / u (1 + kappa): measured 0.85. */
SF_KERNEL double rod_spring_untruncated_force_1(double u, double alpha, double beta, double delta_h) {
    const double t0 = sqrt((1.0 - u) * (u + 1.0));
    return u * (alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0)));
}

/* d/du of piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 23. Error / u (1 + kappa): measured 1.5. */
SF_KERNEL double rod_spring_untruncated_force_1_u(double u, double alpha, double beta, double delta_h) {
    const double root_1 = sqrt((1.0 - u) * (u + 1.0));
    const double t0 = root_1 + 1.0;
    const double t1 = 1.0 / t0;
    const double t2 = u * u;
    const double t3 = t2 / root_1;
    const double t4 = 2.0 * beta;
    return alpha + 6.0 * beta * t1 * t3 - t3 * (-t3 * t4 / (t0 * t0) - t1 * t2 * t4 / (root_1 * root_1));
}

/* Piece 2 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL double rod_spring_untruncated_force_2(double u, double alpha, double beta, double delta_h) {
    return u;
}

/* d/du of piece 2 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL double rod_spring_untruncated_force_2_u(double u, double alpha, double beta, double delta_h) {
    return 1.0;
}

/* Whole dimensionless restoring force u + F_k(u), untruncated.
   Equation (3), (5). Domain: |u| < 1. Error / u (1 + kappa): measured 0.86. */
SF_KERNEL double rod_spring_untruncated_force(double u, double alpha, double beta, double delta_h) {
    if (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= fabs(u))
        return rod_spring_untruncated_force_2(u, alpha, beta, delta_h);
    else
        return rod_spring_untruncated_force_1(u, alpha, beta, delta_h);
}

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 3.3. */
SF_KERNEL void rod_spring_untruncated_averaged(double A, const double *p, double *out) {
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    out[0] = values[0];
    out[1] = values[1];
    out[2] = values[2];
    out[3] = values[3];
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 1.7. */
SF_KERNEL void rod_spring_untruncated_averaged_2(double A, const double *p, double *out) {
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    out[0] = values[0];
    out[1] = values[1];
}

/* H, H_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 3. */
SF_KERNEL void rod_spring_untruncated_averaged_H(double A, const double *p, double *out) {
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    out[0] = values[4];
    out[1] = values[5];
}

/* h - A h_A, where the tangent of h meets A = 0; linear terms are none.
   Equation (20)-(22), (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.9. */
SF_KERNEL double rod_spring_untruncated_intercept(double A, double alpha, double beta, double delta_h) {
    const double p[] = {alpha, beta, delta_h};
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    return values[6];
}

#include "arithmetic_doubles.h"
#define OF(name) rod_spring_untruncated_##name
#include "mechanism_generic.h"
#include "arithmetic_end.h"

SF_FAMILY_END

#endif
