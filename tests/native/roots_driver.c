/* The root solvers over arrays of parameter rows: rows in, Omega and counts out.  For tests and benchmarks. */
#include "roots.h"

/* With SF_CLONES the loops are built as a package would build them: once more for a processor with fma. */
#ifdef SF_CLONES
#define SF_LOOP __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define SF_LOOP
#endif

void response(const double *p, long n, double *Omega, int *count);
void fold(const double *p, long n, double *Omega, int *count);
void peak(const double *p, long n, double *Omega, int *count);

SF_LOOP void response(const double *p, long n, double *Omega, int *count) {
    for (long i = 0; i < n; i++, p += 5)
        count[i] = sf_response_roots(p[0], p[1], p[2], p[3], p[4], Omega + 3 * i);
}

SF_LOOP void fold(const double *p, long n, double *Omega, int *count) {
    for (long i = 0; i < n; i++, p += 5)
        count[i] = sf_fold_roots(p[0], p[1], p[2], p[3], p[4], Omega + 3 * i);
}

SF_LOOP void peak(const double *p, long n, double *Omega, int *count) {
    for (long i = 0; i < n; i++, p += 4)
        count[i] = sf_peak_roots(p[0], p[1], p[2], p[3], Omega + 2 * i);
}
