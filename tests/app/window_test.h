// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/main_window.h"
#include "tests/app/sheet.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

namespace esm::test {

/// The window as a user without OpenGL gets it: the test platform has none.
struct WindowTest : testing::Test {
  LanguageSwitch language;
  std::unique_ptr<MainWindow> window;
  QTemporaryDir folder;

  void SetUp() override
  {
    applyTheme(Theme::Light);
    language.set(Language::English);
    window = std::make_unique<MainWindow>(&language);
    window->document()->start(sheetProject(), QString());
    window->show();
  }
  void TearDown() override
  {
    window.reset();
    language.set(Language::English);
  }
  template <class W>
  W* find(const char* name)
  {
    W* widget = window->findChild<W*>(QLatin1String(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  void click(const char* name) { QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton); }
};

/// Presses a button of the next dialog of this name, as soon as it is there. Keeps what the dialog said.
class Answer : public QObject {
public:
  Answer(const char* dialog, const char* button, QObject* parent = nullptr) : QObject(parent)
  {
    auto* watch = new QTimer(this);
    connect(watch, &QTimer::timeout, this, [this, watch, dialog, button] {
      auto* shown = QApplication::activeModalWidget();
      if (shown == nullptr || shown->objectName() != QLatin1String(dialog)) return;
      watch->stop();
      given = true;
      if (const auto* box = qobject_cast<QMessageBox*>(shown))
        said = box->text() + QLatin1Char(' ') + box->informativeText();
      if (auto* pressed = shown->findChild<QAbstractButton*>(QLatin1String(button)))
        pressed->click();
      else
        static_cast<QDialog*>(shown)->reject();
    });
    watch->start(10);
  }
  bool given = false;
  QString said;
};

} // namespace esm::test
