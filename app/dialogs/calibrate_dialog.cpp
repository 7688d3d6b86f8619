// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/calibrate_dialog.h"

#include "fuzzyeditor/decimal_spin_box.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

namespace esm {

namespace {

constexpr double kMillimetre = 0.001; ///< [m]

QDoubleSpinBox* spinBox(const char* name, const QString& description, double least, double most, double value)
{
  auto* box = new DecimalSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setAccessibleName(description);
  box->setDecimals(2);
  box->setRange(least, most);
  box->setValue(value);
  return box;
}

} // namespace

CalibrateDialog::CalibrateDialog(const StickCalibration& before, QWidget* parent) : QDialog(parent)
{
  setWindowTitle(tr("Calibrate"));
  auto* form = new QFormLayout(this);
  m_newtons = spinBox("calibrateNewtons", tr("Force at 100 %, in newtons"), 0.1, 100.0, before.newtonsAtFull);
  m_newtons->setSuffix(tr(" N"));
  form->addRow(tr("Force at 100 %, as a spring scale shows it:"), m_newtons);
  m_across = new QCheckBox(tr("Pushes left instead of right"));
  m_along = new QCheckBox(tr("Pushes towards you instead of away"));
  m_across->setObjectName(QStringLiteral("calibrateAcross"));
  m_along->setObjectName(QStringLiteral("calibrateAlong"));
  m_across->setChecked(before.reversedAcross);
  m_along->setChecked(before.reversedAlong);
  form->addRow(tr("The force is reversed:"), m_across);
  form->addRow(QString(), m_along);
  auto* origin = new QHBoxLayout;
  const std::array axes{tr("Zero of the scene in the device, X"), tr("Zero of the scene in the device, Y"),
                        tr("Zero of the scene in the device, Z")};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const std::array names{"calibrateOriginX", "calibrateOriginY", "calibrateOriginZ"};
    m_origin[i] = spinBox(names[i], axes[i], -1000.0, 1000.0, before.origin[axis] / kMillimetre);
    m_origin[i]->setSuffix(tr(" mm"));
    origin->addWidget(m_origin[i]);
  }
  form->addRow(tr("Where in the device the scene has its zero:"), origin);
  form->addRow(new QLabel(tr("Holds from the next connection on.")));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
}

StickCalibration CalibrateDialog::calibration() const
{
  StickCalibration said;
  said.newtonsAtFull = m_newtons->value();
  said.reversedAcross = m_across->isChecked();
  said.reversedAlong = m_along->isChecked();
  for (int axis = 0; axis < 3; ++axis)
    said.origin[axis] = m_origin[static_cast<std::size_t>(axis)]->value() * kMillimetre;
  return said;
}

} // namespace esm
