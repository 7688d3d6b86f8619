// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/regions_panel.h"

#include "app/icons.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr double kMetre = 1000.0; // [mm]
constexpr double kDegree = 180.0 / std::numbers::pi;

QToolButton* toolButton(Symbol symbol, const QString& name, QWidget* parent)
{
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setIcon(icon(symbol));
  button->setAutoRaise(true);
  return button;
}

void describe(QWidget* widget, const QString& text)
{
  widget->setAccessibleName(text);
  widget->setToolTip(text);
}

} // namespace

Eigen::Vector3d turnsOf(const Eigen::Quaterniond& rotation)
{
  const Eigen::Matrix3d r = rotation.toRotationMatrix();
  return kDegree * Eigen::Vector3d(std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
                                   std::atan2(r(1, 0), r(0, 0)));
}

Eigen::Quaterniond rotationOf(const Eigen::Vector3d& turns)
{
  const Eigen::Vector3d angle = turns / kDegree;
  return Eigen::AngleAxisd(angle.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angle.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angle.x(), Eigen::Vector3d::UnitX());
}

RegionsPanel::RegionsPanel(Document* document, QWidget* parent) : QWidget(parent), m_document(document)
{
  buildList();
  buildFields();
  connect(document, &Document::projectReset, this, &RegionsPanel::refreshList);
  connect(document, &Document::regionsChanged, this, &RegionsPanel::refreshList);
  connect(document, &Document::inputTargetChanged, this, &RegionsPanel::refreshList);
  connect(document, &Document::netChanged, this, &RegionsPanel::refreshCount);
  retranslateUi();
}

void RegionsPanel::buildList()
{
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("regionsList"));
  m_list->setMinimumHeight(70);
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!m_refreshing && row >= 0) m_document->setInputTarget(row - 1); // row 0 is the base tissue
  });
  connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    const int index = m_list->row(item) - 1;
    if (m_refreshing || index < 0) return;
    Region region = m_document->project().tissue.regions[static_cast<std::size_t>(index)];
    region.enabled = item->checkState() == Qt::Checked;
    const QString what = region.enabled ? tr("switch region on") : tr("switch region off");
    m_document->setRegion(index, std::move(region), what);
  });

  m_add = toolButton(Symbol::Plus, QStringLiteral("regionAdd"), this);
  m_copy = toolButton(Symbol::Copy, QStringLiteral("regionDuplicate"), this);
  m_remove = toolButton(Symbol::Minus, QStringLiteral("regionRemove"), this);
  m_up = toolButton(Symbol::Up, QStringLiteral("regionUp"), this);
  m_down = toolButton(Symbol::Down, QStringLiteral("regionDown"), this);
  connect(m_add, &QToolButton::clicked, this, &RegionsPanel::addRegion);
  connect(m_copy, &QToolButton::clicked, this, [this] {
    if (const Region* region = currentRegion()) {
      Region copy = *region;
      copy.name = tr("%1 copy").arg(QString::fromStdString(copy.name)).toStdString();
      m_document->addRegion(std::move(copy));
    }
  });
  connect(m_remove, &QToolButton::clicked, this, [this] { m_document->removeRegion(current()); });
  connect(m_up, &QToolButton::clicked, this, [this] { m_document->moveRegion(current(), current() - 1); });
  connect(m_down, &QToolButton::clicked, this, [this] { m_document->moveRegion(current(), current() + 1); });
}

void RegionsPanel::buildFields()
{
  m_fields = new QWidget(this);
  auto* grid = new QGridLayout(m_fields);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);

  m_name = new QLineEdit(m_fields);
  m_name->setObjectName(QStringLiteral("regionName"));
  connect(m_name, &QLineEdit::editingFinished, this, [this] {
    const Region* region = currentRegion();
    if (region == nullptr || m_name->text().trimmed().isEmpty()) return refreshFields();
    if (m_name->text().toStdString() == region->name) return;
    Region renamed = *region;
    renamed.name = m_name->text().trimmed().toStdString();
    m_document->setRegion(current(), std::move(renamed), tr("rename region"));
  });

  for (int i = 0; i < kFieldCount; ++i) {
    static const char* const kNames[] = {"regionCentreX", "regionCentreY", "regionCentreZ", "regionAxisX",
                                         "regionAxisY",   "regionAxisZ",   "regionTurnX",   "regionTurnY",
                                         "regionTurnZ",   "regionFalloff"};
    auto* number = new GestureSpinBox(m_fields);
    m_numbers[static_cast<std::size_t>(i)] = number;
    number->setObjectName(QLatin1String(kNames[i]));
    number->setButtonSymbols(i == Falloff ? QAbstractSpinBox::UpDownArrows : QAbstractSpinBox::NoButtons);
    number->setMinimumWidth(58);
    number->setDecimals(i >= TurnX ? 0 : 1);
    if (i <= CentreZ)
      number->setRange(-5000.0, 5000.0);
    else if (i <= AxisZ)
      number->setRange(0.1, 5000.0);
    else if (i <= TurnZ)
      number->setRange(-180.0, 180.0);
    else
      number->setRange(0.0, 100.0);
    number->setSingleStep(i >= TurnX ? 5.0 : 1.0);
    connect(number, &GestureSpinBox::edited, this,
            [this, i](double value, int gesture) { editNumber(i, value, gesture); });
  }

  const auto label = [this] { return new QLabel(m_fields); };
  m_nameLabel = label(), m_centreLabel = label(), m_axesLabel = label(), m_turnLabel = label();
  m_falloffLabel = label();
  m_nameLabel->setBuddy(m_name);
  grid->addWidget(m_nameLabel, 0, 0);
  grid->addWidget(m_name, 0, 1, 1, 3);
  QLabel* const rows[] = {m_centreLabel, m_axesLabel, m_turnLabel};
  for (int row = 0; row < 3; ++row) {
    grid->addWidget(rows[row], row + 1, 0);
    for (int axis = 0; axis < 3; ++axis)
      grid->addWidget(m_numbers[static_cast<std::size_t>(3 * row + axis)], row + 1, axis + 1);
  }
  grid->addWidget(m_falloffLabel, 4, 0);
  grid->addWidget(m_numbers[Falloff], 4, 1);
  m_count = new QLabel(m_fields);
  m_count->setObjectName(QStringLiteral("regionSpringCount"));
  grid->addWidget(m_count, 4, 2, 1, 2);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(2);
  for (QToolButton* button : {m_add, m_copy, m_remove, m_up, m_down}) buttons->addWidget(button);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(m_list, 1);
  layout->addLayout(buttons);
  layout->addWidget(m_fields);
}

const Region* RegionsPanel::currentRegion() const
{
  const auto& regions = m_document->project().tissue.regions;
  return current() < 0 ? nullptr : &regions[static_cast<std::size_t>(current())];
}

void RegionsPanel::editNumber(int field, double value, int gesture)
{
  const Region* before = currentRegion();
  if (m_refreshing || before == nullptr) return;
  Region region = *before;
  QString what;
  if (field <= CentreZ) {
    region.ellipsoid.centre[field] = value / kMetre;
    what = tr("move region");
  } else if (field <= AxisZ) {
    region.ellipsoid.semiAxes[field - AxisX] = value / kMetre;
    what = tr("resize region");
  } else if (field <= TurnZ) {
    Eigen::Vector3d turns = turnsOf(region.ellipsoid.rotation);
    turns[field - TurnX] = value;
    region.ellipsoid.rotation = rotationOf(turns);
    what = tr("turn region");
  } else {
    region.falloff = value / 100.0;
    what = tr("change falloff");
  }
  m_document->setRegion(current(), std::move(region), what, gesture);
}

/// In the middle of the selected node or of the model, sized after the model; with the base tissue's inputs.
Region RegionsPanel::newRegion() const
{
  const Project& project = m_document->project();
  Region region;
  region.name = tr("Region %1").arg(project.tissue.regions.size() + 1).toStdString();
  region.inputs = project.tissue.inputs;
  const Eigen::Matrix3Xd& nodes = project.net.restPosition;
  if (nodes.cols() == 0) return region;
  const Eigen::Vector3d low = nodes.rowwise().minCoeff(), high = nodes.rowwise().maxCoeff();
  const double radius = std::max(0.18 * (high - low).norm(), 1e-3);
  region.ellipsoid.centre = m_placeOfNew.value_or(0.5 * (low + high));
  region.ellipsoid.semiAxes.setConstant(std::round(radius * kMetre) / kMetre);
  return region;
}

void RegionsPanel::addRegion()
{
  m_document->addRegion(newRegion());
}

void RegionsPanel::refreshList()
{
  m_refreshing = true;
  const auto& regions = m_document->project().tissue.regions;
  // Rows are kept where possible: this may run inside a signal of the row itself.
  const int rows = static_cast<int>(regions.size()) + 1;
  while (m_list->count() > rows) delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < rows) m_list->addItem(QString());
  m_list->item(0)->setText(tr("Base tissue"));
  for (int row = 1; row < rows; ++row) {
    const Region& region = regions[static_cast<std::size_t>(row - 1)];
    QListWidgetItem* item = m_list->item(row);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setText(QString::fromStdString(region.name));
    item->setCheckState(region.enabled ? Qt::Checked : Qt::Unchecked);
  }
  m_list->setCurrentRow(current() + 1);
  m_refreshing = false;
  refreshFields();
}

void RegionsPanel::refreshFields()
{
  const Region* region = currentRegion();
  const int last = static_cast<int>(m_document->project().tissue.regions.size()) - 1;
  m_copy->setEnabled(region != nullptr);
  m_remove->setEnabled(region != nullptr);
  m_up->setEnabled(current() > 0);
  m_down->setEnabled(region != nullptr && current() < last);
  m_fields->setEnabled(region != nullptr);
  m_name->setText(region != nullptr ? QString::fromStdString(region->name) : QString());
  refreshCount();
  if (region == nullptr) return;

  const Eigen::Vector3d turns = turnsOf(region->ellipsoid.rotation);
  for (int axis = 0; axis < 3; ++axis) {
    m_numbers[static_cast<std::size_t>(CentreX + axis)]->display(region->ellipsoid.centre[axis] * kMetre);
    m_numbers[static_cast<std::size_t>(AxisX + axis)]->display(region->ellipsoid.semiAxes[axis] * kMetre);
    m_numbers[static_cast<std::size_t>(TurnX + axis)]->display(turns[axis]);
  }
  m_numbers[Falloff]->display(region->falloff * 100.0);
}

/// A spring belongs to the region when its midpoint at rest does: so does core/tissue count.
void RegionsPanel::refreshCount()
{
  const Region* region = currentRegion();
  if (region == nullptr) return m_count->clear();
  const SpringNet& net = m_document->project().net;
  int inside = 0;
  for (Index s = 0; s < net.springCount(); ++s) {
    const Eigen::Vector3d middle =
      0.5 * (net.restPosition.col(net.ends(0, s)) + net.restPosition.col(net.ends(1, s)));
    if (region->ellipsoid.radius(middle) < 1.0) ++inside;
  }
  m_count->setText(tr("%n spring(s)", nullptr, inside));
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
  describe(m_copy, tr("Duplicate region"));
  describe(m_remove, tr("Remove region"));
  describe(m_up, tr("Move region up"));
  describe(m_down, tr("Move region down"));
  describe(m_name, tr("Name of the region"));
  m_nameLabel->setText(tr("Name"));
  m_centreLabel->setText(tr("Centre [mm]"));
  m_axesLabel->setText(tr("Semi-axes [mm]"));
  m_turnLabel->setText(tr("Rotation [°]"));
  m_falloffLabel->setText(tr("Falloff"));
  const QString axes[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    describe(m_numbers[CentreX + axis], tr("Centre %1 in mm").arg(axes[axis]));
    describe(m_numbers[AxisX + axis], tr("Semi-axis %1 in mm").arg(axes[axis]));
    describe(m_numbers[TurnX + axis], tr("Rotation about %1 in degrees").arg(axes[axis]));
  }
  for (GestureSpinBox* number : m_numbers) number->setLocale(QLocale());
  m_numbers[Falloff]->setSuffix(QStringLiteral(" %"));
  describe(m_numbers[Falloff], tr("Share of the radius over which the region fades out"));
  describe(m_count, tr("Springs that the region affects"));
  refreshList();
}

} // namespace esm
