// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tissue/explain_text.h"
#include "fuzzyeditor/why/why_source.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QAction;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QToolButton;
class QTreeWidget;

namespace esm {

/// "Why is it stiff?": one sentence; the tree number <- geometry <- regions <- rules <- inputs, the largest
/// share and the strongest rule first; and what would make it softer or harder, each with a button that does
/// it. Follows the source once per turn of the event loop; hidden it asks nothing. GUI thread.
class WhyPanel : public QWidget {
  Q_OBJECT
public:
  /// @param source not owned, outlives this.
  explicit WhyPanel(WhySource* source, QWidget* parent = nullptr);

  double factor() const;                              ///< that is asked for, 0.8 for 20 % softer
  int explanations() const { return m_explanations; } ///< so that a test can prove the laziness

signals:
  void ruleActivated(int rule); ///< double click or Return, connect to RulesPanel::showRule

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  struct ChangeRow {
    QLabel* text;
    QPushButton* apply;
  };
  void build();
  void retranslate();
  void refresh();
  void refreshChanges();
  void showChanges();
  ChangeRow& changeRow(std::size_t row);
  QAction* addExport(const char* name, void (WhyPanel::*slot)());
  void copySentence();
  void copyCsv();
  void saveCsv();
  void saveJson();
  void save(const QString& filter, const QString& suffix, const std::string& bytes);

  WhySource* m_source;
  QTimer m_later;
  int m_explanations = 0;
  TissueExplanation m_why;
  ChangeList m_changes;
  bool m_known = false; ///< m_why is of the source's present tissue

  QLabel *m_sentence, *m_question, *m_noChange;
  QToolButton* m_menu;
  QAction *m_copySentence, *m_copyCsv, *m_saveJson, *m_saveCsv;
  QTreeWidget* m_tree;
  QSpinBox* m_percent;
  QComboBox* m_direction;
  QGridLayout* m_rows;
  std::vector<ChangeRow> m_changeRows;
};

} // namespace esm
