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

/// The axis of the file that points up. X only where a file states it, never as a choice.
enum class UpAxis { Y, Z, X };

/// Axes that a medical file refers to the patient: DICOM writes x to the Left, y to the back (Posterior),
/// z to the head (Superior), NIfTI x to the Right, y to the front (Anterior), z to the head. In the scene x
/// then points to the patient's right, y to the front and z to the head, so that files of both kinds lie
/// in one place. None: no patient.
enum class PatientAxes { None, Lps, Ras };

/// The unit and the axes of coordinates.
struct FileFrame {
  double metres = 1.0; ///< of one unit
  UpAxis up = UpAxis::Z;
  PatientAxes patientAxes = PatientAxes::None; ///< once z is up
  bool operator==(const FileFrame&) const = default;
};

/// What a file itself says of its unit and axes; empty where it says nothing.
struct StatedFrame {
  std::optional<double> metres; ///< of one unit
  std::optional<UpAxis> up;
  std::optional<PatientAxes> patientAxes;
  bool isEmpty() const noexcept { return *this == StatedFrame{}; }
  bool operator==(const StatedFrame&) const = default;
};

/// What somebody chose for files that say nothing.
struct ChosenFrame {
  LengthUnit unit = LengthUnit::Metre;
  UpAxis up = UpAxis::Z;
  PatientAxes patientAxes = PatientAxes::None; ///< have z up, so `up` does not count with them
};

/// What holds: what the file states, and the choice for the rest.
FileFrame frameOf(const StatedFrame& stated, const ChosenFrame& chosen) noexcept;

/// "millimetres and z up"; @pre something is stated
std::string inWords(const StatedFrame& stated);

/// Scales and turns; nothing is mirrored. x up: (x, y, z) -> (-y, -z, x); y up: (x, y, z) -> (x, -z, y);
/// then LPS: (x, y, z) -> (-x, -y, z).
void toScene(Mesh& mesh, const FileFrame& frame);
/// The same for a file that states nothing.
void toScene(Mesh& mesh, LengthUnit unit, UpAxis up, PatientAxes axes = PatientAxes::None);

/// The extent of a box [m], once it lies in the scene.
Eigen::Vector3d extentInScene(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                              const FileFrame& frame);

/// Whether a body may be so large [m]: what hands and instruments work on has 1 mm to 2 m. Anything else most
/// often has another unit than was thought.
bool isUsualSize(double extent) noexcept;

} // namespace esm
