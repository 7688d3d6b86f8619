// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "tests/fuzzyeditor/fake_fuzzy_document.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTest>
#include <QTranslator>
#include <QWidget>

#include <gtest/gtest.h>

namespace esm::test {

/// A document with its evaluation, and the program's language as the application switches it.
struct PanelTest : testing::Test {
  FakeFuzzyDocument document;
  FuzzyEvaluation evaluation{&document};

  ~PanelTest() override { speak(Language::English); }

  void speak(Language language)
  {
    QCoreApplication::removeTranslator(&m_german);
    const bool german = language == Language::German;
    QLocale::setDefault(QLocale(german ? QLocale::German : QLocale::English));
    if (german) {
      ASSERT_TRUE(m_german.load(QStringLiteral(ESM_FUZZYEDITOR_QM)));
      QCoreApplication::installTranslator(&m_german);
    }
    document.setLanguage(language);
    QCoreApplication::processEvents();
  }

  static void show(QWidget& widget)
  {
    widget.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
    widget.activateWindow();
    QCoreApplication::processEvents();
  }

private:
  QTranslator m_german;
};

} // namespace esm::test
