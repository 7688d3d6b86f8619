// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/status_strip.h"

#include "app/panels/haptics_panel.h"
#include "app/theme.h"

#include <QEvent>
#include <QLocale>
#include <QStatusBar>

namespace esm {

StabilityLight::StabilityLight(QWidget* parent) : QLabel(parent)
{
  setObjectName(QStringLiteral("lblStable"));
  refresh();
}

void StabilityLight::show(Stability stability, bool playing, const std::string& message)
{
  const QString text = QString::fromStdString(message);
  if (stability == m_stability && playing == m_playing && text == m_message) return;
  m_stability = stability;
  m_playing = playing;
  m_message = text;
  refresh();
}

void StabilityLight::refresh()
{
  const SignalColours colours = signalColours(palette());
  QColor colour = palette().color(QPalette::Disabled, QPalette::WindowText);
  QString words, cure;
  switch (m_stability) {
  case Stability::Idle:
    words = tr("no model");
    break;
  case Stability::Good:
    words = m_playing ? tr("stable") : tr("paused");
    colour = m_playing ? colours.good : colour;
    break;
  case Stability::Slow:
    words = tr("behind real time");
    cure = tr("The model is too large or too stiff for this computer in real time: use fewer nodes, softer "
              "tissue or a looser tolerance.");
    colour = colours.warning;
    break;
  case Stability::Stopped:
    words = tr("stopped, last good state");
    colour = colours.bad;
    break;
  }
  setTextFormat(Qt::RichText);
  setText(QStringLiteral("<span style='color:%1'>●</span> %2").arg(colour.name(), words));
  setAccessibleName(tr("Stability: %1").arg(words));
  QStringList tip{words};
  if (!cure.isEmpty()) tip << cure;
  if (!m_message.isEmpty()) tip << m_message;
  setToolTip(tip.join(QStringLiteral("\n")));
}

void StabilityLight::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::ApplicationPaletteChange) refresh();
  QLabel::changeEvent(event);
}

StatusStrip::StatusStrip(QStatusBar* bar)
  : QObject(bar), m_tool(new QLabel(bar)), m_light(new StabilityLight(bar))
{
  bar->setSizeGripEnabled(false);
  m_tool->setObjectName(QStringLiteral("lblTool"));
  bar->addWidget(m_tool, 1);
  m_nodes = add("lblNodes");
  m_springs = add("lblSprings");
  m_realTime = add("lblRealTime");
  m_solver = add("lblSolver");
  bar->addPermanentWidget(m_light);
  m_device = add("lblDevice");
  m_language = add("lblLanguage");
}

QLabel* StatusStrip::add(const char* name)
{
  auto* bar = static_cast<QStatusBar*>(parent());
  auto* label = new QLabel(bar);
  label->setObjectName(QLatin1String(name));
  label->setContentsMargins(6, 0, 6, 0);
  bar->addPermanentWidget(label);
  return label;
}

void StatusStrip::setNet(Index nodes, Index springs)
{
  m_nodeCount = nodes;
  m_springCount = springs;
  retranslate();
}

void StatusStrip::retranslate()
{
  m_nodes->setText(tr("%n node(s)", nullptr, m_nodeCount));
  m_springs->setText(tr("%n spring(s)", nullptr, m_springCount));
}

void StatusStrip::setRun(const SimSnapshot& snapshot)
{
  const QLocale locale;
  m_realTime->setText(snapshot.playing
                        ? tr("real time %1×").arg(locale.toString(snapshot.realTimeFactor, 'f', 2))
                        : tr("t = %1 s").arg(locale.toString(snapshot.time, 'f', 2)));
  m_realTime->setToolTip(tr("Simulated time over wall time; a frame costs %1 % of its period")
                           .arg(locale.toString(100.0 * snapshot.frameCost, 'f', 0)));
  m_solver->setText(tr("solver %1").arg(QString::fromStdString(snapshot.solver)));
  m_solver->setToolTip(QString::fromStdString(snapshot.message));
  m_light->show(snapshot.stability, snapshot.playing, snapshot.message);
}

void StatusStrip::setDevice(const HapticStatus& status)
{
  if (status.state == DeviceState::Absent) {
    m_device->setText(tr("no device"));
    return;
  }
  m_device->setText(tr("device %1 Hz").arg(QLocale().toString(status.rate, 'f', 0)));
  m_device->setToolTip(tr("%1: %2; %3 of %4 ticks late, worst %5 ms")
                         .arg(QString::fromStdString(status.device), deviceStateText(status.state))
                         .arg(status.lateTicks)
                         .arg(status.ticks)
                         .arg(QLocale().toString(1e3 * status.worstLateness, 'f', 1)));
}

void StatusStrip::setLanguage(const QString& code)
{
  m_language->setText(code);
}

} // namespace esm
