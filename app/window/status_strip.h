// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runtime/sim_thread.h"
#include "core/tissue/tissue_model.h"
#include "haptics/haptic_session.h"

#include <QLabel>
#include <QTimer>

#include <optional>
#include <utility>

class QStatusBar;

namespace esm {

/// How the run goes, as light and words: green while the tolerance is kept, yellow while something gives way
/// (implicit steps, accuracy, the clock), red when it had to stop. A picture that does not come is said while
/// it does not. Cause and cure are in the tool tip (and in
/// the status line when the simulation had to stop).
class StabilityLight : public QLabel {
  Q_OBJECT
public:
  explicit StabilityLight(QWidget* parent = nullptr);
  void show(const SimSnapshot& snapshot);
  using QLabel::show;

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  QString causeAndCure() const;
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
class ToleranceNote : public QLabel {
  Q_OBJECT
public:
  explicit ToleranceNote(QWidget* parent = nullptr);
  void show(const SimSnapshot& snapshot);
  using QLabel::show;

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
/// that was given up, stability, device, language. Where they and the message do not fit beside each other
/// the lesser ones make room.
class StatusStrip : public QObject {
  Q_OBJECT
public:
  explicit StatusStrip(QStatusBar* bar);
  void setTool(const QString& hint) { m_tool->setText(hint); }
  void setNet(Index nodes, Index springs);
  /// What the last edit of the tissue cost. @param time [s].
  void setDerived(const DerivationReport& report, double time);
  void clearDerived();
  void setRun(const SimSnapshot& snapshot);
  void setDevice(const HapticStatus& status);
  void setLanguage(const QString& code);
  void retranslate();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QLabel* add(const char* name);
  void makeRoom();
  void showWork(const SimSnapshot& snapshot);
  QLabel *m_tool, *m_derived, *m_nodes, *m_springs, *m_realTime, *m_solver, *m_device, *m_language;
  ToleranceNote* m_tolerance;
  StabilityLight* m_light;
  QTimer m_room; ///< until makeRoom(), once for all that changes at a time
  Index m_nodeCount = 0, m_springCount = 0;
  std::optional<std::pair<Index, double>> m_lastApply; ///< springs, time [s]
  Index m_awakeCount = -1;                             ///< -1: nothing runs
};

} // namespace esm
