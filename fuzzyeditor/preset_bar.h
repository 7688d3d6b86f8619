// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tissue/presets.h"
#include "fuzzyeditor/fuzzy_document.h"

#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace esm {

/// Tissues to start from, above the inputs: a menu, which of them the inputs are now, what is measured of it
/// (with method, source and what is only an estimate), and all inputs back to their defaults. Choosing is one
/// undo step; inputs that a preset does not speak of, the organ's bed, stay as they are.
class PresetBar : public QWidget {
  Q_OBJECT
public:
  explicit PresetBar(FuzzyDocument* document, QWidget* parent = nullptr);

  void retranslate();
  /// What is known of a tissue as rich text: a table of value, range, method and source.
  static QString measurements(const TissuePreset& preset, Language language);

protected:
  void showEvent(QShowEvent* event) override;

private:
  /// The inputs of a preset in the rule base of now; empty if the rule base lacks its words.
  using Values = std::vector<std::pair<std::size_t, fuzzy::InputValue>>;
  void followRuleBase();
  void readPresets();
  void showCurrent();
  void apply(const TissuePreset& preset);
  void resetInputs();
  const TissuePreset* current() const;

  FuzzyDocument* m_document;
  QToolButton *m_choose, *m_info, *m_reset;
  QMenu* m_menu;
  QLabel *m_current, *m_details;
  std::vector<QAction*> m_actions;             ///< one per preset
  std::vector<std::optional<Values>> m_values; ///< one per preset
  bool m_stale = true;                         ///< the rule base changed since they were read
};

} // namespace esm
