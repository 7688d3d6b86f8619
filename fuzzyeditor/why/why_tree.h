// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tissue/explain.h"

#include <QCoreApplication>
#include <QString>

#include <optional>
#include <vector>

class QTreeWidget;

namespace esm {

/// The chain of an explanation as rows of a tree.
struct WhyRow {
  QString key; ///< the same for the same reason at the next explanation: what is unfolded stays so
  QString what, value, help;
  std::optional<double> share; ///< of a region, or a rule's degree: drawn as a bar
  int rule = -1;
  bool open = false; ///< unfolded when it is new
  std::vector<WhyRow> children;
};

class WhyTree {
  Q_DECLARE_TR_FUNCTIONS(esm::WhyTree)
public:
  enum Column { What, Share, Value };
  static constexpr int kRuleRole = Qt::UserRole + 1, kShareRole = Qt::UserRole + 2;

  static std::vector<WhyRow> rows(const TissueExplanation& why, const TissueModel& model, Language language);
  /// Puts the rows into the tree. Items with a key that was there before are reused: a slider drag comes
  /// here sixty times a second.
  static void show(const std::vector<WhyRow>& rows, QTreeWidget* tree);

private:
  static std::vector<WhyRow> valueRows(const TissueExplanation& why, Language language);
  static WhyRow placeRow(const TissueExplanation& why, Language language);
  static WhyRow outputRow(const LayerReason& layer, const OutputReason& output, const TissueModel& model,
                          Language language, bool open);
};

} // namespace esm
