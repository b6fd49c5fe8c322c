/* All records for one target: SF_RECORDS is the name of the table that is defined here. They are a source of their own,
 * as they take almost as long to compile as the solvers. */
#include "interface.h"
#include "program.h"
#include "records.h"
#include "sampled_force.h"

const sf_records SF_RECORDS = {records, sizeof records / sizeof records[0], sf_read_record, sf_free_samples};
