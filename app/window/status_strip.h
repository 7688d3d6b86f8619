// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/status_field.h"
#include "core/runtime/sim_thread.h"
#include "core/tissue/tissue_model.h"
#include "haptics/haptic_session.h"

#include <QLabel>

#include <optional>
#include <utility>

class QStatusBar;

namespace esm {

/// How the run goes, as light and words: green while the tolerance is kept, yellow while something gives way
/// (implicit steps, accuracy, the clock), red when it had to stop. A picture that does not come is said while
/// it does not. Cause and cure are in the tool tip (and in
/// the status line when the simulation had to stop).
class StabilityLight : public StatusField {
  Q_OBJECT
public:
  explicit StabilityLight(QWidget* parent = nullptr);
  void show(const SimSnapshot& snapshot);
  using StatusField::show;

signals:
  void said(); ///< something else, in whatever room it has

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  QString causeAndCure() const;
  QStringList wordings() const;
  Stability m_stability = Stability::Idle;
  bool m_playing = false;
  double m_realTimeFactor = 0.0;
  double m_toldError = 0.0; ///< as SimSnapshot::toldError
  double m_frameTime = 0.0; ///< of a picture that takes long, to a tenth; else 0 [s]
  QualityState m_quality;
  std::string m_message; ///< the engine's, English
};

/// Says that the tolerance was given up, for as long as it is so and while the motion comes from there; else
/// it is hidden. What helps is in the tool tip.
class ToleranceNote : public StatusField {
  Q_OBJECT
public:
  explicit ToleranceNote(QWidget* parent = nullptr);
  void show(const SimSnapshot& snapshot);
  using StatusField::show;

signals:
  void said(); ///< something else, in whatever room it has

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  bool m_now = false;
  double m_until = -1.0;     ///< [s], as SimSnapshot::roughUntil
  double m_toldError = 0.0;  ///< as SimSnapshot::toldError
  double m_tolerance = 0.01; ///< that the last frame was to keep
};

/// The fields of the status bar: tool, what the last edit derived, nodes (and how many are awake), springs
/// (and the work on them), real time with the accuracy in force, solver and why it was chosen, a tolerance
/// that was given up, stability, device, language. Where they and the hint or a message do not fit beside each
/// other, the lesser ones make room; light, factor, lag and error stay. Each change is laid out at once.
class StatusStrip : public QObject {
  Q_OBJECT
public:
  explicit StatusStrip(QStatusBar* bar);
  void setTool(const QString& hint) { m_room->setHint(hint); }
  void setNet(Index nodes, Index springs);
  /// What the last edit of the tissue cost. @param time [s].
  void setDerived(const DerivationReport& report, double time);
  void clearDerived();
  void setRun(const SimSnapshot& snapshot);
  void setDevice(const HapticStatus& status);
  void setLanguage(const QString& code);
  void retranslate();

private:
  StatusField* add(const char* name);
  void showPace(const SimSnapshot& snapshot);
  void showWork(const SimSnapshot& snapshot);
  void showCounts();
  StatusField *m_derived, *m_nodes, *m_springs, *m_realTime, *m_solver, *m_device, *m_language;
  ToleranceNote* m_tolerance;
  StabilityLight* m_light;
  StatusRoom* m_room;
  Index m_nodeCount = 0, m_springCount = 0;
  std::optional<std::pair<Index, double>> m_lastApply; ///< springs, time [s]
  Index m_awakeCount = -1;                             ///< -1: nothing runs
};

} // namespace esm
