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

QString lagText(double lag)
{
  return lag < 0.9995 ? QStringLiteral("%1 ms").arg(QLocale().toString(1e3 * lag, 'f', 0))
                      : QStringLiteral("%1 s").arg(QLocale().toString(lag, 'f', 1));
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

StabilityLight::StabilityLight(QWidget* parent) : StatusField("lblStable", parent)
{
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

QStringList StabilityLight::wordings() const
{
  if (m_stability == Stability::Idle) return {tr("no model")};
  if (m_stability == Stability::Stopped) return {tr("stopped, last good state"), tr("stopped")};
  if (!m_playing) return {tr("paused")};
  switch (m_stability) {
  case Stability::Implicit:
    return {tr("stiff, implicit steps"), tr("stiff")};
  case Stability::Rough:
    return {tr("rougher than wanted"), tr("rougher")};
  case Stability::Slow: {
    const QString absence = QLocale().toString(m_frameTime, 'f', 1);
    if (m_frameTime > 0.0)
      return {tr("too heavy, no picture for %1 s").arg(absence), tr("no picture for %1 s").arg(absence)};
    return {tr("slowed, %1 × real time").arg(QLocale().toString(m_realTimeFactor, 'f', 2)), tr("slowed")};
  }
  default:
    return {tr("stable")};
  }
}

void StabilityLight::refresh()
{
  const SignalColours colours = signalColours(palette());
  QColor colour = palette().color(QPalette::Disabled, QPalette::WindowText);
  if (m_stability == Stability::Stopped)
    colour = colours.bad;
  else if (m_playing && m_stability != Stability::Idle)
    colour = m_stability == Stability::Good ? colours.good : colours.warning;
  const QStringList wordings = this->wordings();
  QStringList tip{wordings.first()};
  if (const QString cure = causeAndCure(); !cure.isEmpty()) tip << cure;
  if (m_playing && m_toldError > 0.0)
    tip << tr("Error of the motion, as its own steps tell: about %1 %").arg(aboutPercent(m_toldError));
  if (!m_message.empty()) tip << reasonText(m_message);
  setMark(QStringLiteral("●"), colour);
  explain(tip.join(QLatin1Char('\n')));
  say(wordings);
  setAccessibleName(tr("Stability: %1").arg(wordings.first()));
  emit said();
}

void StabilityLight::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::ApplicationPaletteChange) refresh();
  StatusField::changeEvent(event);
}

ToleranceNote::ToleranceNote(QWidget* parent) : StatusField("lblTolerance", parent)
{
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
  QStringList wordings;
  if (m_now && m_toldError > 0.0) {
    const QString error = aboutPercent(m_toldError);
    wordings = {tr("rough, error about %1 %").arg(error), tr("error about %1 %").arg(error)};
  } else if (m_now) { // before anything has moved there is no error to speak of
    wordings = {tr("rough")};
  } else if (m_until >= 0.0) {
    const QString until = QLocale().toString(m_until, 'f', 2);
    wordings = {tr("tolerance given up until t = %1 s").arg(until), tr("rough until t = %1 s").arg(until)};
  }
  const QString why =
    tr("To keep the tolerance of %1 % would have cost too much work: the motion is bounded, but rough.")
      .arg(percent(m_tolerance));
  setMark(QStringLiteral("⚠"), signalColours(palette()).warning);
  explain(why + QLatin1Char('\n') +
          (m_now ? roughCure() : tr("What moves now comes from there. Reset begins anew.")));
  say(wordings);
  emit said();
}

void ToleranceNote::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::ApplicationPaletteChange) refresh();
  StatusField::changeEvent(event);
}

StatusStrip::StatusStrip(QStatusBar* bar)
  : QObject(bar), m_tolerance(new ToleranceNote(bar)), m_light(new StabilityLight(bar))
{
  bar->setSizeGripEnabled(false);
  auto* tool = new QLabel(bar);
  tool->setObjectName(QStringLiteral("lblTool"));
  bar->addWidget(tool, 1);
  m_derived = add("lblDerived");
  m_nodes = add("lblNodes");
  m_springs = add("lblSprings");
  m_realTime = add("lblRealTime");
  m_solver = add("lblSolver");
  bar->addPermanentWidget(m_tolerance);
  bar->addPermanentWidget(m_light);
  m_device = add("lblDevice");
  m_language = add("lblLanguage");
  // The hint stands in the preview, too: it gives way before the tolerance, which has a tool tip. A message tells
  // of something new: the counts give way first.
  const std::vector<StatusRoom::Step> steps{{m_derived, 1},   {m_solver, 1}, {m_springs, 1}, {m_realTime, 1},
                                            {m_language, 1},  {m_nodes, 1},  {m_device, 1},  {m_light, 1},
                                            {m_tolerance, 1}, {m_nodes, 2},  {m_realTime, 2}};
  m_room = new StatusRoom(
    bar, tool,
    {m_derived, m_nodes, m_springs, m_realTime, m_solver, m_tolerance, m_light, m_device, m_language}, steps,
    3, steps.size() - 1);
  connect(m_light, &StabilityLight::said, m_room, &StatusRoom::share);
  connect(m_tolerance, &ToleranceNote::said, m_room, &StatusRoom::share);
}

StatusField* StatusStrip::add(const char* name)
{
  auto* bar = static_cast<QStatusBar*>(parent());
  auto* field = new StatusField(name, bar);
  bar->addPermanentWidget(field);
  return field;
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
  retranslate();
}

void StatusStrip::retranslate()
{
  m_derived->explain(tr("Springs that the last edit of the tissue gave new numbers, and how long it took"));
  showCounts();
  m_room->share();
}

void StatusStrip::showCounts()
{
  const QLocale locale;
  QStringList derived;
  if (m_lastApply)
    derived = {tr("%1 of %2 springs derived, %3 ms")
                 .arg(locale.toString(m_lastApply->first), locale.toString(m_springCount),
                      locale.toString(1e3 * m_lastApply->second, 'f', 1)),
               QString()};
  m_derived->say(derived);
  const QString nodes = tr("%n node(s)", nullptr, m_nodeCount);
  const bool someRest = m_awakeCount >= 0 && m_awakeCount < m_nodeCount;
  if (someRest)
    m_nodes->say(
      {tr("%1 of %2 awake").arg(m_awakeCount).arg(nodes), tr("%1 awake").arg(m_awakeCount), QString()});
  else
    m_nodes->say({nodes, nodes, QString()});
  m_springs->say({tr("%n spring(s)", nullptr, m_springCount), QString()});
}

void StatusStrip::setRun(const SimSnapshot& snapshot)
{
  showPace(snapshot);
  m_solver->explain(reasonText(snapshot.message));
  m_solver->say(m_nodeCount == 0
                  ? QStringList()
                  : QStringList{tr("solver %1").arg(QString::fromStdString(snapshot.solver)), QString()});
  showWork(snapshot);
  m_tolerance->show(snapshot);
  m_light->show(snapshot);
  m_room->share();
}

/// Simulated time against the clock: the factor is the last to go.
void StatusStrip::showPace(const SimSnapshot& snapshot)
{
  m_realTime->explain(tr("Simulated time over wall time; a frame costs %1 % of its period")
                        .arg(QLocale().toString(100.0 * snapshot.frameCost, 'f', 0)) +
                      QLatin1Char('\n') + rungText(snapshot.quality));
  if (m_nodeCount == 0) return m_realTime->say({}); // the snapshot is of the model before
  if (!snapshot.playing)
    return m_realTime->say({tr("t = %1 s").arg(QLocale().toString(snapshot.time, 'f', 2))});
  const QString factor = QLocale().toString(snapshot.realTimeFactor, 'f', 2);
  QStringList wordings{tr("real time %1×, tolerance %2 %").arg(factor, percent(snapshot.quality.tolerance)),
                       tr("real time %1×").arg(factor), QStringLiteral("%1×").arg(factor)};
  if (snapshot.quality.rung == 0) wordings[0] = wordings[1];
  if (snapshot.lag > kLongLag) {
    const QString lag = lagText(snapshot.lag);
    wordings[0] = tr("%1, %2 behind").arg(wordings[0], lag);
    wordings[1] = tr("%1, %2 behind").arg(wordings[1], lag);
    wordings[2] = QStringLiteral("%1, −%2").arg(wordings[2], lag);
  }
  m_realTime->say(wordings);
}

void StatusStrip::showWork(const SimSnapshot& snapshot)
{
  const QLocale locale;
  const StepReport& work = snapshot.report;
  m_awakeCount = snapshot.playing ? static_cast<Index>(work.nodesAwake) : -1;
  m_nodes->explain(tr("%1 of %2 nodes awake; the others rest and cost nothing")
                     .arg(work.nodesAwake)
                     .arg(snapshot.position.cols()));
  m_springs->explain(tr("Last frame: %1 springs evaluated in %2 steps, %3 factorizations, %4 rejected steps")
                       .arg(locale.toString(static_cast<qlonglong>(work.springsEvaluated)),
                            locale.toString(static_cast<qlonglong>(work.steps)))
                       .arg(work.factorizations)
                       .arg(work.rejectedSteps));
  showCounts();
}

void StatusStrip::setDevice(const HapticStatus& status)
{
  if (status.state == DeviceState::Absent) {
    m_device->explain(QString());
    m_device->say({tr("no device"), QString()});
  } else {
    m_device->explain(tr("%1: %2; %3 of %4 ticks late, worst %5 ms")
                        .arg(QString::fromStdString(status.device), deviceStateText(status.state))
                        .arg(status.lateTicks)
                        .arg(status.ticks)
                        .arg(QLocale().toString(1e3 * status.worstLateness, 'f', 1)));
    m_device->say({tr("device %1 Hz").arg(QLocale().toString(status.rate, 'f', 0)), QString()});
  }
  m_room->share();
}

void StatusStrip::setLanguage(const QString& code)
{
  m_language->say({code, QString()});
  m_room->share();
}

} // namespace esm
