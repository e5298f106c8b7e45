"""A file takes its place whole or not at all, and never that of another unasked."""

import os
import secrets
import stat
from collections.abc import Callable
from pathlib import Path

from workbook.errors import WriteError
from workbook.text_files import irregular_kind


def refuse_existing(path: Path | None, overwrite: bool) -> None:
    """Raise WriteError where something stands at ``path`` that may not be replaced: only a file, and only if asked."""
    if path is None:
        return
    try:
        path.lstat()
        if not overwrite:
            raise WriteError(f"{path}: the file exists; it is left as it is (--force replaces it, -o names another)")
        kind = irregular_kind(path)
    except FileNotFoundError:
        above = next((folder for folder in path.parents if os.path.lexists(folder)), None)
        if above is not None and not os.path.isdir(above):
            raise WriteError(f"{path}: cannot be written: {above} is no folder") from None
        return  # or a link to a file that is not there yet, when asked to write
    except (OSError, ValueError) as error:
        raise write_error(path, error) from error
    if kind:
        raise WriteError(f"{path}: {kind}; expected the name of a file")


def refuse_same_file(*paths: Path | None) -> None:
    """Raise WriteError where two files would be written to the same place: the second would take the first's."""
    seen: set[str] = set()
    for path in filter(None, paths):
        place = os.path.realpath(path)
        if place in seen:
            raise WriteError(f"{path}: two files would be written there; expected a name for each")
        seen.add(place)


def is_same_file(path: Path, other: Path) -> bool:
    """Whether two paths lead to the same place."""
    return os.path.realpath(path) == os.path.realpath(other)


def refuse_itself(path: Path | None, source: Path) -> None:
    """Raise WriteError where what is built of a file would take its place, asked to replace it or not."""
    if path is not None and is_same_file(path, source):
        raise WriteError(f"{path}: this is what is read; expected another name for what is made of it")


def refuse_suffix(path: Path) -> None:
    """Raise WriteError where a workbook would be written under the name of another kind of file."""
    if path.suffix.lower() != ".xlsx":
        raise WriteError(f"{path}: what is built is a workbook; expected a name ending in .xlsx")


def replace(path: Path, write: Callable[[Path], object], overwrite: bool = False) -> None:
    """Let ``write`` fill a new file beside ``path``, then move it there; a failure leaves the old file whole.

    Raises WriteError where ``path`` exists and ``overwrite`` is not given, also where it came to exist meanwhile.
    A link stays, and the file that it leads to is written.
    """
    refuse_existing(path, overwrite)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        target = Path(os.path.realpath(path)) if path.is_symlink() else path
        draft = target.parent / f".motionbook-{secrets.token_hex(8)}.part"  # a name of no book
        # with the permissions of any new file
        os.close(os.open(draft, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
    except OSError as error:
        raise write_error(path, error) from error
    try:
        write(draft)
        if overwrite:
            if target.exists():  # whose permissions the new file gets
                draft.chmod(stat.S_IMODE(target.stat().st_mode))
            draft.replace(target)
        else:
            claim_name(draft, target)
    except FileExistsError:
        refuse_existing(path, overwrite)
        raise
    except PermissionError as error:
        raise WriteError(f"{path}: cannot be written; close it in the other program and try again") from error
    except OSError as error:
        raise write_error(path, error) from error
    finally:
        draft.unlink(missing_ok=True)


def write_text(path: Path, text: str, overwrite: bool = False) -> None:
    """Write UTF-8 with the same line ends on every system, as :func:`replace` does."""
    replace(path, lambda draft: draft.write_bytes(text.encode()), overwrite)


def claim_name(draft: Path, target: Path) -> None:
    """Give a draft its name unless that is taken, in a single step; raise FileExistsError where it is."""
    try:
        os.link(draft, target)
    except FileExistsError:
        raise
    except OSError:  # a file system without links: the name is taken first, and then filled
        os.close(os.open(target, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
        draft.replace(target)


def write_error(path: Path, error: Exception) -> WriteError:
    """Return the error for a file that the system does not take."""
    return WriteError(f"{path}: cannot be written: {getattr(error, 'strerror', None) or error}")
