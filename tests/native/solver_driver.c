/* The solvers over rows (lam, r, delta_h, mu, zeta, F_0) of isolators, built by a test with samples of its own. */
#define SF_SOLVERS sf_solvers_here
#include "solvers.h"

void onset(const double *rows, long n, double *numbers, int *codes);
void saddle_nodes(const double *rows, long n, double *numbers, int *codes);
void peak(const double *rows, long n, double *numbers, int *codes);

/* rows hold designs within their domain */
static void prepare(const double *row, sf_model *model) {
    rod_spring_record.parameters_of(row, model->p);
    rod_spring_record.damping_of(row + 3, model->damping);
    sf_prepare(&rod_spring_record, model);
}

/* F_SN, Omega, A; status, kind */
void onset(const double *rows, long n, double *numbers, int *codes) {
    sf_work *work = malloc(sizeof *work);
    long k;
    for (k = 0; k < n && work != NULL; k++) {
        sf_model model;
        sf_onset found;
        prepare(rows + 6 * k, &model);
        codes[2 * k] = sf_find_onset(&model, work, &found);
        codes[2 * k + 1] = found.kind;
        numbers[12 * k] = found.F_SN, numbers[12 * k + 1] = found.Omega, numbers[12 * k + 2] = found.A;
    }
    free(work);
}

/* A of up to 12 folds; status, count */
void saddle_nodes(const double *rows, long n, double *numbers, int *codes) {
    sf_work *work = malloc(sizeof *work);
    long k;
    int i;
    for (k = 0; k < n && work != NULL; k++) {
        sf_model model;
        prepare(rows + 6 * k, &model);
        codes[2 * k] = sf_saddle_nodes(&model, rows[6 * k + 5], work, &work->folds);
        codes[2 * k + 1] = work->folds.n;
        for (i = 0; i < work->folds.n && i < 12; i++)
            numbers[12 * k + i] = work->folds.at[i].A;
    }
    free(work);
}

/* A, Omega; status, 0 */
void peak(const double *rows, long n, double *numbers, int *codes) {
    sf_work *work = malloc(sizeof *work);
    long k;
    for (k = 0; k < n && work != NULL; k++) {
        sf_model model;
        prepare(rows + 6 * k, &model);
        codes[2 * k] = sf_peak(&model, rows[6 * k + 5], work, &numbers[12 * k], &numbers[12 * k + 1]);
    }
    free(work);
}
