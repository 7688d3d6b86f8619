// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QWidget>

class QTextBrowser;

namespace esm {

/// Why the tissue is as it is at the selected node: parameters there, the regions' shares, and the rules that
/// led to them, in words. Part of the dock Why.
class NodePanel : public QWidget {
  Q_OBJECT
public:
  explicit NodePanel(Document* document, QWidget* parent = nullptr);
  void setNode(Index node); ///< kNoIndex: none
  Index node() const noexcept { return m_node; }

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  QString sentence() const;

  Document* m_document;
  QTextBrowser* m_text;
  Index m_node = kNoIndex;
};

} // namespace esm
