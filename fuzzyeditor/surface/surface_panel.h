// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QTabWidget;

namespace esm {

class FuzzyEvaluation;
class SurfacePlot;
class SurfaceSource;

/// The control surface: which result over which two inputs, as a map and as a table. Hidden it computes
/// nothing.
class SurfacePanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this.
  explicit SurfacePanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  SurfaceSource* source() const { return m_source; }
  SurfacePlot* plot() const { return m_plot; }

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void fillChoices();
  void ask();
  void choose(QComboBox* changed);

  FuzzyEvaluation* m_evaluation;
  SurfaceSource* m_source;
  QComboBox *m_output, *m_x, *m_y;
  QLabel *m_over, *m_and;
  SurfacePlot* m_plot;
  QTabWidget* m_tabs;
};

} // namespace esm
