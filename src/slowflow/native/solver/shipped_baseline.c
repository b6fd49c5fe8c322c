/* The records for any processor. */
#define SF_RECORDS sf_records_baseline
#include "shipped.h"
