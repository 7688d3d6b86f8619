// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QRect>

class QWidget;

namespace esm {

/// The place for a window of a wanted place (without its frame) on a screen with `room` for windows: all of
/// it there with its frame, as large as wanted where that fits.
QRect placeWithin(const QRect& room, const QRect& wanted, const QMargins& frame);

/// Moves and shrinks a window so that all of it can be seen; a maximized or full one stays.
void putOnScreen(QWidget* window);

/// Puts every window, dialog and floating panel of the program on the screen, each time it is shown.
class ScreenKeeper : public QObject {
  Q_OBJECT
public:
  explicit ScreenKeeper(QObject* parent = nullptr);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// What a window may take of a screen before its frame is known.
QSize sizeWithoutFrame(const QSize& room);

} // namespace esm
