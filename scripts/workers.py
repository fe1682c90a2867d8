"""Commands run by a few workers at a time, with a bar (or plain lines) of progress on stderr."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

FATLINE = "build/fatline"
TIMED_OUT = 124
PLAIN_SECONDS = 15  # between two lines of progress where stderr is not a terminal


running = set()  # process groups


def kill_running():
    for group in list(running):
        try:
            os.killpg(group, signal.SIGKILL)
        except ProcessLookupError:
            pass


def run(command, timeout=None, stdout=subprocess.PIPE, env=None):
    """A CompletedProcess with text; after `timeout` seconds its whole process group is killed (TIMED_OUT)."""
    with subprocess.Popen(command, stdout=stdout, stderr=subprocess.PIPE, text=True, errors="replace",
                          start_new_session=True, env={**os.environ, **(env or {})}) as process:
        running.add(process.pid)
        try:
            out, err = process.communicate(timeout=timeout)
            return subprocess.CompletedProcess(command, process.returncode, out or "", err)
        except BaseException as reason:
            os.killpg(process.pid, signal.SIGKILL)
            out, err = process.communicate()
            if not isinstance(reason, subprocess.TimeoutExpired):
                raise
            err += f"killed after {timeout:g} s\n"
            return subprocess.CompletedProcess(command, TIMED_OUT, out or "", err)
        finally:
            running.discard(process.pid)


def algorithms(precision="double"):
    """The names in the registry of this precision, in its order."""
    listed = run([FATLINE, "--precision", precision, "list", "--json"])
    if listed.returncode != 0:
        sys.exit(f"{FATLINE} list: {listed.stderr.strip()}")
    return [json.loads(line)["algorithm"] for line in listed.stdout.splitlines()]


def duration(seconds):
    seconds = round(seconds)
    if seconds < 100:
        return f"{seconds} s"
    if seconds < 6000:
        return f"{seconds // 60} min {seconds % 60:02d} s"
    return f"{seconds // 3600} h {seconds % 3600 // 60:02d} min"


class Progress:
    """How much of `total` (in any unit of work) is done, and how long the rest will take at the rate so far."""

    def __init__(self, label, total, stream=sys.stderr):
        self.label, self.total, self.stream = label, total, stream
        self.done, self.begun, self.shown = 0.0, time.monotonic(), 0.0
        self.terminal = stream.isatty()
        self.lock = threading.Lock()

    def step(self, work, note=""):
        with self.lock:
            self.done += work
            now = time.monotonic()
            if self.terminal or now - self.shown >= PLAIN_SECONDS:
                self.shown = now
                self.show(now - self.begun, note)

    def show(self, elapsed, note):
        part = min(1.0, self.done / self.total) if self.total else 1.0
        left = duration(elapsed / part * (1 - part)) if part > 0 else "?"
        text = f"{self.label}: {100 * part:3.0f} %, {duration(elapsed)} so far, about {left} left  {note}"
        if self.terminal:
            bar = "#" * round(20 * part)
            self.stream.write(f"\r\033[K[{bar:20s}] {text}"[:110])
        else:
            self.stream.write(text.rstrip() + "\n")
        self.stream.flush()

    def say(self, text):
        """A line of its own above the bar."""
        with self.lock:
            self.stream.write(("\r\033[K" if self.terminal else "") + text + "\n")
            self.stream.flush()

    def end(self):
        if self.terminal:
            self.stream.write("\r\033[K")
            self.stream.flush()


def run_all(jobs, work, label, workers, do):
    """do(job) for each job, `workers` at a time; yields (job, result) as they end. work(job): its expected cost."""
    progress = Progress(label, sum(work(j) for j in jobs))
    with ThreadPoolExecutor(workers) as pool:
        pending = {pool.submit(do, j): j for j in jobs}
        try:
            for future in as_completed(pending):
                job = pending[future]
                result = future.result()
                progress.step(work(job), str(job))
                yield job, result
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            kill_running()
            raise
        finally:
            progress.end()
