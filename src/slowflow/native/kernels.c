/* The inner loop that all kernels share: NumPy's operands in, blocks of contiguous arrays out to the kernel's loops. */
#include "kernels.h"

#include <fenv.h>
#include <math.h>

typedef double row[SF_BLOCK];

/* A block that holds several regimes: each one's elements side by side, and back. */
static void run_mixed(const sf_kernel *kernel, ptrdiff_t n, const double *const *in, double *const *out,
                      const unsigned char *regime, const ptrdiff_t *steps) {
    row rows[SF_MOST_OPERANDS];
    const double *packed_in[SF_MOST_OPERANDS];
    double *packed_out[SF_MOST_OPERANDS];
    int where[SF_BLOCK];
    for (int j = 0; j < kernel->outputs; j++)
        packed_out[j] = rows[kernel->inputs + j];
    for (int r = 0; r < kernel->regimes; r++) {
        ptrdiff_t count = 0;
        int any = 0;
        for (ptrdiff_t i = 0; i < n; i++)
            any |= regime[i] == r;
        if (!any)
            continue;
        for (int i = 0; i < n; i++) {
            where[count] = i;
            count += regime[i] == r;
        }
        /* the last element again and again, until only whole vectors are left */
        ptrdiff_t padded = count;
        while (padded % SF_WIDEST != 0) {
            where[padded] = where[count - 1];
            padded++;
        }
        for (int j = 0; j < kernel->inputs; j++) {
            packed_in[j] = in[j];
            if (steps[j] != 0) {
                for (ptrdiff_t i = 0; i < padded; i++)
                    rows[j][i] = in[j][where[i]];
                packed_in[j] = rows[j];
            }
        }
        kernel->loops[r](padded, packed_in, packed_out);
        for (int j = 0; j < kernel->outputs; j++)
            for (ptrdiff_t i = 0; i < count; i++)
                out[j][where[i]] = packed_out[j][i];
    }
}

/* A block of one regime: whole vectors where they are, and the rest filled up by its last element. */
static void run_plain(const sf_kernel *kernel, sf_loop loop, ptrdiff_t n, const double *const *in, double *const *out,
                      const ptrdiff_t *steps) {
    const ptrdiff_t whole = SF_WHOLE(n), rest = n - whole;
    double tails[SF_MOST_OPERANDS][SF_WIDEST];
    const double *tail_in[SF_MOST_OPERANDS];
    double *tail_out[SF_MOST_OPERANDS];
    if (whole > 0)
        loop(whole, in, out);
    if (rest == 0)
        return;
    for (int j = 0; j < kernel->inputs; j++) {
        tail_in[j] = in[j]; /* the same number everywhere */
        if (steps[j] != 0) {
            for (ptrdiff_t i = 0; i < SF_WIDEST; i++)
                tails[j][i] = in[j][whole + (i < rest ? i : rest - 1)];
            tail_in[j] = tails[j];
        }
    }
    for (int j = 0; j < kernel->outputs; j++)
        tail_out[j] = tails[kernel->inputs + j];
    loop(SF_WIDEST, tail_in, tail_out);
    for (int j = 0; j < kernel->outputs; j++)
        for (ptrdiff_t i = 0; i < rest; i++)
            out[j][whole + i] = tail_out[j][i];
}

/* Whether somewhere a NaN came out and none went in. */
static int turns_invalid(const sf_kernel *kernel, char **operands, ptrdiff_t n, const ptrdiff_t *steps) {
    for (ptrdiff_t i = 0; i < n; i++) {
        int nan_in = 0, nan_out = 0;
        for (int j = 0; j < kernel->inputs; j++)
            nan_in |= isnan(*(const double *)(operands[j] + i * steps[j])) != 0;
        for (int j = kernel->inputs; j < kernel->inputs + kernel->outputs; j++)
            nan_out |= isnan(*(const double *)(operands[j] + i * steps[j])) != 0;
        if (nan_out && !nan_in)
            return 1;
    }
    return 0;
}

/* One element, where it is. */
static void run_one(const sf_kernel *kernel, char **operands) {
    const double *in[SF_MOST_OPERANDS];
    double *out[SF_MOST_OPERANDS];
    ptrdiff_t steps[SF_MOST_OPERANDS];
    unsigned char regime = 0;
    for (int j = 0; j < kernel->inputs; j++)
        in[j] = (const double *)operands[j], steps[j] = sizeof(double);
    for (int j = 0; j < kernel->outputs; j++)
        out[j] = (double *)operands[kernel->inputs + j];
    if (kernel->choose != NULL)
        kernel->choose(1, in, &regime);
    run_plain(kernel, kernel->loops[regime], 1, in, out, steps);
}

/* Any number of elements, block by block. */
static void run_blocks(const sf_kernel *kernel, char **operands, ptrdiff_t n, const ptrdiff_t *steps) {
    const int inputs = kernel->inputs, all = inputs + kernel->outputs;
    row rows[SF_MOST_OPERANDS];
    const double *in[SF_MOST_OPERANDS];
    double *out[SF_MOST_OPERANDS];
    unsigned char regime[SF_BLOCK];
    char in_place[SF_MOST_OPERANDS];

    for (int j = 0; j < all; j++)
        in_place[j] = steps[j] == (ptrdiff_t)sizeof(double);
    for (int j = inputs; j < all; j++)
        for (int k = 0; k < inputs; k++)
            in_place[j] &= operands[j] != operands[k]; /* NumPy gives one array twice, and copies what else overlaps */
    for (int j = 0; j < inputs; j++)
        if (steps[j] == 0)
            for (int i = 0; i < (n < SF_BLOCK - SF_WIDEST ? n + SF_WIDEST : SF_BLOCK); i++)
                rows[j][i] = *(const double *)operands[j];

    for (ptrdiff_t start = 0; start < n; start += SF_BLOCK) {
        const ptrdiff_t size = n - start < SF_BLOCK ? n - start : SF_BLOCK;
        for (int j = 0; j < inputs; j++) {
            const char *from = operands[j] + start * steps[j];
            in[j] = in_place[j] ? (const double *)from : rows[j];
            if (!in_place[j] && steps[j] != 0)
                for (ptrdiff_t i = 0; i < size; i++)
                    rows[j][i] = *(const double *)(from + i * steps[j]);
        }
        for (int j = inputs; j < all; j++)
            out[j - inputs] = in_place[j] ? (double *)(operands[j] + start * steps[j]) : rows[j];

        if (kernel->choose == NULL) {
            run_plain(kernel, kernel->loops[0], size, in, out, steps);
        } else {
            int others = 0;
            kernel->choose(size, in, regime);
            for (int i = 1; i < size; i++)
                others += regime[i] != regime[0];
            if (others)
                run_mixed(kernel, size, in, out, regime, steps);
            else
                run_plain(kernel, kernel->loops[regime[0]], size, in, out, steps);
        }

        for (int j = inputs; j < all; j++)
            if (!in_place[j])
                for (ptrdiff_t i = 0; i < size; i++)
                    *(double *)(operands[j] + (start + i) * steps[j]) = rows[j][i];
    }
}

void sf_run(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_kernel *kernel = data;
    const ptrdiff_t n = dimensions[0];
    const int invalid_before = fetestexcept(FE_INVALID);
    if (n <= 0)
        return;
    if (n == 1)
        run_one(kernel, operands);
    else
        run_blocks(kernel, operands, n, steps);
    /* A comparison with NaN sets the flag that NumPy warns of, although nothing invalid was computed. An input that an
       output has overwritten counts as it is now; at worst a warning is missing there. */
    if (!invalid_before && fetestexcept(FE_INVALID) && !turns_invalid(kernel, operands, n, steps))
        feclearexcept(FE_INVALID);
}
