/* The solvers for processors with fma and AVX2: the same numbers, sooner. Products are still not contracted. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC target("avx2,fma,bmi,bmi2,lzcnt")
#endif
#define SF_SOLVERS sf_solvers_fma
#define SF_RECORDS sf_records_fma
#include "solvers.h"
