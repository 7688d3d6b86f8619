// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/error_text.h"

#include "app/text/error_sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <optional>
#include <vector>

namespace esm {

namespace {

const char* leadOf(ErrorCode code)
{
  switch (code) {
  case ErrorCode::FileUnreadable:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file cannot be read.");
  case ErrorCode::FileUnwritable:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file cannot be written.");
  case ErrorCode::BadFormat:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file is damaged or of another format.");
  case ErrorCode::Unsupported:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "This format or feature is not supported.");
  case ErrorCode::NewerVersion:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file was written by a newer version of this program.");
  case ErrorCode::InvalidValue:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "A value is outside what is possible.");
  case ErrorCode::EmptyResult:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "There is nothing of use in the file.");
  case ErrorCode::Numerics:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The computation could not be carried out.");
  case ErrorCode::NoDevice:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The device is not available.");
  case ErrorCode::OutOfMemory:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "There is not enough memory.");
  case ErrorCode::Cancelled:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The task was cancelled.");
  case ErrorCode::Internal:
    break;
  }
  return QT_TRANSLATE_NOOP("esm::ErrorText", "An internal error occurred.");
}

/// A sentence of the core as an expression with a group for each part that varies.
struct Sentence {
  const char* text;
  QRegularExpression expression;
};

const std::vector<Sentence>& sentences()
{
  static const std::vector<Sentence> known = [] {
    std::vector<Sentence> made;
    for (const char* text : errorSentences()) {
      QString pattern = QRegularExpression::escape(QString::fromUtf8(text));
      static const QRegularExpression place(QStringLiteral("\\\\%\\d"));
      // "vertex %1" names a place and "%1 nodes" counts: they shall not swallow what stands beside them.
      const bool isName = pattern.count(QLatin1String("\\ ")) == 1 && pattern.contains(QLatin1String("\\%1"));
      pattern.replace(place, isName ? QStringLiteral("(\\d+)") : QStringLiteral("(.+?)"));
      made.push_back({text, QRegularExpression(QRegularExpression::anchoredPattern(pattern))});
    }
    return made;
  }();
  return known;
}

std::optional<QString> knownSentence(const QString& sentence)
{
  for (const Sentence& one : sentences()) {
    const QRegularExpressionMatch match = one.expression.match(sentence);
    if (!match.hasMatch()) continue;
    QStringList parts = match.capturedTexts().mid(1);
    const bool isQuote = QLatin1String(one.text) == QLatin1String("the reading library says: %1");
    if (!isQuote)
      for (QString& part : parts) part = errorDetail(part);
    return filled(QCoreApplication::translate("esm::ErrorDetail", one.text), parts);
  }
  return std::nullopt;
}

/// "3 of these, 2 of those": what begins as a known sentence, up to a comma, and so on with the rest.
QString listed(const QString& clause)
{
  const QString comma = QStringLiteral(", ");
  for (qsizetype place = clause.indexOf(comma); place > 0; place = clause.indexOf(comma, place + 1))
    if (const auto known = knownSentence(clause.left(place)))
      return *known + comma + errorDetail(clause.mid(place + comma.size()));
  const qsizetype first = clause.indexOf(comma);
  return first < 0 ? clause : clause.left(first) + comma + errorDetail(clause.mid(first + comma.size()));
}

} // namespace

QString filled(const QString& text, const QStringList& parts)
{
  QString result;
  for (qsizetype i = 0; i < text.size(); ++i) {
    const int part = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
    if (part < 1 || part > parts.size()) {
      result += text[i];
      continue;
    }
    result += parts[part - 1];
    ++i;
  }
  return result;
}

/// "file: line 3: what is wrong; what helps": whole if it is known, else part by part; the rest stays
/// English.
QString errorDetail(const QString& detail)
{
  if (const auto known = knownSentence(detail)) return *known;
  static const QRegularExpression border(QStringLiteral("[:;] "));
  const qsizetype place = detail.indexOf(border);
  if (place <= 0) return listed(detail);
  return errorDetail(detail.left(place)) + detail.mid(place, 2) + errorDetail(detail.mid(place + 2));
}

QString errorDetail(const Error& error)
{
  return errorDetail(QString::fromStdString(error.detail));
}

QString errorLead(ErrorCode code)
{
  return QCoreApplication::translate("esm::ErrorText", leadOf(code));
}

QString errorText(const Error& error)
{
  return errorLead(error.code) + QStringLiteral("\n\n") + errorDetail(error);
}

} // namespace esm
