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
    StatedFrame stated;
    stateAxes(stated, text.substr(name, 3));
    if (stated.patientAxes) return stated;
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

/// A unit by an attribute. One that is no length is told, and not taken for metres in silence.
void stateUnit(StatedFrame& stated, std::string_view value, double metres, std::vector<std::string>& notes)
{
  stateMetres(stated, metres);
  if (!stated.metres && !value.empty())
    notes.push_back("The unit that the file states, '" + std::string(value.substr(0, 40)) +
                    "', is no length and is not used; --unit states it.");
}

StatedFrame statedByCollada(std::string_view bytes, std::vector<std::string>& notes)
{
  StatedFrame stated;
  stated.up = UpAxis::Y; // where a file says nothing, by the standard
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag) && !(tag.isEnd && tag.name == "asset");) {
    if (tag.name.substr(0, 8) == "library_") break;
    if (tag.name == "unit" && !tag.isEnd)
      stateUnit(stated, tag.attribute("meter"), parseDouble(tag.attribute("meter")).value_or(0.0), notes);
    if (tag.name != "up_axis" || tag.isEnd) continue;
    if (tags.content().find("Z_UP") != std::string_view::npos) stated.up = UpAxis::Z;
    if (tags.content().find("X_UP") != std::string_view::npos) stated.up = UpAxis::X;
  }
  return stated;
}

/// The attribute "unit" of the root of AMF and 3MF; both mean millimetres where there is none.
StatedFrame statedByPrinter(std::string_view bytes, std::string_view root, std::vector<std::string>& notes)
{
  StatedFrame stated;
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag);) {
    if (tag.name.substr(tag.name.find(':') + 1) != root) continue; // behind a prefix, or npos + 1 = 0
    const std::string_view name = tag.attribute("unit");
    const auto unit = std::find_if(std::begin(kPrinterUnits), std::end(kPrinterUnits),
                                   [&](const NamedLength& u) { return equalIgnoringCase(u.name, name); });
    if (name.empty()) stated.metres = 1e-3;
    stateUnit(stated, name, unit == std::end(kPrinterUnits) ? 0.0 : unit->metres, notes);
    break;
  }
  return stated;
}

StatedFrame statedByX3d(std::string_view bytes, std::vector<std::string>& notes)
{
  StatedFrame stated;
  XmlTags tags(bytes);
  for (XmlTag tag; tags.next(tag) && !equalIgnoringCase(tag.name, "Scene");)
    if (equalIgnoringCase(tag.name, "unit") && tag.attribute("category") == "length") {
      const std::string_view factor = tag.attribute("conversionFactor");
      stateUnit(stated, factor, parseDouble(factor).value_or(0.0), notes);
    }
  return stated;
}

} // namespace

void stateMetres(StatedFrame& stated, double metres)
{
  if (std::isfinite(metres) && metres > 0.0) stated.metres = metres;
}

void stateAxes(StatedFrame& stated, std::string_view name)
{
  if (equalIgnoringCase(name, "LPS")) stated.patientAxes = PatientAxes::Lps;
  if (equalIgnoringCase(name, "RAS")) stated.patientAxes = PatientAxes::Ras;
}

std::string unreadAxes(const std::string& why)
{
  return "The axes that the field data states (SPACE) are not read: " + why +
         "; --patient-axes lps or ras states them.";
}

StatedFrame statedInText(std::string_view bytes, std::string_view reader)
{
  if (reader == "DXF") return statedByDxf(bytes);
  if (reader == "STL") return statedBySpace(bytes.substr(0, kStlHeader));
  if (reader == "VTK") return statedBySpace(firstLines(bytes, 2));
  if (reader == "PLY") return statedBySpace(bytes.substr(0, std::min(bytes.find("end_header"), kMostHeader)));
  if (reader == "OBJ") return statedBySpace(leadingComments(bytes));
  return {};
}

StatedFrame statedInXml(std::string_view bytes, std::string_view ending, std::vector<std::string>& notes)
{
  if (ending == "dae") return statedByCollada(bytes, notes);
  if (ending == "amf") return statedByPrinter(bytes.substr(0, kMostHeader), "amf", notes);
  if (ending == "3mf") return statedByPrinter(bytes.substr(0, kMostHeader), "model", notes);
  if (ending == "x3d") return statedByX3d(bytes.substr(0, kMostHeader), notes);
  return {};
}

} // namespace esm
