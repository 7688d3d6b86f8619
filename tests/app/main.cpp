// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/theme.h"

#include <QApplication>
#include <QLocale>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <clocale>

/// One QApplication for all tests, off screen unless asked otherwise, with settings of its own.
int main(int argc, char** argv)
{
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir settings;
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  QLocale::setDefault(QLocale(QLocale::English));
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setOrganizationName(QStringLiteral("esm"));
  QApplication::setApplicationName(QStringLiteral("esm-modeler-test"));
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
