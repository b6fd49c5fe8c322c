"""Forces that are Python functions. Takes functions of u; returns a mechanism's record, with averages by quadrature.

Such a function has no derivatives, and nothing encloses it. On each of its pieces it is replaced by the polynomial
through its values (`polynomial`); all else is of this (`force`), and stands in a record as of any mechanism (`record`).
"""

from slowflow.sampled.force import Stated, check_signature, record
from slowflow.sampled.polynomial import rows

__all__ = ["Stated", "check_signature", "record", "rows"]
