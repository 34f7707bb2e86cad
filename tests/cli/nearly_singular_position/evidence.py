"""What the report says of the rates and of the evidence for them, in powers of ten."""

import json
import math
import sys

motion = json.load(open(sys.argv[1]))["cases"]["rocker drives"]["kinematics"]
evidence = motion["evidence"]
if motion["status"] == "solved":
    # b turns by -2/offset, which is exact for the linkage as drawn.
    print("  solved, crank to rocker 1e%.0f" % math.log10(abs(motion["freedoms"]["b.wz"])),
          "residual", "small" if evidence["residual"] < 1e-12 else evidence["residual"])
else:
    print(" ", motion["status"], "gap of 1e%.0f" % evidence["gap"], set(motion["freedoms"].values()))
