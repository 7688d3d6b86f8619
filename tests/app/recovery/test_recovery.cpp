// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/recovery_dialog.h"
#include "app/document/recovery.h"
#include "app/window/main_window.h"
#include "core/base/file_io.h"
#include "core/project/project_io.h"
#include "fuzzyeditor/rules/rule_table_model.h"
#include "fuzzyeditor/rules/rule_text_page.h"
#include "fuzzyeditor/rules/rules_panel.h"
#include "tests/app/recovery/session.h"
#include "tests/app/sheet.h"

#include <QAbstractButton>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <fstream>

using namespace esm;
namespace fs = std::filesystem;

namespace {

struct RecoveryTest : testing::Test {
  QTemporaryDir folder;
  LanguageSwitch language;
  std::unique_ptr<MainWindow> window;

  fs::path journals() const { return fs::path(folder.path().toStdString()) / "recovery"; }
  QString file() const { return folder.filePath("organ.esm"); }
  void SetUp() override
  {
    language.set(Language::English);
    QObject::connect(&reader, &QTimer::timeout, [this] { press(); });
    reader.start(20);
    openWindow();
  }
  void TearDown() override
  {
    EXPECT_TRUE(answers.isEmpty()) << "not asked: " << answers.join(' ').toStdString();
    window.reset();
    language.set(Language::English);
  }
  void openWindow()
  {
    window = std::make_unique<MainWindow>(&language);
    window->keepJournal(journals());
    window->document()->start(test::sheetProject(), QString());
    window->show();
  }
  /// As if the process had been killed: nobody has said what shall become of the changes.
  void crash() { window.reset(); }
  Document& document() { return *window->document(); }
  RuleTableModel* table() { return window->findChild<RulesPanel*>()->tableModel(); }
  QPlainTextEdit* text() { return window->findChild<QPlainTextEdit*>("rulesText"); }
  void makeMistake(const QString& cell)
  {
    table()->setData(table()->index(1, RuleTableModel::Condition), cell);
  }

  // === Somebody who answers dialogs: one button of each that comes, in order
  QStringList answers, rows;
  QString said, asked;
  QTimer reader;

  void answer(const char* button) { answers << button; }
  void press()
  {
    QWidget* dialog = QApplication::activeModalWidget();
    if (dialog == nullptr) return;
    asked = dialog->objectName();
    auto* box = qobject_cast<QMessageBox*>(dialog);
    if (box != nullptr) said = box->text() + '\n' + box->informativeText();
    if (auto* list = dialog->findChild<QListWidget*>()) {
      rows.clear();
      for (int i = 0; i < list->count(); ++i) rows << list->item(i)->text();
    }
    const QString name = answers.isEmpty() ? QString() : answers.takeFirst();
    if (box != nullptr && name == "Discard") // its text is the platform's
      return box->button(QMessageBox::Discard)->click();
    for (auto* each : dialog->findChildren<QAbstractButton*>())
      if (each->objectName() == name || each->text().remove('&') == name) return each->click();
    ADD_FAILURE() << "nobody answers " << asked.toStdString() << " with " << name.toStdString();
    dialog->close();
  }
};

} // namespace

// The whole way: edits, the end of the process, the question, and the document as it was.
TEST_F(RecoveryTest, CrashedWorkIsOfferedAndComesBack)
{
  ASSERT_TRUE(document().saveAs(file()));
  document().setInput(0, 0.9, 0);
  document().setGravity({0.0, 0.0, -1.0});
  document().setFixed({0, 3}, true);
  const std::string before = toJson(document().project());
  crash();
  openWindow();
  answer("recoveryRecover");
  ASSERT_TRUE(window->offerRecovery(false));
  EXPECT_EQ(asked, "dlgRecovery");
  ASSERT_EQ(rows.size(), 1);
  EXPECT_TRUE(rows[0].contains("sheet")) << rows[0].toStdString();
  EXPECT_TRUE(rows[0].contains("3 steps after the last save")) << rows[0].toStdString();
  EXPECT_EQ(toJson(document().project()), before);
  EXPECT_EQ(document().path(), file());
  EXPECT_TRUE(document().isModified());
  EXPECT_TRUE(window->isWindowModified());

  // It is kept on until it is saved.
  document().rename("once more");
  crash();
  openWindow();
  rows.clear();
  answer("recoveryRecover");
  ASSERT_TRUE(window->offerRecovery(false));
  EXPECT_TRUE(rows[0].contains("4 steps after the last save")) << rows[0].toStdString();
  EXPECT_EQ(document().project().name, "once more");
  ASSERT_TRUE(document().saveAs(file()));
  EXPECT_FALSE(document().isModified());
  crash();
  openWindow();
  EXPECT_FALSE(window->offerRecovery(false));
  EXPECT_TRUE(window->recovery()->find().empty());
}

// What a process that was killed has done can be undone and redone by the next one, down to the saved state and
// by whichever process: each state is the one that was there, byte by byte.
TEST_F(RecoveryTest, RecoveredStepsCanBeUndoneAndRedone)
{
  ASSERT_TRUE(document().saveAs(file()));
  std::vector<std::string> states;
  QStringList names;
  const auto note = [&] {
    states.push_back(toJson(document().project()));
    names << document().undoStack()->undoText();
  };
  note();
  document().setInput(0, 0.9, 0), note();
  document().setGravity({0.0, 0.0, -1.0}), note();
  document().rename("dropped");
  document().undoStack()->undo(); // and never redone
  document().setFixed({0, 3}, true), note();
  ASSERT_TRUE(document().importModel({"other", {}, test::sheetProject(5).net, {}}, true));
  note();
  document().setInput(0, 0.2, 7);
  document().setInput(0, 0.3, 7), note(); // one gesture, one step
  document().undoStack()->undo();
  document().undoStack()->undo(); // to be redone
  for (int life = 0; life < 2; ++life) {
    ASSERT_TRUE(window->recovery()->waitWritten(std::chrono::seconds(10)));
    crash();
    openWindow();
    answer("recoveryRecover");
    ASSERT_TRUE(window->offerRecovery(false));
    QUndoStack& undo = *document().undoStack();
    ASSERT_EQ(undo.count(), 5) << life;
    ASSERT_EQ(undo.index(), 3) << life;
    EXPECT_EQ(toJson(document().project()), states[3]) << life;
    for (int i = 2; i >= 0; --i) {
      EXPECT_EQ(undo.undoText(), names[i + 1]) << life;
      undo.undo();
      EXPECT_EQ(toJson(document().project()), states[static_cast<std::size_t>(i)]) << life << ", " << i;
    }
    EXPECT_FALSE(document().isModified()) << "the file has it";
    for (int i = 1; i <= 5; ++i) {
      undo.redo();
      EXPECT_EQ(toJson(document().project()), states[static_cast<std::size_t>(i)]) << life << ", " << i;
    }
    EXPECT_EQ(document().stepsAfterSave(), 5);
    undo.setIndex(3);
  }
}

// Work that no file has: back to what it began from.
TEST_F(RecoveryTest, RecoveredStepsOfUnsavedWorkCanBeUndone)
{
  const std::string before = toJson(document().project());
  document().setInput(0, 0.9, 0);
  document().rename("mine");
  ASSERT_TRUE(window->recovery()->waitWritten(std::chrono::seconds(10)));
  crash();
  openWindow();
  answer("recoveryRecover");
  ASSERT_TRUE(window->offerRecovery(false));
  EXPECT_TRUE(document().isModified());
  document().undoStack()->setIndex(0);
  EXPECT_EQ(toJson(document().project()), before);
  EXPECT_FALSE(document().isModified());
}

// A process that ends in the first second leaves a picture; where it had no time for one the list says so.
TEST_F(RecoveryTest, PictureIsTakenRightAfterTheFirstStep)
{
  Recovery recovery(&document(), journals() / "apart");
  recovery.setPictureSource([] {
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::red);
    return picture;
  });
  document().rename("seen");
  const auto picture = [&] {
    for (const auto& entry : fs::directory_iterator(journals() / "apart"))
      if (fs::exists(entry.path() / kJournalPicture)) return true;
    return false;
  };
  EXPECT_LE(Recovery::kFirstPicture, 500);
  EXPECT_TRUE(QTest::qWaitFor(picture, 30000)); // [ms] a machine may be busy
}

// "3 Schritte nach dem letzten Speichern": in German, and for work without a file.
TEST_F(RecoveryTest, StepsAreSaidInTheWindowsLanguage)
{
  language.set(Language::German);
  EXPECT_EQ(stepsText(3, false, false), "3 Schritte nach dem letzten Speichern");
  EXPECT_EQ(stepsText(1, true, true), "1 Schritt, nie gespeichert, eine Regel in Arbeit");
}

// Later, discard: remembered. What was put off is still there for who asks.
TEST_F(RecoveryTest, AnswersAreRemembered)
{
  document().rename("first");
  crash();
  openWindow();
  answer("recoveryLater");
  EXPECT_FALSE(window->offerRecovery(false));
  EXPECT_FALSE(window->offerRecovery(false)); // asks nothing: there is nobody to answer
  answer("recoveryDiscard");
  answer("Cancel"); // not meant: it is asked once more
  answer("recoveryDiscard");
  answer("Discard");
  EXPECT_FALSE(window->offerRecovery(true));
  EXPECT_FALSE(window->offerRecovery(true));
  EXPECT_TRUE(window->recovery()->find().empty());
}

// A file that is another one by now is not written over.
TEST_F(RecoveryTest, ChangedFileIsNotTheRecoveredWorksFile)
{
  ASSERT_TRUE(document().saveAs(file()));
  document().rename("mine");
  crash();
  ASSERT_TRUE(saveProject(test::sheetProject(5), file().toStdString()));
  openWindow();
  answer("recoveryRecover");
  answer("OK");
  ASSERT_TRUE(window->offerRecovery(false));
  EXPECT_EQ(asked, "dlgRecovered");
  EXPECT_EQ(document().project().name, "mine");
  EXPECT_TRUE(document().path().isEmpty());
}

// The user who lets changes go is not offered them again; who undoes everything has nothing to be offered.
TEST_F(RecoveryTest, WhatWasLetGoIsGone)
{
  document().rename("other");
  answer("Discard");
  window->close();
  crash();
  openWindow();
  EXPECT_TRUE(window->recovery()->find().empty());
  document().rename("other");
  document().undoStack()->undo();
  crash();
  openWindow();
  EXPECT_TRUE(window->recovery()->find().empty());
}

// Journals that cannot be read: one message, the bytes kept, no second question.
TEST_F(RecoveryTest, DamagedJournalIsToldOnceAndKept)
{
  fs::create_directories(journals() / "1-abcdef");
  std::ofstream(journals() / "1-abcdef" / kJournalLines) << "rubbish\nand more\n";
  answer("OK");
  EXPECT_FALSE(window->offerRecovery(false));
  EXPECT_EQ(asked, "dlgError");
  EXPECT_TRUE(said.contains("1-abcdef")) << said.toStdString();
  EXPECT_TRUE(fs::exists(journals() / "kept-1-abcdef" / kJournalLines));
  EXPECT_FALSE(window->offerRecovery(false));
}

// Steps to the saved state, whichever way they went.
TEST_F(RecoveryTest, StepsAreCountedFromTheSavedState)
{
  EXPECT_EQ(document().stepsAfterSave(), 0);
  document().rename("a");
  document().rename("b");
  EXPECT_EQ(document().stepsAfterSave(), 2);
  ASSERT_TRUE(document().saveAs(file()));
  EXPECT_EQ(document().stepsAfterSave(), 0);
  document().undoStack()->undo();
  document().undoStack()->undo();
  EXPECT_EQ(document().stepsAfterSave(), 2);
  document().rename("c"); // the saved state is out of reach: two back and one on
  EXPECT_EQ(document().stepsAfterSave(), 3);
  document().rename("d");
  EXPECT_EQ(document().stepsAfterSave(), 4);
}

// A project that is named at the start is not lost for recovered work: it opens in another window, and the status bar
// says so; where that cannot be, a dialog does.
TEST_F(RecoveryTest, AProjectNamedAtTheStartIsOpenedBesideRecoveredWork)
{
  const QString other = folder.filePath("other.esm");
  ASSERT_TRUE(saveProject(test::sheetProject(4), other.toStdString()));
  ASSERT_TRUE(document().saveAs(file()));
  document().rename("mine");
  QStringList started;
  const auto start = [&](const QString& named, bool works) {
    ASSERT_TRUE(window->recovery()->waitWritten(std::chrono::seconds(10)));
    crash();
    openWindow();
    window->begin(named, [&](const QString& path) {
      started << path;
      return works;
    });
  };
  answer("recoveryRecover");
  ASSERT_NO_FATAL_FAILURE(start(other, true));
  EXPECT_EQ(document().project().name, "mine");
  EXPECT_EQ(started, QStringList{other});
  const QString message = window->statusBar()->currentMessage();
  EXPECT_TRUE(message.contains("Recovered: 1 step") &&
              message.contains("“other.esm” opens in a window of its own"))
    << message.toStdString();

  answer("recoveryRecover");
  ASSERT_NO_FATAL_FAILURE(start(file(), true)); // the work is a later state of it
  answer("recoveryRecover");
  ASSERT_NO_FATAL_FAILURE(start(QString(), true));
  EXPECT_EQ(started.size(), 1);

  answer("recoveryRecover");
  answer("Close");
  ASSERT_NO_FATAL_FAILURE(start(other, false));
  EXPECT_EQ(asked, "dlgNamedLater");
  EXPECT_TRUE(said.contains("“other.esm” is not open")) << said.toStdString();
  EXPECT_EQ(document().project().name, "mine");

  answer("recoveryRecover");
  answer("namedOpenHere");
  answer("Discard"); // asked whether to save what was recovered
  ASSERT_NO_FATAL_FAILURE(start(other, false));
  EXPECT_EQ(document().path(), other);

  document().rename("changed");
  answer("recoveryLater");
  started.clear();
  ASSERT_NO_FATAL_FAILURE(start(file(), true)); // without recovered work as ever
  EXPECT_EQ(document().path(), file());
  EXPECT_TRUE(started.isEmpty());
}

// Who has replaced the model is asked before the next save takes the former organ's file, in every later process
// too; not where that is undone, and not once the file holds the new organ.
TEST_F(RecoveryTest, AnotherModelIsAskedAboutAfterACrashToo)
{
  const auto comeBack = [&] {
    ASSERT_TRUE(window->recovery()->waitWritten(std::chrono::seconds(10)));
    crash();
    openWindow();
    answer("recoveryRecover");
    ASSERT_TRUE(window->offerRecovery(false));
    ASSERT_EQ(document().path(), file());
  };
  ASSERT_TRUE(document().saveAs(file()));
  document().rename("mine");
  ASSERT_NO_FATAL_FAILURE(comeBack());
  EXPECT_FALSE(document().fileHoldsAnotherModel()) << "it is the file's own";
  ASSERT_TRUE(document().importModel({"other", {}, test::sheetProject(5).net, {}}, true));
  document().setInput(0, 0.9, 0);
  for (int life = 0; life < 2; ++life) {
    ASSERT_NO_FATAL_FAILURE(comeBack());
    answer("Cancel");
    EXPECT_FALSE(window->saveProject()) << life;
    EXPECT_EQ(asked, "dlgOtherModel") << life;
    EXPECT_TRUE(said.contains("organ.esm")) << life;
    EXPECT_EQ(loadProject(file().toStdString())->name, "sheet") << life;
  }
  document().undoStack()->undo();
  EXPECT_TRUE(document().fileHoldsAnotherModel());
  document().undoStack()->undo(); // the import
  EXPECT_FALSE(document().fileHoldsAnotherModel());
  document().undoStack()->redo();
  makeMistake("hardnes IS very hard"); // a save that leaves something out: the lines go on
  ASSERT_TRUE(document().saveAs(file()));
  document().rename("later");
  ASSERT_NO_FATAL_FAILURE(comeBack());
  EXPECT_FALSE(document().fileHoldsAnotherModel()) << "the file holds the new organ now";
  document().undoStack()->undo();
  document().undoStack()->undo();
  EXPECT_TRUE(document().fileHoldsAnotherModel()) << "the former organ is another one now";
}

// A rule with a mistake is unsaved work: in the title, at closing, after a crash, and not in another project.
TEST_F(RecoveryTest, MistakeOfTheTableIsUnsavedWork)
{
  EXPECT_FALSE(window->isWindowModified());
  makeMistake("hardnes IS very hard");
  ASSERT_TRUE(table()->mistake());
  EXPECT_TRUE(document().isModified());
  EXPECT_TRUE(window->isWindowModified());
  answer("Cancel");
  EXPECT_FALSE(window->close());
  EXPECT_EQ(asked, "dlgUnsaved");
  EXPECT_TRUE(said.contains("A rule has a mistake")) << said.toStdString();

  crash();
  openWindow();
  answer("recoveryRecover");
  ASSERT_TRUE(window->offerRecovery(false));
  EXPECT_TRUE(rows[0].contains("a rule that was being written"));
  ASSERT_TRUE(table()->mistake());
  EXPECT_EQ(table()->mistake()->text, "hardnes IS very hard");
  EXPECT_EQ(table()->mistake()->row, 1);
  EXPECT_TRUE(window->isWindowModified());

  document().start(test::sheetProject(5), QString());
  EXPECT_FALSE(table()->mistake());
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(document().ruleDraft().isEmpty());
}

// The same for the rules as text, seen or not.
TEST_F(RecoveryTest, MistakeOfTheTextIsUnsavedWork)
{
  auto* tabs = window->findChild<QTabWidget*>("rulesTabs");
  tabs->setCurrentIndex(1);
  QApplication::processEvents();
  const QString whole = text()->toPlainText();
  ASSERT_FALSE(whole.isEmpty());
  text()->setPlainText(whole + "\nIF hardnes IS hard");
  EXPECT_TRUE(window->isWindowModified());
  tabs->setCurrentIndex(0);
  document().setInput(0, 0.7, 0);
  fuzzy::RuleBase rules = document().ruleBase();
  rules.rules[0].weight = 0.5;
  document().setRuleBase(rules, "weight"); // the text follows, unseen
  ASSERT_TRUE(window->recovery()->waitWritten(std::chrono::seconds(10)));
  crash();
  openWindow();
  answer("recoveryRecover");
  ASSERT_TRUE(window->offerRecovery(false));
  EXPECT_EQ(document().ruleBase().rules[0].weight, 0.5);
  window->findChild<QTabWidget*>("rulesTabs")->setCurrentIndex(1);
  QApplication::processEvents();
  EXPECT_TRUE(text()->toPlainText().endsWith("\nIF hardnes IS hard")) << text()->toPlainText().toStdString();
  EXPECT_TRUE(window->isWindowModified());

  document().start(test::sheetProject(5), QString());
  QApplication::processEvents();
  EXPECT_EQ(text()->toPlainText(), whole);
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_FALSE(window->findChild<RulesPanel*>()->textPage()->hasMistakes());
}

// Saving leaves a mistake out and says so; the title goes on telling that something is not saved.
TEST_F(RecoveryTest, MistakeSurvivesASave)
{
  makeMistake("hardnes IS very hard");
  ASSERT_TRUE(document().saveAs(file()));
  EXPECT_TRUE(document().isModified());
  crash();
  openWindow();
  answer("recoveryRecover");
  ASSERT_TRUE(window->offerRecovery(false));
  ASSERT_TRUE(table()->mistake());
  EXPECT_EQ(document().path(), file());
  table()->discardMistake();
  EXPECT_FALSE(document().isModified()) << "the file has everything else";
}

// A rule that is typed and right but not applied yet is saved with the project.
TEST_F(RecoveryTest, TypedRuleIsSavedWithoutAPause)
{
  window->findChild<QTabWidget*>("rulesTabs")->setCurrentIndex(1);
  QApplication::processEvents();
  const std::size_t rules = document().ruleBase().rules.size();
  const QString whole = text()->toPlainText();
  text()->setPlainText(whole + '\n' + whole.section('\n', 0, 0));
  EXPECT_TRUE(document().isModified());
  ASSERT_TRUE(document().saveAs(file()));
  EXPECT_EQ(loadProject(file().toStdString()).value().tissue.rules.rules.size(), rules + 1);
  EXPECT_FALSE(document().isModified());
}
