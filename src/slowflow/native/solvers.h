/* All solvers for one target: SF_SOLVERS is the name of the table that is defined here, SF_RECORDS that of its
 * records. */
#include "gradient.h"
#include "many_detachment.h"
#include "many_folds.h"
#include "many_onsets.h"
#include "many_peaks.h"
#include "many_states.h"

static const sf_batch sf_rows_of_many[] = {
    {"many_detachment", "(),(),(),()", "dddb", "F_cr, Omega_cr, u_cr, status", 0, sf_loop_detachment, NULL, 0},
    {"many_onset", "(),(),(),(),(),()", "dddbbb", "F_SN, Omega, A, kind, folds at rest, status", 0, sf_loop_onsets,
     sf_answer_onset, 0},
    {"many_saddle_nodes", "(k),(k),(k),(),(),()", "DDKnbb", "F_0 -> Omega, A, kind, count, undecided, status", 1,
     sf_loop_folds, sf_answer_folds, 1},
    {"many_amplitudes", "(k),(k),(),(),()", "DBnbb", "F_0, Omega -> A, stable, count, undecided, status", 2,
     sf_loop_states, sf_answer_states_at, 1},
    {"many_peak", "(),(),()", "ddb", "F_0 -> A, Omega, status", 1, sf_loop_peaks, sf_answer_peak, 0},
    {"many_frequency_response", "(n),(n),(n),(n),(n),(),(k),(k),(k),(),(),()", "DDBHBiDDKnbb",
     "F_0, samples, low, high -> Omega, A, stable, branch, whether it is closed, points; Omega, A, kind of folds, "
     "count, undecided, status",
     4, sf_loop_singly, sf_answer_response_and_folds, 1},
    {"many_second_detachment", "(),(),(),()", "dddb", "as many_detachment, in the second approximation", 0,
     sf_loop_singly, sf_answer_second_detachment, 0},
    {"many_second_onset", "(),(),(),(),(),()", "dddbbb", "as many_onset, in the second approximation", 0,
     sf_loop_singly, sf_answer_second_onset, 0},
    {"many_second_saddle_nodes", "(k),(k),(k),(),(),()", "DDKnbb",
     "as many_saddle_nodes, in the second approximation, with whether some are lost for undecided", 1, sf_loop_singly,
     sf_answer_second_folds, 1},
    {"many_second_peak", "(),(),()", "ddb", "as many_peak, in the second approximation", 1, sf_loop_singly,
     sf_answer_second_top, 1},
    {"many_proved_saddle_nodes", "(),(),()", "bbb", "F_0 -> count, whether it is proved, status", 1, sf_loop_singly,
     sf_answer_proved_folds, 1},
    {"many_proved_amplitudes", "(),(),()", "bbb", "F_0, Omega -> count, whether it is proved, status", 2,
     sf_loop_singly, sf_answer_proved_states, 1},
    {"many_gradients", "(r,n),()", "Db",
     "F_0, Omega, A, kind, whether inertia excites -> derivatives (rows, columns), status", 5, sf_loop_gradients, NULL,
     0},
};

const sf_solvers SF_SOLVERS = {sf_rows_of_one,
                               sf_rows_of_many,
                               sizeof sf_rows_of_one / sizeof *sf_rows_of_one,
                               sizeof sf_rows_of_many / sizeof *sf_rows_of_many,
                               sf_slopes_of,
                               &SF_RECORDS};
