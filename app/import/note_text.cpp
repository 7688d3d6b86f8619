// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/note_text.h"

#include "app/text/error_text.h"
#include "app/text/reason_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <optional>
#include <span>

namespace esm {

namespace {

constexpr const char* kStates = "The file states ";

constexpr KnownSentence kNotes[] = {
  {R"((\d+) vertices were joined with others at the same place\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Vertices joined with others at the same place: %1.")},
  {R"((\d+) vertices nearly meet others, within (\S+); --weld-tolerance \S+ joins them\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Vertices that nearly meet others: %1. A weld tolerance of %2 joins them.")},
  {R"((\d+) points that no face or line uses become no nodes\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Points that no face or line uses, and that become no nodes: %1.")},
  {R"((\d+) single points were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Single points that were passed over: %1.")},
  {R"((\d+) vertices that nothing uses have coordinates that are not finite numbers\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Unused vertices with coordinates that are not finite numbers: %1.")},
  {R"((\d+) faces with more than three corners were cut into triangles\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Faces with more than three corners, cut into triangles: %1.")},
  {R"((\d+) faces with fewer than three corners were read as lines\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Faces with fewer than three corners, read as lines: %1.")},
  {R"((\d+) cells of higher order were reduced to their corners\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Cells of higher order, reduced to their corners: %1.")},
  {R"((\d+) hexahedra, wedges and pyramids became their edges\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Hexahedra, wedges and pyramids that became their edges: %1.")},
  {R"((\d+) cells that are no tetrahedra were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Cells that are no tetrahedra and were passed over: %1.")},
  {R"(The file is named \.(\S+), but its content is (\S+); it was read as that\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The file is named .%1, but its content is %2; it was read as that.")},
  {R"(The header promises (\d+) facets, but (\d+) are there; all of these were read\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The header promises %1 facets, but %2 are there; all of these were read.")},
  {R"(The header promises (\d+) facets, but (\d+) are there; all of these were read\. The file may be cut short\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The header promises %1 facets, but %2 are there; all of these were "
                                        "read. The file may be cut short.")},
  {R"(The section promises (\d+) nodes, but (\d+) are there; all of these were read\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The section promises %1 nodes, but %2 are there; all of these were read.")},
  {R"(The section promises (\d+) elements, but (\d+) are there; all of these were read\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The section promises %1 elements, but %2 are there; all of these were read.")},
  {R"(The attribute (\w+) promises (-?\d+) cells, but (\d+) are there; all of these were read\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The attribute %1 promises %2 cells, but %3 are there; all of these were read.")},
  {R"((\d+) lines behind the (\d+ promised \w+) were passed over, the first is line (\d+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Lines behind the %2 that were passed over: %1, the first is line %3. Is the count "
                     "wrong?")},
  {R"((\d+) bytes behind the last (?:facet|node|element) were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Bytes behind the end that were passed over: %1.")},
  {R"(The word '(.+)' is written in two; it was read all the same\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The word “%1” is written in two; it was read all the same.")},
  {R"((\d+) lines between facets were passed over \(the first begins with '(.*)'\)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Lines between facets that were passed over: %1 (the first begins with “%2”).")},
  {R"((\d+) header lines without the word comment were passed over \(the first begins with '(.*)'\)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Header lines that were passed over: %1 (the first begins with “%2”).")},
  {R"(The file ends without '?(endsolid|EOF)'?; it may be cut short\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The file ends without “%1”; it may be cut short.")},
  {R"((\d+) of the element '(.*)' were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Passed over of the element “%2”: %1.")},
  {R"((\d+) of the element '(.*)' were read as strips of triangles\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Read as strips of triangles from the element “%2”: %1.")},
  {R"((\d+) of the element '(.*)' were read as fans of triangles\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Read as fans of triangles from the element “%2”: %1.")},
  {R"((\d+) of the element '(.*)' were read as lines\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Read as lines from the element “%2”: %1.")},
  {R"((\d+) of the element '(.*)' were read as tetrahedra\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Read as tetrahedra from the element “%2”: %1.")},
  {R"((\d+) of the element '(.*)' were read as faces\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Read as faces from the element “%2”: %1.")},
  {R"((\d+) statements for points, curves or free-form surfaces were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Statements for points, curves or free-form surfaces that were passed over: %1.")},
  {R"((\d+) lines with unknown keywords were passed over, the first is line (\d+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Lines with unknown keywords that were passed over: %1, the first is line %2.")},
  {R"((\d+) arcs of polylines became their chords\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Arcs of polylines that became their chords: %1.")},
  {R"((\d+) entities that are no lines or faces were passed over: (.+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Entities that are no lines or faces and were passed over: %1 (%2).")},
  {R"((\d+) entities in paper space were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Entities in paper space that were passed over: %1.")},
  {R"((\d+) invisible entities were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Invisible entities that were passed over: %1.")},
  {R"((\d+) entities on layers that are frozen or off \((.+)\) were passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Entities on layers that are frozen or off, passed over: %1 (%2).")},
  {R"((\d+) lines begin with a colour, which was passed over\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Lines that begin with a colour, which was passed over: %1.")},
  {R"((\d+) lines with twelve numbers were read as quads\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Lines with twelve numbers, read as quads: %1.")},
  {R"(Its part '(.+)' is missing here: (.+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Its part “%1” is missing here: %2.")},
  {R"(Its part '(.+)' is missing here \(and (\d+) more\): (.+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Its part “%1” is missing here (and %2 more): %3.")},
  {R"(The reading library went on after a fault, a part may be missing: (.+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The reading library went on after a fault, a part may be missing: %1.")},
  {R"((\d+) more of its parts are missing\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "More of its parts that are missing: %1.")},
  {R"(The kernel offers no seccomp, so the foreign reader of this format was not kept from the network\.)",
   QT_TRANSLATE_NOOP(
     "esm::ImportNote",
     "The kernel offers no seccomp, so the foreign reader of this format was not kept from the network.")},
  {R"(Pulled along its longest axis the net was (\S+) times as stiff as the body; its springs are scaled by (\S+)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Pulled along its longest axis the net was %1 times as stiff as the "
                                        "body; its springs are scaled by %2.")},
  {R"(Polygons' edges are gone with the remeshing, all triangle edges are springs\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Polygons' edges are gone with the remeshing, all triangle edges are springs.")},
  {R"((\d+) nodes of the surface found no wall opposite and got no strut)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Nodes of the surface that found no wall opposite and got no strut: %1.")},
  {R"(The wall is (\S+) mm thick, of (\d+) layers? of cells, and has (\S+) cm\^3; its springs miss an even stiffness by (\S+) %\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The wall is %1 mm thick, layers of cells: %2, volume: %3 cm³; its "
                                        "springs miss an even stiffness by %4 %.")},
  {R"(At (\d+) nodes the wall had to be thinner, down to (\S+) mm: the opposite wall is near there, or the surface bends sharply\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Nodes where the wall had to be thinner: %1, down to %2 mm. The "
                                        "opposite wall is near there, or the surface bends sharply.")},
  {R"((\d+) triangles of the inner surface still run through others; repair the surface there\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Triangles of the inner surface that still run through others: %1. "
                                        "Repair the surface there.")},
  // Repairs
  {R"(removed (\d+) triangles without area)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Removed: %1 triangles without area.")},
  {R"(removed (\d+) triangles that were there twice)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Removed: %1 triangles that were there twice.")},
  {R"(removed (\d+) lines without length or there twice)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Removed: %1 lines without length or there twice.")},
  {R"(removed (\d+) vertices that nothing used)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Removed: %1 vertices that nothing used.")},
  {R"(tied (\d+) vertices to the edges they only lay on)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Vertices tied to the edges they only lay on: %1.")},
  {R"(made (\d+) triangles of (\d+), with edges from (\S+) to (\S+))",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Made %1 triangles of %2, with edges from %3 to %4 m.")},
  {R"(took the many fine creases for roughness and smoothed them over; ask for shorter edges to keep them)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The many fine creases were taken for roughness and smoothed over; "
                                        "more triangles keep them.")},
  {R"(could not come down to (\d+) triangles: lines, creases, seams or many small parts hold the others)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "It could not come down to %1 triangles: lines, creases, seams or "
                                        "many small parts hold the others.")},
  {R"(some edges stay more than 5 times shorter than others: .+)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Some edges stay more than 5 times shorter than others: lines, creases, seams or small "
                     "parts hold them, and the shortest sets the time step.")},
  {R"(filled (\d+) holes with (\d+) triangles)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Holes that were filled: %1, with %2 triangles.")},
  {R"(left (\d+) borders open: they are larger than asked for, or not closed, or without area)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Borders that stay open: %1. They are larger than asked for, or not "
                                        "closed, or without area.")},
  {R"(left out (\d+) vertices that lie nowhere \(NaN or infinite\), and (\d+) triangles on them)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "Left out: %1 vertices that lie nowhere (NaN or infinite), and %2 triangles on them.")},
  {R"(dropped (\d+) of (\d+) parts, (\d+) elements in all)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Dropped: %1 of %2 parts, %3 elements in all.")},
  {R"(turned (\d+) triangles round)", QT_TRANSLATE_NOOP("esm::ImportNote", "Triangles turned round: %1.")},
  {R"(over (\d+) edges neighbours cannot agree on a side: .+)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "Edges over which neighbours cannot agree on a side: %1. The surface "
                                        "is twisted like a Moebius strip.")},
  // What a file states of itself
  {R"(The file states (.+), which is used \(--ignore-stated uses the choices\)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The file states %1, which is used.")},
  {R"(The file states (.+), which is used and not .+ \(--ignore-stated uses the choices\)\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The file states %1, which is used.")},
  {R"(The axes that the field data states \(SPACE\) are not read: .+; --patient-axes lps or ras states them\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote",
                     "The axes that the file states for a patient could not be read; choose "
                     "them yourself.")},
  {R"(The unit that the file states, '(.*)', is no length and is not used; --unit states it\.)",
   QT_TRANSLATE_NOOP(
     "esm::ImportNote",
     "The unit that the file states, “%1”, is no length and is not used; choose it yourself.")},
  {R"(The file states (.+); as wished, the choices hold and not that\.)",
   QT_TRANSLATE_NOOP("esm::ImportNote", "The file states %1; as wished, the choices hold and not that.")},
};

/// Parts of what a file states.
constexpr KnownSentence kStated[] = {
  {R"((.+) and (.+))", QT_TRANSLATE_NOOP("esm::ImportNote", "%1 and %2")},
  {"metres", QT_TRANSLATE_NOOP("esm::ImportNote", "metres")},
  {"decimetres", QT_TRANSLATE_NOOP("esm::ImportNote", "decimetres")},
  {"centimetres", QT_TRANSLATE_NOOP("esm::ImportNote", "centimetres")},
  {"millimetres", QT_TRANSLATE_NOOP("esm::ImportNote", "millimetres")},
  {"micrometres", QT_TRANSLATE_NOOP("esm::ImportNote", "micrometres")},
  {"kilometres", QT_TRANSLATE_NOOP("esm::ImportNote", "kilometres")},
  {"inches", QT_TRANSLATE_NOOP("esm::ImportNote", "inches")},
  {"feet", QT_TRANSLATE_NOOP("esm::ImportNote", "feet")},
  {"yards", QT_TRANSLATE_NOOP("esm::ImportNote", "yards")},
  {R"(units of (\S+) m)", QT_TRANSLATE_NOOP("esm::ImportNote", "units of %1 m")},
  {"x up", QT_TRANSLATE_NOOP("esm::ImportNote", "x up")},
  {"y up", QT_TRANSLATE_NOOP("esm::ImportNote", "y up")},
  {"z up", QT_TRANSLATE_NOOP("esm::ImportNote", "z up")},
  {R"(a patient's axes \((LPS|RAS)\))", QT_TRANSLATE_NOOP("esm::ImportNote", "a patient's axes (%1)")},
};

QRegularExpressionMatch matched(const char* pattern, const QString& text)
{
  return QRegularExpression(QRegularExpression::anchoredPattern(QLatin1String(pattern))).match(text);
}

QString statedText(const QString& words);

/// A part of a sentence: a number as the language writes it, what a file states, a reason, a name.
QString partText(const QString& part, bool isStated)
{
  bool isNumber = false;
  const double value = QLocale::c().toDouble(part, &isNumber);
  if (isNumber) return part.contains(QLatin1Char('.')) ? QLocale().toString(value, 'g', 3) : part;
  return isStated ? statedText(part) : errorDetail(part);
}

std::optional<QString> known(const QString& sentence, std::span<const KnownSentence> list, bool isStated)
{
  for (const KnownSentence& one : list) {
    const QRegularExpressionMatch match = matched(one.pattern, sentence);
    if (!match.hasMatch()) continue;
    QString text = QCoreApplication::translate("esm::ImportNote", one.text);
    QStringList parts;
    for (int group = 1; group <= match.lastCapturedIndex(); ++group)
      parts << partText(match.captured(group), isStated || sentence.startsWith(QLatin1String(kStates)));
    return filled(text, parts);
  }
  return std::nullopt;
}

QString statedText(const QString& words)
{
  return known(words, kStated, true).value_or(words);
}

} // namespace

QString importNoteText(const std::string& note)
{
  QString text = QString::fromStdString(note);
  if (const auto whole = known(text, kNotes, false)) return *whole;
  const QString border = QStringLiteral(": "); // behind the name of one of several files
  for (qsizetype place = text.indexOf(border); place > 0; place = text.indexOf(border, place + 1))
    if (const auto rest = known(text.mid(place + border.size()), kNotes, false))
      return text.left(place) + border + *rest;
  return text;
}

} // namespace esm
