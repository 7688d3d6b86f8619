#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Holds the engine's judgement in one place (core/dynamics/planner/policy.h).

Two things are checked: each constant there says its unit, its range and its origin, and its value lies in that range;
and no other file of the rooms that judge (planner, rest) has a number of its own that is not one of mathematics.
Prints one line per fault; exit 1 if there is any.
"""
import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
POLICY = Path("core/dynamics/planner/policy.h")
ROOMS = ("core/dynamics/planner", "core/dynamics/rest")
ORIGINS = ("rule", "fit", "bound")
FRAME = 1.0 / 60.0

# Numbers that are no judgement: counts, halves and doubles, signs, powers of ten that only convert.
MATHEMATICS = {0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 8.0, 1e6}
# Rounding, and limits that nobody reaches: where it stands, and why.
ALLOWED = {
    "core/dynamics/planner/free_bodies.cpp": "what rounding leaves of sums over nodes",
}
ROUNDING = re.compile(r"^(1e-9|1e-12|1e-10|1e-13|1e-15|1e-300|1e15|1e-3)$")

DECLARATION = re.compile(r"^\s+(?:double|int|std::\w+)\s+\w+ =(?: |$)")
VALUE = re.compile(r"\w+ =\s+([^,;]+)[,;]")
MARK = re.compile(r"\[([^\[\]]+)\]")
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d*(?:e[+-]?\d+)?|\d+e[+-]?\d+)(?![\w.])")


def evaluate(text):
    text = text.strip().replace("kFrame", repr(FRAME))
    if not re.fullmatch(r"[-+*/.()e\d ]+", text):
        return None
    return float(eval(text))  # digits and operators only, as checked above


def declarations(lines):
    """Line number, code and comment of each constant, whatever lines they take."""
    for number, line in enumerate(lines):
        if not DECLARATION.match(line):
            continue
        code, comment = "", ""
        for following in lines[number:]:
            own, _, remark = following.partition("///<")
            if ";" in code and own.strip():
                break
            code, comment = code + own, comment + remark
        yield number + 1, code, comment


def faults_of_policy():
    for number, code, comment in declarations((ROOT / POLICY).read_text(encoding="utf-8").splitlines()):
        marks = MARK.findall(comment)
        parts = [part.strip() for part in marks[-1].split(";")] if marks else []
        where = f"{POLICY}:{number}"
        if len(parts) != 3 or parts[2] not in ORIGINS or ".." not in parts[1]:
            yield f"{where}: say [unit; low..high; {'|'.join(ORIGINS)}] of the constant"
            continue
        low, high = (evaluate(end) for end in parts[1].split("..", 1))
        for text in VALUE.findall(code):
            value = evaluate(text)
            if value is None or low is None or high is None:
                yield f"{where}: {text.strip()} or its range {parts[1]} is no number"
            elif not low <= value <= high:
                yield f"{where}: {text.strip()} is outside of {parts[1]}"


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", lambda match: "\n" * match.group(0).count("\n"), text, flags=re.DOTALL)
    text = re.sub(r"//[^\n]*", "", text)
    return re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', text)


def faults_of(path):
    name = path.relative_to(ROOT).as_posix()
    if name == POLICY.as_posix() or name in ALLOWED:
        return
    for number, line in enumerate(without_comments(path.read_text(encoding="utf-8")).splitlines(), 1):
        for text in NUMBER.findall(line):
            if float(text) not in MATHEMATICS and not ROUNDING.match(text):
                yield f"{name}:{number}: {text} is a judgement: it belongs into {POLICY}"


def main():
    faults = list(faults_of_policy())
    files = [path for room in ROOMS for path in sorted((ROOT / room).glob("*.*")) if path.suffix in (".h", ".cpp")]
    for path in files:
        faults.extend(faults_of(path))
    print("\n".join(faults) if faults else f"{len(files)} files judge by {POLICY} alone")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
