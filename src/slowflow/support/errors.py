"""The exceptions of slowflow: one base class; each is also the corresponding built-in exception.

Any other exception from the package is a bug.
"""


class SlowflowError(Exception):
    """Base class of all deliberate exceptions; the message states what is wrong, where, and what is allowed."""


class Refused(SlowflowError, ValueError):
    """An argument outside its domain, or a question that is not available here."""


class WrongType(SlowflowError, TypeError):
    """An argument of a type that is not accepted, or one that is missing, unknown or given twice."""


class NotSettled(SlowflowError, ArithmeticError):
    """The computation did not reach a reliable result."""


class OutOfRange(NotSettled, OverflowError):
    """Numbers exceed the range of double precision, or an amplitude is unbounded."""


class BuildFailed(SlowflowError, RuntimeError):
    """Requested compilation failed; the message contains the compiler's output."""


class SceneError(Refused):
    """An invalid input file: file, line, key and value, and what is allowed."""
