// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_actions.h"

#include "app/icons.h"
#include "app/viewport/scene_view.h"
#include "core/dynamics/simulation.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace esm {

namespace {

/// Text, status text and tool tip in one; the tool tip names the keys.
void say(QAction* action, const QString& text, const QString& help = {})
{
  action->setText(text);
  QString plain = help.isEmpty() ? QString(text).remove(QLatin1Char('&')).remove(QStringLiteral("…")) : help;
  action->setStatusTip(plain);
  if (!action->shortcut().isEmpty())
    plain += QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText));
  action->setToolTip(plain);
}

/// The engine's solvers in short; one that is not known here speaks for itself, in English.
QString solverHelp(const SolverInfo& info)
{
  constexpr std::pair<const char*, const char*> kKnown[] = {
    {"leapfrog", QT_TRANSLATE_NOOP("esm::Solver", "explicit, one force pass per step, second order")},
    {"chebyshev", QT_TRANSLATE_NOOP("esm::Solver", "explicit, with more viscous stages per step")},
    {"stoermer3", QT_TRANSLATE_NOOP("esm::Solver", "the same by Stoermer's rule: waves keep in phase")},
    {"verlet", QT_TRANSLATE_NOOP("esm::Solver", "explicit, second order in viscosity too")},
    {"stoermer",
     QT_TRANSLATE_NOOP("esm::Solver", "explicit multistep, one force pass per step, fourth order")},
    {"rk4", QT_TRANSLATE_NOOP("esm::Solver", "explicit, fourth order")},
    {"dopri5", QT_TRANSLATE_NOOP("esm::Solver", "explicit, fifth order, for small errors")},
    {"implicit", QT_TRANSLATE_NOOP("esm::Solver", "implicit, second order, stable at any step: stiff nets")},
    {"lie", QT_TRANSLATE_NOOP("esm::Solver", "linearised implicit, first order, bounded")},
    {"descent", QT_TRANSLATE_NOOP("esm::Solver", "implicit, first order, never gains energy")},
    {"block-descent",
     QT_TRANSLATE_NOOP("esm::Solver",
                       "the same without a factor, a frame at a time: keeps time under the hand")},
    {"multirate", QT_TRANSLATE_NOOP("esm::Solver", "each spring at its own rate: few stiff springs")},
    {"wavefront", QT_TRANSLATE_NOOP("esm::Solver", "from the greatest force outward, as in 1999")},
    {"relax", QT_TRANSLATE_NOOP("esm::Solver", "to the rest of each moment, without inertia")},
  };
  for (const auto& [name, help] : kKnown)
    if (info.name == name) return QCoreApplication::translate("esm::Solver", help);
  return QString::fromStdString(info.description);
}

} // namespace

WindowActions::WindowActions(QMainWindow* window) : QObject(window), m_window(window)
{
  createActions();
  createMenus(window);
  createToolBar(window);
  retranslate();
}

QAction* WindowActions::add(const char* name)
{
  auto* action = new QAction(m_window);
  action->setObjectName(QStringLiteral("act") + QLatin1String(name));
  m_window->addAction(action);
  return action;
}

QAction* WindowActions::choice(QActionGroup* group, const char* name, const QVariant& data)
{
  QAction* action = add(name);
  action->setCheckable(true);
  action->setData(data);
  group->addAction(action);
  return action;
}

void WindowActions::createActions()
{
  const auto with = [this](const char* name, Symbol symbol, const QKeySequence& shortcut = {}) {
    QAction* action = add(name);
    action->setIcon(icon(symbol));
    action->setShortcut(shortcut);
    return action;
  };
  newProject = with("New", Symbol::New, QKeySequence::New);
  open = with("Open", Symbol::Open, QKeySequence::Open);
  save = with("Save", Symbol::Save, QKeySequence::Save);
  saveAs = add("SaveAs");
  saveAs->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_S);
  import = with("Import", Symbol::Import, Qt::CTRL | Qt::Key_I);
  exportShape = add("Export");
  exportShape->setShortcut(Qt::CTRL | Qt::Key_E);
  picture = add("Picture");
  picture->setShortcut(Qt::Key_F12);
  recover = add("Recover");
  recover->setVisible(false); // until there is somebody who keeps unsaved work
  quit = add("Quit");
  quit->setShortcut(Qt::CTRL | Qt::Key_Q);
  quit->setMenuRole(QAction::QuitRole);

  undo = with("Undo", Symbol::Undo, QKeySequence::Undo);
  redo = with("Redo", Symbol::Redo);
  redo->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
  rename = add("Rename");

  fit = with("Fit", Symbol::Fit);
  showSurface = add("ShowSurface");
  showSprings = add("ShowSprings");
  showStruts = add("ShowStruts");
  for (QAction* shown : {showSurface, showSprings, showStruts}) {
    shown->setCheckable(true);
    shown->setChecked(shown != showStruts);
  }
  defaultLayout = add("DefaultLayout");
  fullScreen = add("FullScreen");
  fullScreen->setShortcut(Qt::Key_F11);
  fullScreen->setCheckable(true);
  colouring = new QActionGroup(this);
  choice(colouring, "ColourNone", static_cast<int>(Colouring::None));
  choice(colouring, "ColourStiffness", static_cast<int>(Colouring::Stiffness))->setChecked(true);
  choice(colouring, "ColourStrain", static_cast<int>(Colouring::Strain));
  choice(colouring, "ColourForce", static_cast<int>(Colouring::Force));
  choice(colouring, "ColourRegionWeight", static_cast<int>(Colouring::RegionWeight));
  theme = new QActionGroup(this);
  choice(theme, "ThemeSystem", QStringLiteral("system"))->setChecked(true);
  choice(theme, "ThemeLight", QStringLiteral("light"));
  choice(theme, "ThemeDark", QStringLiteral("dark"));
  language = new QActionGroup(this);
  choice(language, "LanguageGerman", QStringLiteral("de"))->setText(QStringLiteral("Deutsch"));
  choice(language, "LanguageEnglish", QStringLiteral("en"))->setText(QStringLiteral("English"));

  addRegion = with("AddRegion", Symbol::Plus, Qt::CTRL | Qt::SHIFT | Qt::Key_R);
  holdNode = add("HoldNode");
  holdNode->setShortcut(Qt::Key_T);
  holdNode->setCheckable(true);
  holdNode->setEnabled(false);

  play = with("Play", Symbol::Play, Qt::Key_Space);
  step = with("Step", Symbol::Step, Qt::Key_Period);
  reset = with("Reset", Symbol::Reset, Qt::Key_Home);
  tools = new QActionGroup(this);
  toolCamera = choice(tools, "ToolCamera", static_cast<int>(Tool::Camera));
  toolPull = choice(tools, "ToolPull", static_cast<int>(Tool::Pull));
  toolSelect = choice(tools, "ToolSelect", static_cast<int>(Tool::Select));
  toolRegion = choice(tools, "ToolRegion", static_cast<int>(Tool::Region));
  toolCamera->setIcon(icon(Symbol::Camera));
  toolCamera->setShortcut(Qt::Key_Q);
  toolCamera->setChecked(true);
  toolPull->setIcon(icon(Symbol::Pull));
  toolPull->setShortcut(Qt::Key_E);
  toolSelect->setIcon(icon(Symbol::Select));
  toolSelect->setShortcut(Qt::Key_W);
  toolRegion->setIcon(icon(Symbol::Region));
  toolRegion->setShortcut(Qt::Key_G);
  realTime = add("RealTime");
  solver = new QActionGroup(this);
  solverAuto = choice(solver, "SolverAuto", QStringLiteral("auto"));
  for (const SolverInfo& info : solverNames()) {
    const QString name = QString::fromStdString(info.name);
    QAction* action = choice(solver, "Solver", name);
    action->setObjectName(QStringLiteral("actSolver_") + name);
  }

  arm = with("Arm", Symbol::Arm);
  arm->setCheckable(true);
  stop = with("Stop", Symbol::Stop, Qt::Key_Escape);
  keys = add("Keys");
  keys->setShortcut(Qt::Key_F1);
  about = add("About");
  about->setMenuRole(QAction::AboutRole);
  aboutQt = add("AboutQt");
  aboutQt->setMenuRole(QAction::AboutQtRole);
}

void WindowActions::createMenus(QMainWindow* window)
{
  const auto menu = [window](const char* name, const QList<QAction*>& actions) {
    QMenu* made = window->menuBar()->addMenu(QString());
    made->setObjectName(QLatin1String(name));
    for (QAction* action : actions)
      if (action != nullptr)
        made->addAction(action);
      else
        made->addSeparator();
    return made;
  };
  const auto subMenu = [](QMenu* parent, const char* name, const QList<QAction*>& actions) {
    QMenu* made = parent->addMenu(QString());
    made->setObjectName(QLatin1String(name));
    made->addActions(actions);
    return made;
  };

  fileMenu = menu("menuFile", {newProject, open});
  recentMenu = subMenu(fileMenu, "menuRecent", {});
  sampleMenu = subMenu(fileMenu, "menuSamples", {});
  for (QAction* action : {save, saveAs}) fileMenu->addAction(action);
  fileMenu->addSeparator();
  for (QAction* action : {import, exportShape, picture}) fileMenu->addAction(action);
  fileMenu->addAction(recover);
  fileMenu->addSeparator();
  fileMenu->addAction(quit);

  editMenu = menu("menuEdit", {undo, redo, nullptr, rename});
  viewMenu = menu("menuView", {fit, showSurface, showSprings, showStruts});
  colouringMenu = subMenu(viewMenu, "menuColouring", colouring->actions());
  viewMenu->addSeparator();
  docksMenu = subMenu(viewMenu, "menuDocks", {});
  viewMenu->addAction(defaultLayout);
  viewMenu->addSeparator();
  themeMenu = subMenu(viewMenu, "menuTheme", theme->actions());
  languageMenu = subMenu(viewMenu, "menuLanguage", language->actions());
  viewMenu->addAction(fullScreen);

  tissueMenu = menu("menuTissue", {addRegion, holdNode});
  simulationMenu = menu("menuSimulation", {play, step, reset, nullptr});
  toolMenu = subMenu(simulationMenu, "menuTool", tools->actions());
  solverMenu = subMenu(simulationMenu, "menuSolver", solver->actions());
  solverMenu->setToolTipsVisible(true);
  simulationMenu->addAction(realTime);
  hapticsMenu = menu("menuHaptics", {arm, stop});
  helpMenu = menu("menuHelp", {keys, nullptr, about, aboutQt});
}

void WindowActions::createToolBar(QMainWindow* window)
{
  toolBar = window->addToolBar(QString());
  toolBar->setObjectName(QStringLiteral("toolBar"));
  toolBar->setMovable(false);
  toolBar->setIconSize(QSize(22, 22));
  const QList<QList<QAction*>> groups = {{import, open, save},
                                         {undo, redo},
                                         {play, step, reset},
                                         {toolCamera, toolPull, toolSelect, toolRegion},
                                         {fit}};
  for (const QList<QAction*>& group : groups) {
    for (QAction* action : group) toolBar->addAction(action);
    toolBar->addSeparator();
  }
  for (QAction* action : {play, toolCamera, toolPull, toolSelect, toolRegion, import}) {
    auto* button = qobject_cast<QToolButton*>(toolBar->widgetForAction(action));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }

  colouringBox = new QComboBox(toolBar);
  colouringBox->setObjectName(QStringLiteral("colouringBox"));
  for (QAction* action : colouring->actions()) colouringBox->addItem(action->text(), action->data());
  toolBar->addWidget(colouringBox);
  connect(colouringBox, &QComboBox::activated, this,
          [this](int row) { colouring->actions().at(row)->trigger(); });
  for (QAction* action : colouring->actions())
    connect(action, &QAction::toggled, colouringBox, [this, action](bool on) {
      if (on) colouringBox->setCurrentIndex(static_cast<int>(colouring->actions().indexOf(action)));
    });
  colouringBox->setCurrentIndex(static_cast<int>(Colouring::Stiffness));

  auto* space = new QWidget(toolBar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  toolBar->addWidget(space);
  createStopBar(window);
  for (const QToolBar* bar : {toolBar, stopBar})
    for (QAction* action : bar->actions())
      if (QWidget* widget = bar->widgetForAction(action); widget != nullptr && widget->objectName().isEmpty())
        widget->setObjectName(QStringLiteral("tool_") + action->objectName());
}

/// A bar of its own, which narrow windows do not fold away, and which cannot be hidden.
void WindowActions::createStopBar(QMainWindow* window)
{
  stopBar = window->addToolBar(QString());
  stopBar->setObjectName(QStringLiteral("stopBar"));
  stopBar->setMovable(false);
  stopBar->toggleViewAction()->setVisible(false);
  stopBar->addAction(stop);
  auto* stopButton = qobject_cast<QToolButton*>(stopBar->widgetForAction(stop));
  stopButton->setToolButtonStyle(Qt::ToolButtonTextOnly);
  stopButton->setStyleSheet(
    QStringLiteral("QToolButton { background: #c22f2a; color: white; font-weight: bold; "
                   "border: 1px solid #8f1f1b; border-radius: 3px; padding: 4px 14px; }"
                   "QToolButton:hover { border: 2px solid palette(text); }"));
}

void WindowActions::setPlaying(bool playing)
{
  m_playing = playing;
  play->setIcon(icon(playing ? Symbol::Pause : Symbol::Play));
  say(play, playing ? tr("&Pause") : tr("&Play"));
}

void WindowActions::retranslate()
{
  retranslateFileAndEdit();
  retranslateViewAndTissue();
  retranslateRun();
  retranslateMenus();
}

void WindowActions::retranslateFileAndEdit()
{
  say(newProject, tr("&New"), tr("New project without a model"));
  say(open, tr("&Open…"));
  say(save, tr("&Save"));
  say(saveAs, tr("Save &as…"));
  say(import, tr("&Import mesh…"), tr("Import a mesh: OBJ, STL, PLY and more"));
  import->setIconText(tr("Import"));
  say(exportShape, tr("&Export shape…"), tr("Write the shape of this moment as mesh, VTU or CSV"));
  say(picture, tr("&Picture of the preview…"));
  say(recover, tr("&Recover unsaved work…"), tr("What earlier windows could not save"));
  say(quit, tr("&Quit"));
  say(undo, tr("&Undo"));
  say(redo, tr("&Redo"));
  say(rename, tr("Re&name project…"));
}

void WindowActions::retranslateViewAndTissue()
{
  say(fit, tr("&Fit model"), tr("Show the whole model (F)"));
  say(showSurface, tr("&Surface"));
  say(showSprings, tr("S&prings"));
  say(showStruts, tr("S&truts"), tr("Struts and the springs of walls: what holds the organ up from inside"));
  say(defaultLayout, tr("&Default layout"));
  say(fullScreen, tr("F&ull screen"));
  const QString colourings[] = {tr("Plain"), tr("Stiffness"), tr("Strain"), tr("Force"),
                                tr("Weight of the region")};
  for (int i = 0; i < 5; ++i) {
    colouring->actions().at(i)->setText(colourings[i]);
    if (colouringBox != nullptr) colouringBox->setItemText(i, tr("Colour: %1").arg(colourings[i]));
  }
  if (colouringBox != nullptr) {
    colouringBox->setAccessibleName(tr("What the colours show"));
    colouringBox->setToolTip(colouringBox->accessibleName());
  }
  theme->actions().at(0)->setText(tr("As the system"));
  theme->actions().at(1)->setText(tr("Light"));
  theme->actions().at(2)->setText(tr("Dark"));
  say(addRegion, tr("&Add region"), tr("Add an ellipsoid of other tissue at the selected node"));
  say(holdNode, tr("&Hold selected node"), tr("Hold the selected node fast in space"));
}

void WindowActions::retranslateRun()
{
  setPlaying(m_playing);
  say(step, tr("S&tep"), tr("One frame ahead"));
  say(reset, tr("&Reset"), tr("Back to the shape at rest"));
  say(toolCamera, tr("&Camera"), tr("Camera: drag to turn, right button to move, wheel to zoom"));
  say(toolPull, tr("P&ull"), tr("Pull: drag the tissue and feel its force"));
  say(toolSelect, tr("&Select"),
      tr("Select: click a node to see why it is as it is, or drag a box around several"));
  say(toolRegion, tr("Re&gion"), tr("Region: move, turn and resize the chosen region by its handles"));
  retranslateSolvers();
  say(realTime, tr("Real &time…"), tr("What gives way when the model is too heavy for real time"));
  say(arm, tr("&Force on the device"), tr("Let the device feel the force; it fades in"));
  say(stop, tr("&Stop"), tr("Force zero at once and let go; space does it too while force is on"));
  say(keys, tr("&Keys"));
  say(about, tr("&About this program"));
  say(aboutQt, tr("About &Qt"));
}

void WindowActions::retranslateSolvers()
{
  say(solverAuto, tr("Automatic"), tr("The cheapest way that keeps the tolerance"));
  for (const SolverInfo& info : solverNames())
    for (QAction* action : solver->actions())
      if (action->data().toString().toStdString() == info.name)
        say(action, QString::fromStdString(info.name), solverHelp(info));
}

void WindowActions::retranslateMenus()
{
  fileMenu->setTitle(tr("&File"));
  recentMenu->setTitle(tr("Open &recent"));
  sampleMenu->setTitle(tr("Sa&mples"));
  editMenu->setTitle(tr("&Edit"));
  viewMenu->setTitle(tr("&View"));
  colouringMenu->setTitle(tr("&Colour by"));
  docksMenu->setTitle(tr("&Panels"));
  themeMenu->setTitle(tr("&Theme"));
  languageMenu->setTitle(tr("&Language"));
  tissueMenu->setTitle(tr("&Tissue"));
  simulationMenu->setTitle(tr("&Simulation"));
  toolMenu->setTitle(tr("T&ool"));
  solverMenu->setTitle(tr("So&lver"));
  hapticsMenu->setTitle(tr("&Haptics"));
  helpMenu->setTitle(tr("Hel&p"));
  toolBar->setWindowTitle(tr("Tool bar"));
  stopBar->setWindowTitle(tr("Stop"));
  for (const QToolBar* bar : {toolBar, stopBar})
    for (QAction* action : bar->actions())
      if (QWidget* widget = bar->widgetForAction(action);
          widget != nullptr && widget->inherits("QToolButton"))
        widget->setAccessibleName(
          QString(action->text()).remove(QLatin1Char('&')).remove(QStringLiteral("…")));
}

} // namespace esm
