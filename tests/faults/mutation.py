"""One mutated file through every command, and what must hold for all answers."""

from __future__ import annotations

import json
from dataclasses import dataclass, field

import oracles
import sweeps
from program import Command, Program, Run
from promises import Promises

# Only measurements of time; its answers are those of analyze.
LEFT_OUT = {"bench"}
FAST, HIGH = "fast", "high"


@dataclass
class Verdict:
    """What is wrong, and how often each oracle had something to judge."""

    wrong: list[str] = field(default_factory=list)
    judged: dict[str, int] = field(default_factory=dict)

    def add(self, oracle: str, said: list[str]) -> None:
        self.judged[oracle] = self.judged.get(oracle, 0) + 1
        self.wrong += [f"{oracle}: {text}" for text in said]


class Judge:
    """Holds a program to its promises, one file at a time."""

    def __init__(self, program: Program, promises: Promises | None = None) -> None:
        self.program = program
        self.commands = [one for one in program.commands() if one.name not in LEFT_OUT]
        self.promises = promises or Promises.of(program)

    def judge(self, text: str) -> Verdict:
        verdict = Verdict()
        for command in self.commands:
            run = self._run(verdict, text, command.arguments())
            if run.err and run.status == 3 and command.name == "check":
                verdict.add("a mistake has a place", [] if run.codes() else ["no code"])
        self._compare(verdict, text)
        return verdict

    def _run(self, verdict: Verdict, text: str, arguments: list) -> Run:
        run = self.program.run([*arguments, "file.yaml"], files={"file.yaml": text.encode()},
                               hang=self.promises.seconds * 12)
        verdict.add("promises", [f"{run.what}: {one}" for one in self.promises.broken_by(run)])
        return run

    def _report(self, verdict: Verdict, text: str, *arguments: str) -> dict | None:
        run = self._run(verdict, text, [*arguments, "--format", "json"])
        if not run.out:
            return None
        try:
            return oracles.strict(run.out)
        except ValueError as error:
            verdict.add("strict JSON", [f"{run.what}: {error}"])
            return None

    def _compare(self, verdict: Verdict, text: str) -> None:
        report = self._report(verdict, text, "analyze")
        if report is None:
            return
        again = self._report(verdict, text, "analyze")
        verdict.add("the same again", [] if json.dumps(again) == json.dumps(report) else ["no"])
        table = self._run(verdict, text, ["analyze", "--format", "csv"])
        verdict.add("CSV as JSON", list(oracles.csv_as_json(report, table.out)))
        plain = self._run(verdict, text, ["analyze"])
        verdict.add("text as JSON", list(oracles.text_as_json(report, plain.out)))
        for accuracy in (FAST, HIGH, "exact"):
            other = self._report(verdict, text, "analyze", "--accuracy", accuracy)
            if other is not None:
                said = oracles.accuracies(report, other, accuracy == FAST)
                verdict.add(f"auto as {accuracy}", list(said))
        motion = self._report(verdict, text, "motion")
        if motion is not None:
            verdict.add("motion as analyze", list(oracles.first_row(report, motion)))
        self._sweep(verdict, text)

    def _sweep(self, verdict: Verdict, text: str) -> None:
        varied = sweeps.with_sweep(text)
        rows, analyses = self.swept(verdict, varied) if varied else ([], [])
        if rows:
            verdict.add("sweep as analyze", list(sweeps.compare(rows, analyses)))

    def swept(self, verdict: Verdict, text: str) -> tuple[list[dict], list[sweeps.Analysed]]:
        """The rows of a sweep, and what analyze says of each of its states."""
        run = self._run(verdict, text, ["sweep", "--quiet", "--format", "json"])
        rows = [oracles.strict(line) for line in run.out.splitlines()]
        analyses = []
        for state in sweeps.STATES if rows else ():
            done = self._run(verdict, text, ["analyze", "--format", "json", "--diagnostics",
                                             "json", "--set", f"{sweeps.PARAMETER}={state}"])
            said = [json.loads(line) for line in done.said.splitlines()]
            analyses.append((oracles.strict(done.out) if done.out else None,
                             [one for file in said for one in file["diagnostics"]]))
        return rows, analyses
