/* All solvers of one mechanism. Included once for each, with
 *
 *   SF_M(name)        the name of this mechanism's function
 *   SF_KERNEL(name)   the generated kernel
 *   SF_DESIGN_SIZE    how many numbers a user gives beside mu and zeta, SF_IS_DESIGN(design) whether they are allowed,
 *                     SF_PARAMETERS_OF(design, p) the mechanism's parameters from them
 *   SF_PARAMETERS, SF_BREAKPOINTS, SF_REACH
 */
#include "scan.h"

#include "locus.h"

#include "onset.h"

#include "curve.h"

#include "many.h"

static const sf_solver SF_M(solver) = {
    SF_NAME,
    SF_PARAMETERS,
    SF_DESIGN_SIZE,
    SF_M(prepare),
    SF_M(onset),
    SF_M(detachment),
    SF_M(peak),
    SF_M(saddle_nodes),
    SF_M(fold_locus),
    SF_M(range),
    SF_M(skeleton),
    SF_M(show),
    SF_M(draw),
    SF_M(most_states),
    SF_M(states),
    SF_M(extremum),
    SF_M(draw_locus),
    {SF_M(many_detachment), SF_M(many_onsets), SF_M(many_folds), SF_M(many_peaks)},
};

#undef SF_M
#undef SF_KERNEL
#undef SF_NAME
#undef SF_DESIGN_SIZE
#undef SF_IS_DESIGN
#undef SF_PARAMETERS_OF
#undef SF_PARAMETERS
#undef SF_BREAKPOINTS
#undef SF_REACH
