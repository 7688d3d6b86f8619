// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QActionGroup;
class QComboBox;
class QMainWindow;
class QMenu;
class QToolBar;

namespace esm {

/// The menus and the tool bar of the window: every action with name, icon, keys and its texts in the
/// window's language. What an action does is connected by MainWindow. Object names are "act" + member name.
class WindowActions : public QObject {
  Q_OBJECT
public:
  explicit WindowActions(QMainWindow* window);
  void retranslate();

  // === Actions, by menu
  QAction *newProject, *open, *save, *saveAs, *import, *exportShape, *picture, *recover, *quit;
  QAction *undo, *redo, *rename;
  QAction *fit, *showSurface, *showSprings, *showStruts, *defaultLayout, *fullScreen;
  QActionGroup *colouring, *theme, *language; ///< data: Colouring as int, theme name, language code
  QAction *addRegion, *holdNode;
  QAction *play, *step, *reset, *solverAuto, *realTime;
  QActionGroup *tools, *solver; ///< data: Tool as int, solver name
  QAction *toolCamera, *toolSelect, *toolPull, *toolRegion;
  QAction *arm, *stop;
  QAction *keys, *about, *aboutQt;

  // === Places
  QMenu *fileMenu, *recentMenu, *sampleMenu, *editMenu, *viewMenu, *docksMenu, *colouringMenu, *themeMenu,
    *languageMenu, *tissueMenu, *simulationMenu, *toolMenu, *solverMenu, *hapticsMenu, *helpMenu;
  QToolBar *toolBar, *stopBar;
  QComboBox* colouringBox = nullptr; ///< in the tool bar; follows `colouring`

  void setPlaying(bool playing); ///< Play becomes Pause

private:
  QAction* add(const char* name);
  QAction* choice(QActionGroup* group, const char* name, const QVariant& data);
  void createActions();
  void createMenus(QMainWindow* window);
  void createToolBar(QMainWindow* window);
  void createStopBar(QMainWindow* window);
  void retranslateFileAndEdit();
  void retranslateViewAndTissue();
  void retranslateRun();
  void retranslateSolvers();
  void retranslateMenus();

  QMainWindow* m_window;
  bool m_playing = false;
};

} // namespace esm
