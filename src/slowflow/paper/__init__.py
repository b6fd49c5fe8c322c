"""All that knows the paper: in go its numbers, formulas and figures, out come the report and the drawings."""
