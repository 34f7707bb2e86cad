import csv
import sys

with open(sys.argv[1], encoding="utf-8", newline="") as file:
    for row in csv.DictReader(file):
        alone, lossy = (float(row[f"motor/{quantity} [N*m]"]) for quantity in ("action", "lossy_action"))
        print(row["step"], "at a dead point" if alone == lossy == 0.0 else f"{lossy / alone:.9f}")
