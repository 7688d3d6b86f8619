// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/haptics/user_profile.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QDoubleSpinBox;

namespace esm {

/// Asks for what a stick or wheel cannot tell: its newtons, its sense, and where its middle is.
/// @note GUI thread.
class CalibrateDialog : public QDialog {
  Q_OBJECT
public:
  explicit CalibrateDialog(const StickCalibration& before, QWidget* parent = nullptr);
  StickCalibration calibration() const;

private:
  QDoubleSpinBox* m_newtons;
  QCheckBox *m_across, *m_along;
  std::array<QDoubleSpinBox*, 3> m_origin; ///< [mm]
};

} // namespace esm
