/* The solvers of all mechanisms as tables of functions: what the binding to Python calls. */
#ifndef SF_INTERFACE_H
#define SF_INTERFACE_H

#include <fenv.h>

#include "work.h"

/* isola: an isola point, else a cusp; minimum: of the level along the fold locus; saddle: F has a saddle in (A, Omega) */
typedef struct {
    double F_0, Omega, A;
    int isola, minimum, saddle;
} sf_extremum;

typedef void (*sf_many)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data);

enum { SF_MANY_DETACHMENT, SF_MANY_ONSETS, SF_MANY_FOLDS, SF_MANY_PEAKS, SF_MANY };

typedef struct {
    const char *name;
    int parameters, design_size;
    void (*prepare)(double m, double zeta, double reach, sf_model *model); /* model->p is set before */
    sf_status (*onset)(const sf_model *, sf_work *, sf_onset *);
    sf_status (*detachment)(const sf_model *, double *F_cr, double *Omega_cr, double *u_cr);
    sf_status (*peak)(const sf_model *, double F_0, sf_work *, double *A, double *Omega);
    sf_status (*saddle_nodes)(const sf_model *, double F_0, sf_work *, sf_folds *);
    sf_status (*fold_locus)(const sf_model *, double F_0, double A_max, sf_work *);
    sf_status (*range)(const sf_model *, double F_0, double *A_max);
    sf_status (*skeleton)(const sf_model *, double F_0, sf_work *);
    long (*show)(const sf_model *, double F_0, double low, double high, double samples, sf_work *, double *total);
    void (*draw)(const sf_model *, double F_0, double samples, double total, const sf_skeleton *shown, double *Omega,
                 double *A, unsigned char *stable, long long *branch);
    int (*most_states)(const sf_work *, double Omega);
    int (*states)(const sf_model *, double F_0, const sf_work *, double Omega, double *A, unsigned char *stable);
    sf_extremum (*extremum)(const sf_model *, const sf_zero *);
    long (*draw_locus)(const sf_model *, long samples, sf_work *, double *Omega, double *A, double *F_0,
                       long long *branch);
    sf_many many[SF_MANY];
} sf_solver;

/* mechanisms, and behind those that a user designs the scenes of one; the second table is for processors with fma */
enum { SF_ROD_SPRING, SF_DUFFING, SF_ROD_SPRING_EXACT, SF_DESIGNED, SF_ROD_SPRING_ATTACHED = SF_DESIGNED, SF_MECHANISMS };
extern const sf_solver *const sf_solvers_baseline[SF_MECHANISMS];
extern const sf_solver *const sf_solvers_fma[SF_MECHANISMS];

#endif
