#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text of the window has a German translation, with the same placeholders, and none is left over.

usage: check_translations.py LUPDATE SOURCE_DIR
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree

lupdate, source = sys.argv[1], pathlib.Path(sys.argv[2])
problems = []
for name, extra in (("esm_de.ts", []), ("esm_en.ts", ["-pluralonly"])):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / name
        copy.write_bytes((source / "translations" / name).read_bytes())
        subprocess.run([lupdate, "-locations", "none", "-I", ".", *extra, "app", "fuzzyeditor", "-ts", str(copy)],
                       cwd=source, check=True, stdout=subprocess.DEVNULL)
        messages = 0
        for context in tree.parse(copy).getroot().findall("context"):
            for message in context.findall("message"):
                messages += 1
                text = message.findtext("source")
                translation = message.find("translation")
                where = f"{name}: {context.findtext('name')}: {text!r}"
                if translation.get("type") in ("vanished", "obsolete"):
                    problems.append(f"{where} is not in the sources any more")
                    continue
                forms = [form.text or "" for form in translation.findall("numerusform")] or [translation.text or ""]
                if translation.get("type") == "unfinished" or not all(forms):
                    problems.append(f"{where} has no translation")
                for form in forms:
                    if set(re.findall(r"%\d|%n", text)) != set(re.findall(r"%\d|%n", form)):
                        problems.append(f"{where} has other placeholders than {form!r}")
        print(f"{name}: {messages} texts")
if problems:
    sys.exit("\n".join(problems))
