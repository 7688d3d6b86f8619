// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/reason_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>

namespace esm {

namespace {

constexpr KnownSentence kClauses[] = {
  {R"(springs at node (\d+) \((\S+) N/m on (\S+) kg\) need explicit steps of (\S+) us)",
   QT_TRANSLATE_NOOP("esm::Reason", "springs at node %1 (%2 N/m on %3 kg) need explicit steps of %4 µs")},
  {"they take them alone, and the rest its own",
   QT_TRANSLATE_NOOP("esm::Reason", "they take them alone, and the rest its own")},
  {"no spring limits the step", QT_TRANSLATE_NOOP("esm::Reason", "no spring limits the step")},
  {R"((\S+) as asked)", QT_TRANSLATE_NOOP("esm::Reason", "%1 as asked")},
  {"explicit steps are cheapest", QT_TRANSLATE_NOOP("esm::Reason", "explicit steps are cheapest")},
  {R"(the tolerance asks for order (\d+))",
   QT_TRANSLATE_NOOP("esm::Reason", "the tolerance asks for order %1")},
  {"the engine went implicit", QT_TRANSLATE_NOOP("esm::Reason", "the engine went implicit")},
  {"the engine went implicit and stays bounded, but the tolerance may not hold",
   QT_TRANSLATE_NOOP("esm::Reason",
                     "the engine went implicit and stays bounded, but the tolerance may not hold")},
  {"the tolerance would cost too many steps and may not hold",
   QT_TRANSLATE_NOOP("esm::Reason", "the tolerance would cost too many steps and may not hold")},
  {"as no step was both good and affordable, it takes damped steps that gain no energy: lower the stiffness "
   "or the loads, raise the masses, or allow more effort",
   QT_TRANSLATE_NOOP("esm::Reason",
                     "as no step was both good and affordable, it takes damped steps that gain no energy: "
                     "lower the stiffness or the loads, raise the masses, or allow more effort")},
  {"to keep time, it takes a few damped steps for each frame, whose error is told",
   QT_TRANSLATE_NOOP("esm::Reason",
                     "to keep time, it takes a few damped steps for each frame, whose error is told")},
  {R"(numbers became infinite \(stiffest at node (\d+)\))",
   QT_TRANSLATE_NOOP("esm::Reason", "numbers became infinite (stiffest at node %1)")},
  {"numbers became infinite", QT_TRANSLATE_NOOP("esm::Reason", "numbers became infinite")},
  {R"(the (\S+) solver found no step small enough \(stiffest at node (\d+)\))",
   QT_TRANSLATE_NOOP("esm::Reason", "the solver %1 found no step small enough (stiffest at node %2)")},
  {R"(the (\S+) solver found no step small enough)",
   QT_TRANSLATE_NOOP("esm::Reason", "the solver %1 found no step small enough")},
  {R"(the last good state is kept: take a smaller fixed step, at most (\S+) us, or automatic steps)",
   QT_TRANSLATE_NOOP("esm::Reason", "the last good state is kept: take a smaller fixed step, at most %1 µs, "
                                    "or automatic steps")},
  {"the last good state is kept: lower the stiffness or the loads, or raise the masses",
   QT_TRANSLATE_NOOP("esm::Reason",
                     "the last good state is kept: lower the stiffness or the loads, or raise the masses")},
  {"the last good state is kept: lower the stiffness or the loads, or take a larger tolerance",
   QT_TRANSLATE_NOOP(
     "esm::Reason",
     "the last good state is kept: lower the stiffness or the loads, or take a larger tolerance")},
};

/// "0.4" as the language writes it; whole numbers and names stay.
QString localized(const QString& word)
{
  bool isNumber = false;
  const double value = QLocale::c().toDouble(word, &isNumber);
  return isNumber && word.contains(QLatin1Char('.')) ? QLocale().toString(value, 'g', 3) : word;
}

/// Compiled once: panels that follow the simulation ask ten times a second.
QRegularExpression compiled(const char* pattern)
{
  thread_local QHash<const char*, QRegularExpression> known;
  QRegularExpression& expression = known[pattern];
  if (expression.pattern().isEmpty())
    expression.setPattern(QRegularExpression::anchoredPattern(QLatin1String(pattern)));
  return expression;
}

} // namespace

QString translated(const QString& sentence, std::span<const KnownSentence> known, const char* context)
{
  for (const KnownSentence& one : known) {
    const QRegularExpressionMatch match = compiled(one.pattern).match(sentence);
    if (!match.hasMatch()) continue;
    QString text = QCoreApplication::translate(context, one.text);
    for (int group = 1; group <= match.lastCapturedIndex(); ++group)
      text = text.arg(localized(match.captured(group)));
    return text;
  }
  return sentence;
}

QString reasonText(const std::string& reason)
{
  QStringList clauses = QString::fromStdString(reason).split(QStringLiteral("; "));
  for (QString& clause : clauses) clause = translated(clause, kClauses, "esm::Reason");
  return clauses.join(QStringLiteral("; "));
}

} // namespace esm
