"""Reads YAML into the values that kinestat sees: null, true, false, numbers and text.

YAML 1.1, which Python's reader speaks, knows more: yes and no, 017 and 1:30, dates. To kinestat and
to editors none of these is anything but text or a plain number. Keys are always text.
"""

from __future__ import annotations

import re
from typing import Any

import yaml

WHOLE = re.compile(r"[-+]?[0-9]+")
DECIMAL = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
NULLS = {"", "~", "null", "Null", "NULL"}


def scalar(text: str) -> Any:
    """The value of a scalar without quotes."""
    if text in NULLS:
        return None
    if text in ("true", "false"):
        return text == "true"
    if WHOLE.fullmatch(text):
        return int(text)
    return float(text) if DECIMAL.fullmatch(text) else text


def value(node: yaml.Node) -> Any:
    if isinstance(node, yaml.MappingNode):
        return {key.value: value(item) for key, item in node.value}
    if isinstance(node, yaml.SequenceNode):
        return [value(item) for item in node.value]
    return scalar(node.value) if node.style is None else node.value


def read(text: str) -> Any:
    return value(yaml.compose(text, Loader=yaml.BaseLoader))
