"""Damages reports, seeded, and prints the exit statuses that compare answers with."""

import os
import random
import subprocess
from pathlib import Path

chance = random.Random(20080901)
statuses = set()
for name in ("a.json", "a.csv"):
    whole = Path(name).read_bytes()
    for _ in range(150):
        damaged = bytearray(whole)
        for _ in range(chance.randint(1, 3)):
            damaged[chance.randrange(len(damaged))] = chance.choice(b'\x00\xff"{[,:]}0-.eE\\\r\n \xc3')
        if chance.random() < 0.3:
            del damaged[chance.randrange(len(damaged)):]
        Path("damaged").write_bytes(damaged)
        done = subprocess.run(
            [os.environ["KINESTAT"], "compare", name, "damaged"], capture_output=True, check=False
        )
        statuses.add(done.returncode)
        (done.stdout + done.stderr).decode("utf-8")
        if bool(done.stderr) != (done.returncode == 3):
            print("status", done.returncode, "with", done.stderr)
print(sorted(statuses - {0}))
