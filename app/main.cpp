// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"
#include "app/sample_files.h"
#include "app/window/main_window.h"
#include "app/window/screen_room.h"
#include "app/window/scripted_run.h"
#include "app/window/state_dump.h"
#include "core/base/large_pages.h"
#include "core/base/version.h"
#include "core/project/journal.h"
#include "haptics/exit_guard.h"

#include <QApplication>
#include <QProcess>
#include <QSettings>
#include <QSocketNotifier>
#include <QSurfaceFormat>
#include <QTimer>

#include <clocale>
#include <csignal>
#include <cstdio>
#include <optional>

namespace {

/// Core profile 3.3 for every context; must be set before the application exists.
void askForOpenGl()
{
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL); // Wayland would otherwise default to OpenGL ES
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
}

esm::Language chosenLanguage(const esm::CommandLine& options)
{
  const QString saved = QSettings().value(QStringLiteral("language")).toString();
  const QString asked = QString::fromStdString(options.language);
  return esm::languageFromCode(asked.isEmpty() ? saved : asked).value_or(esm::systemLanguage());
}

esm::Theme chosenTheme(const esm::CommandLine& options)
{
  const QString saved = QSettings().value(QStringLiteral("theme")).toString();
  const QString asked = QString::fromStdString(options.theme);
  return esm::themeFromName(asked.isEmpty() ? saved : asked).value_or(esm::Theme::System);
}

/// A window of its own for a file, started as this one was.
bool startAnotherWindow(const esm::CommandLine& options, const QString& file)
{
  QStringList words;
  const auto add = [&words](const char* option, const std::string& value) {
    if (!value.empty()) words << QLatin1String(option) << QString::fromStdString(value);
  };
  add("--lang", options.language);
  add("--theme", options.theme);
  add("--emulate-device", options.emulate);
  words << QStringLiteral("--") << file; // whatever its name begins with
  return QProcess::startDetached(QApplication::applicationFilePath(), words);
}

/// Without dialogs: nobody may be there to answer.
void runScript(esm::MainWindow& window, const esm::CommandLine& options)
{
  if (options.file.empty()) {
    window.openSample();
  } else if (auto project = esm::projectFromFile(QString::fromStdString(options.file)); project) {
    window.document()->start(std::move(project).value(), QString());
  } else {
    std::fprintf(stderr, "esm-modeler: %s\n", project.error().detail.c_str());
    return QApplication::exit(1);
  }
  new esm::ScriptedRun(&window, QString::fromStdString(options.screenshot), options.after);
}

} // namespace

int main(int argc, char** argv)
{
  esm::keepBigArraysInHeap();
  std::signal(SIGXFSZ, SIG_IGN); // a file beyond the limit of its size is a fault of writing, not the end
  esm::CommandLine options;
  if (const int code = esm::parseCommandLine(argc, argv, options); code >= 0) return code;

  const esm::ExitGuard guard; // no hand is left with a force, however the program ends
  askForOpenGl();
  QApplication application(argc, argv);
  QSocketNotifier asked(esm::ExitGuard::descriptor(), QSocketNotifier::Read);
  QObject::connect(&asked, &QSocketNotifier::activated, &application,
                   [] { QApplication::exit(128 + esm::ExitGuard::signal()); });
  std::setlocale(LC_NUMERIC, "C");  // Qt took the system's: libraries must go on reading 1.5 as 1.5
  std::setlocale(LC_MESSAGES, "C"); // reasons are translated by the window, in its own language
  QApplication::setOrganizationName(QStringLiteral("esm"));
  QApplication::setApplicationName(QStringLiteral("esm-modeler"));
  QApplication::setApplicationVersion(QString::fromLatin1(esm::version()));

  esm::LanguageSwitch language;
  language.set(chosenLanguage(options));
  esm::applyTheme(chosenTheme(options));
  esm::MainWindow window(&language, esm::makeDeviceSource(QString::fromStdString(options.emulate)));
  window.setTheme(chosenTheme(options));
  const bool scripted = !options.screenshot.empty();
  if (!scripted) {
    window.restoreLayout();
    window.keepJournal(esm::recoveryFolder());
  }
  if (options.width > 0 || options.height > 0) {
    window.resize(options.width > 0 ? options.width : window.width(),
                  options.height > 0 ? options.height : window.height());
    window.applyDefaultLayout();
  }
  std::optional<esm::ScreenKeeper> keeper;
  if (!scripted) keeper.emplace(); // a scripted window has the size it was asked for
  window.show();

  // Once the event loop runs: dialogs of opening need it.
  QTimer::singleShot(0, &window, [&] {
    if (scripted) return runScript(window, options);
    window.begin(QString::fromStdString(options.file),
                 [&options](const QString& file) { return startAnotherWindow(options, file); });
  });
  if (!options.dumpState.empty()) new esm::StateDump(&window, QString::fromStdString(options.dumpState));
  return QApplication::exec();
}
