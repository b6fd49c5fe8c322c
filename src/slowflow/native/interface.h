/* The solvers and the records as tables: what the binding to Python calls. */
#ifndef SF_INTERFACE_H
#define SF_INTERFACE_H

#include "certificate.h"
#include "second_work.h"
#include "work.h"

typedef void (*sf_many)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data);

/* Makes a record of words and numbers, with the damping and the excitation of another one. */
typedef sf_status (*sf_record_of)(const sf_mechanism *like, const char *name, const int *words, ptrdiff_t count,
                                const double *numbers, ptrdiff_t length, sf_mechanism **record);

/* The record of every mechanism that the package ships, and what makes one of a program, and of polynomials. */
typedef struct {
    const sf_mechanism *const *all;
    int count;
    sf_record_of of_program, of_samples;
    void (*free_samples)(const sf_mechanism *record);
} sf_records;

/* All that was built for one target: the questions about one oscillator, those about many, and the records. */
typedef struct {
    sf_status (*onset)(const sf_model *, const sf_exactly *, sf_work *, sf_onset *);
    sf_status (*detachment)(const sf_model *, const sf_exactly *, double *F_cr, double *Omega_cr, double *u_cr);
    sf_status (*peak)(const sf_model *, const sf_exactly *, double F_0, double most, sf_work *, double *A,
                      double *Omega);
    sf_status (*saddle_nodes)(const sf_model *, const sf_given *, double F_0, sf_room *, sf_folds *);
    sf_status (*fold_locus)(const sf_model *, double A_max, sf_work *);
    sf_status (*extrema)(const sf_model *, double A_max, sf_work *);
    sf_status (*range)(const sf_model *, double F_0, double *A_max);
    double (*undamped_cut)(const sf_model *, double F_0);
    const char *(*spring)(const sf_model *);
    int (*are_events_close)(const sf_model *, double F_0, double A_max, sf_work *);
    sf_status (*skeleton)(const sf_model *, const sf_given *, double F_0, sf_room *);
    long (*show)(const sf_model *, double F_0, double low, double high, double samples, sf_work *);
    void (*draw)(const sf_model *, double F_0, double samples, const sf_skeleton *shown, double *Omega,
                 double *A, unsigned char *stable, long long *branch);
    sf_status (*states)(const sf_model *, const sf_given *, double F_0, sf_room *, double Omega, int *n, double *A,
                        unsigned char *stable, int *undecided);
    int most_states;
    sf_extremum (*extremum)(const sf_model *, const sf_exactly *, const sf_zero *);
    long (*draw_locus)(const sf_model *, long samples, sf_work *, double *Omega, double *A, double *F_0,
                       long long *branch);
    sf_status (*certify_folds)(const sf_model *, const sf_given *, double F_0, const double *hints, int count,
                               sf_proof *, sf_certificate *);
    sf_status (*certify_states)(const sf_model *, const sf_given *, double F_0, double Omega, sf_proof *,
                                sf_certificate *);
    sf_status (*certify_detachment)(const sf_given *, sf_interval *F_cr, sf_interval *Omega_cr);
    sf_status (*certify_onset)(const sf_model *, const sf_given *, sf_work *, sf_proof *, sf_proved_onset *);
    sf_second_curve *(*second_response)(const sf_model *, const sf_given *, double F_0, sf_wanted, double samples,
                                        double low, double high, sf_room *, sf_status *);
    sf_status (*second_saddle_nodes)(const sf_model *, const sf_given *, double F_0, sf_room *, sf_second_folds *);
    void (*second_free)(sf_second_curve *);
    void (*second_folds)(const sf_model *, double F_0, const sf_second_curve *, sf_second_folds *);
    long (*second_most)(const sf_second_curve *, double Omega);
    int (*second_states)(const sf_model *, double F_0, const sf_second_curve *, double Omega, sf_second_point *);
    sf_second_status (*second_peak)(const sf_model *, double F_0, const sf_second_curve *, sf_second_point *);
    sf_second_status (*second_cusp)(const sf_model *, const sf_onset *first, sf_onset *, double *u_max);
    sf_second_status (*second_detach)(const sf_model *, double F_first, double Omega_first, double u_cr, double *F_cr,
                                      double *Omega_cr);
    sf_many many_detachment, many_onsets, many_folds, many_states, many_peaks, many_proved_folds, many_proved_states;
    sf_many many_curves;
    sf_many many_gradients, many_inertial_gradients, many_told;
    sf_many many_second_detachment, many_second_onsets, many_second_folds, many_second_peaks;
    sf_many many_averages;
    const sf_records *records;
} sf_solvers;

/* for any processor, and for those with fma */
extern const sf_solvers sf_solvers_baseline, sf_solvers_fma;
extern const sf_records sf_records_baseline, sf_records_fma;

#endif
