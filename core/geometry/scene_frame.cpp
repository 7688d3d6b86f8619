// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/scene_frame.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace esm {

namespace {

struct NamedUnit {
  LengthUnit unit;
  const char* name;
  double metres;
};

constexpr NamedUnit kUnits[] = {{LengthUnit::Millimetre, "mm", 1e-3},
                                {LengthUnit::Centimetre, "cm", 1e-2},
                                {LengthUnit::Metre, "m", 1.0},
                                {LengthUnit::Inch, "inch", 0.0254}};

const NamedUnit& named(LengthUnit unit)
{
  return *std::find_if(std::begin(kUnits), std::end(kUnits),
                       [unit](const auto& u) { return u.unit == unit; });
}

std::string unitInWords(double metres)
{
  struct Name {
    double metres;
    const char* word;
  };
  constexpr Name kNames[] = {{1.0, "metres"},      {1e-3, "millimetres"}, {1e-2, "centimetres"},
                             {0.0254, "inches"},   {0.3048, "feet"},      {1e-6, "micrometres"},
                             {1e-1, "decimetres"}, {1e3, "kilometres"},   {0.9144, "yards"}};
  for (const Name& name : kNames)
    if (std::abs(metres - name.metres) <= 1e-6 * name.metres) return name.word; // some write float32
  return "units of " + formatDouble(metres, 6) + " m";
}

} // namespace

std::optional<LengthUnit> lengthUnitFromName(std::string_view name) noexcept
{
  for (const NamedUnit& unit : kUnits)
    if (name == unit.name) return unit.unit;
  return std::nullopt;
}

std::string lengthUnitName(LengthUnit unit)
{
  return named(unit).name;
}

double metresPer(LengthUnit unit) noexcept
{
  return named(unit).metres;
}

FileFrame frameOf(const StatedFrame& stated, const ChosenFrame& chosen) noexcept
{
  FileFrame frame;
  frame.metres = stated.metres.value_or(metresPer(chosen.unit));
  frame.patientAxes = stated.patientAxes.value_or(chosen.patientAxes);
  frame.up = stated.up.value_or(frame.patientAxes == PatientAxes::None ? chosen.up : UpAxis::Z);
  return frame;
}

std::string inWords(const StatedFrame& stated)
{
  std::vector<std::string> parts;
  if (stated.metres) parts.push_back(unitInWords(*stated.metres));
  constexpr const char* kUp[] = {"y up", "z up", "x up"}; // in the order of UpAxis
  if (stated.up) parts.emplace_back(kUp[static_cast<std::size_t>(*stated.up)]);
  if (stated.patientAxes && *stated.patientAxes != PatientAxes::None)
    parts.emplace_back(*stated.patientAxes == PatientAxes::Lps ? "a patient's axes (LPS)"
                                                               : "a patient's axes (RAS)");
  std::string words;
  for (std::size_t i = 0; i < parts.size(); ++i)
    words += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return words;
}

void toScene(Mesh& mesh, const FileFrame& frame)
{
  mesh.position *= frame.metres;
  const auto negate = [&mesh](int row) { // 0 - 0 is 0, not -0
    mesh.position.row(row) = 0.0 - mesh.position.row(row).array();
  };
  if (frame.up == UpAxis::Y) {
    mesh.position.row(1).swap(mesh.position.row(2));
    negate(1);
  } else if (frame.up == UpAxis::X) {
    mesh.position.row(0).swap(mesh.position.row(1)); // y, x, z
    mesh.position.row(1).swap(mesh.position.row(2)); // y, z, x
    negate(0);
    negate(1);
  }
  if (frame.patientAxes == PatientAxes::Lps) {
    negate(0);
    negate(1);
  }
}

void toScene(Mesh& mesh, LengthUnit unit, UpAxis up, PatientAxes axes)
{
  toScene(mesh, frameOf({}, {unit, up, axes}));
}

Eigen::Vector3d extentInScene(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const FileFrame& frame)
{
  const Eigen::Vector3d extent = (high - low) * frame.metres;
  if (frame.up == UpAxis::Y) return {extent.x(), extent.z(), extent.y()};
  if (frame.up == UpAxis::X) return {extent.y(), extent.z(), extent.x()};
  return extent;
}

bool isUsualSize(double extent) noexcept
{
  constexpr double kRounding = 1e-6; // a millimetre out of float32 may fall short of one
  return extent >= 1e-3 * (1.0 - kRounding) && extent <= 2.0 * (1.0 + kRounding);
}

} // namespace esm
