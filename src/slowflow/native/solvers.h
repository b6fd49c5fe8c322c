/* All solvers for one target: SF_SOLVERS is the name of the table that is defined here, SF_RECORDS that of its
 * records. */
#include "certify.h"
#include "curve.h"
#include "gradient.h"
#include "interface.h"
#include "many.h"
#include "many_curves.h"
#include "many_proofs.h"
#include "onset.h"
#include "second_many.h"
#include "states.h"

const sf_solvers SF_SOLVERS = {
    sf_settled_onset,
    sf_settled_detachment,
    sf_settled_peak,
    sf_settled_folds,
    sf_fold_locus,
    sf_extrema,
    sf_range_at,
    sf_undamped_cut,
    sf_spring,
    sf_are_events_close,
    sf_make_skeleton,
    sf_show,
    sf_draw,
    sf_states,
    SF_MOST_STATES,
    sf_settled_extremum,
    sf_draw_locus,
    sf_certify_folds,
    sf_certify_states,
    sf_certify_detachment,
    sf_certify_onset,
    sf_second_response,
    sf_second_saddle_nodes,
    sf_second_free,
    sf_folds_on,
    sf_most_crossings,
    sf_states_on,
    sf_peak_on,
    sf_second_cusp,
    sf_second_detach,
    sf_many_detachment,
    sf_many_onsets,
    sf_many_folds,
    sf_many_states,
    sf_many_peaks,
    sf_many_proved_folds,
    sf_many_proved_states,
    sf_many_curves,
    sf_many_gradients,
    sf_many_inertial_gradients,
    sf_many_told,
    sf_many_second_detachment,
    sf_many_second_onsets,
    sf_many_second_folds,
    sf_many_second_peaks,
    sf_many_averages,
    &SF_RECORDS,
};
