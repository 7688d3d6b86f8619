#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every sentence that the sources of the readers can say is known to the window, which then has its German text.

The window takes an English message apart as app/text/error_text.cpp does: whole, or clause by clause; this does the same with what the
expressions of the sources can make, a number standing in for all that varies.

usage: check_reader_sentences.py SOURCE_DIR
"""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
VARIES = "7"
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?P<raw>.*?)\)"|"(?P<text>(?:\\.|[^"\\])*)"|\'(?P<char>(?:\\.|[^\'\\])+)\'|^\s*#[^\n]*|'
                   r'(?P<mark>\w+(?:\'\d+)*|::|\+=|->|<<|==|\S)|\s+', re.S | re.M)
ENDS = {",", ";", "return", "=", "+=", "<<", "case", "=="}
# Words of other programs that are looked for, and what only a developer who starts the worker by hand meets.
NOT_SAID = {"library_words.cpp": r"constexpr Sign kSigns\[\] = \{.*?\n\};", "main.cpp": r"std::f?(?:puts|printf)\(.*?;",
            "foreign_kinds.cpp": r".*"}  # check_translations.py has its kinds
NAMES = re.compile(r"(Gmsh|PLY|VTK|Open Inventor) ?[\d.]* ?\([\w ,-]+\)|# vtk DataFile|facet normal|when reading |\" as a real number")
# Parts of notes whose whole sentences app/import/note_text.cpp lists.
PARTS = {"7 were passed over.", "7 bytes behind the last 7 were passed over.",
         "The section promises 7 7, but 7 are there; all of these were read.", "7 of the element '7' were read as 7.", "fans of triangles", "strips of triangles", "The file states 7",
         "7, which is used (--ignore-stated uses the choices).", "7 and the chosen axes", "the chosen axes", "7 The file may be cut short.",
         "7 (and 7 more)", "7, by a fault of its own or because the file is damaged; ", "7, which is no word of PLY; remarks begin with the word comment"}


def tokens(code):
    for match in TOKEN.finditer(code):
        if match["raw"] is not None:
            yield "text", match["raw"]
        elif match["text"] is not None:
            yield "text", match["text"].replace('\\"', '"').replace("\\n", "\n").replace("\\\\", "\\")
        elif match["char"] is not None:
            yield "text", match["char"]
        elif match["mark"] is not None:
            yield "mark", match["mark"]


def nested(stream):
    """The tokens, with all between brackets as one item."""
    top = []
    open_lists = [top]
    for kind, token in stream:
        if kind == "mark" and token in "([{":
            inner = [token]
            open_lists[-1].append(("group", inner))
            open_lists.append(inner)
        elif kind == "mark" and token in ")]}" and len(open_lists) > 1:
            open_lists.pop()
        else:
            open_lists[-1].append((kind, token))
    return top


def split(items, marks):
    parts = [[]]
    for item in items:
        if item[0] == "mark" and item[1] in marks:
            parts.append([])
        else:
            parts[-1].append(item)
    return parts


def forms(items):
    """All that an expression may say: both sides of "?" and ":", each with the terms of "+" one behind the other."""
    depth, question = 0, None
    for place, (kind, token) in enumerate(items):
        if kind == "mark" and token == "?":
            question = place if question is None else question
            depth += 1
        elif kind == "mark" and token == ":" and depth:
            depth -= 1
            if depth == 0:
                return forms(items[question + 1:place]) | forms(items[place + 1:])
    made = {""}
    for part in split(items, {"+"}):
        made = {start + end for start in made for end in term(part)}
    return made


def term(items):
    if len(items) == 1 and items[0][0] == "mark" and items[0][1] in constants:
        return {constants[items[0][1]]}
    if items and all(kind == "text" for kind, _ in items):
        return {"".join(token for _, token in items)}
    is_string = items and items[-1][0] == "group" and items[-1][1][0] == "(" and [token for _, token in items[:-1]] in ([], ["std", "::", "string"])
    if is_string and any(kind == "text" for kind, _ in items[-1][1][1:]):
        return forms(items[-1][1][1:])
    return {VARIES}


def expressions(items):
    for part in split(items, ENDS):
        yield from forms(part)
        for place, (kind, token) in enumerate(part):
            if kind != "group":
                continue
            yield from expressions(token[1:])
            if place and part[place - 1][1] in ("tooMany", "tooSmall"):  # their last word is counted
                yield from (f"{VARIES} {one}" for one in forms(split(token[1:], {","})[-1]))


def is_prose(text):
    return re.search(r"[A-Za-z]{2,}", text) is not None and not NAMES.fullmatch(text)


def said(code):
    return {text for text in expressions(nested(tokens(code))) if is_prose(text) and
            re.search(r"[a-z]{2,}[,;:']* .*[a-z]{2}|[a-z]{3,}.* [a-z]{2,}|7 [a-z]+$", text)}


def pattern_of(sentence):
    is_name = "%1" in sentence and sentence.count(" ") == 1
    return re.compile(re.sub(r"%\d", r"(\\d+)" if is_name else "(.+?)", re.escape(sentence)), re.S)


sentences = [pattern_of("".join(re.findall(r'"((?:\\.|[^"\\])*)"', text)).replace('\\"', '"'))
             for text in re.findall(r'QT_TRANSLATE_NOOP\(\s*"esm::ErrorDetail",(.*?)\),\n', (source / "app/text/error_sentences.cpp").read_text(), re.S)]
notes = [re.compile(text) for text in re.findall(r'\{R?"\(?(.*?)\)?",\s*QT_TRANSLATE', (source / "app/import/note_text.cpp").read_text())]


def is_known(text):
    text = re.sub(r"(?<=[a-z)])7+$", "", text)  # what is appended is a clause of its own
    if not is_prose(text):
        return True
    for sentence in sentences:
        if match := sentence.fullmatch(text):
            return all(is_known(part) or text[match.start(place) - 1] == "'" for place, part in enumerate(match.groups(), 1))
    for border in ("[:;] ", ", "):
        if parts := re.split(border, text, maxsplit=1)[1:]:
            return is_known(text[:-len(parts[0])].rstrip(":;, ")) and is_known(parts[0])
    return False


problems, count = [], 0
for file in sorted((source / "meshimport").rglob("*")):
    if file.suffix not in (".cpp", ".h"):
        continue
    code = file.read_text()
    if file.name in NOT_SAID:
        code = re.sub(NOT_SAID[file.name], "", code, flags=re.S)
    constants = {name: "".join(re.findall(r'"((?:\\.|[^"\\])*)"', text))
                 for name, text in re.findall(r'(\w+) =((?:\s*"(?:\\.|[^"\\])*")+);', code)}
    for text in sorted(said(code)):
        count += 1
        text = VARIES + text if text[0] in " ,;" else text
        if text not in PARTS and not is_known(text) and not is_known(f"{VARIES} {text}") and not any(note.fullmatch(text) for note in notes):
            problems.append(f"{file.relative_to(source)}: {text!r} has no sentence in app/text/error_sentences.cpp or app/import/note_text.cpp")
print(f"{count} sentences of readers, {len(sentences)} sentences and {len(notes)} notes of the window")
if problems:
    sys.exit("\n".join(problems))
