"""Disagreements that are known and still open, each by what a test says of it.

A known defect must show: as soon as nothing of a whole run matches it, its test fails until the line
is gone.
"""

from __future__ import annotations

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Defect:
    test: str      # the method that shows it
    pattern: str   # of its complaint, 'planar-12: motion: …'
    reason: str


MILLION = "test_the_origin_a_million_sizes_away_does_not_matter"
INCHES = "test_compare_finds_no_difference_in_inches_and_radians"

KNOWN = [
    *(Defect(MILLION, f"^{name}: ", "powers, or what stands on contact points, friction or losses, "
             "lose their digits far from the origin") for name in
      ("cables_block_and_tackle_with_losses", "cables_finger_rehabilitation",
       "cables_weston_hoist", "gears_self_locking_planetary", "planar_cam_and_follower",
       "planar_toggle_press", "spatial_four_legged_table")),
    Defect(MILLION, "^transmissions_bevel_differential: ",
           "a rank of irrational numbers is decided by doubles"),
    *(Defect(INCHES, f"^{name}: ", "affine coefficients that are rounding have values")
      for name in ("transmissions_ravigneaux", "transmissions_ravigneaux_teeth")),
]


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
