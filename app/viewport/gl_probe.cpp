// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/gl_probe.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace esm {

namespace {

constexpr const char* kPlatformsWithoutGl[] = {"offscreen", "minimal", "minimalegl", "vnc", "linuxfb"};

/// Multisampling costs a software renderer half its speed.
int affordableSamples(const QOpenGLContext& context)
{
  bool given = false;
  const int wanted = qEnvironmentVariableIntValue("ESM_VIEW_SAMPLES", &given);
  if (given && wanted >= 0 && wanted <= 16) return wanted;
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const QByteArray renderer = QByteArray(name).toLower();
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "software"})
    if (renderer.contains(software)) return 0;
  return 4;
}

GlProbe probe()
{
  GlProbe result;
  if (qEnvironmentVariable("ESM_VIEW") == QLatin1String("off")) {
    result.reason = QT_TRANSLATE_NOOP("esm::GlProbe", "it is switched off by ESM_VIEW=off");
    return result;
  }
  const QString platform = QGuiApplication::platformName();
  for (const char* without : kPlatformsWithoutGl)
    if (platform == QLatin1String(without)) {
      result.reason = QT_TRANSLATE_NOOP("esm::GlProbe", "the display \"%1\" has no OpenGL");
      result.arguments = {platform};
      return result;
    }
  QOpenGLContext context;
  context.setFormat(glFormat(0));
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface)) {
    result.reason = QT_TRANSLATE_NOOP("esm::GlProbe", "the graphics driver offers no OpenGL context");
    return result;
  }
  const QSurfaceFormat got = context.format();
  if (context.isOpenGLES() || got.version() < qMakePair(3, 3)) {
    result.reason = QT_TRANSLATE_NOOP("esm::GlProbe", "the graphics driver offers OpenGL %1.%2 only");
    result.arguments = {QString::number(got.majorVersion()), QString::number(got.minorVersion())};
  } else {
    result.usable = true;
    result.samples = affordableSamples(context);
  }
  context.doneCurrent();
  return result;
}

} // namespace

QString GlProbe::why() const
{
  QString text = QCoreApplication::translate("esm::GlProbe", reason);
  for (const QString& argument : arguments) text = text.arg(argument);
  return text;
}

const GlProbe& glProbe()
{
  static const GlProbe result = probe();
  return result;
}

QSurfaceFormat glFormat(int samples)
{
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL); // else Wayland offers OpenGL ES
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(samples);
  return format;
}

} // namespace esm
