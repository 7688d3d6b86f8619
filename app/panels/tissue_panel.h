// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/panels/gesture_spin_box.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace esm {

/// Dock Tissue: wall thickness, density, force law and gravity, which hold for the whole model.
class TissuePanel : public QWidget {
  Q_OBJECT
public:
  explicit TissuePanel(Document* document, QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();
  void refresh();
  GestureSpinBox* addNumber(const QString& name, double low, double high, double step, int decimals);
  void edit(double TissueSettings::*number, double value, int gesture);
  void offer(GestureSpinBox* field, const QString& label, const QString& help, bool applies,
             double TissueParameters::*value);

  Document* m_document;
  QFormLayout* m_form = nullptr;
  GestureSpinBox *m_thickness = nullptr, *m_density = nullptr, *m_lawParameter = nullptr,
                 *m_gravity = nullptr;
  QComboBox* m_law = nullptr;
  QCheckBox* m_fromTissue = nullptr;
  bool m_refreshing = false;
};

} // namespace esm
