"""Whether a folder that code is imported from is the user's own: its owner and mode, and those of all that leads to it.

In:  a path.
Out: nothing; `Refused` with what to do where another user could have put code there. POSIX only: elsewhere, as on
     Windows, nothing is looked at.
"""

from __future__ import annotations

import contextlib
import os
import stat
from pathlib import Path

from .errors import Refused

#: what is said of a folder that is refused
ADVICE = "Code in it would run as yours, so nothing is imported from it: name a folder of your own in SLOWFLOW_DERIVED"


def check_own(folder: Path) -> None:
    """That the folder, if it is there, what is in it, and every folder above belong to nobody else.

    Raises Refused for the first that another user owns, the superuser excepted, or that others may write to. Above it
    a sticky folder, as /tmp, is allowed: nobody removes there what is another's.
    """
    if os.name != "posix":
        return
    # the path as it is written, and where its links lead
    for place in dict.fromkeys((folder.absolute(), folder.resolve())):
        for above in place.parents:
            if above.exists():
                _check(above, above.stat(), f"or say: chmod go-w '{above}'", sticky=True)
        if not place.exists():
            continue
        found = place.stat()
        _check(place, found, f"or say: chmod 700 '{place}'")
        closed = not found.st_mode & (stat.S_IXGRP | stat.S_IXOTH)
        for path in (*place.glob("*"), *place.glob("__pycache__/*")):
            with contextlib.suppress(
                FileNotFoundError
            ):  # another process has compiled, and removes what it was made of
                _check(path, path.lstat(), f"or remove '{place}', what is in it is derived again", closed=closed)


def _check(path: Path, found: os.stat_result, remedy: str, *, sticky: bool = False, closed: bool = False) -> None:
    """`closed`: others do not reach it, whatever its mode is."""
    if found.st_uid not in (os.getuid(), 0):
        raise Refused(f"{path} belongs to another user, number {found.st_uid}. {ADVICE}")
    others = found.st_mode & stat.S_IWOTH or (found.st_mode & stat.S_IWGRP and not _is_private(found.st_gid))
    link, kept = stat.S_ISLNK(found.st_mode), sticky and found.st_mode & stat.S_ISVTX
    if others and not (link or kept or closed):
        raise Refused(f"others may write to {path}, mode {stat.S_IMODE(found.st_mode):o}. {ADVICE}, {remedy}")


def _is_private(group: int) -> bool:
    """Whether a group is the user's alone: it has the user's name and no other members."""
    import grp  # here, not above: there is none elsewhere than on POSIX
    import pwd

    try:
        own, user = grp.getgrgid(group), pwd.getpwuid(os.getuid())
    except KeyError:
        return False
    return own.gr_name == user.pw_name and set(own.gr_mem) <= {user.pw_name}
