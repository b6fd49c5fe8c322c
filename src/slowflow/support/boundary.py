"""Where a computation begins: whatever a question refuses, it has refused before.

A question that takes long calls `begin` after its checks. `refusal` asks a question up to there: what it refuses is
found in its own words, without the computation.
"""

from __future__ import annotations

from collections.abc import Callable
from contextvars import ContextVar
from typing import Any

from slowflow.support.errors import Refused, SlowflowError

_checks_only: ContextVar[bool] = ContextVar("checks_only", default=False)


class _Begins(Exception):
    """Raised in place of a computation."""


def begin() -> None:
    """Mark the beginning of a computation."""
    if _checks_only.get():
        raise _Begins


def refusal(ask: Callable[[], Any]) -> str:
    """Why a question is refused, "" if it is not; a computation without a result is no refusal."""
    token = _checks_only.set(True)
    try:
        ask()
    except Refused as error:
        return str(error)
    except (_Begins, SlowflowError):
        pass
    finally:
        _checks_only.reset(token)
    return ""
