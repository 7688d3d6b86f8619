// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "fuzzyeditor/why/why_source.h"

#include <optional>

namespace esm {

/// What the dock Why explains: the selected node or spring of the document, or with nothing selected the
/// tissue whose inputs are being edited.
class WhySelection : public WhySource {
  Q_OBJECT
public:
  /// @param document not owned, outlives this.
  explicit WhySelection(Document* document, QObject* parent = nullptr);

  void select(ExplainedThing thing); ///< Kind::Tissue: nothing is selected
  void selectNode(Index node);       ///< kNoIndex: nothing
  void selectSpring(Index spring);
  const ExplainedThing& selected() const noexcept { return m_thing; }

  const TissueField* field() const override { return m_document->tissueField(); }
  TissueExplanation explanation() const override;
  Language language() const override { return m_document->ruleLanguage(); }
  /// Sets the input of the base tissue or region, which then is the one that the inputs' panel shows.
  void apply(const InputChange& change) override;

private:
  void netChanged();

  Document* m_document;
  ExplainedThing m_thing;
  mutable std::optional<TissueExplainer> m_explainer; ///< of the present net, made when a place is asked for
};

} // namespace esm
