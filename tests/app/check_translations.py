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

# What a foreign file is: a sentence of its own, or a general one around a name ("a %1 mesh", not "a STEP file, which holds
# surfaces and no mesh" taken as one).
texts = {message.findtext("source") for context in tree.parse(source / "translations" / "esm_de.ts").getroot().findall("context")
         if context.findtext("name") == "esm::ErrorDetail" for message in context.findall("message")}
kinds = (source / "meshimport" / "foreign_kinds.cpp").read_text()
named = re.findall(r'\{"([^"]+)",\s*(?:k\w+Out|"([^"]+)")\}', kinds) + re.findall(r'k\w+\{"([^"]+)", ()k\w+Out\}', kinds)
for text in {text for pair in named for text in pair if text} | set(re.findall(r'k\w+Out =\s*"([^"]+)"', kinds)):
    names = [re.fullmatch(re.escape(one).replace("%1", "(.+)"), text) for one in texts if "%1" in one]
    if text not in texts and not any(match and re.fullmatch(r"[A-Z0-9]\S*( [A-Z0-9]\S*)*|gzip|tar|zstd|xz|bzip2|[37]\S+( [A-Z]\S*)*",
                                                             match[1]) for match in names if match):
        problems.append(f"foreign_kinds.cpp: {text!r} has no sentence in app/text/error_sentences.cpp")
print(f"foreign_kinds.cpp: {len(named)} kinds")
if problems:
    sys.exit("\n".join(problems))
