// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/rule_findings.h"
#include "fuzzyeditor/fuzzy_document.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <vector>

namespace esm {

/// Looks for what is odd about a document's rules, never in the way of an edit: after a pause, on a copy, on
/// a thread of its own. While it is off (a hidden panel) it costs nothing. Changes of the inputs are none of
/// its business. GUI thread.
class ProblemFinder : public QObject {
  Q_OBJECT
public:
  /// @param document not owned, outlives this.
  explicit ProblemFinder(FuzzyDocument* document, QObject* parent = nullptr);
  ~ProblemFinder() override; ///< waits for the thread

  void setOn(bool on);
  void setPause(int milliseconds) { m_pause.setInterval(milliseconds); } ///< default 250
  /// Of the rules as they were when the last look ended; rule numbers may be old while isCurrent() is false.
  const std::vector<fuzzy::RuleFinding>& findings() const { return m_findings; }
  bool isCurrent() const { return m_current; }

signals:
  void found(); ///< the findings are those of the rules of now

private:
  void followDocument();
  void look();
  void take(std::vector<fuzzy::RuleFinding> findings);

  FuzzyDocument* m_document;
  QTimer m_pause;
  QThreadPool m_threads;
  std::vector<fuzzy::RuleFinding> m_findings;
  bool m_on = false, m_current = false;
  bool m_looking = false;  ///< a look is under way
  bool m_outdated = false; ///< and the rules have changed since it began
};

} // namespace esm
