#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Clang's view of every source that GCC has compiled: syntax, types and warnings, nothing is written.

usage: clang_syntax.py BUILD_FOLDER    (of a build that is done: generated sources must be there)
"""
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys

# Of what only GCC knows; and unity builds define the same macros and templates again and again.
NOT_FOR_CLANG = ("-fno-gnu-unique", "-Wlogical-op", "-Wduplicated-cond", "-Wduplicated-branches", "-Wuseless-cast")
WITH_A_VALUE = ("-o", "-MF", "-MT", "-MQ")


def command_for_clang(entry):
    words = shlex.split(entry["command"])
    while words and not words[0].endswith(("c++", "g++", "clang++")):
        words.pop(0)  # ccache
    kept = ["clang++", "-fsyntax-only"]
    words = iter(words[1:])
    for word in words:
        if word in WITH_A_VALUE:
            next(words)
        elif word not in ("-c", "-MD", "-MMD", *NOT_FOR_CLANG):
            kept.append(word)
    # For clang -Wconversion implies -Wsign-conversion, for GCC it does not.
    return kept + ["-Wno-sign-conversion", "-Wno-unknown-warning-option", "-Wno-ignored-optimization-argument"]


def check(entry):
    done = subprocess.run(command_for_clang(entry), cwd=entry["directory"], capture_output=True, text=True, check=False)
    return entry["file"], done.returncode, done.stderr


def main():
    entries = json.loads((pathlib.Path(sys.argv[1]) / "compile_commands.json").read_text(encoding="utf-8"))
    entries = [entry for entry in entries if pathlib.Path(entry["file"]).exists()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [pool.submit(check, entry) for entry in entries]
        for job in concurrent.futures.as_completed(jobs):
            file, code, said = job.result()
            if code != 0:
                pool.shutdown(cancel_futures=True)
                sys.exit(f"{said}\nclang++ does not take {file}")
    print(f"{len(entries)} sources, clang++ takes them all")


if __name__ == "__main__":
    main()
