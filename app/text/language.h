// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/types.h"

#include <QObject>
#include <QString>
#include <QTranslator>

#include <optional>

namespace esm {

std::optional<Language> languageFromCode(const QString& code); ///< "de", "en"
QString languageCode(Language language);
Language systemLanguage(); ///< German where the system speaks it, else English

/// Switches the program's language while it runs: installs our translation and Qt's own, widgets hear
/// QEvent::LanguageChange. Field numbers follow (QLocale). One per application, GUI thread.
class LanguageSwitch : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  void set(Language language);
  Language language() const noexcept { return m_language; }

private:
  QTranslator m_ours, m_qts;
  Language m_language = Language::English;
};

} // namespace esm
