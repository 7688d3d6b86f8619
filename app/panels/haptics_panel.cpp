// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/haptics_panel.h"

#include "app/haptics/haptic_text.h"
#include "app/icons.h"
#include "app/panels/describe.h"
#include "app/panels/emulator_panel.h"
#include "app/panels/force_display.h"
#include "app/panels/haptic_devices.h"
#include "app/panels/haptic_path.h"
#include "app/panels/trace_plots.h"
#include "app/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace esm {

namespace {

constexpr qint64 kStateEvery = 150, kForceEvery = 30; // [ms]

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

QString milliseconds(double seconds)
{
  return QLocale().toString(1e3 * seconds, 'f', 2);
}

} // namespace

HapticsPanel::HapticsPanel(DeviceDesk* desk, SimulationController* controller, QWidget* parent)
  : QWidget(parent), m_controller(controller)
{
  buildHead();
  buildTabs(desk);
  connect(m_limit, &GestureSpinBox::edited, this,
          [this](double newtons, int) { m_controller->setForceLimit(newtons); });
  connect(m_grip, &GestureSpinBox::edited, this,
          [this](double millimetres, int) { m_controller->setGripRadius(1e-3 * millimetres); });
  connect(m_gain, &GestureSpinBox::edited, this,
          [this](double factor, int) { m_controller->setForceScale(factor); });
  connect(m_arm, &QPushButton::clicked, this, [this](bool on) {
    if (on)
      m_controller->arm();
    else
      m_controller->disarm();
    m_said.clear();
  });
  connect(m_stop, &QPushButton::clicked, m_controller, &SimulationController::stop);
  connect(m_devices, &HapticDevices::said, this, &HapticsPanel::setMessage);
  connect(m_path, &HapticPath::said, this, &HapticsPanel::setMessage);
  connect(m_controller, &SimulationController::deviceChanged, this, [this] {
    m_said.clear();
    for (TracePlot* plot : {m_forcePlot, m_positionPlot, m_energyPlot}) plot->clear();
    refreshState();
  });
  connect(m_controller, &SimulationController::deviceTicked, this,
          [this](const std::vector<TraceSample>& ticks) {
            for (TracePlot* plot : {m_forcePlot, m_positionPlot, m_energyPlot}) plot->add(ticks);
            if (!m_lastForce.isValid() || m_lastForce.elapsed() > kForceEvery) refreshForce();
            if (!m_lastState.isValid() || m_lastState.elapsed() > kStateEvery) refreshState();
          });
  retranslateUi();
}

void HapticsPanel::buildHead()
{
  m_state = new QLabel(this);
  m_state->setObjectName(QStringLiteral("hapticState"));
  m_message = new QLabel(this);
  m_message->setObjectName(QStringLiteral("hapticMessage"));
  m_message->setWordWrap(true);
  m_message->setTextFormat(Qt::PlainText);
  for (QLabel* each : {m_state, m_message}) // a long text must not make the window wider
    each->setMinimumWidth(60);
  const auto field = [this](const char* name, double least, double most, double step) {
    auto* made = new GestureSpinBox(this);
    made->setObjectName(QLatin1String(name));
    made->setDecimals(1);
    made->setRange(least, most);
    made->setSingleStep(step);
    return made;
  };
  m_limitLabel = new QLabel(this);
  m_limit = field("hapticForceLimit", 0.1, 20.0, 0.5);
  m_limitLabel->setBuddy(m_limit);
  m_gripLabel = new QLabel(this);
  m_grip = field("pullRadius", 0.0, 50.0, 1.0);
  m_gripLabel->setBuddy(m_grip);
  m_gainLabel = new QLabel(this);
  m_gain = field("hapticGain", 0.0, 10.0, 0.1);
  m_gainLabel->setBuddy(m_gain);
  m_arm = new QPushButton(icon(Symbol::Arm), QString(), this);
  m_arm->setObjectName(QStringLiteral("hapticArm"));
  m_arm->setCheckable(true);
  m_arm->setAutoDefault(false);
  m_stop = new QPushButton(this);
  m_stop->setObjectName(QStringLiteral("hapticStop"));
  m_stop->setAutoDefault(false);
  m_stop->setStyleSheet(
    QStringLiteral("QPushButton { background: #c22f2a; color: white; font-weight: bold; "
                   "border: 1px solid #8f1f1b; border-radius: 3px; padding: 4px 14px; }"
                   "QPushButton:focus, QPushButton:hover { border: 2px solid palette(text); }"));
}

void HapticsPanel::buildTabs(DeviceDesk* desk)
{
  m_devices = new HapticDevices(desk, m_controller);
  m_path = new HapticPath(desk, m_controller);
  m_forceLabel = new QLabel(this);
  m_force = new QLabel(this);
  m_force->setObjectName(QStringLiteral("hapticForce"));
  m_dial = new ForceDial(this);
  m_dial->setObjectName(QStringLiteral("hapticDial"));
  m_forcePlot = new TracePlot(TracePlot::Kind::Force);
  m_positionPlot = new TracePlot(TracePlot::Kind::Position);
  m_energyPlot = new TracePlot(TracePlot::Kind::Energy);
  m_jitterPlot = new JitterPlot;
  m_timing = new QLabel(this);
  m_timing->setObjectName(QStringLiteral("hapticTiming"));
  m_timing->setWordWrap(true);

  auto* force = new QWidget;
  auto* number = new QVBoxLayout;
  number->addWidget(m_forceLabel);
  number->addWidget(m_force);
  number->addWidget(m_dial, 1);
  auto* forceRow = new QHBoxLayout(force);
  forceRow->setContentsMargins(4, 4, 4, 4);
  forceRow->addLayout(number);
  forceRow->addWidget(m_forcePlot, 1);
  auto* timing = new QWidget;
  auto* timingColumn = new QVBoxLayout(timing);
  timingColumn->setContentsMargins(4, 4, 4, 4);
  timingColumn->addWidget(m_timing);
  timingColumn->addWidget(m_jitterPlot, 1);

  m_tabs = new QTabWidget(this);
  m_tabs->setObjectName(QStringLiteral("hapticTabs"));
  m_tabs->tabBar()->setObjectName(QStringLiteral("hapticTabBar"));
  m_tabs->setDocumentMode(true);
  for (QWidget* page : {static_cast<QWidget*>(m_devices), force, static_cast<QWidget*>(m_positionPlot),
                        static_cast<QWidget*>(m_energyPlot), timing, static_cast<QWidget*>(m_path)})
    m_tabs->addTab(page, QString());
  if (desk->emulated() != nullptr) {
    m_emulator = new EmulatorPanel(desk);
    m_tabs->addTab(m_emulator, QString());
  }

  auto* top = new QHBoxLayout;
  top->addWidget(m_state, 1);
  top->addWidget(m_arm);
  top->addWidget(m_stop);
  auto* below = new QHBoxLayout;
  below->addWidget(m_message, 1);
  for (QWidget* each : {static_cast<QWidget*>(m_limitLabel), static_cast<QWidget*>(m_limit),
                        static_cast<QWidget*>(m_gripLabel), static_cast<QWidget*>(m_grip),
                        static_cast<QWidget*>(m_gainLabel), static_cast<QWidget*>(m_gain)})
    below->addWidget(each);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(3);
  layout->addLayout(top);
  layout->addLayout(below);
  layout->addWidget(m_tabs, 1);
}

void HapticsPanel::setMessage(const QString& text)
{
  m_said = text;
  refreshState();
}

void HapticsPanel::refreshState()
{
  m_lastState.start();
  const HapticStatus status = m_controller->hapticStatus();
  const DeviceReport report = m_controller->deviceReport();
  QString state = deviceStateText(status.state);
  if (!m_controller->deviceName().empty()) {
    if (report.phase != DevicePhase::Running) state = devicePhaseText(report.phase);
    state = QStringLiteral("%1: %2").arg(deviceNameText(m_controller->deviceName()), state);
  }
  m_state->setText(QStringLiteral("● %1").arg(state));
  m_state->setToolTip(state);
  QPalette colours = m_state->palette();
  colours.setColor(QPalette::WindowText, stateColour(status.state, palette()));
  m_state->setPalette(colours);
  const std::string reason = report.phase == DevicePhase::Running ? status.reason : report.reason;
  const QString text = !m_said.isEmpty() ? m_said : hapticReasonText(reason);
  m_message->setText(text);
  const DeviceProfile* profile = m_controller->deviceProfile();
  const double most = profile != nullptr ? profile->maxForce : 20.0;
  if (m_limit->maximum() != most) {
    const QSignalBlocker quiet(m_limit); // the user's own limit stays for the next device
    m_limit->setMaximum(most);
  }
  if (!m_limit->hasFocus()) m_limit->display(m_controller->forceLimit());
  if (!m_grip->hasFocus()) m_grip->display(1e3 * m_controller->gripRadius());
  if (!m_gain->hasFocus()) m_gain->display(m_controller->forceScale());
  refreshArm();
  m_devices->refresh();
  m_path->refresh();
  if (!m_timing->isVisible()) return;
  const JitterCounts jitter = m_controller->jitter();
  m_jitterPlot->show(jitter);
  m_timing->setText(
    tr("%1 Hz, %2; late by %3 ms (half), %4 ms (99 %), %5 ms (99.9 %), %6 ms (worst); %7 of %8 ticks missed")
      .arg(QLocale().toString(status.rate, 'f', 0), priorityText(status.priority),
           milliseconds(jitter.percentile(0.5)), milliseconds(jitter.percentile(0.99)),
           milliseconds(jitter.percentile(0.999)), milliseconds(jitter.worst))
      .arg(jitter.missed)
      .arg(jitter.ticks));
}

void HapticsPanel::refreshArm()
{
  const DeviceState state = m_controller->hapticStatus().state;
  m_arm->setEnabled(state != DeviceState::Absent &&
                    m_controller->deviceReport().phase == DevicePhase::Running);
  m_arm->setChecked(state == DeviceState::Arming || state == DeviceState::Active);
}

void HapticsPanel::refreshForce()
{
  m_lastForce.start();
  m_forcePlot->addTissueForce(m_controller->snapshot().toolForce.norm());
  for (TracePlot* plot : {m_forcePlot, m_positionPlot, m_energyPlot}) plot->redraw();
  if (!m_force->isVisible()) return;
  const Eigen::Vector3d force = m_controller->forceInHand();
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
  m_limitLabel->setText(tr("Force limit"));
  describe(m_limit,
           tr("Largest force that pull tool and device may give, in N; never above the device's own"));
  m_limit->setSuffix(QStringLiteral(" N"));
  m_limit->setLocale(QLocale());
  m_gripLabel->setText(tr("Grip"));
  describe(m_grip, tr("Radius of the patch that the pull tool takes hold of, in mm; at 0 mm one node alone"));
  m_grip->setSuffix(QStringLiteral(" mm"));
  m_grip->setLocale(QLocale());
  m_gainLabel->setText(tr("Gain"));
  describe(m_gain, tr("Force felt over force of the tissue"));
  m_gain->setSuffix(QStringLiteral("×"));
  m_gain->setLocale(QLocale());
  m_arm->setText(tr("Force on"));
  describe(m_arm, tr("Let the device feel the force; it fades in"));
  m_stop->setText(tr("Stop"));
  describe(m_stop, tr("Force zero at once (Esc, and space while force is on)"));
  m_forceLabel->setText(tr("Force in the hand"));
  describe(m_force, tr("Force that a device would feel"));
  describe(m_dial,
           tr("Direction of the force: x to the right, z up, bar: y; the number is the force at the rim"));
  const QString tabs[] = {tr("Devices"), tr("Force"), tr("Position"), tr("Energy"),
                          tr("Timing"),  tr("Path"),  tr("Emulator")};
  for (int i = 0; i < m_tabs->count(); ++i) m_tabs->setTabText(i, tabs[i]);
  m_tabs->setAccessibleName(tr("Parts of the haptics panel"));
  QFont big = font();
  big.setPointSizeF(big.pointSizeF() * 1.7);
  big.setBold(true);
  m_force->setFont(big);
  m_force->setMinimumWidth(QFontMetrics(big).horizontalAdvance(QStringLiteral("00,00 N")) + 6);
  refreshState();
  refreshForce();
}

} // namespace esm
