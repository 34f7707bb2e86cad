"""Takes from an analysis that waits for its input the right to open files; its status and words."""

import os
import resource
import subprocess
import sys
import time
from pathlib import Path

process = subprocess.Popen(
    [os.environ["KINESTAT"], "analyze", "--quiet", "--out", "reports", "-"], stdin=subprocess.PIPE
)
call = Path(f"/proc/{process.pid}/syscall")
while call.read_text().split()[:2] not in (["0", "0x0"], ["63", "0x0"]):  # read(0, …), by machine
    time.sleep(0.01)
resource.prlimit(process.pid, resource.RLIMIT_NOFILE, (3, 3))
process.communicate(Path("file.yaml").read_bytes())
sys.exit(process.returncode)
