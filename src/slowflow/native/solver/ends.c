/* Means by the motion's ends over NumPy's operands: boxes in charts that are packed into an array (ends.h). */
#include "ends.h"

#include <fenv.h>

#include "solver.h"

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))

/* charts, lo and hi of x, of y, number of the chart -> lower ends, upper ends; NaN where there are no such charts. */
void sf_ends_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    fenv_t before;
    const double *known = NULL;
    sf_charts charts = {0};
    int is_known = 0;
    (void)data;
    feholdexcept(&before);
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double *packed = (const double *)(const void *)(operands[0] + i * steps[0]), chart = IN(5);
        sf_ended found;
        const sf_interval *of = &found.A;
        if (packed != known) {
            is_known = steps[8] == (ptrdiff_t)sizeof *packed && sf_read_charts(packed, dimensions[1], &charts);
            known = packed;
        }
        const int is_chart = is_known && chart >= 0 && chart < charts.charts;
        if (is_chart)
            sf_on_ends(&charts, sfi_of(IN(1), IN(2)), sfi_of(IN(3), IN(4)), (int)chart, &found);
        for (int j = 0; j < SF_OF_MOTION; j++) {
            *(double *)(void *)(operands[6] + i * steps[6] + j * steps[9]) = is_chart ? of[j].lo : NAN;
            *(double *)(void *)(operands[7] + i * steps[7] + j * steps[10]) = is_chart ? of[j].hi : NAN;
        }
    }
    fesetenv(&before);
}
