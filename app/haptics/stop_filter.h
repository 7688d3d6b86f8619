// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

namespace esm {

/// While force may flow, Esc and space take it away wherever the keyboard is: in a modal dialog, a menu, a
/// text field. The key is used up by that: it neither closes the dialog nor presses a button (which might be
/// the one that lets force flow again). Watches all events of the application while it lives. GUI thread.
class StopFilter : public QObject {
  Q_OBJECT
public:
  StopFilter(std::function<bool()> forceMayFlow, std::function<void()> stop, QObject* parent);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::function<bool()> m_forceMayFlow;
  std::function<void()> m_stop;
  int m_usedUp = 0; ///< this key, until it is let go
};

} // namespace esm
