// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/regions_panel.h"

#include "app/icons.h"
#include "app/panels/describe.h"
#include "app/panels/region_list.h"
#include "core/geometry/extent.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace esm {

RegionsPanel::RegionsPanel(Document* document, QWidget* parent) : QWidget(parent), m_document(document)
{
  buildList();
  buildButtons();
  m_fields = new RegionFields(document);
  m_scroll = new QScrollArea(this);
  m_scroll->setObjectName(QStringLiteral("regionFieldsArea"));
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setWidgetResizable(true);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_scroll->setFocusPolicy(Qt::NoFocus);
  m_scroll->setWidget(m_fields);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(0);
  for (QToolButton* each : {m_add, m_fromSelection, m_copy, m_remove, m_up, m_down}) buttons->addWidget(each);
  buttons->addStretch();
  for (QToolButton* each : {m_visible, m_locked}) buttons->addWidget(each);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_list, 1);
  layout->addLayout(buttons);
  layout->addWidget(m_scroll, 3);

  connect(document, &Document::projectReset, this, &RegionsPanel::refresh);
  connect(document, &Document::regionsChanged, this, &RegionsPanel::refresh);
  connect(document, &Document::inputTargetChanged, this, &RegionsPanel::refresh);
  connect(document, &Document::netChanged, m_fields, &RegionFields::refreshCount);
  retranslateUi();
}

void RegionsPanel::buildList()
{
  m_list = new RegionList(this);
  m_list->setObjectName(QStringLiteral("regionsList"));
  m_list->setMinimumHeight(70);
  connect(m_list, &RegionList::chosen, m_document, &Document::setInputTarget);
  connect(m_list, &RegionList::visibleAsked, m_document, &Document::showRegion);
  connect(m_list, &RegionList::lockAsked, m_document, &Document::lockRegion);
  connect(m_list, &RegionList::moveAsked, m_document, &Document::moveRegion);
  connect(m_list, &RegionList::enabledAsked, this, [this](int index, bool on) {
    Region region = m_document->project().tissue.regions[static_cast<std::size_t>(index)];
    region.enabled = on;
    m_document->setRegion(index, std::move(region), on ? tr("switch region on") : tr("switch region off"));
  });
}

QToolButton* RegionsPanel::button(const char* name)
{
  auto* made = new QToolButton(this);
  made->setObjectName(QLatin1String(name));
  made->setAutoRaise(true);
  return made;
}

void RegionsPanel::buildButtons()
{
  const auto action = [this](const char* name, Symbol symbol, auto slot) {
    QToolButton* made = button(name);
    made->setIcon(icon(symbol));
    connect(made, &QToolButton::clicked, this, slot);
    return made;
  };
  m_add = action("regionAdd", Symbol::Plus, &RegionsPanel::addRegion);
  m_fromSelection = action("regionFromSelection", Symbol::FromSelection, &RegionsPanel::addFromSelection);
  m_copy = action("regionDuplicate", Symbol::Copy, &RegionsPanel::duplicate);
  m_remove = action("regionRemove", Symbol::Minus, [this] { m_document->removeRegion(current()); });
  m_up = action("regionUp", Symbol::Up, [this] { m_document->moveRegion(current(), current() - 1); });
  m_down = action("regionDown", Symbol::Down, [this] { m_document->moveRegion(current(), current() + 1); });
  m_visible = action("regionVisible", Symbol::Eye,
                     [this] { m_document->showRegion(current(), m_visible->isChecked()); });
  m_locked = action("regionLocked", Symbol::LockOpen,
                    [this] { m_document->lockRegion(current(), m_locked->isChecked()); });
  m_visible->setCheckable(true);
  m_locked->setCheckable(true);
}

const Region* RegionsPanel::currentRegion() const
{
  const auto& regions = m_document->project().tissue.regions;
  return current() < 0 ? nullptr : &regions[static_cast<std::size_t>(current())];
}

/// In the middle of the picked node or of the model, sized after the model; with the base tissue's inputs.
Region RegionsPanel::newRegion() const
{
  const Project& project = m_document->project();
  Region region;
  region.name = tr("Region %1").arg(project.tissue.regions.size() + 1).toStdString();
  region.inputs = project.tissue.inputs;
  const Eigen::Matrix3Xd& nodes = project.net.restPosition;
  if (nodes.cols() == 0) return region;
  const double radius = std::max(0.18 * extentOf(nodes), 1e-3);
  region.ellipsoid.centre = m_placeOfNew.value_or(boxOf(nodes).center());
  region.ellipsoid.semiAxes.setConstant(std::round(radius * kMillimetresPerMetre) /
                                        kMillimetresPerMetre); // a round number of mm
  return region;
}

void RegionsPanel::addRegion()
{
  m_document->addRegion(newRegion());
}

/// Around the selected nodes at rest, so that all of them have weight 1.
void RegionsPanel::addFromSelection()
{
  const SpringNet& net = m_document->project().net;
  if (m_selection.empty() || net.springCount() == 0) return;
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(m_selection.size()));
  for (std::size_t i = 0; i < m_selection.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = net.restPosition.col(m_selection[i]);
  // Nodes of a flat patch do not spread across it: half a spring reaches to both its sides.
  const double least = std::max(0.5 * net.restLength.mean(), GizmoDrag::kLeastSemiAxis);
  Region region = newRegion();
  const auto fitted = fitEllipsoid(places, least, region.falloff);
  if (!fitted) {
    emit m_document->problem(fitted.error());
    return;
  }
  region.ellipsoid = fitted.value();
  m_document->addRegion(std::move(region));
}

void RegionsPanel::duplicate()
{
  const Region* region = currentRegion();
  if (region == nullptr) return;
  Region copy = *region;
  copy.name = tr("%1 copy").arg(QString::fromStdString(copy.name)).toStdString();
  copy.locked = false;
  m_document->addRegion(std::move(copy));
}

void RegionsPanel::setSelection(const std::vector<Index>& nodes)
{
  m_selection = nodes;
  m_fromSelection->setEnabled(!m_selection.empty());
}

void RegionsPanel::refresh()
{
  const auto& regions = m_document->project().tissue.regions;
  m_list->show(regions, tr("Base tissue"), current());
  const Region* region = currentRegion();
  const bool free = region != nullptr && !region->locked;
  m_copy->setEnabled(region != nullptr);
  m_remove->setEnabled(free);
  m_up->setEnabled(free && current() > 0);
  m_down->setEnabled(free && current() + 1 < static_cast<int>(regions.size()));
  m_visible->setEnabled(region != nullptr);
  m_locked->setEnabled(region != nullptr);
  m_visible->setChecked(region == nullptr || region->visible);
  m_locked->setChecked(region != nullptr && region->locked);
  m_visible->setIcon(icon(m_visible->isChecked() ? Symbol::Eye : Symbol::EyeShut));
  m_locked->setIcon(icon(m_locked->isChecked() ? Symbol::Lock : Symbol::LockOpen));
  m_fields->refresh();
}

void RegionsPanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void RegionsPanel::retranslateUi()
{
  describe(m_list, tr("Regions, later ones cover earlier ones"));
  describe(m_add, tr("Add region"));
  describe(m_fromSelection, tr("Add a region around the selected nodes"));
  describe(m_copy, tr("Duplicate region"));
  describe(m_remove, tr("Remove region"));
  describe(m_up, tr("Move region up"));
  describe(m_down, tr("Move region down"));
  describe(m_visible, tr("Show the region in the preview"));
  describe(m_locked, tr("Lock the region against changes"));
  m_fromSelection->setEnabled(!m_selection.empty());
  refresh();
  // The fields may scroll up and down, but are never cut off at their side.
  m_scroll->setMinimumWidth(m_fields->minimumSizeHint().width() +
                            style()->pixelMetric(QStyle::PM_ScrollBarExtent));
}

} // namespace esm
