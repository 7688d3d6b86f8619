// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QLabel>

#include <optional>

namespace esm {

/// The upper part of the dock Why: the selected node, the tissue's parameters at its rest place and whose
/// tissue it is by how much. The share that is chosen (first the largest) is explained by its rules below;
/// each name is a link that chooses it.
class NodePanel : public QLabel {
  Q_OBJECT
public:
  explicit NodePanel(Document* document, QWidget* parent = nullptr);
  void setNode(Index node); ///< kNoIndex: none, the panel hides
  Index node() const noexcept { return m_node; }

signals:
  /// The rules' account of the chosen share; `place` is its heading.
  void explained(const QString& place, const esm::fuzzy::Inference& inference);
  void nothingSelected();

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  void showLayers(const std::vector<TissueLayer>& layers, const TissueParameters& parameters);
  QString shareName(const TissueLayer& share) const;

  Document* m_document;
  Index m_node = kNoIndex;
  std::optional<int> m_chosen; ///< region of the share, -1 the base tissue; empty: the largest share
};

} // namespace esm
