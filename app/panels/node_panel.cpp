// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/node_panel.h"

#include "app/error_text.h"

#include <QEvent>
#include <QLocale>

#include <algorithm>

namespace esm {

namespace {

QString number(double value, int digits = 3)
{
  return QLocale().toString(value, 'g', digits);
}

} // namespace

NodePanel::NodePanel(Document* document, QWidget* parent) : QLabel(parent), m_document(document)
{
  setObjectName(QStringLiteral("nodeWhy"));
  setTextFormat(Qt::RichText);
  setWordWrap(true);
  setMargin(6);
  setTextInteractionFlags(Qt::TextBrowserInteraction);
  connect(this, &QLabel::linkActivated, this, [this](const QString& region) {
    m_chosen = region.toInt();
    refresh();
  });
  connect(document, &Document::projectReset, this, [this] { setNode(kNoIndex); });
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
  m_chosen.reset();
  refresh();
}

void NodePanel::refresh()
{
  setAccessibleName(tr("Explanation of the selected node"));
  setVisible(m_node != kNoIndex);
  if (m_node == kNoIndex) {
    emit nothingSelected();
    return;
  }
  const Project& project = m_document->project();
  if (auto field = TissueField::create(project.tissue))
    showLayers(field->layersAt(project.net.restPosition.col(m_node)),
               field->at(project.net.restPosition.col(m_node)));
  else
    setText(errorText(field.error()).toHtmlEscaped());
}

QString NodePanel::shareName(const TissueLayer& share) const
{
  if (share.region < 0) return tr("Base tissue");
  return QString::fromStdString(
    m_document->project().tissue.regions[static_cast<std::size_t>(share.region)].name);
}

void NodePanel::showLayers(const std::vector<TissueLayer>& layers, const TissueParameters& parameters)
{
  const Project& project = m_document->project();
  const auto node = static_cast<std::size_t>(m_node);
  const Eigen::Vector3d place = project.net.restPosition.col(m_node);
  QString html = QStringLiteral("<b>%1</b>%2 (%3 / %4 / %5 mm)<br>")
                   .arg(tr("Node %1").arg(static_cast<int>(project.net.nodeId[node])),
                        project.net.fixed[node] != 0 ? tr(", held fast,") : QString(),
                        number(1e3 * place.x()), number(1e3 * place.y()), number(1e3 * place.z()));
  html += tr("Young's modulus %1 kPa, viscosity %2 ms, anchoring %3 kPa/mm")
            .arg(number(1e-3 * parameters.youngsModulus), number(1e3 * parameters.viscosity),
                 number(1e-6 * parameters.anchoring));

  const auto chosen = [this](const TissueLayer& share) { return m_chosen == share.region; };
  auto told = std::find_if(layers.begin(), layers.end(), chosen);
  if (told == layers.end())
    told = std::max_element(layers.begin(), layers.end(),
                            [](const TissueLayer& a, const TissueLayer& b) { return a.share < b.share; });
  QStringList parts;
  for (const TissueLayer& share : layers) {
    const QString name = shareName(share).toHtmlEscaped();
    const bool shown = share.region == told->region;
    parts << tr("%1 % from %2")
               .arg(number(100.0 * share.share),
                    shown ? QStringLiteral("<b>%1</b>").arg(name)
                          : QStringLiteral("<a href='%1'>%2</a>").arg(share.region).arg(name));
  }
  html += QStringLiteral("<br>") + parts.join(QStringLiteral(", "));
  if (!project.parametersFromTissue)
    html += QStringLiteral("<br><i>%1</i>").arg(tr("The springs keep the parameters of their file."));
  setText(html);
  if (told == layers.end()) return;
  emit explained(tr("Node %1, %2").arg(static_cast<int>(project.net.nodeId[node])).arg(shareName(*told)),
                 told->inference);
}

void NodePanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) refresh();
  QLabel::changeEvent(event);
}

} // namespace esm
