// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/node_panel.h"

#include "app/error_text.h"

#include <QEvent>
#include <QLocale>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

QString number(double value, int digits = 3)
{
  return QLocale().toString(value, 'g', digits);
}

/// The rules that fired, strongest first, as list items.
QString firingItems(const fuzzy::RuleBase& rules, fuzzy::Inference inference, Language language)
{
  std::stable_sort(inference.firings.begin(), inference.firings.end(),
                   [](const auto& a, const auto& b) { return a.degree > b.degree; });
  QString items;
  for (const fuzzy::RuleFiring& firing : inference.firings) {
    if (firing.degree <= 0.0) break;
    const std::string text =
      fuzzy::formatRule(rules.rules[static_cast<std::size_t>(firing.rule)], rules, language);
    items += QStringLiteral("<li><b>%1</b> · %2</li>")
               .arg(number(firing.degree, 2), QString::fromStdString(text).toHtmlEscaped());
  }
  return items;
}

} // namespace

NodePanel::NodePanel(Document* document, QWidget* parent)
  : QWidget(parent), m_document(document), m_text(new QTextBrowser(this))
{
  m_text->setObjectName(QStringLiteral("nodeWhy"));
  m_text->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_text);
  const auto forget = [this] { setNode(kNoIndex); }; // another net has other nodes
  connect(document, &Document::projectReset, this, forget);
  connect(document, &Document::netChanged, this, [this] {
    if (m_node >= m_document->project().net.nodeCount()) m_node = kNoIndex;
    refresh();
  });
  connect(document, &Document::parametersChanged, this, &NodePanel::refresh);
  connect(document, &Document::regionsChanged, this, &NodePanel::refresh);
  connect(document, &Document::ruleLanguageChanged, this, &NodePanel::refresh);
  refresh();
}

void NodePanel::setNode(Index node)
{
  m_node = node;
  refresh();
}

void NodePanel::refresh()
{
  m_text->setAccessibleName(tr("Explanation of the selected node"));
  setVisible(m_node != kNoIndex);
  if (m_node != kNoIndex) m_text->setHtml(sentence());
}

QString NodePanel::sentence() const
{
  const Project& project = m_document->project();
  const Eigen::Vector3d place = project.net.restPosition.col(m_node);
  auto field = TissueField::create(project.tissue);
  if (!field) return errorText(field.error()).toHtmlEscaped();
  const Explanation why = field->explain(place);

  const bool fixed = project.net.fixed[static_cast<std::size_t>(m_node)] != 0;
  QString html =
    QStringLiteral("<p><b>%1</b>%2 (%3 / %4 / %5 mm)</p>")
      .arg(tr("Node %1").arg(static_cast<int>(project.net.nodeId[static_cast<std::size_t>(m_node)])),
           fixed ? tr(", held fast,") : QString(), number(1e3 * place.x()), number(1e3 * place.y()),
           number(1e3 * place.z()));
  html += QStringLiteral("<p>%1</p>")
            .arg(tr("Young's modulus %1 kPa, viscosity %2 ms, anchoring %3 kPa/mm")
                   .arg(number(1e-3 * why.parameters.youngsModulus), number(1e3 * why.parameters.viscosity),
                        number(1e-6 * why.parameters.anchoring)));
  for (std::size_t i = 0; i < why.shares.size(); ++i) {
    const RegionShare& share = why.shares[i];
    const QString name =
      share.region < 0
        ? tr("Base tissue")
        : QString::fromStdString(project.tissue.regions[static_cast<std::size_t>(share.region)].name);
    const QString rules = firingItems(project.tissue.rules, why.inferences[i], m_document->ruleLanguage());
    html +=
      QStringLiteral("<p style='margin-bottom:0'>%1</p><ul style='margin-top:2px'>%2</ul>")
        .arg(tr("%1 % from “%2”, because of these rules:")
               .arg(number(100.0 * share.weight), name.toHtmlEscaped()),
             rules.isEmpty() ? QStringLiteral("<li>%1</li>").arg(tr("no rule fired, defaults hold")) : rules);
  }
  if (!project.parametersFromTissue)
    html += QStringLiteral("<p><i>%1</i></p>").arg(tr("The springs keep the parameters of their file."));
  return html;
}

void NodePanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) refresh();
  QWidget::changeEvent(event);
}

} // namespace esm
