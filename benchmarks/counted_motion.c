/* How often a motion that is followed does what its time goes into, and what each of that costs here, as `counted.c`
 * has it of averaged answers.
 */
#include <time.h>

#include "taylor.h"
#include "exact/sides.h"

enum { KEPT = 4096, ROUNDS = 20, MOST_PIECES = 8, MOST_CONSTANTS = 16 };

typedef struct {
    const sf_piece *piece;
    sf_drive drive;
    double theta, u, v;
} kept_step;

static long steps_made, searched;
static kept_step step_kept[KEPT];
static double search_kept[KEPT][SF_TERMS];
static volatile double sink;

static double counted_expanded(const sf_piece *piece, const sf_drive *drive, double direction, double theta, double u,
                               double v, const sf_four *flow, sf_expansion *x)
{
    step_kept[steps_made++ % KEPT] = (kept_step){piece, *drive, theta, u, v};
    return sf_expanded(piece, drive, direction, theta, u, v, flow, x);
}

static sf_found counted_first_zero(const double *a, double *zero)
{
    memcpy(search_kept[searched++ % KEPT], a, sizeof search_kept[0]);
    return sf_first_zero(a, zero);
}

#define sf_expanded counted_expanded
#define sf_first_zero counted_first_zero
#include "exact/follow.h"
#undef sf_expanded
#undef sf_first_zero

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double seconds_of_steps(long n)
{
    double best = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            const kept_step *const at = &step_kept[i];
            sf_expansion x;
            sink = sf_expanded(at->piece, &at->drive, 1.0, at->theta, at->u, at->v, NULL, &x);
        }
        best = fmin(best, (now() - start) / (double)n);
    }
    return best;
}

static double seconds_of_searches(long n)
{
    double best = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            double zero;
            sink = sf_first_zero(search_kept[i], &zero) + zero;
        }
        best = fmin(best, (now() - start) / (double)n);
    }
    return best;
}

/* A motion from rest at u = 0 over so many turns. names, constants: of each piece, by rising u, and from the numbers of
 * each, `of` it; edges: the ends of all but the last; out: phases, steps, searches for a stop, and the seconds of a step
 * and of a search. Returns 0 where a piece is not known. */
int turns(int pieces, int about, const char **names, const int *of, const double *constants, const double *edges,
          double mu, double zeta, double Omega, double F_0, double end, double *out)
{
    static sf_piece piece[MOST_PIECES];
    static double p[MOST_PIECES][2][MOST_CONSTANTS], edge[MOST_PIECES + 1];
    sf_system system = {.pieces = pieces, .about = about, .odd = 1, .piece = piece, .edge = edge, .mu = mu, .zeta = zeta,
                        .mu_s = mu};
    sf_forced forced = {&system, Omega, F_0, 1000000};
    sf_phases phases = {0};
    if (pieces > MOST_PIECES)
        return 0;
    edge[0] = -SF_FAR, edge[pieces] = SF_FAR;
    for (int i = 0; i < pieces; constants += of[i++]) {
        const sf_law *law = sf_laws;
        while (law->name != NULL && strcmp(law->name, names[i]) != 0)
            law++;
        if (law->name == NULL || of[i] != law->constants || of[i] >= MOST_CONSTANTS)
            return 0;
        piece[i].law = law, piece[i].below = i > about ? &piece[i - 1] : i < about ? &piece[i + 1] : NULL;
        for (int side = 0; side < 2; side++) {
            memcpy(p[i][side], constants, (size_t)of[i] * sizeof *constants);
            p[i][side][of[i]] = side ? 1.0 : -1.0, piece[i].p[side] = p[i][side];
        }
        if (i > 0)
            edge[i] = edges[i - 1];
    }
    steps_made = searched = 0;
    const int followed = sf_follow(&forced, 0.0, 0.0, 0.0, end, NULL, &phases) == SF_GOOD;
    out[0] = (double)phases.count, out[1] = (double)steps_made, out[2] = (double)searched;
    free(phases.at);
    if (!followed || searched == 0)
        return 0;
    out[3] = seconds_of_steps(steps_made < KEPT ? steps_made : KEPT);
    out[4] = seconds_of_searches(searched < KEPT ? searched : KEPT);
    return 1;
}
