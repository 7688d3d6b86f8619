// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace esm {

enum class Symbol {
  New,
  Open,
  Save,
  Import,
  Undo,
  Redo,
  Play,
  Pause,
  Step,
  Reset,
  Camera,
  Pull,
  Select,
  Region,
  Eye,
  EyeShut,
  Lock,
  LockOpen,
  FromSelection,
  Stop,
  Fit,
  Plus,
  Minus,
  Copy,
  Up,
  Down,
  Arm,
  Program
};

/// Drawn icons that take their colour from the palette at the moment of painting, so that they are right in
/// every theme and at every scale (Qt's SVG plug-in need not be installed).
QIcon icon(Symbol symbol);

} // namespace esm
