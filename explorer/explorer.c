/* The solvers as WebAssembly. Takes numbers in `in`; returns numbers in arrays that the page reads from memory.
 *
 * A thin interface: it keeps one oscillator and one workspace, calls the solvers and the generated kernels, and
 * computes nothing itself. Everything is dimensionless. `python -m explorer` writes mechanisms.h: records and restoring
 * forces of the package's mechanisms and of the library's, where the pieces of a force end that is not odd, and what
 * the page calls them.
 */
#include "curve.h"
#include "inertial.h"
#include "onset.h"
#include "records.h"
#include "solver/root_lanes.c"
#include "states.h"

#include "linearization.h"
#include "mechanisms.h"
#include "random.h"

#define EXPORT(name) __attribute__((export_name(#name))) name

/* points of one answer, and of a spectral density */
enum { MOST = 1 << 14, COLUMNS = 5, MOST_POINTS = 40 };

static sf_mechanism excited; /* the record that was chosen, by what excites it */
static sf_model model;
static sf_inputs inputs, *known; /* known: NULL where no proof is possible */
static sf_room room;
static double in[SF_MOST_DESIGN + SF_MOST_DAMPING], out[COLUMNS][MOST], spectrum[MOST_POINTS][2];
static unsigned char flags[3][MOST];
static long long branch[MOST];
static int undecided, rises, chosen;

/* The oscillator as it was given, in pairs, for the last digits of an answer. */
static const sf_exactly *exactly(void) { return known == NULL ? NULL : &known->exactly; }

double *EXPORT(input)(void) { return in; }
double *EXPORT(column)(int i) { return out[i]; }
unsigned char *EXPORT(flag)(int i) { return flags[i]; }
long long *EXPORT(branches)(void) { return branch; }
int EXPORT(capacity)(void) { return MOST; }
int EXPORT(is_undecided)(void) { return undecided; }

int EXPORT(known_mechanisms)(void) { return sizeof names / sizeof names[0]; }
const char *EXPORT(name_of)(int i) { return names[i]; }

/* in: the design, then mu and zeta; whether a base or an unbalance excites it. out[0]: breakpoints; returns their
 * number, or -1 for what is not allowed. */
int EXPORT(choose)(int i, int by_inertia) {
    const sf_mechanism *record = &excited;
    excited = **mechanisms[i];
    const double *of_damping = in + record->design_size;
    if (by_inertia)
        sf_excite_by_inertia(&excited);
    known = NULL, model.mechanism = NULL, rises = places_of[i] != NULL, chosen = i;
    if (!sf_take_design(record, in, model.p) || !record->damping_of(of_damping, model.damping) ||
        !sf_prepare(record, in, &model))
        return -1;
    if (sf_give(record, in, of_damping[0], of_damping[1], &inputs))
        known = &inputs;
    memcpy(out[0], model.b, sizeof model.b);
    return model.breaks;
}

/* out[0]: the u at which the force passes from one piece to the next, by rising u; returns their number. */
int EXPORT(places)(int i) {
    if (places_of[i] != NULL) {
        out[0][0] = places_of[i](model.p);
        return 1;
    }
    for (int k = 0; k < model.breaks; k++)
        out[0][model.breaks - 1 - k] = -model.b[k], out[0][model.breaks + k] = model.b[k];
    return 2 * model.breaks;
}

double EXPORT(sticking)(void) { return model.m; }

/* Largest amplitude that makes sense, or infinite. */
double EXPORT(reach)(void) { return model.reach; }

double EXPORT(stiffness_at_rest)(void) {
    const sf_sample at = sf_sample_at(&model, 0);
    return -at.h_A;
}

static void add_what_follows(long i, double F_0) {
    const sf_sample at = sf_sample_at(&model, out[1][i]);
    out[2][i] = slow_flow_phase(out[0][i], out[1][i], model.m, model.zeta, at.h);
    const double force = sf_force(&model, F_0, out[0][i]);
    out[3][i] = slow_flow_transmissibility(out[0][i], out[1][i], force, model.m, model.zeta, at.h);
    out[4][i] = model.mechanism->mean_offset(out[1][i], model.p);
}

/* As `slowflow.averaged.diagnostics.turns_beyond`. */
static int turns_beyond(const sf_sample *at) {
    const sf_sample rest = sf_sample_at(&model, 0);
    int passed = 0;
    while (passed < model.breaks && at->A > model.b[passed])
        passed++;
    return ((rest.h <= 0 && rest.h_A < 0) || at->h < 0) && forces[chosen](at->A, model.p) < 0 &&
           slopes[chosen](at->A, model.p, passed) < 0;
}

/* As `slowflow.averaged.diagnostics.keeps_centre`; whether the motion turns beyond the well; and whether it is stable.
 * A force with one end rises, so that its mean stiffness is positive and it has no well. */
static void look_at(long i) {
    if (rises) {
        flags[1][i] = 1, flags[2][i] = 0;
        return;
    }
    const sf_sample at = sf_sample_at(&model, out[1][i]);
    flags[2][i] = (unsigned char)turns_beyond(&at);
    flags[1][i] = slow_flow_mean_stiffness(at.A, at.h, at.h_A) >= 0 ||
                  slow_flow_offset_stiffness(out[0][i], at.A, at.h, at.h_A) > 0;
    flags[0][i] = flags[0][i] && flags[1][i] && !flags[2][i];
}

static void look_at_all(long n, double F_0) {
    for (long i = 0; i < n; i++)
        add_what_follows(i, F_0), look_at(i);
}

/* The response curve: out Omega, A, phi, transmissibility, mean B; flags stable, centred, beyond the well. Returns the
 * number, or the status with its sign turned. */
long EXPORT(respond)(double F_0, double low, double high, double samples) {
    const sf_status status = sf_sticks(&model, F_0) ? SF_STICKS : sf_make_skeleton(&model, known, F_0, &room);
    if (status != SF_OK)
        return -(long)status;
    const long n = sf_show(&model, F_0, low, high, samples, &room.work);
    if (n < 0 || n > MOST)
        return -(long)(n < 0 ? SF_NO_BOUND : SF_TOO_MANY);
    const sf_points drawn = {out[0], out[1], branch, flags[0]};
    const long moves = sf_draw(&model, F_0, samples, &room.work.shown, &drawn);
    undecided = room.undecided;
    look_at_all(moves, F_0);
    return moves;
}

/* Steady states at a frequency: as `respond`. */
int EXPORT(states)(double F_0, double Omega) {
    int n;
    room.followed = 0;
    const sf_status status = sf_states(&model, known, F_0, &room, Omega, &n, out[1], flags[0], &undecided);
    if (status != SF_OK)
        return -(int)status;
    for (int i = 0; i < n; i++)
        out[0][i] = Omega;
    look_at_all(n, F_0);
    return n;
}

/* out: Omega, A; flags: up, corner. */
int EXPORT(folds)(double F_0) {
    sf_folds *found = &room.work.folds;
    const sf_status status = sf_sticks(&model, F_0) ? SF_STICKS : sf_settled_folds(&model, known, F_0, &room, found);
    if (status != SF_OK)
        return -(int)status;
    for (int i = 0; i < found->n; i++) {
        out[0][i] = found->at[i].Omega, out[1][i] = found->at[i].A;
        flags[0][i] = (unsigned char)found->at[i].up, flags[1][i] = (unsigned char)found->at[i].corner;
    }
    undecided = found->undecided;
    return found->n;
}

/* out[0]: F_SN, Omega, A, its kind, and the lowest level at which the fold locus ends at Omega = 0; returns the
 * status. */
int EXPORT(onset)(void) {
    sf_onset found;
    const sf_status status = sf_settled_onset(&model, exactly(), &room.work, &found);
    out[0][0] = found.F_SN, out[0][1] = found.Omega, out[0][2] = found.A;
    out[0][3] = found.kind, out[0][4] = found.rest;
    return status;
}

/* out[0]: F_cr, Omega_cr, u_cr; returns the status. */
int EXPORT(detachment)(void) { return sf_settled_detachment(&model, exactly(), out[0], out[0] + 1, out[0] + 2); }

/* out[0]: A, Omega, and whether the well of the spring holds no peak; returns the status. As
 * `slowflow.averaged.questions.Averaged.peak`: of those that do not turn beyond the well. */
int EXPORT(peak)(double F_0) {
    double most = HUGE_VAL;
    out[0][2] = 0;
    while (!sf_sticks(&model, F_0)) {
        const sf_status status = sf_settled_peak(&model, exactly(), F_0, most, &room.work, out[0], out[0] + 1);
        out[0][2] = status == SF_UNBOUNDED && !rises && model.zeta > 0;
        if (status != SF_OK || rises)
            return status;
        const sf_sample at = sf_sample_at(&model, out[0][0]);
        if (!turns_beyond(&at))
            return status;
        most = (1 - 0x1p-30) * out[0][0];
    }
    return SF_STICKS;
}

/* out: Omega, A, F_0 along the fold locus. */
long EXPORT(locus)(double A_max, long samples) {
    const sf_status status = sf_fold_locus(&model, A_max, 1, &room.work);
    if (status != SF_OK)
        return -(long)status;
    const long n = sf_draw_locus(&model, samples, &room.work, NULL, NULL, NULL, NULL);
    if (n > MOST)
        return -(long)SF_TOO_MANY;
    sf_draw_locus(&model, samples, &room.work, out[0], out[1], out[2], branch);
    return n;
}

/* Frequencies below `high` between which a steady state would be unstable, at n amplitudes up to A_max; out: A, then
 * the ends of each interval. Returns how many there are. */
int EXPORT(unstable)(double A_max, double high, int n) {
    int found = 0;
    for (int i = 0; i < n; i++) {
        double w[5] = {0};
        const sf_sample at = sf_sample_at(&model, A_max * (i + 0.5) / n);
        int ends = sf_fold_roots(at.A, at.h, at.h_A, model.m, model.zeta, w + 1) + 1;
        w[ends++] = high;
        for (int k = 0; k + 1 < ends; k++) {
            const double a = w[k], b = fmin(w[k + 1], high);
            if (a < b && slow_flow_stability(0.5 * (a + b), at.A, model.m, model.zeta, at.h, at.h_A) < 0 &&
                found < MOST)
                out[0][found] = at.A, out[1][found] = a, out[2][found++] = b;
        }
    }
    return found;
}

/* out: A, the backbone's Omega (NaN where there is none), at n amplitudes up to A_max. */
void EXPORT(backbone)(double A_max, int n) {
    for (int i = 0; i < n; i++) {
        const sf_sample at = sf_sample_at(&model, A_max * (i + 1) / n);
        out[0][i] = at.A, out[1][i] = slow_flow_backbone(at.A, at.h);
    }
}

/* out: Omega, the amplitude that no response exceeds; needs zeta > 0. */
void EXPORT(envelope)(double F_0, double high, int n) {
    for (int i = 0; i < n; i++) {
        out[0][i] = high * (i + 1) / n;
        const double force = sf_force(&model, F_0, out[0][i]);
        out[1][i] = force > model.m ? slow_flow_limit_envelope(out[0][i], force, model.m, model.zeta) : 0;
    }
}

/* out: u, f(u), at n displacements from -u_max to u_max. */
void EXPORT(force)(int mechanism, double u_max, int n) {
    for (int i = 0; i < n; i++) {
        out[0][i] = u_max * (2.0 * i / (n - 1) - 1);
        out[1][i] = forces[mechanism](out[0][i], model.p);
    }
}

double *EXPORT(density)(void) { return spectrum[0]; }
int EXPORT(room_of_density)(void) { return MOST_POINTS; }

double sf_explored_force(double u) { return forces[chosen](u, model.p); }

/* Under white noise of a power, or the density in `spectrum`: see random.h. */
int EXPORT(random)(double power, int points) {
    double *const columns[4] = {out[0], out[1], out[2], out[3]};
    const double mu = in[excited.design_size];
    return sf_explored_random(model.b, model.breaks, mu, model.zeta, power, (const double (*)[2])spectrum, points, MOST,
                              columns);
}
