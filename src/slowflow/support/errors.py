"""The errors that slowflow raises on purpose: one base class, each also the built-in error that callers know.

Anything else that leaves the package is a defect.
"""


class SlowflowError(Exception):
    """Base class of every error that slowflow raises on purpose; its message says what, where, and what is allowed."""


class Refused(SlowflowError, ValueError):
    """An argument outside its domain, or a question that has no answer here."""


class WrongType(SlowflowError, TypeError):
    """An argument of a type that is not accepted, or one that is missing, unknown or given twice."""


class NotSettled(SlowflowError, ArithmeticError):
    """The computation did not reach an answer that can be trusted."""


class OutOfRange(NotSettled, OverflowError):
    """Numbers leave the range of doubles, or an amplitude has no bound."""


class BuildFailed(SlowflowError, RuntimeError):
    """Compiled code that was requested cannot be had: the message holds what the compiler printed."""


class SceneError(Refused):
    """A scene that cannot be run: which file, line, key and value, and what is allowed."""
