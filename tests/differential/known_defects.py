"""Known disagreements that are still open, each as reported by a test.

A known defect must occur: if nothing in a whole run matches it, its test fails until the line is removed.
"""

from __future__ import annotations

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Defect:
    test: str      # the method that shows it
    pattern: str   # of its complaint, 'planar-12: motion: …'
    reason: str


KNOWN: list[Defect] = []


def sort_out(test: str, complaints: list[str], is_whole_run: bool) -> list[str]:
    """Complaints that nobody knows of, and known ones that are no longer heard."""
    of_test = [one for one in KNOWN if one.test == test]
    known = {one: [c for c in complaints if re.search(one.pattern, c)] for one in of_test}
    excused = {c for heard in known.values() for c in heard}
    said = [c for c in complaints if c not in excused]
    if is_whole_run:
        said += [f"'{one.pattern}' is mended; take it from the known defects ({one.reason})"
                 for one, heard in known.items() if not heard]
    return said
