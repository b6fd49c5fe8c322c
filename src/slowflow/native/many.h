/* Batches of designs, for one mechanism: in go strided arrays, out come strided arrays. Included as scan.h is.
 *
 * The loops have the form of NumPy's ufuncs: args[i] + k * steps[i] is argument i of design k. The inputs are the
 * design (SF_DESIGN_SIZE numbers), mu, zeta and where needed F_0. Nothing is allocated per design.
 */

/* The rest of a model whose parameters are set. */
static void SF_M(prepare)(double m, double zeta, double reach, sf_model *model) {
    model->m = m, model->zeta = zeta, model->reach = reach;
    model->breaks = 0;
#if SF_BREAKPOINTS > 0
    {
        double b[SF_BREAKPOINTS], jump[SF_BREAKPOINTS];
        int i;
        SF_KERNEL(breakpoints)(model->p, b);
        SF_KERNEL(jumps)(model->p, jump);
        for (i = 0; i < SF_BREAKPOINTS; i++)
            if (b[i] > 0) { /* a piece of no width is no piece */
                model->b[model->breaks] = b[i];
                model->jump[model->breaks++] = jump[i];
            }
    }
#endif
}

static double SF_M(input)(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k) {
    return *(const double *)(const void *)(args[i] + k * steps[i]);
}

static void SF_M(output)(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k, double value) {
    *(double *)(void *)(args[i] + k * steps[i]) = value;
}

static void SF_M(output_code)(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k, int value) {
    *(signed char *)(args[i] + k * steps[i]) = (signed char)value;
}

/* Design k as the solvers take it; 0 if a number lies outside its domain. */
static int SF_M(design_at)(char **args, const ptrdiff_t *steps, ptrdiff_t k, sf_model *model) {
    double design[SF_DESIGN_SIZE], mu, zeta;
    int i;
    memset(model, 0, sizeof *model);
    for (i = 0; i < SF_DESIGN_SIZE; i++)
        design[i] = SF_M(input)(args, steps, i, k);
    mu = SF_M(input)(args, steps, i, k), zeta = SF_M(input)(args, steps, i + 1, k);
    if (!(mu >= 0 && zeta >= 0 && mu < HUGE_VAL && zeta < HUGE_VAL) || !SF_IS_DESIGN(design))
        return 0;
    SF_PARAMETERS_OF(design, model->p);
    SF_M(prepare)(slow_flow_friction(mu), zeta, SF_REACH, model);
    return 1;
}

/* A solver tries values that it then discards: the flags that these raise are no fault of the arguments. */
static void SF_M(quietly)(sf_many loop, char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps) {
    fenv_t before;
    feholdexcept(&before);
    loop(args, dimensions, steps, NULL);
    fesetenv(&before);
}

/* design, mu, zeta -> F_cr, Omega_cr, u_cr, status */
static void SF_M(loop_detachment)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const int out = SF_DESIGN_SIZE + 2;
    ptrdiff_t k;
    (void)data;
    for (k = 0; k < dimensions[0]; k++) {
        sf_model model;
        double found[3] = {NAN, NAN, NAN};
        int i;
        sf_status status = SF_INVALID;
        if (SF_M(design_at)(args, steps, k, &model))
            status = SF_M(detachment)(&model, &found[0], &found[1], &found[2]);
        for (i = 0; i < 3; i++)
            SF_M(output)(args, steps, out + i, k, found[i]);
        SF_M(output_code)(args, steps, out + 3, k, status);
    }
}

/* design, mu, zeta -> F_SN, Omega, A, kind, status */
static void SF_M(loop_onsets)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const int out = SF_DESIGN_SIZE + 2;
    sf_work *work = malloc(sizeof *work);
    ptrdiff_t k;
    (void)data;
    for (k = 0; k < dimensions[0]; k++) {
        sf_model model;
        sf_onset found = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL};
        sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (work != NULL && SF_M(design_at)(args, steps, k, &model))
            status = SF_M(onset)(&model, work, &found);
        SF_M(output)(args, steps, out, k, found.F_SN);
        SF_M(output)(args, steps, out + 1, k, found.Omega);
        SF_M(output)(args, steps, out + 2, k, found.A);
        SF_M(output_code)(args, steps, out + 3, k, found.kind);
        SF_M(output_code)(args, steps, out + 4, k, status);
    }
    free(work);
}

/* design, mu, zeta, F_0 -> A, Omega, status */
static void SF_M(loop_peaks)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const int out = SF_DESIGN_SIZE + 3;
    sf_work *work = malloc(sizeof *work);
    ptrdiff_t k;
    (void)data;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = SF_M(input)(args, steps, out - 1, k);
        sf_model model;
        double A = NAN, Omega = NAN;
        sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (work != NULL && F_0 > 0 && F_0 < HUGE_VAL && SF_M(design_at)(args, steps, k, &model))
            status = SF_M(peak)(&model, F_0, work, &A, &Omega);
        SF_M(output)(args, steps, out, k, A);
        SF_M(output)(args, steps, out + 1, k, Omega);
        SF_M(output_code)(args, steps, out + 2, k, status);
    }
    free(work);
}

/* design, mu, zeta, F_0 -> Omega (places), A (places), kind (places), count, status; kind 1 leads up, -1 down, 2 and -2
 * on a corner, 0 is an empty place */
static void SF_M(loop_folds)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const int out = SF_DESIGN_SIZE + 3;
    const ptrdiff_t places = dimensions[1], *inner = steps + out + 5;
    sf_work *work = malloc(sizeof *work);
    ptrdiff_t k, i;
    (void)data;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = SF_M(input)(args, steps, out - 1, k);
        sf_model model;
        sf_folds found;
        sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
        found.n = 0;
        if (work != NULL && F_0 > 0 && F_0 < HUGE_VAL && SF_M(design_at)(args, steps, k, &model))
            status = SF_M(saddle_nodes)(&model, F_0, work, &found);
        if (found.n > places && status == SF_OK)
            status = SF_TOO_MANY;
        for (i = 0; i < places; i++) {
            const int filled = i < found.n;
            *(double *)(void *)(args[out] + k * steps[out] + i * inner[0]) = filled ? found.at[i].Omega : NAN;
            *(double *)(void *)(args[out + 1] + k * steps[out + 1] + i * inner[1]) = filled ? found.at[i].A : NAN;
            *(signed char *)(args[out + 2] + k * steps[out + 2] + i * inner[2]) =
                (signed char)(!filled ? 0 : (found.at[i].up ? 1 : -1) * (found.at[i].corner ? 2 : 1));
        }
        SF_M(output_code)(args, steps, out + 3, k, found.n);
        SF_M(output_code)(args, steps, out + 4, k, status);
    }
    free(work);
}

static void SF_M(many_detachment)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    (void)data;
    SF_M(quietly)(SF_M(loop_detachment), args, dimensions, steps);
}

static void SF_M(many_onsets)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    (void)data;
    SF_M(quietly)(SF_M(loop_onsets), args, dimensions, steps);
}

static void SF_M(many_folds)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    (void)data;
    SF_M(quietly)(SF_M(loop_folds), args, dimensions, steps);
}

static void SF_M(many_peaks)(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    (void)data;
    SF_M(quietly)(SF_M(loop_peaks), args, dimensions, steps);
}
