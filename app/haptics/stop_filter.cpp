// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/haptics/stop_filter.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include <utility>

namespace esm {

StopFilter::StopFilter(std::function<bool()> forceMayFlow, std::function<void()> stop, QObject* parent)
  : QObject(parent), m_forceMayFlow(std::move(forceMayFlow)), m_stop(std::move(stop))
{
  QCoreApplication::instance()->installEventFilter(this);
}

/// One press arrives several times: for shortcuts, at the window, at the widget. The first stops.
bool StopFilter::eventFilter(QObject* watched, QEvent* event)
{
  const QEvent::Type type = event->type();
  if (type != QEvent::ShortcutOverride && type != QEvent::KeyPress && type != QEvent::KeyRelease)
    return QObject::eventFilter(watched, event);
  const auto* key = static_cast<const QKeyEvent*>(event);
  if (key->key() != Qt::Key_Escape && key->key() != Qt::Key_Space) return false;
  if (type == QEvent::KeyRelease) {
    const bool used = m_usedUp == key->key();
    if (used && !key->isAutoRepeat()) m_usedUp = 0;
    return used;
  }
  if (m_forceMayFlow()) {
    m_usedUp = key->key();
    m_stop();
  } else if (type == QEvent::ShortcutOverride && !key->isAutoRepeat()) {
    m_usedUp = 0; // a new press, should the release of the last have gone elsewhere
  }
  if (m_usedUp != key->key()) return false;
  event->accept(); // of a shortcut override: no shortcut
  return true;
}

} // namespace esm
