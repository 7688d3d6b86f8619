// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device_registry.h"
#include "haptics/haptic_types.h"

#include <QString>

#include <string>

namespace esm {

// The device layer speaks English; here it speaks the window's language.

QString deviceStateText(DeviceState state); ///< "force on", ...
QString devicePhaseText(DevicePhase phase); ///< "needs home", ...
/// What is connected, by its name in the registry: "Novint Falcon", "simulated device"; another stays as it
/// is.
QString deviceNameText(const std::string& name);
/// A reason of status, report, listing or of an error's detail; one that is not known stays as it is.
QString hapticReasonText(const std::string& reason);
QString priorityText(const std::string& priority); ///< of the servo thread

} // namespace esm
