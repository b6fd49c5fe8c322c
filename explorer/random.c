/* Random vibration of the oscillator that explorer.c keeps. A source of its own: names of the integrator, by whose
 * pieces of a force Gaussian averages are taken, are those of averages over a cycle. */
#include "taylor.h"
#include "linearized.h"

#include "random.h"

enum { MOST_BREAKS = 8, MOST_MOTIONS = 16, MOST_BANDS = 400 };

static double value(const sf_law *self, const double *p, double u) {
    (void)self, (void)p;
    return sf_explored_force(u);
}

int sf_explored_random(const double *b, int breaks, double mu, double zeta, double power, const double (*points)[2],
                       int count, int room, double *const out[4]) {
    static union {
        sf_table table;
        char room[sizeof(sf_table) + MOST_BANDS * sizeof(sf_band)];
    } density;
    static const sf_law law = {.name = "the force", .value = value};
    static const double side[2] = {-1.0, 1.0};
    const int pieces = 2 * breaks + 1;
    sf_piece piece[2 * MOST_BREAKS + 1];
    double edge[2 * MOST_BREAKS + 2];
    if (breaks > MOST_BREAKS || sf_read_table(points, count, NULL) > MOST_BANDS)
        return -1;
    for (int i = 0; i < pieces; i++)
        piece[i] = (sf_piece){&law, {&side[0], &side[1]}, NULL};
    edge[0] = -SF_FAR, edge[pieces] = SF_FAR;
    for (int k = 0; k < breaks; k++)
        edge[breaks - k] = -b[k], edge[breaks + 1 + k] = b[k];
    const sf_system system = {
        .pieces = pieces, .about = breaks, .odd = 1, .piece = piece, .edge = edge, .mu = mu, .zeta = zeta};
    sf_stationary at[MOST_MOTIONS];
    sf_motions found = {.max_count = room < MOST_MOTIONS ? room : MOST_MOTIONS, .at = at};
    if (power > 0.0)
        sf_white(&system, power, &found);
    else {
        sf_read_table(points, count, &density.table);
        if (!sf_tabulated(&system, &density.table, &found))
            return -2;
    }
    if (found.undecided[0] != 0.0 || found.count > found.max_count)
        return -1;
    for (int i = 0; i < found.count; i++)
        out[0][i] = at[i].u, out[1][i] = at[i].v, out[2][i] = at[i].k, out[3][i] = at[i].dry / at[i].c;
    return found.count;
}
