"""Usage: limited.py SECONDS BYTES COMMAND...

Runs a command, with its whole group of processes, until it ends or has taken too long; 0 is no limit. The last line of
standard output is JSON: how it ended, and what it has used. This is a program of its own, and a small one, because the
physical memory of what a process starts is counted from that of the process on.
"""

import json
import os
import resource
import signal
import subprocess
import sys
import threading
import time

seconds, limit_of_bytes, command = float(sys.argv[1]), int(float(sys.argv[2])), sys.argv[3:]


def set_limits():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if limit_of_bytes > 0:
        resource.setrlimit(resource.RLIMIT_AS, (limit_of_bytes, limit_of_bytes))


def end_group():
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
start = time.monotonic()
process = subprocess.Popen(command, stdin=subprocess.DEVNULL, start_new_session=True, preexec_fn=set_limits)
timer = threading.Timer(seconds, end_group)
if seconds > 0:
    timer.start()
try:
    _, status, usage = os.wait4(process.pid, 0)
    passed = time.monotonic() - start
finally:
    timer.cancel()
    end_group()  # what is left of it, also if this program is interrupted
outcome = {
    "status": os.waitstatus_to_exitcode(status),  # negative: the signal that has ended it
    "is_timed_out": 0 < seconds <= passed,
    "process_seconds": passed,
    "cpu_seconds": usage.ru_utime + usage.ru_stime,
    "peak_bytes": usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024),  # of the largest of its processes
}
print("\n" + json.dumps(outcome))
