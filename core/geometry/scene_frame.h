// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace esm {

/// How coordinates of files become those of the scene: metres, right-handed, z up.

enum class LengthUnit { Millimetre, Centimetre, Metre, Inch };
std::optional<LengthUnit> lengthUnitFromName(std::string_view name) noexcept; ///< mm, cm, m, inch
std::string lengthUnitName(LengthUnit unit);
double metresPer(LengthUnit unit) noexcept;

/// The axis of the file that points up.
enum class UpAxis { Y, Z };

/// Axes that a medical file refers to the patient: DICOM writes x to the Left, y to the back (Posterior),
/// z to the head (Superior), NIfTI x to the Right, y to the front (Anterior), z to the head. In the scene x
/// then points to the patient's right, y to the front and z to the head, so that files of both kinds lie
/// in one place. None: no patient.
enum class PatientAxes { None, Lps, Ras };

/// Scales and turns; nothing is mirrored. y up: (x, y, z) -> (x, -z, y); LPS: (x, y, z) -> (-x, -y, z).
/// Patient axes have z up, so `up` does not count with them.
void toScene(Mesh& mesh, LengthUnit unit, UpAxis up, PatientAxes axes = PatientAxes::None);

} // namespace esm
