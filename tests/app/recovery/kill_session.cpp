// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The program that is killed: plays a session and notes in FOLDER/log what it begins and what is done.
// usage: esm_kill_session FOLDER document|window
#include "app/document/recovery.h"
#include "app/window/main_window.h"
#include "tests/app/recovery/session.h"

#include <QApplication>
#include <QPushButton>
#include <QTimer>

#include <clocale>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

using namespace esm;

namespace {

/// Straight to the kernel: what is noted survives the process.
void note(int log, const std::string& line)
{
  if (::write(log, (line + '\n').c_str(), line.size() + 1) < 0) std::abort();
}

void play(test::Session& session, int log)
{
  session.open();
  note(log, "done 0");
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [&session, log, timer, step = 0]() mutable {
    ++step;
    note(log, "begin " + std::to_string(step));
    session.step(step);
    note(log, "done " + std::to_string(step));
    if (step == test::Session::kSteps) timer->stop();
  });
  timer->start(1);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3) return 2;
  const std::filesystem::path folder = argv[1];
  const bool hasWindow = std::string(argv[2]) == "window";
  const int log = ::open((folder / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log < 0) return 2;
  const std::unique_ptr<QCoreApplication> application(hasWindow ? new QApplication(argc, argv)
                                                                : new QCoreApplication(argc, argv));
  std::setlocale(LC_NUMERIC, "C");
  const std::filesystem::path file = folder / "organ.esm";
  if (hasWindow) {
    LanguageSwitch language;
    MainWindow window(&language);
    window.keepJournal(folder / "recovery");
    window.show();
    test::Session session(window.document(), file, [&] {
      QTimer::singleShot(0, &window, [] { // over another organ it asks first
        if (QWidget* box = QApplication::activeModalWidget())
          box->findChild<QPushButton*>(QStringLiteral("otherVersionOverwrite"))->click();
      });
      if (!window.saveProject()) std::abort();
    });
    QTimer::singleShot(0, &window, [&] { play(session, log); });
    return QApplication::exec();
  }
  Document document;
  Recovery recovery(&document, folder / "recovery");
  test::Session session(&document, file, [&] {
    if (!document.saveAs(document.path())) std::abort();
  });
  play(session, log);
  return QCoreApplication::exec();
}
