/* The solvers for any processor. */
#define SF_TABLE sf_solvers_baseline
#include "instances.h"
