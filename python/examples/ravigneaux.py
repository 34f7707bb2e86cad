"""A Ravigneaux transmission: its ratios, other teeth, and the best of ten thousand.

Run it as it is, or cell by cell in an editor that knows `# %%`. It needs NumPy.
"""

# %% Load the mechanism and read its ratios
import itertools
import sys
import warnings
from pathlib import Path

import numpy as np

import kinestat

if len(sys.argv) == 2 and sys.argv[1].endswith(".yaml"):
    FILE = Path(sys.argv[1])
else:
    FILE = Path(__file__).resolve().parents[2] / "mechanisms/transmissions/ravigneaux.yaml"

train = kinestat.load(FILE)
report = train.analyze()
print("ratios:", {case: round(report["cases", case, "ratio"], 3) for case in train.cases})

# %% Set teeth
# The planets have to fit between the suns and the ring: two numbers follow from the others, and do so
# from now on. The file lists published values of 19, 41 and 15 teeth, which are the same so far.
train.set("N3", "N2 + 2*N6jk")
train.set("N6i", "N2 + N6jk - N1 - 2*N5")
print("ring:", train.parameters["N3"], "teeth, torque of brake B2 in M1:",
      round(train.analyze(check=True)["/cases/M1/statics/actions/B2"], 1), "N*m")

# %% Record case M1 and play it for ten thousand combinations
N1, N2, N5 = np.array(
    list(itertools.product(range(16, 36), range(30, 55), range(12, 32))), dtype=float
).T
tape = train.record(["N1", "N2", "N5"], ["ratio", "out"], case="M1")
ratio, torque = tape.play({"N1": N1, "N2": N2, "N5": N5}).T
print(len(ratio), "states,", np.count_nonzero(tape.statuses == "solved"), "solved")

# %% The best of those that can be built: three sets of planets, no gear too small or too large
N6jk = train.parameters["N6jk"]
N3 = N2 + 2 * N6jk
N6i = N2 + N6jk - N1 - 2 * N5
can_be_built = (
    (tape.statuses == "solved")
    & (N6i >= 12) & (N6i <= N6jk)
    & ((N2 + N3) % 3 == 0) & ((N3 - N1) % 3 == 0)
)
best = np.flatnonzero(can_be_built)[np.argmax(ratio[can_be_built])]
print(np.count_nonzero(can_be_built), "can be built; largest ratio", round(ratio[best], 4),
      f"with N1 = {N1[best]:g}, N2 = {N2[best]:g}, N5 = {N5[best]:g},",
      f"torque of the ring {torque[best]:.1f} {tape.output_units[1]}")

# %% Its gears
# Other teeth miss the published values of the file, as they should; a warning each would say so.
warnings.simplefilter("ignore", kinestat.MechanismWarning)
train.parameters.update(N1=int(N1[best]), N2=int(N2[best]), N5=int(N5[best]))
report = train.analyze()
print("ratios:", {case: round(report["cases", case, "ratio"], 3) for case in train.cases})
