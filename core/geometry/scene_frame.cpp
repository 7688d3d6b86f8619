// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/scene_frame.h"

#include <algorithm>

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

void toScene(Mesh& mesh, LengthUnit unit, UpAxis up, PatientAxes axes)
{
  mesh.position *= metresPer(unit);
  const auto negate = [&mesh](int row) { // 0 - 0 is 0, not -0
    mesh.position.row(row) = 0.0 - mesh.position.row(row).array();
  };
  if (axes == PatientAxes::Lps) {
    negate(0);
    negate(1);
  } else if (axes == PatientAxes::None && up == UpAxis::Y) {
    mesh.position.row(1).swap(mesh.position.row(2));
    negate(1);
  }
}

} // namespace esm
