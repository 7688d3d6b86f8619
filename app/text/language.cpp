// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

static void loadTranslationResource()
{
  Q_INIT_RESOURCE(esm_translations);
}

namespace esm {

std::optional<Language> languageFromCode(const QString& code)
{
  if (code == QLatin1String("de")) return Language::German;
  if (code == QLatin1String("en")) return Language::English;
  return std::nullopt;
}

QString languageCode(Language language)
{
  return language == Language::German ? QStringLiteral("de") : QStringLiteral("en");
}

Language systemLanguage()
{
  return QLocale::system().language() == QLocale::German ? Language::German : Language::English;
}

void LanguageSwitch::set(Language language)
{
  loadTranslationResource();
  m_language = language;
  QCoreApplication::removeTranslator(&m_ours);
  QCoreApplication::removeTranslator(&m_qts);

  QLocale locale(language == Language::German ? QLocale::German : QLocale::English);
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale::setDefault(locale);
  // Qt's own texts first: the last installed translator is asked first
  if (language == Language::German &&
      m_qts.load(QStringLiteral("qtbase_de"), QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&m_qts);
  if (m_ours.load(QStringLiteral(":/i18n/esm_%1.qm").arg(languageCode(language)))) // English: plurals only
    QCoreApplication::installTranslator(&m_ours);
}

} // namespace esm
