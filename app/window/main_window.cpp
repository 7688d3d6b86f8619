// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"

#include "app/dialogs/real_time_dialog.h"
#include "app/document/recovery.h"
#include "app/haptics/stop_filter.h"
#include "app/icons.h"
#include "app/panels/haptics_panel.h"
#include "app/panels/regions_panel.h"
#include "app/panels/tissue_panel.h"
#include "app/panels/why_selection.h"
#include "app/text/error_text.h"
#include "app/text/reason_text.h"
#include "app/viewport/scene_model.h"
#include "app/window/screen_room.h"
#include "app/window/status_strip.h"
#include "app/window/window_actions.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/inputs_panel.h"
#include "fuzzyeditor/rules/rules_panel.h"
#include "fuzzyeditor/surface/surface_panel.h"
#include "fuzzyeditor/terms/membership_panel.h"
#include "fuzzyeditor/why/why_panel.h"

#include <QAbstractButton>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include <utility>

namespace esm {

MainWindow::MainWindow(LanguageSwitch* language, std::shared_ptr<DeviceSource> devices, QWidget* parent)
  : QMainWindow(parent),
    m_document(new Document(this)),
    m_jobs(new JobRunner(this)),
    m_view(new SceneView(this)),
    m_controller(new SimulationController(m_document, m_view, this)),
    m_desk(new DeviceDesk(devices ? std::move(devices) : makeDeviceSource({}), this)),
    m_language(language),
    m_evaluation(new FuzzyEvaluation(m_document, this)),
    m_actions(new WindowActions(this)),
    m_status(new StatusStrip(statusBar())),
    m_dropHint(new QLabel(this))
{
  setObjectName(QStringLiteral("mainWindow"));
  setWindowIcon(icon(Symbol::Program));
  setAcceptDrops(true);
  m_dropHint->setObjectName(QStringLiteral("dropHint"));
  m_dropHint->setAlignment(Qt::AlignCenter);
  m_dropHint->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_dropHint->setStyleSheet(QStringLiteral("background: palette(window); border: 3px dashed "
                                           "palette(highlight); border-radius: 12px; font-size: 22pt;"));
  m_dropHint->hide();
  setDockNestingEnabled(true);
  m_document->setRuleLanguage(language->language());
  watchFiles();
  createDocks();
  connectDocument();
  connectActions();
  connectFileActions();
  connectFrame();
  qApp->installEventFilter(this);
  new StopFilter([this] { return m_controller->forceMayFlow(); }, [this] { emergencyStop(); }, this);

  m_controller->setQuality(savedQualityPlan());
  retranslateUi();
  showProject();
  resize(QSize(1600, 1000).boundedTo(sizeWithoutFrame(screen()->availableSize())));
  applyDefaultLayout();
  m_desk->open("simulated", [this](DeviceDesk::Opened device) {
    const Status attached = m_controller->attachDevice(std::move(device).value(), "simulated",
                                                       SimulationController::Coupling::HoldsNode);
    if (!attached) statusBar()->showMessage(errorLead(attached.error().code), 8000);
  });
}

/// Panels and controller look at the document, which QObject would delete first as the oldest child.
MainWindow::~MainWindow()
{
  qApp->removeEventFilter(this);
  for (QDockWidget* dock : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) delete dock;
  delete m_recovery;
  delete m_controller;
  delete m_view;
}

// === Panels

QDockWidget* MainWindow::addDock(const char* name, Qt::DockWidgetArea area, QWidget* content)
{
  auto* dock = new QDockWidget(this);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::createDocks()
{
  m_regions = new RegionsPanel(m_document);
  m_why = new WhySelection(m_document, this);
  auto* whyPanel = new WhyPanel(m_why);
  auto* inputs = new InputsPanel(m_evaluation);
  auto* membership = new MembershipPanel(m_evaluation);
  auto* rules = new RulesPanel(m_evaluation);
  connect(inputs, &InputsPanel::inputFocused, membership, &MembershipPanel::showInput);
  connect(whyPanel, &WhyPanel::ruleActivated, rules, &RulesPanel::showRule);
  connect(rules, &RulesPanel::variableRequested, membership, &MembershipPanel::showVariable);

  m_dockRegions = addDock("dockRegions", Qt::LeftDockWidgetArea, m_regions);
  m_dockTissue = addDock("dockTissue", Qt::LeftDockWidgetArea, new TissuePanel(m_document));
  m_dockInputs = addDock("dockInputs", Qt::RightDockWidgetArea, inputs);
  m_dockMf = addDock("dockMf", Qt::RightDockWidgetArea, membership);
  m_dockSurface = addDock("dockSurface", Qt::RightDockWidgetArea, new SurfacePanel(m_evaluation));
  m_dockWhy = addDock("dockWhy", Qt::RightDockWidgetArea, whyPanel);
  m_dockRules = addDock("dockRules", Qt::BottomDockWidgetArea, rules);
  m_dockHaptics = addDock("dockHaptics", Qt::BottomDockWidgetArea, new HapticsPanel(m_desk, m_controller));
  for (QDockWidget* dock : {m_dockRules, m_dockInputs, m_dockMf, m_dockSurface, m_dockWhy, m_dockRegions,
                            m_dockTissue, m_dockHaptics})
    m_actions->docksMenu->addAction(dock->toggleViewAction());
}

void MainWindow::applyDefaultLayout()
{
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  const std::pair<QDockWidget*, Qt::DockWidgetArea> places[] = {
    {m_dockRegions, Qt::LeftDockWidgetArea},  {m_dockTissue, Qt::LeftDockWidgetArea},
    {m_dockInputs, Qt::RightDockWidgetArea},  {m_dockMf, Qt::RightDockWidgetArea},
    {m_dockSurface, Qt::RightDockWidgetArea}, {m_dockWhy, Qt::RightDockWidgetArea},
    {m_dockRules, Qt::BottomDockWidgetArea},  {m_dockHaptics, Qt::BottomDockWidgetArea}};
  for (const auto& [dock, area] : places) {
    dock->setFloating(false);
    addDockWidget(area, dock);
    dock->show();
  }
  constexpr int kLow = 850;     // [pixel]: below, the panels above each other are higher than the window
  constexpr int kNarrow = 1450; // [pixel]: below, rules and haptics do not fit beside each other
  splitDockWidget(m_dockInputs, m_dockMf, Qt::Vertical);
  if (height() < kLow) {
    tabifyDockWidget(m_dockRegions, m_dockTissue);
    tabifyDockWidget(m_dockMf, m_dockWhy);
  } else {
    splitDockWidget(m_dockRegions, m_dockTissue, Qt::Vertical);
    splitDockWidget(m_dockMf, m_dockWhy, Qt::Vertical);
  }
  tabifyDockWidget(m_dockMf, m_dockSurface);
  if (width() < kNarrow)
    tabifyDockWidget(m_dockRules, m_dockHaptics);
  else
    splitDockWidget(m_dockRules, m_dockHaptics, Qt::Horizontal);
  for (QDockWidget* inFront : {m_dockRules, m_dockMf, m_dockRegions}) inFront->raise();
  const int w = width(), h = height();
  resizeDocks({m_dockRegions, m_dockInputs}, {w * 17 / 100, w * 25 / 100}, Qt::Horizontal);
  resizeDocks({m_dockRules, m_dockHaptics}, {w * 42 / 100, w * 33 / 100}, Qt::Horizontal);
  resizeDocks({m_dockRules}, {h * 30 / 100}, Qt::Vertical);
  resizeDocks({m_dockInputs, m_dockMf, m_dockWhy}, {h * 25 / 100, h * 37 / 100, h * 32 / 100}, Qt::Vertical);
}

// === Document to window

void MainWindow::connectDocument()
{
  connect(m_document, &Document::projectReset, this, &MainWindow::showProject);
  connect(m_document, &Document::titleChanged, this, &MainWindow::refreshTitle);
  connect(m_document, &Document::regionsChanged, this, &MainWindow::refreshRegions);
  connect(m_document, &Document::inputTargetChanged, this, &MainWindow::refreshRegions);
  connect(m_document, &Document::netChanged, this, [this] {
    const SpringNet& net = m_document->project().net;
    m_status->setNet(net.nodeCount(), net.springCount());
    if (m_selectedNode < net.nodeCount()) refreshHoldAction();
  });
  connect(m_document, &Document::modelReplaced, this, [this] {
    selectNode(kNoIndex);
    m_status->clearDerived();    // it was of the former springs
    statusBar()->clearMessage(); // and that of what an undo may have taken away
    m_view->fit();
  });
  connect(m_document, &Document::parametersChanged, this,
          [this] { m_status->setDerived(m_document->lastApply(), m_document->lastApplyTime()); });
  connect(m_document, &Document::problem, this, [this](const Error& error) {
    statusBar()->showMessage(errorLead(error.code) + QLatin1Char(' ') + errorDetail(error), 12000);
  });
  QUndoStack* undo = m_document->undoStack();
  connect(undo, &QUndoStack::indexChanged, this, &MainWindow::retranslateUndo);
  connect(m_actions->undo, &QAction::triggered, undo, &QUndoStack::undo);
  connect(m_actions->redo, &QAction::triggered, undo, &QUndoStack::redo);
}

void MainWindow::showProject()
{
  const Project& project = m_document->project();
  selectNode(kNoIndex);
  m_status->setNet(project.net.nodeCount(), project.net.springCount());
  m_status->clearDerived();
  m_view->setViewSettings(project.view);
  m_actions->showSurface->setChecked(project.view.showSurface);
  m_actions->showSprings->setChecked(project.view.showSprings);
  m_actions->showStruts->setChecked(project.view.showStruts);
  for (QAction* action : m_actions->colouring->actions()) {
    const auto colouring = static_cast<Colouring>(action->data().toInt());
    if (colouringName(colouring).toStdString() != project.view.colouring) continue;
    action->setChecked(true);
    m_view->setColouring(colouring);
  }
  for (QAction* action : m_actions->solver->actions())
    action->setChecked(action->data().toString().toStdString() == project.simulation.solver.solver);
  refreshRegions();
  refreshTitle();
  retranslateUndo();
}

void MainWindow::refreshRegions()
{
  m_view->setRegions(m_document->project().tissue.regions, m_document->inputTarget());
}

void MainWindow::selectNode(Index node)
{
  m_selectedNode = node;
  m_why->selectNode(node);
  const SpringNet& net = m_document->project().net;
  if (node != kNoIndex)
    m_regions->setPlaceOfNew(Eigen::Vector3d(net.restPosition.col(node)));
  else
    m_regions->setPlaceOfNew(std::nullopt);
  refreshHoldAction();
}

void MainWindow::selectSpring(Index spring)
{
  selectNode(kNoIndex);
  m_why->selectSpring(spring);
}

Index MainWindow::selectedSpring() const
{
  const ExplainedThing& thing = m_why->selected();
  return thing.kind == ExplainedThing::Kind::Spring ? thing.index : kNoIndex;
}

void MainWindow::refreshHoldAction()
{
  const SpringNet& net = m_document->project().net;
  m_actions->holdNode->setEnabled(m_selectedNode != kNoIndex);
  m_actions->holdNode->setChecked(m_selectedNode != kNoIndex &&
                                  net.fixed[static_cast<std::size_t>(m_selectedNode)] != 0);
}

// === Actions

void MainWindow::connectActions()
{
  const auto on = [this](QAction* action, auto slot) { connect(action, &QAction::triggered, this, slot); };
  on(m_actions->fit, [this] { m_view->fit(); });
  for (QAction* shown : {m_actions->showSurface, m_actions->showSprings, m_actions->showStruts})
    connect(shown, &QAction::toggled, this, [this] {
      m_view->setShown(m_actions->showSurface->isChecked(), m_actions->showSprings->isChecked(),
                       m_actions->showStruts->isChecked());
    });
  connect(m_actions->colouring, &QActionGroup::triggered, this,
          [this](QAction* action) { m_view->setColouring(static_cast<Colouring>(action->data().toInt())); });
  on(m_actions->defaultLayout, [this] { applyDefaultLayout(); });
  connect(m_actions->fullScreen, &QAction::toggled, this,
          [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
  connect(m_actions->theme, &QActionGroup::triggered, this, [this](QAction* action) {
    const Theme theme = themeFromName(action->data().toString()).value_or(Theme::System);
    setTheme(theme);
    QSettings().setValue(QStringLiteral("theme"), themeName(theme));
  });
  connect(m_actions->language, &QActionGroup::triggered, this, [this](QAction* action) {
    setLanguage(languageFromCode(action->data().toString()).value_or(Language::English));
    QSettings().setValue(QStringLiteral("language"), action->data().toString());
  });

  on(m_actions->addRegion, [this] { m_regions->addRegion(); });
  on(m_actions->holdNode, [this](bool hold) { m_document->setFixed({m_selectedNode}, hold); });
  on(m_actions->play, [this] { m_controller->setPlaying(!m_controller->isPlaying()); });
  on(m_actions->step, [this] { m_controller->stepOnce(); });
  on(m_actions->reset, [this] { m_controller->reset(); });
  connect(m_controller, &SimulationController::playingChanged, m_actions, &WindowActions::setPlaying);
  connect(m_controller, &SimulationController::playingChanged, this, [this](bool playing) {
    if (playing) statusBar()->clearMessage(); // what it says of a pause is over
  });
  connect(m_view, &SceneView::pullStarted, this, [this] {
    if (!m_controller->isPlaying()) // with force on the space key stops, and plays nothing
      statusBar()->showMessage(m_controller->forceMayFlow()
                                 ? tr("The simulation is paused: nothing moves until “Play” is pressed.")
                                 : tr("The simulation is paused: nothing moves until it plays (space key)."),
                               15000);
  });
  connect(m_actions->tools, &QActionGroup::triggered, this, [this](QAction* action) {
    m_controller->endPull();
    m_view->setTool(static_cast<Tool>(action->data().toInt()));
    refreshToolHint();
  });
  connect(m_actions->solver, &QActionGroup::triggered, this,
          [this](QAction* action) { m_document->setSolver(action->data().toString().toStdString()); });
  on(m_actions->realTime, [this] { chooseRealTime(); });
  on(m_actions->arm, [this](bool armed) { armed ? m_controller->arm() : m_controller->disarm(); });
  on(m_actions->stop, [this] { emergencyStop(); });
  on(m_actions->keys, [this] { showKeys(); });
  on(m_actions->about, [this] { showAbout(); });
  on(m_actions->aboutQt, [] { QApplication::aboutQt(); });
  connect(m_view, &SceneView::nodeSelected, this, &MainWindow::selectNode);
  connect(m_view, &SceneView::springSelected, this, &MainWindow::selectSpring);
  connect(m_view, &SceneView::selectionChanged, this,
          [this] { m_regions->setSelection(m_view->selection()); });
  connect(m_view, &SceneView::regionDragStarted, m_regions, &RegionsPanel::beginDrag);
  connect(m_view, &SceneView::regionDragged, m_regions, &RegionsPanel::drag);
}

void MainWindow::connectFrame()
{
  connect(m_controller, &SimulationController::frame, this, &MainWindow::showRun);
  connect(m_controller, &SimulationController::clockRead, this, &MainWindow::showRun);
}

/// Numbers that change sixty times a second cannot be read: the status bar follows ten times, whether or not
/// there is a new picture; but a light that turns for the worse does so at once.
void MainWindow::showRun()
{
  constexpr qint64 kPause = 80; // [ms]; with the screen's own 20 at most nothing is older than 100
  const SimSnapshot& snapshot = m_controller->snapshot();
  const bool worse = snapshot.stability > m_shownStability; // in the order of the enumeration
  const bool stopped = worse && snapshot.stability == Stability::Stopped;
  if (stopped)
    statusBar()->showMessage(
      tr("The simulation stopped on its last good state. %1").arg(reasonText(snapshot.message)), 20000);
  if (m_lastStatus.isValid() && m_lastStatus.elapsed() < kPause && !worse) return;
  m_lastStatus.start();
  m_shownStability = snapshot.stability;
  m_status->setRun(snapshot);
  const HapticStatus device = m_controller->hapticStatus();
  m_status->setDevice(device);
  m_actions->arm->setEnabled(device.state != DeviceState::Absent);
  m_actions->arm->setChecked(device.state == DeviceState::Arming || device.state == DeviceState::Active);
}

void MainWindow::chooseRealTime()
{
  RealTimeDialog dialog(savedQualityPlan(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  saveQualityPlan(dialog.plan());
  m_controller->setQuality(dialog.plan());
}

void MainWindow::emergencyStop()
{
  const bool wasOn = m_controller->forceMayFlow();
  const bool wasHeld = std::exchange(m_pulledAtEscape, false) || m_controller->isPulling();
  m_controller->stop();
  m_view->letGo();
  statusBar()->showMessage(
    wasOn     ? tr("Stopped: force zero, tissue released. “Force on” lets the device feel again.")
    : wasHeld ? tr("Stopped: the tissue is released, force is zero.")
              : tr("Force is zero, nothing is held."), // Esc has many uses
    6000);
}

/// Space plays and pauses everywhere but where it presses a button or ticks a row.
bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    // The view lets go at this key, too, and is asked before the shortcut that stops.
    if (key->key() == Qt::Key_Escape && m_controller->isPulling()) m_pulledAtEscape = true;
    const bool pressable = qobject_cast<QAbstractButton*>(watched) != nullptr ||
                           qobject_cast<QComboBox*>(watched) != nullptr ||
                           watched->inherits("QAbstractItemView");
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier && pressable) {
      event->accept();
      return true;
    }
  }
  return QMainWindow::eventFilter(watched, event);
}

} // namespace esm
