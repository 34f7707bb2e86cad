"""Where two links of 50 mm and 100 sqrt(2) mm are stretched: at 90 deg less the angle at which the end
of the crank of 150 mm is as far from the pin at 100 mm."""

import csv
import io
import math
import os
import re
import subprocess
from pathlib import Path

reach = 50.0 + 100.0 * math.sqrt(2.0)
limit = math.degrees(math.acos((150.0**2 + 100.0**2 - reach**2) / (2.0 * 150.0 * 100.0))) - 90.0
text = Path("file.yaml").read_text(encoding="utf-8")
for way in Path("ways.txt").read_text(encoding="utf-8").splitlines():
    Path("way.yaml").write_text(f"{text}motion: {way[:-1]}, case: run, report: [out, motor]}}\n", encoding="utf-8")
    command = [os.environ["KINESTAT"], "motion", "way.yaml"]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    told = float(re.search(r"limit of \S+ at (?:.*, )?motor = (\S+) deg", done.stdout)[1])
    done = subprocess.run([*command, "--format", "csv", "--layout", "wide"], capture_output=True, encoding="utf-8",
                          check=False)
    *_, last = csv.DictReader(io.StringIO(done.stdout))
    place = float(last["a.wz/position [deg]"])
    drive = float(last.get("motor/drive [deg]", place))
    worst = max(abs(one - limit) for one in (place, drive))
    print(last["status"], f"{told:g}", "exactly" if worst < 1e-7 else f"{worst:g} off")
