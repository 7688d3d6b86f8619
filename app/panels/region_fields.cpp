// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/region_fields.h"

#include "app/panels/describe.h"
#include "app/panels/falloff_curve.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;
constexpr int kNoMirror = 0, kOwnPlane = 4; ///< rows of the choice; between them the planes x, y and z

/// The row that shows a mirror.
int mirrorChoice(const std::optional<MirrorPlane>& mirror)
{
  if (!mirror) return kNoMirror;
  for (int axis = 0; axis < 3; ++axis)
    if (mirror->normal[(axis + 1) % 3] == 0.0 && mirror->normal[(axis + 2) % 3] == 0.0) return axis + 1;
  return kOwnPlane;
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

RegionFields::RegionFields(Document* document, QWidget* parent) : QWidget(parent), m_document(document)
{
  m_name = new QLineEdit(this);
  m_name->setObjectName(QStringLiteral("regionName"));
  connect(m_name, &QLineEdit::editingFinished, this, &RegionFields::rename);
  buildNumbers();
  buildChoices();
  buildLayout();
  retranslateUi();
}

void RegionFields::buildNumbers()
{
  static const char* const kNames[kFieldCount] = {
    "regionCentreX", "regionCentreY", "regionCentreZ", "regionAxisX",   "regionAxisY",   "regionAxisZ",
    "regionTurnX",   "regionTurnY",   "regionTurnZ",   "regionFalloff", "regionMirrorAt"};
  for (int i = 0; i < kFieldCount; ++i) {
    auto* number = new GestureSpinBox(this);
    m_numbers[static_cast<std::size_t>(i)] = number;
    number->setObjectName(QLatin1String(kNames[i]));
    number->setButtonSymbols(i == Falloff ? QAbstractSpinBox::UpDownArrows : QAbstractSpinBox::NoButtons);
    number->setMinimumWidth(46);
    number->setDecimals(i == Falloff ? 0 : 1);
    if (i >= AxisX && i <= AxisZ)
      number->setRange(GizmoDrag::kLeastSemiAxis * kMillimetresPerMetre,
                       GizmoDrag::kLargestSemiAxis * kMillimetresPerMetre);
    else if (i >= TurnX && i <= TurnZ)
      number->setRange(-180.0, 180.0);
    else if (i == Falloff)
      number->setRange(0.0, 100.0);
    else
      number->setRange(-5000.0, 5000.0);
    number->setSingleStep(i >= TurnX && i <= Falloff ? 5.0 : 1.0);
    connect(number, &GestureSpinBox::edited, this,
            [this, i](double value, int gesture) { editNumber(i, value, gesture); });
  }
}

void RegionFields::buildChoices()
{
  m_profile = new QComboBox(this);
  m_profile->setObjectName(QStringLiteral("regionProfile"));
  m_profile->setMinimumContentsLength(6);
  m_profile->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (const FalloffProfile profile :
       {FalloffProfile::Smooth, FalloffProfile::Linear, FalloffProfile::Smoother})
    m_profile->addItem(QString(), static_cast<int>(profile));
  connect(m_profile, &QComboBox::activated, this, [this](int row) {
    const auto profile = static_cast<FalloffProfile>(m_profile->itemData(row).toInt());
    edit(tr("change profile"), [profile](Region& region) { region.profile = profile; });
  });
  m_insideOut = new QCheckBox(this);
  m_insideOut->setObjectName(QStringLiteral("regionInsideOut"));
  connect(m_insideOut, &QCheckBox::clicked, this, [this](bool on) {
    edit(tr("turn region inside out"), [on](Region& region) { region.insideOut = on; });
  });
  m_mirror = new QComboBox(this);
  m_mirror->setObjectName(QStringLiteral("regionMirror"));
  m_mirror->setMinimumContentsLength(6);
  m_mirror->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (int row = kNoMirror; row < kOwnPlane; ++row) m_mirror->addItem(QString());
  connect(m_mirror, &QComboBox::activated, this, &RegionFields::editMirror);
  m_detach = new QPushButton(this);
  m_detach->setObjectName(QStringLiteral("regionDetachTwin"));
  connect(m_detach, &QPushButton::clicked, this,
          [this] { m_document->detachTwin(m_document->inputTarget()); });
}

void RegionFields::buildLayout()
{
  for (QLabel** label : {&m_nameLabel, &m_centreLabel, &m_axesLabel, &m_turnLabel, &m_falloffLabel,
                         &m_weightLabel, &m_mirrorLabel, &m_count})
    *label = new QLabel(this);
  m_nameLabel->setBuddy(m_name);
  m_count->setObjectName(QStringLiteral("regionSpringCount"));
  m_curve = new FalloffCurve(this);
  m_curve->setObjectName(QStringLiteral("regionWeightCurve"));

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);
  grid->addWidget(m_nameLabel, 0, 0);
  grid->addWidget(m_name, 0, 1, 1, 3);
  QLabel* const rows[] = {m_centreLabel, m_axesLabel, m_turnLabel};
  for (int row = 0, number = 0; row < 3; ++row) {
    grid->addWidget(rows[row], row + 1, 0);
    for (int axis = 0; axis < 3; ++axis, ++number)
      grid->addWidget(m_numbers[static_cast<std::size_t>(number)], row + 1, axis + 1);
  }
  grid->addWidget(m_falloffLabel, 4, 0);
  grid->addWidget(m_numbers[Falloff], 4, 1);
  grid->addWidget(m_profile, 4, 2, 1, 2);
  grid->addWidget(m_weightLabel, 5, 0);
  grid->addWidget(m_curve, 5, 1, 1, 3);
  grid->addWidget(m_insideOut, 6, 0, 1, 2);
  grid->addWidget(m_count, 6, 2, 1, 2);
  grid->addWidget(m_mirrorLabel, 7, 0);
  grid->addWidget(m_mirror, 7, 1, 1, 2);
  grid->addWidget(m_numbers[MirrorAt], 7, 3);
  grid->addWidget(m_detach, 8, 0, 1, 4);
}

// === Edits

const Region* RegionFields::region() const
{
  const int chosen = m_document->inputTarget();
  return chosen < 0 ? nullptr : &m_document->project().tissue.regions[static_cast<std::size_t>(chosen)];
}

template <class Change>
void RegionFields::edit(const QString& what, Change&& change, int gesture)
{
  const Region* before = region();
  if (m_refreshing || before == nullptr) return;
  Region after = *before;
  change(after);
  m_document->setRegion(m_document->inputTarget(), std::move(after), what, gesture);
}

void RegionFields::rename()
{
  const std::string name = m_name->text().trimmed().toStdString();
  if (name.empty()) return refresh();
  edit(tr("rename region"), [&name](Region& region) { region.name = name; });
}

void RegionFields::editNumber(int field, double value, int gesture)
{
  if (field <= CentreZ)
    edit(
      tr("move region"),
      [=](Region& region) { region.ellipsoid.centre[field] = value / kMillimetresPerMetre; }, gesture);
  else if (field <= AxisZ)
    edit(
      tr("resize region"),
      [=](Region& region) { region.ellipsoid.semiAxes[field - AxisX] = value / kMillimetresPerMetre; },
      gesture);
  else if (field <= TurnZ)
    edit(
      tr("turn region"),
      [=](Region& region) {
        Eigen::Vector3d turns = turnsOf(region.ellipsoid.rotation);
        turns[field - TurnX] = value;
        region.ellipsoid.rotation = rotationOf(turns);
      },
      gesture);
  else if (field == Falloff)
    edit(
      tr("change falloff"), [=](Region& region) { region.falloff = value / 100.0; }, gesture);
  else
    edit(
      tr("move mirror plane"),
      [=](Region& region) {
        const int axis = mirrorChoice(region.mirror) - 1;
        if (axis >= 0 && axis < 3) region.mirror->point[axis] = value / kMillimetresPerMetre;
      },
      gesture);
}

/// A plane begins in the middle of the model.
void RegionFields::editMirror(int choice)
{
  if (choice == kOwnPlane || region() == nullptr || choice == mirrorChoice(region()->mirror)) return;
  const Eigen::Matrix3Xd& nodes = m_document->project().net.restPosition;
  edit(tr("mirror region"), [&](Region& region) {
    region.mirror.reset();
    if (choice == kNoMirror) return;
    MirrorPlane plane;
    plane.normal = Eigen::Vector3d::Unit(choice - 1);
    if (nodes.cols() > 0)
      plane.point[choice - 1] = 0.5 * (nodes.row(choice - 1).minCoeff() + nodes.row(choice - 1).maxCoeff());
    region.mirror = plane;
  });
}

void RegionFields::setShape(const GizmoShape& shape, int gesture)
{
  const Region* before = region();
  if (before == nullptr) return;
  QString what = tr("resize region");
  if (shape.falloff != before->falloff)
    what = tr("change falloff");
  else if (shape.ellipsoid.centre != before->ellipsoid.centre)
    what = tr("move region");
  else if (shape.ellipsoid.semiAxes == before->ellipsoid.semiAxes)
    what = tr("turn region");
  edit(
    what,
    [&shape](Region& region) {
      region.ellipsoid = shape.ellipsoid;
      region.falloff = shape.falloff;
    },
    gesture);
}

// === What is shown

void RegionFields::refresh()
{
  const Region* shown = region();
  setEnabled(shown != nullptr && !shown->locked);
  refreshCount();
  if (shown == nullptr) {
    m_name->clear();
    m_curve->clear();
    return;
  }
  m_refreshing = true;
  m_name->setText(QString::fromStdString(shown->name));
  const Eigen::Vector3d turns = turnsOf(shown->ellipsoid.rotation);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    m_numbers[CentreX + axis]->display(shown->ellipsoid.centre[i] * kMillimetresPerMetre);
    m_numbers[AxisX + axis]->display(shown->ellipsoid.semiAxes[i] * kMillimetresPerMetre);
    m_numbers[TurnX + axis]->display(turns[i]);
  }
  m_numbers[Falloff]->display(shown->falloff * 100.0);
  m_profile->setCurrentIndex(m_profile->findData(static_cast<int>(shown->profile)));
  m_insideOut->setChecked(shown->insideOut);
  m_curve->show(*shown);
  refreshMirror(*shown);
  m_refreshing = false;
}

void RegionFields::refreshMirror(const Region& region)
{
  const int choice = mirrorChoice(region.mirror);
  if (choice == kOwnPlane && m_mirror->count() == kOwnPlane) m_mirror->addItem(tr("own plane"));
  if (choice != kOwnPlane && m_mirror->count() > kOwnPlane) m_mirror->removeItem(kOwnPlane);
  m_mirror->setCurrentIndex(choice);
  const bool numeric = choice != kNoMirror && choice != kOwnPlane;
  m_numbers[MirrorAt]->setEnabled(numeric);
  m_numbers[MirrorAt]->display(numeric ? region.mirror->point[choice - 1] * kMillimetresPerMetre : 0.0);
  m_detach->setEnabled(region.mirror && !region.insideOut);
}

/// A spring belongs to the region when its midpoint at rest does: so does core/tissue count.
void RegionFields::refreshCount()
{
  const Region* shown = region();
  if (shown == nullptr) return m_count->clear();
  const SpringNet& net = m_document->project().net;
  const RegionShape shape(*shown);
  int inside = 0;
  for (Index s = 0; s < net.springCount(); ++s)
    if (shape.weight(net.middleOf(s)) > 0.0) ++inside;
  m_count->setText(tr("%n spring(s)", nullptr, inside));
}

void RegionFields::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void RegionFields::retranslateUi()
{
  describe(m_name, tr("Name of the region"));
  m_nameLabel->setText(tr("Name"));
  m_centreLabel->setText(tr("Centre [mm]"));
  m_axesLabel->setText(tr("Semi-axes [mm]"));
  m_turnLabel->setText(tr("Rotation [°]"));
  m_falloffLabel->setText(tr("Falloff"));
  m_weightLabel->setText(tr("Weight"));
  m_mirrorLabel->setText(tr("Mirror"));
  const QString axes[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    describe(m_numbers[CentreX + axis], tr("Centre %1 in mm").arg(axes[axis]));
    describe(m_numbers[AxisX + axis], tr("Semi-axis %1 in mm").arg(axes[axis]));
    describe(m_numbers[TurnX + axis], tr("Rotation about %1 in degrees").arg(axes[axis]));
    m_mirror->setItemText(static_cast<int>(axis) + 1, tr("plane %1 at").arg(axes[axis]));
  }
  for (GestureSpinBox* number : m_numbers) number->setLocale(QLocale());
  m_numbers[Falloff]->setSuffix(QStringLiteral(" %"));
  describe(m_numbers[Falloff], tr("Share of the radius over which the region fades out"));
  describe(m_profile, tr("How the weight falls from 1 to 0"));
  const QString profiles[] = {tr("smooth"), tr("linear"), tr("smoother")};
  for (int row = 0; row < 3; ++row) m_profile->setItemText(row, profiles[row]);
  describe(m_curve, tr("Weight from the centre outward; the line is the surface"));
  m_insideOut->setText(tr("Inside out"));
  describe(m_insideOut, tr("The region is what lies outside of the ellipsoid"));
  describe(m_mirror, tr("A twin behind a plane: both are one region"));
  m_mirror->setItemText(kNoMirror, tr("none"));
  describe(m_numbers[MirrorAt], tr("Place of the mirror plane in mm"));
  m_detach->setText(tr("Make twin a region of its own"));
  m_detach->setAccessibleName(m_detach->text());
  describe(m_count, tr("Springs that the region affects"));
  refresh();
}

} // namespace esm
