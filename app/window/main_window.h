// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/haptics/device_desk.h"
#include "app/jobs/job.h"
#include "app/simulation_controller.h"
#include "app/text/language.h"
#include "app/theme.h"
#include "app/viewport/scene_view.h"

#include <QElapsedTimer>
#include <QMainWindow>

#include <filesystem>
#include <functional>

class QDockWidget;
class QLabel;

namespace esm {

class ChangedFilesBar;
class FuzzyEvaluation;
struct FoundJournal;
class Recovery;
class RegionsPanel;
class StatusStrip;
class WhySelection;
class WindowActions;

/// The window of the modeler: the 3D preview in the middle, the panels in docks around it, tool bar, menus
/// and status bar. It joins the parts and asks before anything is lost; the work is theirs.
class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  /// @param language not owned, outlives the window.
  /// @param devices  null: those of this computer.
  explicit MainWindow(LanguageSwitch* language, std::shared_ptr<DeviceSource> devices = nullptr,
                      QWidget* parent = nullptr);
  ~MainWindow() override;

  Document* document() noexcept { return m_document; }
  SimulationController* controller() noexcept { return m_controller; }
  SceneView* sceneView() noexcept { return m_view; }
  DeviceDesk* devices() noexcept { return m_desk; }
  WindowActions* actions() noexcept { return m_actions; }

  // === Files (main_window_files.cpp)
  /// A project or a mesh, by content of its name. Says in a message what went wrong.
  bool openPath(const QString& path);
  bool openSample(); ///< the first sample, playing; false: there is none
  bool saveProject();
  bool saveProjectAs();
  void importPaths(const QStringList& paths); ///< meshes, joined to one model

  // === Unsaved work (main_window_recovery.cpp)
  void keepJournal(const std::filesystem::path& folder); ///< from now on
  /// Asks what shall become of what a crash left. @param asked also of what was put off before.
  /// @return work was recovered into the document.
  bool offerRecovery(bool asked);
  /// What a program has to do at its start: offers unsaved work, opens what the command line names, or a sample.
  /// @param anotherWindow opens the named one where unsaved work has taken this window; whether that went well
  void begin(const QString& named, const std::function<bool(const QString& path)>& anotherWindow);
  Recovery* recovery() noexcept { return m_recovery; } ///< null without keepJournal()

  void setTheme(Theme theme);
  void setLanguage(Language language);
  void selectNode(Index node);
  Index selectedNode() const noexcept { return m_selectedNode; }
  void selectSpring(Index spring);
  Index selectedSpring() const; ///< kNoIndex: none
  void applyDefaultLayout();
  void restoreLayout(); ///< of the last time, if there is one

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // main_window.cpp
  void createDocks();
  QDockWidget* addDock(const char* name, Qt::DockWidgetArea area, QWidget* content);
  void connectDocument();
  void connectActions();
  void connectFrame();
  void showRun();
  void showProject();
  void refreshRegions();
  void refreshHoldAction();
  void chooseRealTime();
  void emergencyStop();

  // main_window_texts.cpp
  void retranslateUi();
  void retranslateUndo();
  void refreshTitle();
  void refreshToolHint();
  void showKeys();
  void showAbout();

  // main_window_files.cpp
  void connectFileActions();
  void watchFiles();
  bool writeProject(const QString& path, const QString& kept = {});
  enum class OtherVersion { Overwrite, SaveElsewhere, Keep };
  OtherVersion askAboutOtherVersion(const QString& kept);
  OtherVersion askAboutOtherModel();
  OtherVersion askBeforeOverwriting(const char* dialog, const QString& text, const QString& what);
  void commitTyped();
  void tellSaved(const QString& kept);
  bool mayDropChanges(); ///< saved, or the user lets them go
  void newProject();
  bool playSample(const QString& path);
  void sayOpened(const QString& name);
  void chooseAndOpen();
  void chooseAndImport();
  void exportShape();
  void savePicture();
  void renameProject();
  void showError(const QString& title, const Error& error);

  // main_window_layout.cpp
  void rememberFile(const QString& path);
  void fillRecentMenu();
  void fillSampleMenu();
  void saveLayout();

  // main_window_recovery.cpp
  void tellUnreadable(std::vector<FoundJournal>& found);
  bool recover(FoundJournal&& journal);

  Document* m_document;
  JobRunner* m_jobs;
  SceneView* m_view;
  SimulationController* m_controller;
  DeviceDesk* m_desk;
  LanguageSwitch* m_language;
  FuzzyEvaluation* m_evaluation;
  WindowActions* m_actions;
  StatusStrip* m_status;
  RegionsPanel* m_regions = nullptr;
  WhySelection* m_why = nullptr;
  ChangedFilesBar* m_changedFiles = nullptr;
  Recovery* m_recovery = nullptr;
  QDockWidget *m_dockRegions = nullptr, *m_dockTissue = nullptr, *m_dockInputs = nullptr, *m_dockMf = nullptr,
              *m_dockSurface = nullptr, *m_dockWhy = nullptr, *m_dockRules = nullptr,
              *m_dockHaptics = nullptr;
  QLabel* m_dropHint;
  Index m_selectedNode = kNoIndex;
  Stability m_shownStability = Stability::Idle;
  bool m_pulledAtEscape =
    false; ///< the mouse pulled as Esc was pressed, which emergencyStop() has not said yet
  QElapsedTimer m_lastStatus;
};

} // namespace esm
