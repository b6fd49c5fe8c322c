/* Every function of these headers with a symbol, for what calls a library.

   Written by `make derive` or `slowflow derive`; never edit. */

#ifdef _WIN32
#define SF_KERNEL __declspec(dllexport)
#else
#define SF_KERNEL
#endif
#define SF_TWOFOLD SF_KERNEL

#include "slow_flow.h"
#include "frequencies.h"
#include "inertia.h"
#include "off_centre.h"
#include "dissipation.h"
#include "linearization.h"
#include "sensitivities.h"
#include "sampled.h"
#include "motion.h"
#include "second_approximation.h"
#include "den_hartog.h"
#include "duffing.h"
#include "rod_spring.h"
#include "rod_spring_untruncated.h"
