// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/unit_question.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace esm {

namespace {

QString dialogText(const char* text)
{
  return QCoreApplication::translate("esm::ImportDialog", text);
}

QString unitText(LengthUnit unit)
{
  return unit == LengthUnit::Inch ? QCoreApplication::translate("esm::RecipeForm", "inch")
                                  : QString::fromStdString(lengthUnitName(unit));
}

/// "32 mm", "3 m"
QString lengthText(double metres)
{
  const bool inMetres = metres >= 1.0;
  return QStringLiteral("%1 %2").arg(QLocale().toString(inMetres ? metres : 1000.0 * metres, 'g', 3),
                                     inMetres ? QStringLiteral("m") : QStringLiteral("mm"));
}

} // namespace

std::optional<LengthUnit> likelyUnit(double extent)
{
  for (const LengthUnit unit :
       {LengthUnit::Millimetre, LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Inch})
    if (isUsualSize(extent * metresPer(unit))) return unit;
  return std::nullopt;
}

QString likelyText(double extent)
{
  const auto likely = likelyUnit(extent);
  if (!likely) return {};
  return dialogText(QT_TRANSLATE_NOOP("esm::ImportDialog", "With the unit %1 it would be %2 large."))
    .arg(unitText(*likely), lengthText(extent * metresPer(*likely)));
}

UnitAnswer askAboutUnit(double extent, double metres, QWidget* parent)
{
  QMessageBox box(
    QMessageBox::Question, dialogText(QT_TRANSLATE_NOOP("esm::ImportDialog", "Import")),
    dialogText(QT_TRANSLATE_NOOP("esm::ImportDialog", "The model is %1 large. Is its unit right?"))
      .arg(lengthText(metres)),
    QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("dlgUnit"));
  box.setInformativeText(likelyText(extent));
  QPushButton* use = nullptr;
  if (const auto likely = likelyUnit(extent)) {
    use = box.addButton(
      dialogText(QT_TRANSLATE_NOOP("esm::ImportDialog", "Take the unit %1")).arg(unitText(*likely)),
      QMessageBox::AcceptRole);
    use->setObjectName(QStringLiteral("unitUse"));
  }
  QPushButton* keep = box.addButton(dialogText(QT_TRANSLATE_NOOP("esm::ImportDialog", "Import as it is")),
                                    QMessageBox::DestructiveRole);
  keep->setObjectName(QStringLiteral("unitKeep"));
  if (use != nullptr)
    box.setDefaultButton(use);
  else
    box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() == keep) return UnitAnswer::Keep;
  return use != nullptr && box.clickedButton() == use ? UnitAnswer::UseLikely : UnitAnswer::Cancel;
}

} // namespace esm
