// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/stated_frame.h"

#include "core/base/ascii_case.h"
#include "core/base/text_number.h"
#include "meshimport/dxf_groups.h"
#include "meshimport/xml_tags.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

struct NamedLength {
  std::string_view name;
  double metres;
};

constexpr double kSurveyFoot = 1200.0 / 3937.0; ///< of the United States, by definition

/// By the group code 70 behind $INSUNITS; 0 is "no unit". The last are astronomers' and surveyors'.
constexpr double kDxfUnits[] = {0.0,
                                0.0254,
                                0.3048,
                                1609.344,
                                1e-3,
                                1e-2,
                                1.0,
                                1e3,
                                0.0254e-6,
                                0.0254e-3,
                                0.9144,
                                1e-10,
                                1e-9,
                                1e-6,
                                0.1,
                                10.0,
                                100.0,
                                1e9,
                                1.495978707e11,
                                9.4607304725808e15,
                                3.0856776e16,
                                kSurveyFoot,
                                kSurveyFoot / 12.0,
                                3.0 * kSurveyFoot,
                                5280.0 * kSurveyFoot};

constexpr NamedLength kPrinterUnits[] = {{"micron", 1e-6},     {"millimeter", 1e-3}, {"millimeters", 1e-3},
                                         {"centimeter", 1e-2}, {"inch", 0.0254},     {"foot", 0.3048},
                                         {"feet", 0.3048},     {"meter", 1.0}};

constexpr std::size_t kMostHeader = 1 << 16; ///< bytes in which a unit is looked for
constexpr std::size_t kStlHeader = 80;

/// The groups of the HEADER section stand between its name and ENDSEC without a 0 of their own.
StatedFrame statedByDxf(std::string_view bytes)
{
  StatedFrame stated;
  DxfEntities entities(bytes);
  DxfEntity entity;
  while (entities.next(entity) && entity.name != "SECTION") {
  }
  if (entity.name != "SECTION" || entity.text(2) != "HEADER") return stated;
  const auto variable = std::find_if(entity.groups.begin(), entity.groups.end(), [](const DxfGroup& group) {
    return group.code == 9 && group.value == "$INSUNITS";
  });
  if (variable == entity.groups.end() || std::next(variable) == entity.groups.end()) return stated;
  const long long code = parseInteger(std::next(variable)->value).value_or(0);
  if (code > 0 && code < static_cast<long long>(std::size(kDxfUnits)))
    stateMetres(stated, kDxfUnits[static_cast<std::size_t>(code)]);
  return stated;
}

StatedFrame axesNamed(std::string_view name)
{
  StatedFrame stated;
  if (equalIgnoringCase(name, "LPS")) stated.patientAxes = PatientAxes::Lps;
  if (equalIgnoringCase(name, "RAS")) stated.patientAxes = PatientAxes::Ras;
  return stated;
}

/// "... SPACE=LPS ..."; "WORKSPACE=LPS" and "SPACE=LPST" mean something else.
StatedFrame statedBySpace(std::string_view text)
{
  constexpr std::string_view kSpace = "SPACE=";
  const auto isInWord = [&](std::size_t at) {
    const char c = at < text.size() ? asciiLower(text[at]) : ' ';
    return (c >= 'a' && c <= 'z') || c == '_';
  };
  for (std::size_t at = text.find(kSpace); at != text.npos; at = text.find(kSpace, at + 1)) {
    const std::size_t name = at + kSpace.size();
    if ((at > 0 && isInWord(at - 1)) || isInWord(name + 3)) continue;
    if (const StatedFrame stated = axesNamed(text.substr(name, 3)); stated.patientAxes) return stated;
  }
  return {};
}

/// The first `count` lines.
std::string_view firstLines(std::string_view bytes, int count)
{
  std::size_t end = 0;
  for (int line = 0; line < count && end < bytes.size(); ++line)
    end = std::min(bytes.find('\n', end), bytes.size() - 1) + 1;
  return bytes.substr(0, end);
}

/// The comments before the first statement.
std::string_view leadingComments(std::string_view bytes)
{
  std::size_t end = 0;
  while (end < bytes.size() && std::string_view("#\r\n").find(bytes[end]) != std::string_view::npos)
    end = std::min(bytes.find('\n', end), bytes.size() - 1) + 1;
  return bytes.substr(0, end);
}

/// The field data of 3D Slicer, if it is written as text: the letters as numbers.
StatedFrame statedByFieldData(std::string_view bytes)
{
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag) && tag.name != "Piece";) {
    if (tag.name != "Array" || tag.attribute("Name") != "SPACE" || tag.attribute("format") != "ascii")
      continue;
    std::string name;
    std::string_view numbers = tags.content();
    while (!numbers.empty()) {
      const std::size_t first = std::min(numbers.find_first_not_of(" \t\r\n"), numbers.size());
      numbers.remove_prefix(first);
      const std::size_t end = std::min(numbers.find_first_of(" \t\r\n"), numbers.size());
      if (const auto code = parseInteger(numbers.substr(0, end)); code && *code > 32 && *code < 127)
        name += static_cast<char>(*code);
      numbers.remove_prefix(end);
    }
    return axesNamed(name);
  }
  return {};
}

StatedFrame statedByCollada(std::string_view bytes)
{
  StatedFrame stated;
  stated.up = UpAxis::Y; // where a file says nothing, by the standard
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag) && !(tag.isEnd && tag.name == "asset");) {
    if (tag.name.substr(0, 8) == "library_") break;
    if (tag.name == "unit" && !tag.isEnd)
      stateMetres(stated, parseDouble(tag.attribute("meter")).value_or(0.0));
    if (tag.name != "up_axis" || tag.isEnd) continue;
    if (tags.content().find("Z_UP") != std::string_view::npos) stated.up = UpAxis::Z;
    if (tags.content().find("X_UP") != std::string_view::npos) stated.up = UpAxis::X;
  }
  return stated;
}

/// The attribute "unit" of the root of AMF and 3MF; both mean millimetres where there is none.
StatedFrame statedByPrinter(std::string_view bytes, std::string_view root)
{
  StatedFrame stated;
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag);) {
    if (tag.name.substr(tag.name.find(':') + 1) != root) continue; // behind a prefix, or npos + 1 = 0
    const std::string_view name = tag.attribute("unit");
    const auto unit = std::find_if(std::begin(kPrinterUnits), std::end(kPrinterUnits),
                                   [&](const NamedLength& u) { return equalIgnoringCase(u.name, name); });
    if (unit != std::end(kPrinterUnits)) stated.metres = unit->metres;
    if (name.empty()) stated.metres = 1e-3;
    break;
  }
  return stated;
}

StatedFrame statedByX3d(std::string_view bytes)
{
  StatedFrame stated;
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag) && !equalIgnoringCase(tag.name, "Scene");)
    if (equalIgnoringCase(tag.name, "unit") && tag.attribute("category") == "length")
      stateMetres(stated, parseDouble(tag.attribute("conversionFactor")).value_or(0.0));
  return stated;
}

} // namespace

void stateMetres(StatedFrame& stated, double metres)
{
  if (std::isfinite(metres) && metres > 0.0) stated.metres = metres;
}

StatedFrame statedInText(std::string_view bytes, std::string_view reader)
{
  if (reader == "DXF") return statedByDxf(bytes);
  if (reader == "VTU") return statedByFieldData(bytes.substr(0, kMostHeader));
  if (reader == "STL") return statedBySpace(bytes.substr(0, kStlHeader));
  if (reader == "VTK") return statedBySpace(firstLines(bytes, 2));
  if (reader == "PLY") return statedBySpace(bytes.substr(0, std::min(bytes.find("end_header"), kMostHeader)));
  if (reader == "OBJ") return statedBySpace(leadingComments(bytes));
  return {};
}

StatedFrame statedInXml(std::string_view bytes, std::string_view ending)
{
  if (ending == "dae") return statedByCollada(bytes);
  if (ending == "amf") return statedByPrinter(bytes.substr(0, kMostHeader), "amf");
  if (ending == "3mf") return statedByPrinter(bytes.substr(0, kMostHeader), "model");
  if (ending == "x3d") return statedByX3d(bytes.substr(0, kMostHeader));
  return {};
}

} // namespace esm
