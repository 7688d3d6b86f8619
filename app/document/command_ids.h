// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace esm {

/// QUndoCommand::id() of the commands that merge; one number per class, never used twice.
enum CommandId {
  kSetInputCommand = 1,
  kEditRegionsCommand = 2,
  kSetTissueSettingsCommand = 3,
  kSetGravityCommand = 4,
  kSetRuleBaseCommand = 5,
  kSetInputsCommand = 6,
};

} // namespace esm
