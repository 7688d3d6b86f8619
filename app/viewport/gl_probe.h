// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QSurfaceFormat>

namespace esm {

/// What this session's display can do, found out without creating a window: on platforms without GL the
/// mere existence of a QOpenGLWidget ends the process.
struct GlProbe {
  bool usable = false;     ///< OpenGL 3.3 core works
  int samples = 0;         ///< multisampling for smooth edges; 0 where the processor does the drawing
  const char* reason = ""; ///< it is not usable, English; see why()
  QStringList arguments;   ///< for the %1 in `reason`

  QString why() const; ///< in the present language; empty if usable
};

/// Tried once per process, on the GUI thread, after QApplication exists. ESM_VIEW=off says no without trying,
/// ESM_VIEW_SAMPLES=n overrides the multisampling.
const GlProbe& glProbe();

/// The format that the probe has tried: 3.3 core, 24 bit depth, stencil for QPainter.
QSurfaceFormat glFormat(int samples);

} // namespace esm
