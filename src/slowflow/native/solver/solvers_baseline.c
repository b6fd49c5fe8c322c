/* The solvers for any processor. */
#define SF_SOLVERS sf_solvers_baseline
#define SF_RECORDS sf_records_baseline
#include "solvers.h"
