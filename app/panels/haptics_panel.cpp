// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/haptics_panel.h"

#include "app/error_text.h"
#include "app/icons.h"
#include "app/panels/force_display.h"
#include "app/theme.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace esm {

namespace {

void describe(QWidget* widget, const QString& text)
{
  widget->setAccessibleName(text);
  widget->setToolTip(text);
}

QColor stateColour(DeviceState state, const QPalette& palette)
{
  const SignalColours colours = signalColours(palette);
  switch (state) {
  case DeviceState::Active:
    return colours.good;
  case DeviceState::Arming:
  case DeviceState::Fading:
    return colours.warning;
  case DeviceState::Fault:
    return colours.bad;
  case DeviceState::Absent:
  case DeviceState::Idle:
    break;
  }
  return palette.color(QPalette::WindowText);
}

/// The device layer speaks English; what it says in daily use is known here.
QString reasonText(const std::string& reason)
{
  [[maybe_unused]] constexpr const char* kKnown =
    QT_TRANSLATE_NOOP("esm::HapticsPanel", "Stopped by the user; arm again to go on");
  return QCoreApplication::translate("esm::HapticsPanel", reason.c_str());
}

} // namespace

QString deviceStateText(DeviceState state)
{
  const char* text = nullptr;
  switch (state) {
  case DeviceState::Absent:
    text = QT_TRANSLATE_NOOP("esm::HapticsPanel", "no device");
    break;
  case DeviceState::Idle:
    text = QT_TRANSLATE_NOOP("esm::HapticsPanel", "ready, force off");
    break;
  case DeviceState::Arming:
    text = QT_TRANSLATE_NOOP("esm::HapticsPanel", "force fades in");
    break;
  case DeviceState::Active:
    text = QT_TRANSLATE_NOOP("esm::HapticsPanel", "force on");
    break;
  case DeviceState::Fading:
    text = QT_TRANSLATE_NOOP("esm::HapticsPanel", "force fades out");
    break;
  case DeviceState::Fault:
    text = QT_TRANSLATE_NOOP("esm::HapticsPanel", "stopped, force off");
    break;
  }
  return QCoreApplication::translate("esm::HapticsPanel", text);
}

HapticsPanel::HapticsPanel(SimulationController* controller, QWidget* parent)
  : QWidget(parent), m_controller(controller)
{
  m_deviceLabel = new QLabel(this);
  m_device = new QComboBox(this);
  m_device->setObjectName(QStringLiteral("hapticDevice"));
  for (const std::string& name : HapticSession::deviceNames())
    m_device->addItem(QString::fromStdString(name), QString::fromStdString(name));
  m_deviceLabel->setBuddy(m_device);
  m_state = new QLabel(this);
  m_state->setObjectName(QStringLiteral("hapticState"));
  m_reason = new QLabel(this);
  m_reason->setObjectName(QStringLiteral("hapticReason"));
  m_reason->setWordWrap(true);
  m_limitLabel = new QLabel(this);
  m_limit = new GestureSpinBox(this);
  m_limit->setObjectName(QStringLiteral("hapticForceLimit"));
  m_limit->setRange(0.1, 20.0);
  m_limit->setSingleStep(0.5);
  m_limit->setDecimals(1);
  m_limitLabel->setBuddy(m_limit);
  m_arm = new QPushButton(icon(Symbol::Arm), QString(), this);
  m_arm->setObjectName(QStringLiteral("hapticArm"));
  m_arm->setCheckable(true);
  m_stop = new QPushButton(icon(Symbol::Stop), QString(), this);
  m_stop->setObjectName(QStringLiteral("hapticStop"));
  m_forceLabel = new QLabel(this);
  m_force = new QLabel(this);
  m_force->setObjectName(QStringLiteral("hapticForce"));
  m_dial = new ForceDial(this);
  m_dial->setObjectName(QStringLiteral("hapticDial"));
  m_curve = new ForceCurve(this);

  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(4);
  grid->addWidget(m_deviceLabel, 0, 0);
  grid->addWidget(m_device, 0, 1);
  grid->addWidget(m_state, 1, 0, 1, 2);
  grid->addWidget(m_limitLabel, 2, 0);
  grid->addWidget(m_limit, 2, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_arm);
  buttons->addWidget(m_stop);
  auto* left = new QVBoxLayout;
  left->addLayout(grid);
  left->addLayout(buttons);
  left->addWidget(m_reason);
  left->addStretch();
  auto* middle = new QVBoxLayout;
  middle->addWidget(m_forceLabel);
  middle->addWidget(m_force);
  middle->addWidget(m_dial, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(left);
  layout->addLayout(middle);
  layout->addWidget(m_curve, 1);

  connect(m_device, &QComboBox::activated, this, &HapticsPanel::chooseDevice);
  connect(m_limit, &GestureSpinBox::edited, this,
          [this](double newtons, int) { m_controller->setForceLimit(newtons); });
  connect(m_arm, &QPushButton::clicked, this, [this](bool on) {
    if (on)
      m_controller->arm();
    else
      m_controller->disarm();
  });
  connect(m_stop, &QPushButton::clicked, m_controller, &SimulationController::stop);
  connect(m_controller, &SimulationController::deviceChanged, this, [this] {
    m_traceAligned = false;
    m_curve->clear();
    m_clock.restart();
    refreshState();
  });
  connect(m_controller, &SimulationController::frame, this, [this] {
    refreshForce();
    if (!m_lastState.isValid() || m_lastState.elapsed() > 150) refreshState();
  });
  m_clock.start();
  retranslateUi();
}

void HapticsPanel::chooseDevice()
{
  if (auto opened = m_controller->openDevice(m_device->currentData().toString().toStdString()); !opened)
    m_reason->setText(errorText(opened.error()));
}

void HapticsPanel::refreshState()
{
  m_lastState.start();
  const HapticStatus status = m_controller->hapticStatus();
  m_state->setText(QStringLiteral("● %1").arg(deviceStateText(status.state)));
  QPalette colours = m_state->palette();
  colours.setColor(QPalette::WindowText, stateColour(status.state, palette()));
  m_state->setPalette(colours);
  if (status.state != DeviceState::Absent) m_reason->setText(reasonText(status.reason));
  m_arm->setEnabled(status.state != DeviceState::Absent);
  m_arm->setChecked(status.state == DeviceState::Arming || status.state == DeviceState::Active);
  m_limit->display(m_controller->forceLimit());
}

/// Both clocks run at the speed of the wall; the curve puts the newest tick of the servo at now.
void HapticsPanel::refreshForce()
{
  const double now = 1e-3 * static_cast<double>(m_clock.elapsed());
  const Eigen::Vector3d force = m_controller->snapshot().toolForce;
  m_curve->addTissueForce(now, force.norm());
  m_trace.clear();
  m_controller->takeTrace(m_trace);
  if (!m_trace.empty() && !m_traceAligned) {
    m_traceOffset = now - m_trace.back().time;
    m_traceAligned = true;
  }
  constexpr std::size_t kEvery = 8; // 1000 ticks per second are more than the curve has pixels
  for (std::size_t i = 0; i < m_trace.size(); i += kEvery)
    m_curve->addDeviceForce(m_trace[i].time + m_traceOffset, m_trace[i].force.norm());
  m_curve->redraw();
  if (!isVisible()) return;
  m_force->setText(tr("%1 N").arg(QLocale().toString(force.norm(), 'f', 2)));
  m_dial->setForce(force);
}

void HapticsPanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  if (event->type() == QEvent::PaletteChange) refreshState();
  QWidget::changeEvent(event);
}

void HapticsPanel::retranslateUi()
{
  m_deviceLabel->setText(tr("Device"));
  describe(m_device, tr("Haptic device"));
  for (int i = 0; i < m_device->count(); ++i)
    if (m_device->itemData(i).toString() == QLatin1String("simulated"))
      m_device->setItemText(i, tr("simulated"));
  m_limitLabel->setText(tr("Force limit"));
  describe(m_limit, tr("Largest force that pull tool and device may give, in N"));
  m_limit->setSuffix(QStringLiteral(" N"));
  m_limit->setLocale(QLocale());
  m_arm->setText(tr("Force on"));
  describe(m_arm, tr("Let the device feel the force; it fades in"));
  m_stop->setText(tr("Stop"));
  describe(m_stop, tr("Force zero at once (Esc)"));
  m_forceLabel->setText(tr("Force in the hand"));
  describe(m_force, tr("Force that a device would feel"));
  describe(m_dial,
           tr("Direction of the force: x to the right, z up, bar: y; the number is the force at the rim"));
  QFont big = font();
  big.setPointSizeF(big.pointSizeF() * 1.7);
  big.setBold(true);
  m_force->setFont(big);
  m_force->setMinimumWidth(QFontMetrics(big).horizontalAdvance(QStringLiteral("00,00 N")) + 6);
  refreshState();
  refreshForce();
}

} // namespace esm
