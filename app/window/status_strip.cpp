// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/status_strip.h"

#include "app/haptics/haptic_text.h"
#include "app/text/reason_text.h"
#include "app/theme.h"

#include <QEvent>
#include <QLocale>
#include <QStatusBar>

#include <cmath>

namespace esm {

namespace {

constexpr double kLongFrame = 0.5; ///< that a picture may take before its absence is said [s]
constexpr double kLongLag = 0.1;   ///< that pictures may be late before it is said [s]

QString percent(double tolerance)
{
  return QLocale().toString(100.0 * tolerance, 'g', 3);
}

/// An estimate, which has no more digits than it deserves.
QString aboutPercent(double share)
{
  return QLocale().toString(100.0 * share, 'g', share < 0.1 ? 1 : 2);
}

/// Against a tolerance that is not kept.
QString roughCure()
{
  return StatusStrip::tr("Fewer nodes, softer tissue or heavier nodes help; what gives way is chosen in "
                         "Simulation, Real time.");
}

/// What led to the rung in force.
QString rungText(const QualityState& quality)
{
  if (quality.rung == 0)
    return StatusStrip::tr("Accuracy as wanted: error up to %1 %").arg(percent(quality.tolerance));
  QString text;
  switch (quality.measure) {
  case QualityMeasure::Tolerance:
    text = StatusStrip::tr("Larger error to keep real time: up to %1 % (step %2 of %3)");
    break;
  case QualityMeasure::Effort:
    text = StatusStrip::tr("Rougher solver steps to keep real time; wanted error %1 % (step %2 of %3)");
    break;
  case QualityMeasure::SlowMotion:
    text = StatusStrip::tr("Nothing more may give way but the clock; wanted error %1 % (step %2 of %3)");
    break;
  }
  return text.arg(percent(quality.tolerance)).arg(quality.rung).arg(quality.lastRung);
}

} // namespace

StabilityLight::StabilityLight(QWidget* parent) : QLabel(parent)
{
  setObjectName(QStringLiteral("lblStable"));
  refresh();
}

void StabilityLight::show(const SimSnapshot& snapshot)
{
  const auto shown = [](double factor) { return std::lround(100.0 * factor); };
  const double frameTime =
    snapshot.frameTime >= kLongFrame ? 0.1 * std::floor(10.0 * snapshot.frameTime) : 0.0;
  if (snapshot.stability == m_stability && snapshot.playing == m_playing && snapshot.message == m_message &&
      shown(snapshot.realTimeFactor) == shown(m_realTimeFactor) && frameTime == m_frameTime &&
      snapshot.quality.rung == m_quality.rung &&
      aboutPercent(snapshot.toldError) == aboutPercent(m_toldError))
    return;
  m_stability = snapshot.stability;
  m_playing = snapshot.playing;
  m_realTimeFactor = snapshot.realTimeFactor;
  m_frameTime = frameTime;
  m_toldError = snapshot.toldError;
  m_quality = snapshot.quality;
  m_message = snapshot.message;
  refresh();
}

QString StabilityLight::causeAndCure() const
{
  switch (m_stability) {
  case Stability::Implicit:
    return tr("The tolerance is kept, by implicit steps. Softer tissue or heavier nodes would allow cheaper "
              "explicit ones.");
  case Stability::Rough: {
    if (!(m_quality.tolerance > m_quality.wantedTolerance)) return roughCure();
    return tr("To keep real time, the error may be %1 % instead of %2 %.")
             .arg(percent(m_quality.tolerance), percent(m_quality.wantedTolerance)) +
           QLatin1Char(' ') + roughCure();
  }
  case Stability::Slow:
    return tr("The model is too large or too stiff for this computer in real time: use fewer nodes, softer "
              "tissue or a looser tolerance.");
  case Stability::Idle:
  case Stability::Good:
  case Stability::Stopped:
    break;
  }
  return {};
}

void StabilityLight::refresh()
{
  const SignalColours colours = signalColours(palette());
  QColor colour = m_playing ? colours.warning : palette().color(QPalette::Disabled, QPalette::WindowText);
  QString words = tr("paused");
  if (m_stability == Stability::Idle) {
    words = tr("no model");
  } else if (m_stability == Stability::Stopped) {
    words = tr("stopped, last good state");
    colour = colours.bad;
  } else if (m_playing) {
    switch (m_stability) {
    case Stability::Implicit:
      words = tr("stiff, implicit steps");
      break;
    case Stability::Rough:
      words = tr("rougher than wanted");
      break;
    case Stability::Slow:
      words = m_frameTime > 0.0
                ? tr("too heavy, no picture for %1 s").arg(QLocale().toString(m_frameTime, 'f', 1))
                : tr("slowed, %1 × real time").arg(QLocale().toString(m_realTimeFactor, 'f', 2));
      break;
    default:
      words = tr("stable");
      colour = colours.good;
      break;
    }
  }
  setTextFormat(Qt::RichText);
  setText(QStringLiteral("<span style='color:%1'>●</span> %2").arg(colour.name(), words));
  setAccessibleName(tr("Stability: %1").arg(words));
  QStringList tip{words};
  if (const QString cure = causeAndCure(); !cure.isEmpty()) tip << cure;
  if (m_playing && m_toldError > 0.0)
    tip << tr("Error of the motion, as its own steps tell: about %1 %").arg(aboutPercent(m_toldError));
  if (!m_message.empty()) tip << reasonText(m_message);
  setToolTip(tip.join(QStringLiteral("\n")));
}

void StabilityLight::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::ApplicationPaletteChange) refresh();
  QLabel::changeEvent(event);
}

ToleranceNote::ToleranceNote(QWidget* parent) : QLabel(parent)
{
  setObjectName(QStringLiteral("lblTolerance"));
  setContentsMargins(6, 0, 6, 0);
  refresh();
}

void ToleranceNote::show(const SimSnapshot& snapshot)
{
  const bool now = snapshot.report.rough;
  const auto shown = [](double until) { return std::lround(100.0 * until); }; // two digits
  if (now == m_now && shown(snapshot.roughUntil) == shown(m_until) &&
      snapshot.quality.tolerance == m_tolerance &&
      aboutPercent(snapshot.toldError) == aboutPercent(m_toldError))
    return;
  m_now = now;
  m_toldError = snapshot.toldError;
  m_until = snapshot.roughUntil;
  m_tolerance = snapshot.quality.tolerance;
  refresh();
}

void ToleranceNote::refresh()
{
  setVisible(m_now || m_until >= 0.0);
  const QString until = QLocale().toString(m_until, 'f', 2);
  QString words = tr("tolerance given up until t = %1 s").arg(until);
  if (m_now) // before anything has moved there is no error to speak of
    words = m_toldError > 0.0 ? tr("rough, error about %1 %").arg(aboutPercent(m_toldError)) : tr("rough");
  setTextFormat(Qt::RichText);
  setText(
    QStringLiteral("<span style='color:%1'>⚠</span> %2").arg(signalColours(palette()).warning.name(), words));
  setAccessibleName(words);
  const QString why =
    tr("To keep the tolerance of %1 % would have cost too much work: the motion is bounded, but rough.")
      .arg(percent(m_tolerance));
  setToolTip(why + QLatin1Char('\n') +
             (m_now ? roughCure() : tr("What moves now comes from there. Reset begins anew.")));
}

void ToleranceNote::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::ApplicationPaletteChange) refresh();
  QLabel::changeEvent(event);
}

StatusStrip::StatusStrip(QStatusBar* bar)
  : QObject(bar),
    m_tool(new QLabel(bar)),
    m_tolerance(new ToleranceNote(bar)),
    m_light(new StabilityLight(bar))
{
  bar->setSizeGripEnabled(false);
  m_tool->setObjectName(QStringLiteral("lblTool"));
  bar->addWidget(m_tool, 1);
  m_derived = add("lblDerived");
  m_nodes = add("lblNodes");
  m_springs = add("lblSprings");
  m_realTime = add("lblRealTime");
  m_solver = add("lblSolver");
  bar->addPermanentWidget(m_tolerance);
  bar->addPermanentWidget(m_light);
  m_device = add("lblDevice");
  m_language = add("lblLanguage");
  m_room.setSingleShot(true);
  m_room.setInterval(0);
  connect(&m_room, &QTimer::timeout, this, &StatusStrip::makeRoom);
  connect(bar, &QStatusBar::messageChanged, this, [this, bar](const QString& message) {
    bar->setToolTip(message); // one longer than any window can be read there
    m_room.start();
  });
  bar->installEventFilter(this);
}

bool StatusStrip::eventFilter(QObject*, QEvent* event)
{
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) m_room.start();
  return false;
}

/// A label that is cut off says less than none: the least telling go first.
void StatusStrip::makeRoom()
{
  const auto* bar = static_cast<QStatusBar*>(parent());
  constexpr int kGap = 8;          // [pixel], about what the bar leaves around a label
  constexpr int kReturnAfter = 40; // [pixel] more, so that changing digits make no label come and go
  const auto wide = [&](const QLabel* label) { return label->sizeHint().width() + kGap; };
  const QString message = bar->currentMessage();
  int needed = message.isEmpty() ? wide(m_tool) : bar->fontMetrics().horizontalAdvance(message) + 2 * kGap;
  needed += wide(m_light) + wide(m_device) + wide(m_language);
  if (m_tolerance->isVisibleTo(bar)) needed += wide(m_tolerance);
  bool fits = true;
  for (QLabel* label : {m_realTime, m_nodes, m_springs, m_solver, m_derived}) {
    const bool isThere = !label->text().isEmpty() && (label != m_derived || m_lastApply);
    if (!isThere) {
      label->setVisible(false);
      continue;
    }
    needed += wide(label);
    fits = fits && needed + (label->isVisibleTo(bar) ? 0 : kReturnAfter) <= bar->width();
    label->setVisible(fits);
  }
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
  m_tolerance->show(SimSnapshot()); // another motion
  retranslate();
}

void StatusStrip::setDerived(const DerivationReport& report, double time)
{
  m_lastApply.emplace(report.springsChanged, time);
  retranslate();
}

void StatusStrip::clearDerived()
{
  m_lastApply.reset();
  m_derived->clear();
  retranslate();
}

void StatusStrip::retranslate()
{
  const QLocale locale;
  m_room.start();
  m_derived->setToolTip(
    tr("Springs that the last edit of the tissue gave new numbers, and how long it took"));
  if (m_lastApply)
    m_derived->setText(tr("%1 of %2 springs derived, %3 ms")
                         .arg(locale.toString(m_lastApply->first), locale.toString(m_springCount),
                              locale.toString(1e3 * m_lastApply->second, 'f', 1)));
  const QString nodes = tr("%n node(s)", nullptr, m_nodeCount);
  const bool someRest = m_awakeCount >= 0 && m_awakeCount < m_nodeCount;
  m_nodes->setText(someRest ? tr("%1 of %2 awake").arg(m_awakeCount).arg(nodes) : nodes);
  m_springs->setText(tr("%n spring(s)", nullptr, m_springCount));
}

void StatusStrip::setRun(const SimSnapshot& snapshot)
{
  const QLocale locale;
  const QString factor = locale.toString(snapshot.realTimeFactor, 'f', 2);
  if (m_nodeCount == 0) // the snapshot is of the model before
    m_realTime->clear();
  else if (!snapshot.playing)
    m_realTime->setText(tr("t = %1 s").arg(locale.toString(snapshot.time, 'f', 2)));
  else if (snapshot.quality.rung == 0)
    m_realTime->setText(tr("real time %1×").arg(factor));
  else
    m_realTime->setText(tr("real time %1×, tolerance %2 %").arg(factor, percent(snapshot.quality.tolerance)));
  if (m_nodeCount > 0 && snapshot.lag > kLongLag)
    m_realTime->setText(
      tr("%1, %2 ms behind").arg(m_realTime->text(), locale.toString(1e3 * snapshot.lag, 'f', 0)));
  m_realTime->setToolTip(tr("Simulated time over wall time; a frame costs %1 % of its period")
                           .arg(locale.toString(100.0 * snapshot.frameCost, 'f', 0)) +
                         QLatin1Char('\n') + rungText(snapshot.quality));
  m_solver->setText(m_nodeCount == 0 ? QString()
                                     : tr("solver %1").arg(QString::fromStdString(snapshot.solver)));
  m_solver->setToolTip(reasonText(snapshot.message));
  showWork(snapshot);
  m_tolerance->show(snapshot);
  m_light->show(snapshot);
}

void StatusStrip::showWork(const SimSnapshot& snapshot)
{
  const QLocale locale;
  const StepReport& work = snapshot.report;
  m_awakeCount = snapshot.playing ? static_cast<Index>(work.nodesAwake) : -1;
  retranslate();
  m_nodes->setToolTip(tr("%1 of %2 nodes awake; the others rest and cost nothing")
                        .arg(work.nodesAwake)
                        .arg(snapshot.position.cols()));
  m_springs->setToolTip(
    tr("Last frame: %1 springs evaluated in %2 steps, %3 factorizations, %4 rejected steps")
      .arg(locale.toString(static_cast<qlonglong>(work.springsEvaluated)),
           locale.toString(static_cast<qlonglong>(work.steps)))
      .arg(work.factorizations)
      .arg(work.rejectedSteps));
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
