// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/screen_room.h"

#include <QCoreApplication>
#include <QEvent>
#include <QScreen>
#include <QTimer>
#include <QWidget>

#include <algorithm>

namespace esm {

QRect placeWithin(const QRect& room, const QRect& wanted, const QMargins& frame)
{
  const QRect inner = room.marginsRemoved(frame);
  QRect place = wanted;
  place.setSize(wanted.size().boundedTo(inner.size()));
  place.moveLeft(std::clamp(place.left(), inner.left(), inner.right() + 1 - place.width()));
  place.moveTop(std::clamp(place.top(), inner.top(), inner.bottom() + 1 - place.height()));
  return place;
}

void putOnScreen(QWidget* window)
{
  if (window->windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen | Qt::WindowMinimized)) return;
  const QRect inner = window->geometry(), outer = window->frameGeometry();
  const QMargins frame(inner.left() - outer.left(), inner.top() - outer.top(), outer.right() - inner.right(),
                       outer.bottom() - inner.bottom());
  const QRect place = placeWithin(window->screen()->availableGeometry(), inner, frame);
  if (place != inner) window->setGeometry(place);
}

ScreenKeeper::ScreenKeeper(QObject* parent) : QObject(parent)
{
  QCoreApplication::instance()->installEventFilter(this);
}

/// Window managers draw their frame after the window is shown: only then is its size known.
bool ScreenKeeper::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() != QEvent::Show || !watched->isWidgetType()) return false;
  auto* window = static_cast<QWidget*>(watched);
  const Qt::WindowType type = window->windowType();
  if (!window->isWindow() || (type != Qt::Window && type != Qt::Dialog && type != Qt::Tool)) return false;
  for (const int pause : {0, 500}) // [ms]
    QTimer::singleShot(pause, window, [window] {
      if (window->isVisible() && window->isWindow()) putOnScreen(window);
    });
  return false;
}

QSize sizeWithoutFrame(const QSize& room)
{
  constexpr QSize kLikelyFrame(8, 48); // [pixel], a title bar above and thin borders
  return room - kLikelyFrame;
}

} // namespace esm
