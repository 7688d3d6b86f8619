// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/haptic_devices.h"

#include "app/dialogs/calibrate_dialog.h"
#include "app/haptics/haptic_text.h"
#include "app/haptics/user_profile.h"
#include "app/icons.h"
#include "app/panels/describe.h"
#include "app/theme.h"
#include "core/geometry/extent.h"

#include <QCheckBox>
#include <QClipboard>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

SimulationController::Coupling couplingOf(const std::string& name)
{
  return name == "simulated" || name == "laparoscope" ? SimulationController::Coupling::HoldsNode
                                                      : SimulationController::Coupling::Touches;
}

const QRegularExpression kDigest(QStringLiteral("([0-9a-f]{32})([0-9a-f]{32})"));

QString axesText(std::uint8_t axes)
{
  QStringList names;
  for (int axis = 0; axis < 8; ++axis)
    if ((axes >> axis & 1) != 0) names << QString::number(axis + 1);
  return names.join(QStringLiteral(", "));
}

} // namespace

HapticDevices::HapticDevices(DeviceDesk* desk, SimulationController* controller, QWidget* parent)
  : QWidget(parent), m_desk(desk), m_controller(controller)
{
  build();
  layOut();
  connect(m_list, &QListWidget::currentRowChanged, this, &HapticDevices::showDetails);
  connect(m_list, &QListWidget::itemActivated, this, &HapticDevices::connectOrNot);
  connect(m_rescan, &QToolButton::clicked, m_desk, &DeviceDesk::rescan);
  connect(m_copyRule, &QToolButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(m_rule->text()); });
  connect(m_consent, &QCheckBox::toggled, m_desk, &DeviceDesk::setConsent);
  connect(m_chooseFirmware, &QPushButton::clicked, this, &HapticDevices::chooseFirmware);
  connect(m_connect, &QPushButton::clicked, this, &HapticDevices::connectOrNot);
  connect(m_home, &QPushButton::clicked, m_controller, &SimulationController::requestHome);
  connect(m_place, &QPushButton::clicked, this, &HapticDevices::placeOnModel);
  connect(m_calibrate, &QPushButton::clicked, this, &HapticDevices::calibrate);
  connect(m_desk, &DeviceDesk::listed, this, &HapticDevices::takeList);
  connect(m_desk, &DeviceDesk::busyChanged, this, &HapticDevices::refresh);
  connect(m_controller, &SimulationController::deviceChanged, this, &HapticDevices::refresh);
  retranslateUi();
}

void HapticDevices::build()
{
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("hapticList"));
  m_list->setMinimumWidth(190);
  m_list->setMinimumHeight(60);
  m_list->setWordWrap(true);
  const auto label = [this](const char* name) {
    auto* made = new QLabel(this);
    made->setObjectName(QLatin1String(name));
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    made->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return made;
  };
  m_what = label("hapticWhat");
  m_reason = label("hapticReason");
  m_firmware = label("hapticFirmware");
  m_rule = new QLineEdit(this);
  m_rule->setObjectName(QStringLiteral("hapticRule"));
  m_rule->setReadOnly(true);
  m_copyRule = new QToolButton(this);
  m_copyRule->setObjectName(QStringLiteral("hapticCopyRule"));
  m_copyRule->setIcon(icon(Symbol::Copy));
  m_copyRule->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_rescan = new QToolButton(this);
  m_rescan->setObjectName(QStringLiteral("hapticRescan"));
  m_consent = new QCheckBox(this);
  m_consent->setObjectName(QStringLiteral("hapticConsent"));
  m_consent->setChecked(m_desk->consent());
  const auto button = [this](const char* name) {
    auto* made = new QPushButton(this);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
  };
  m_connect = button("hapticConnect");
  m_home = button("hapticHome");
  m_chooseFirmware = button("hapticChooseFirmware");
  m_place = button("hapticPlace");
  m_calibrate = button("hapticCalibrate");
}

void HapticDevices::layOut()
{
  auto* details = new QWidget(this);
  auto* rule = new QHBoxLayout;
  rule->addWidget(m_rule, 1);
  rule->addWidget(m_copyRule);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* each : {m_connect, m_home, m_place, m_calibrate}) buttons->addWidget(each);
  buttons->addStretch();
  auto* column = new QVBoxLayout(details);
  column->setContentsMargins(4, 2, 4, 2);
  column->setSpacing(4);
  column->addWidget(m_what);
  column->addLayout(buttons);
  column->addWidget(m_reason);
  column->addLayout(rule);
  column->addWidget(m_firmware);
  column->addWidget(m_chooseFirmware, 0, Qt::AlignLeft);
  column->addWidget(m_consent);
  column->addStretch();
  auto* area = new QScrollArea(this);
  area->setObjectName(QStringLiteral("hapticDetails"));
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setFocusPolicy(Qt::NoFocus);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(details);
  auto* left = new QVBoxLayout;
  left->setSpacing(2);
  left->addWidget(m_list, 1);
  left->addWidget(m_rescan, 0, Qt::AlignLeft);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(left, 2);
  layout->addWidget(area, 3);
}

std::string HapticDevices::current() const
{
  const int row = m_list->currentRow();
  const auto& listings = m_desk->listings();
  return row >= 0 && row < static_cast<int>(listings.size()) ? listings[static_cast<std::size_t>(row)].name
                                                             : std::string();
}

bool HapticDevices::isConnected(const std::string& name) const
{
  return !name.empty() && m_controller->deviceName() == name;
}

/// A session does not survive its cable: plugged in again, the device is one that can be connected.
void HapticDevices::takeList()
{
  const std::string name = m_controller->deviceName();
  const DeviceListing* listing = name.empty() ? nullptr : m_desk->find(name);
  if (listing != nullptr && listing->usable && m_controller->deviceReport().phase == DevicePhase::Lost)
    m_controller->detachDevice();
  fillList();
}

void HapticDevices::fillList()
{
  const int row = std::max(m_list->currentRow(), 0);
  const QSignalBlocker quiet(m_list);
  const int wanted = static_cast<int>(m_desk->listings().size());
  while (m_list->count() > wanted) delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < wanted) m_list->addItem(QString());
  m_list->setCurrentRow(std::min(row, wanted - 1));
  refresh();
}

void HapticDevices::refresh()
{
  if (m_list->count() != static_cast<int>(m_desk->listings().size())) return fillList();
  for (int row = 0; row < m_list->count(); ++row) showRow(row);
  showDetails();
}

/// Name and state; meaning is never in the colour alone.
void HapticDevices::showRow(int row)
{
  const DeviceListing& listing = m_desk->listings()[static_cast<std::size_t>(row)];
  QString state;
  const SignalColours colours = signalColours(palette());
  QColor colour = palette().color(QPalette::WindowText);
  if (isConnected(listing.name)) {
    const DevicePhase phase = m_controller->deviceReport().phase;
    state = devicePhaseText(phase);
    colour = phase == DevicePhase::Running                               ? colours.good
             : phase == DevicePhase::Fault || phase == DevicePhase::Lost ? colours.bad
                                                                         : colours.warning;
  } else if (!listing.udevRule.empty()) {
    state = tr("no permission");
    colour = colours.bad;
  } else if (!listing.usable) {
    state = listing.reason == "Not plugged in" || listing.reason == "Looking for it"
              ? hapticReasonText(listing.reason).toLower()
              : tr("cannot be used");
  } else {
    state = listing.reason.empty() || m_desk->consent() ? tr("ready to connect") : tr("needs your consent");
  }
  QListWidgetItem* item = m_list->item(row);
  const QString text = QStringLiteral("%1: %2").arg(deviceNameText(listing.name), state);
  if (item->text() != text) item->setText(text);
  if (item->foreground().color() != colour) item->setForeground(colour);
}

QString HapticDevices::reasonOf(const DeviceListing& listing) const
{
  if (isConnected(listing.name)) {
    const DeviceReport report = m_controller->deviceReport();
    QString text = hapticReasonText(report.reason);
    if (report.phase == DevicePhase::Upload)
      text += QStringLiteral(" (%1 %)").arg(static_cast<int>(100.0f * report.progress));
    if (report.phase == DevicePhase::NeedsHome && report.unhomed != 0)
      text +=
        QStringLiteral("\n") + tr("Axes that do not know their place yet: %1").arg(axesText(report.unhomed));
    return text;
  }
  if (m_desk->opening() && m_failedName.empty()) return tr("Being opened…");
  if (listing.name == m_failedName && !m_failure.isEmpty()) return m_failure;
  if (listing.reason.empty() || (listing.usable && m_desk->consent())) return {};
  return hapticReasonText(listing.reason);
}

void HapticDevices::showDetails()
{
  const DeviceListing* listing = m_desk->find(current());
  if (listing == nullptr) return;
  const bool connected = isConnected(listing->name), falcon = listing->name == "falcon";
  const DevicePhase phase = connected ? m_controller->deviceReport().phase : DevicePhase::Opening;
  m_what->setText(hapticReasonText(listing->description));
  const QString reason = reasonOf(*listing);
  if (m_reason->text() != reason) m_reason->setText(reason);
  m_reason->setVisible(!reason.isEmpty());
  const QString rule = QString::fromStdString(listing->udevRule);
  if (m_rule->text() != rule) m_rule->setText(rule), m_rule->setCursorPosition(0);
  m_rule->setVisible(!rule.isEmpty());
  m_copyRule->setVisible(!rule.isEmpty());
  QString firmware =
    !listing->details.empty() ? hapticReasonText(listing->details) : tr("No firmware file is chosen");
  m_firmware->setToolTip(firmware);
  firmware.replace(kDigest, QStringLiteral("\\1 \\2")); // so that it can be wrapped
  if (m_firmware->text() != firmware) m_firmware->setText(firmware);
  m_firmware->setVisible(falcon);
  m_chooseFirmware->setVisible(falcon);
  m_consent->setVisible(listing->name == "wooden");
  const bool works = connected && phase != DevicePhase::Lost;
  m_connect->setText(works ? tr("Disconnect") : tr("Connect"));
  const bool mayOpen = listing->usable && (listing->reason.empty() || m_desk->consent());
  m_connect->setEnabled(works || (mayOpen && !m_desk->opening()));
  m_home->setVisible(connected && listing->name == "wooden");
  m_home->setEnabled(phase == DevicePhase::NeedsHome || phase == DevicePhase::Running);
  m_calibrate->setVisible(listing->name == "pid");
  m_place->setEnabled(!m_controller->forceMayFlow()); // the tissue would jump into the hand
  m_place->setVisible(works && m_controller->coupling() == SimulationController::Coupling::Touches);
}

void HapticDevices::connectOrNot()
{
  const std::string name = current();
  if (name.empty() || !m_connect->isEnabled()) return;
  m_failedName.clear();
  m_failure.clear();
  const bool works = isConnected(name) && m_controller->deviceReport().phase != DevicePhase::Lost;
  m_controller->detachDevice();
  if (works) return;
  m_desk->open(name, [this, name](DeviceDesk::Opened opened) {
    Status attached = opened ? m_controller->attachDevice(std::move(*opened), name, couplingOf(name))
                             : Status(opened.error());
    if (!attached) {
      m_failedName = name;
      m_failure = hapticReasonText(attached.error().detail);
      emit said(m_failure);
      m_desk->rescan(); // permission may have changed since the last look
    }
    refresh();
  });
  refresh();
}

void HapticDevices::chooseFirmware()
{
  const QString folder = QFileInfo(QString::fromStdString(m_desk->firmware().string())).absolutePath();
  const QString file = QFileDialog::getOpenFileName(this, tr("Firmware of your Falcon"), folder,
                                                    tr("Firmware (*.bin *.hex *.img)") +
                                                      QStringLiteral(";;") + tr("All files (*)"));
  if (!file.isEmpty()) m_desk->setFirmware(file);
}

/// So that the hand in the middle of its reach is in the middle of the organ.
void HapticDevices::placeOnModel()
{
  const DeviceProfile* profile = m_controller->deviceProfile();
  const Eigen::Matrix3Xd& nodes = m_controller->snapshot().position;
  if (profile == nullptr || nodes.cols() == 0) return;
  const Eigen::Vector3d middle = boxOf(nodes).center();
  m_controller->placeWorkspace(middle - 0.5 * (profile->workspaceMin + profile->workspaceMax));
}

/// A stick knows per cent only, and not which way: the user measures once what they are.
void HapticDevices::calibrate()
{
  const std::string name = current();
  const Result<StickCalibration> before = stickCalibration(name);
  if (!before) return emit said(hapticReasonText(before.error().detail));
  CalibrateDialog dialog(*before, this);
  if (dialog.exec() != QDialog::Accepted) return;
  if (const Status written = setStickCalibration(name, dialog.calibration()); !written)
    emit said(hapticReasonText(written.error().detail));
}

void HapticDevices::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  if (event->type() == QEvent::PaletteChange) refresh();
  QWidget::changeEvent(event);
}

void HapticDevices::retranslateUi()
{
  describe(m_list, tr("Haptic devices and their state"));
  describe(m_rule,
           tr("This line in /etc/udev/rules.d/70-esm-haptics.rules permits it; then plug it out and in"));
  m_copyRule->setText(tr("Copy"));
  describe(m_copyRule, tr("Copy the udev line"));
  m_rescan->setText(tr("Search again"));
  describe(m_rescan, tr("Look for devices again"));
  m_consent->setText(tr("It is a WoodenHaptics"));
  describe(m_consent, tr("Its USB numbers are nobody's own: say that what carries them is a WoodenHaptics. "
                         "Holds until the program ends."));
  describe(m_connect, tr("Connect or disconnect the device; no force flows by this"));
  m_home->setText(tr("Home"));
  describe(m_home, tr("The grip is at its home position now"));
  m_place->setText(tr("Place on model"));
  describe(m_place, tr("Put the middle of the workspace into the middle of the model"));
  m_calibrate->setText(tr("Calibrate…"));
  describe(m_calibrate,
           tr("Say how many newtons the device gives at 100 %, which way it pushes, and where its zero is"));
  m_chooseFirmware->setText(tr("Choose firmware…"));
  describe(m_chooseFirmware, tr("The Falcon forgets its firmware with each power-off; its licence forbids us "
                                "to bring it"));
  refresh();
}

} // namespace esm
