// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runtime/quality_ladder.h"

#include <QDialog>

class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace esm {

/// The user's wishes of the last time, from the settings of the application; what is missing or damaged there
/// is as the plan's default.
QualityPlan savedQualityPlan();
void saveQualityPlan(const QualityPlan& plan);

/// What gives way, in which order and how far, when a model is too heavy for real time.
class RealTimeDialog : public QDialog {
  Q_OBJECT
public:
  explicit RealTimeDialog(const QualityPlan& plan, QWidget* parent = nullptr);
  QualityPlan plan() const;

private:
  void show(const QualityPlan& plan);
  void move(int by);
  void refresh();

  QListWidget* m_order;
  QPushButton *m_up, *m_down;
  QDoubleSpinBox *m_finest, *m_coarsest; ///< [%]
};

} // namespace esm
