"""What tests of sweeps share: a text with a sweep, and its rows or what is said of it."""

from __future__ import annotations

import json

import program


def swept(text: str, sweep: str, *options: str) -> tuple[list[dict], str]:
    """The rows, and what the program said."""
    done = program.call("sweep", *options, "-", text=f"{text}\nsweep: {sweep}\n")
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()], done.stderr


def refused(text: str, sweep: str) -> str:
    done = program.call("sweep", "-", text=f"{text}\nsweep: {sweep}\n")
    if done.returncode == 0:
        raise AssertionError(done.stdout)
    return done.stderr
