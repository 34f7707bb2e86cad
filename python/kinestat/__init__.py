"""Analysis of mechanisms by Davies' method: gear trains, linkages, cables.

Load a mechanism file, set its parameters, and analyse it as a whole, or record one of its cases as a
tape and evaluate it for many values of some parameters:

    >>> import kinestat
    >>> train = kinestat.load("ravigneaux.yaml")
    >>> train.analyze()["/cases/M1/ratio"]
    2.8468899521531092
    >>> tape = train.record("w_in", ["ratio", "out"], case="M1")
    >>> tape.play([[1.0], [2.0]])

Numbers are in the units that the mechanism file sets (its section `units`; SI without it, with
angles in radians). The world frame is right-handed. The motion of a coupling is that of its head
relative to its tail, its action that of the tail on the head. For everything else see `kinestat
help` and the README of the program.
"""

from __future__ import annotations

from ._library import library
from ._messages import (
    Bug,
    CheckFailed,
    EnvironmentFailure,
    Error,
    MechanismWarning,
    Message,
    NoAnswer,
    Status,
    UnknownPlace,
    UsageError,
    WrongInput,
)
from ._mechanism import Mechanism, Parameters, load, parse
from ._report import Report
from ._tape import Tape

__version__: str = library.kinestat_version().decode()

__all__ = [
    "Bug",
    "CheckFailed",
    "EnvironmentFailure",
    "Error",
    "Mechanism",
    "MechanismWarning",
    "Message",
    "NoAnswer",
    "Parameters",
    "Report",
    "Status",
    "Tape",
    "UnknownPlace",
    "UsageError",
    "WrongInput",
    "load",
    "parse",
]
