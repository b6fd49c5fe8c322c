/* The solvers for any processor. */
#define SF_SOLVERS sf_solvers_baseline
#include "solvers.h"
