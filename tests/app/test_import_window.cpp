// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/import_dialog.h"
#include "app/import/note_text.h"
#include "app/import/recipe_form.h"
#include "app/import/unit_question.h"
#include "app/window/screen_room.h"
#include "core/base/file_io.h"
#include "core/net/net_builder.h"
#include "core/project/project_io.h"
#include "tests/app/window_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QScreen>
#include <QStatusBar>
#include <QTreeWidget>

using namespace esm;
using test::WindowTest;

TEST_F(WindowTest, ImportDialogReportsAndBuildsTheNet)
{
  const QString path = folder.filePath("two.obj");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 0 0 0\nv 40 0 0\nv 0 40 0\nv 40 40 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\n"));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  // The lone point becomes no node, so it has no part in the size.
  EXPECT_TRUE(dialog.findChild<QLabel*>("importSize")->text().contains("40 × 40 × 0 mm"));
  EXPECT_TRUE(dialog.findChild<QLabel*>("importPrediction")->text().contains("4 nodes, 5 springs"));
  EXPECT_FALSE(dialog.findChild<QAbstractButton*>("importAdd")->isEnabled());
  dialog.findChild<QComboBox*>("importUnit")->setCurrentText("cm");
  EXPECT_TRUE(dialog.findChild<QLabel*>("importSize")->text().contains("400 × 400 × 0 mm"));
  dialog.accept(); // the net of these choices is still being made: there is nothing to take
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  const IncomingModel model = dialog.takeModel();
  EXPECT_EQ(model.net.nodeCount(), 4);
  EXPECT_EQ(model.source.unit, LengthUnit::Centimetre);
  ASSERT_TRUE(window->document()->importModel(model, true));
  EXPECT_EQ(window->document()->undoStack()->count(), 1);
}

// The lone vertex is a defect with a place; chosen in the list it is ringed in the preview.
TEST_F(WindowTest, ImportDialogListsDefectsAndRemembersChoices)
{
  const QString path = folder.filePath("two.remembered");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 0 0 0\nv 40 0 0\nv 0 40 0\nv 40 40 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\n"));
  JobRunner jobs;
  const auto ready = [](ImportDialog& dialog) {
    return QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); });
  };
  {
    ImportDialog dialog({path}, &jobs, true, defaultTissue());
    ASSERT_TRUE(ready(dialog));
    EXPECT_TRUE(dialog.findChild<QLabel*>("importRemembered")->text().isEmpty());
    auto* list = dialog.findChild<QTreeWidget*>("importDefects");
    ASSERT_EQ(list->topLevelItemCount(), 2); // the open border, the vertex that nothing uses
    list->setCurrentItem(list->topLevelItem(1)->child(0));
    ASSERT_EQ(dialog.view()->marks().cols(), 1);
    EXPECT_LT((dialog.view()->marks() - Eigen::Vector3d(0.009, 0.009, 0.009)).norm(), 1e-12);
    dialog.findChild<QCheckBox*>("importUseless")->setChecked(true);
    ASSERT_TRUE(ready(dialog));
    dialog.accept();
  }
  ImportDialog again({path}, &jobs, true, defaultTissue());
  EXPECT_TRUE(again.findChild<QCheckBox*>("importUseless")->isChecked());
  EXPECT_TRUE(again.findChild<QLabel*>("importRemembered")->text().contains("REMEMBERED"));
  again.findChild<QAbstractButton*>("importReset")->click();
  EXPECT_FALSE(again.findChild<QCheckBox*>("importUseless")->isChecked());
  ASSERT_TRUE(ready(again));
}

// Numbers of the material come as inputs of the tissue, together with the net, in one step of undo.
TEST_F(WindowTest, ImportDialogBringsTheMaterial)
{
  const QString path = folder.filePath("bar.material");
  ASSERT_TRUE(writeFileAtomically(
    path.toStdString(), "v 0 0 0\nv 9 0 0\nv 0 30 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
  Document* document = window->document();
  const TissueModel before = document->project().tissue;
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, before);
  const auto ready = [&] {
    return QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); });
  };
  ASSERT_TRUE(ready());
  dialog.findChild<QComboBox*>("importBody")->setCurrentIndex(1);
  dialog.findChild<QDoubleSpinBox*>("importThickness")->setValue(1.5);
  dialog.findChild<QDoubleSpinBox*>("importModulus")->setValue(40.0);
  EXPECT_FALSE(dialog.findChild<QCheckBox*>("importFit")->isEnabled()); // the modulus brings it
  ASSERT_TRUE(ready());
  dialog.accept();
  const IncomingModel model = dialog.takeModel();
  EXPECT_EQ(model.source.material.youngsModulus, 40e3);
  ASSERT_TRUE(document->importModel(model, true));
  EXPECT_EQ(document->project().tissue.thickness, 0.0015);
  EXPECT_NEAR(document->tissueField()->base().youngsModulus / 40e3, 1.0, 0.01);
  EXPECT_NE(document->project().net.material.modulusScale, 1.0);
  document->undoStack()->undo();
  EXPECT_EQ(document->project().tissue.thickness, before.thickness);
  EXPECT_EQ(document->project().tissue.inputs, before.inputs);
}

// What is added comes beside the model with its own lines, struts and bands, in one step of undo; nothing of
// the model moves, its tissue and recipe stay, and the whole can be simulated and saved.
TEST_F(WindowTest, ImportDialogAddsToTheModel)
{
  const QString path = folder.filePath("bar.added");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 0 0 0\nv 9 0 0\nv 0 30 0\nv 0 0 9\nv 0 0 40\nv 20 0 40\n"
                                  "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nl 4 5 6\n"));
  Document* document = window->document();
  const Project before = document->project();
  const Index nodes = before.net.nodeCount(), springs = before.net.springCount();
  ASSERT_GT(nodes, 0);
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, false, before.tissue);
  dialog.findChild<QComboBox*>("importAnchors")->setCurrentIndex(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  EXPECT_TRUE(dialog.replaces());
  auto* add = dialog.findChild<QAbstractButton*>("importAdd");
  ASSERT_TRUE(add->isEnabled());
  add->click();
  EXPECT_FALSE(dialog.replaces());
  dialog.accept();
  ASSERT_TRUE(document->importModel(dialog.takeModel(), dialog.replaces()));
  const Project& after = document->project();
  EXPECT_EQ(after.net.nodeCount(), nodes + 6);
  EXPECT_EQ(after.net.springCount(), springs + 6 + 2);
  EXPECT_EQ(std::count(after.net.kind.begin() + springs, after.net.kind.end(), SpringKind::Line), 2);
  EXPECT_EQ((after.net.anchors.bandLength > 0.0).count(), 4); // from the surface, not from the lines
  EXPECT_EQ(after.net.restPosition.leftCols(nodes), before.net.restPosition);
  EXPECT_NEAR(after.net.restPosition(1, nodes + 2), 0.03, 1e-15);
  EXPECT_TRUE((after.net.stiffness.head(springs) == before.net.stiffness).all());
  EXPECT_TRUE(checkNet(after.net));
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.source, before.source);
  EXPECT_EQ(after.tissue.inputs, before.tissue.inputs);
  const auto file = folder.filePath("both.esm");
  ASSERT_TRUE(document->saveAs(file));
  const auto read = loadProject(file.toStdString());
  ASSERT_TRUE(read) << read.error().detail;
  EXPECT_EQ(read->net.nodeCount(), nodes + 6);
  document->undoStack()->undo();
  EXPECT_EQ(document->project().net.nodeCount(), nodes);
}

// 600 triangles, one above the other, and one that pierces them all: more than are listed. The list says so,
// instead of passing what it shows for all there is.
TEST_F(WindowTest, ImportDialogSaysThatMoreTrianglesMayRunThroughOthers)
{
  std::string text = "v 1 1 -1\nv 2 1 -1\nv 1 1 601\nf 1 2 3\n";
  for (int i = 0; i < 600; ++i) {
    const std::string z = std::to_string(i) + ".5";
    text += "v 0 0 " + z + "\nv 9 0 " + z + "\nv 0 9 " + z + "\nf -3 -2 -1\n";
  }
  const QString path = folder.filePath("stack.pierced");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), text));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  auto* list = dialog.findChild<QTreeWidget*>("importDefects");
  const auto found = list->findItems("Triangles that run through others: at least ", Qt::MatchStartsWith);
  ASSERT_EQ(found.size(), 1);
  QTreeWidgetItem* head = found.front();
  const int last = head->childCount() - 1;
  EXPECT_EQ(head->child(last)->text(0), "The search ended early: there may be more");
  EXPECT_FALSE(head->toolTip(0).isEmpty());
  list->setCurrentItem(head->child(last)); // a remark has no place
  EXPECT_EQ(dialog.view()->marks().cols(), 0);
  language.set(Language::German);
  EXPECT_TRUE(
    QTest::qWaitFor([&] { return list->findItems("Triangles that run", Qt::MatchStartsWith).isEmpty(); }));
}

// A mesh file that changes on disk shows a bar; Update takes it in one step of undo, and the bar goes.
TEST_F(WindowTest, AChangedFileIsOfferedAndTakenInOneStep)
{
  const QString path = folder.filePath("wall.watched");
  const auto write = [&](const char* last) {
    ASSERT_TRUE(writeFileAtomically(path.toStdString(), std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + last +
                                                          "f 1 2 3\nf 2 4 3\n"));
  };
  write("v 1 1 0\n");
  Document* document = window->document();
  {
    JobRunner jobs;
    ImportDialog dialog({path}, &jobs, true, document->project().tissue);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
    dialog.accept();
    ASSERT_TRUE(document->importModel(dialog.takeModel(), true));
  }
  document->setFixed({1}, true);
  const int steps = document->undoStack()->count();
  auto* bar = window->findChild<QFrame*>("changedFilesBar");
  QTest::qWait(700); // longer than a change takes to settle
  EXPECT_TRUE(bar->isHidden());
  write("v 1 1 0.5\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !bar->isHidden(); }));
  EXPECT_TRUE(window->findChild<QLabel*>("changedFilesText")->text().contains("wall.watched"));
  window->findChild<QAbstractButton*>("changedFilesIgnore")->click();
  EXPECT_TRUE(bar->isHidden());
  EXPECT_EQ(document->undoStack()->count(), steps);
  write("v 1 1 0.25\n"); // once more: it asks again
  ASSERT_TRUE(QTest::qWaitFor([&] { return !bar->isHidden(); }));
  window->findChild<QAbstractButton*>("changedFilesUpdate")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return document->undoStack()->count() == steps + 1; }));
  EXPECT_EQ(document->project().net.restPosition(2, 3), 0.25);
  EXPECT_EQ(document->project().net.fixed[1], 1); // what was carried over
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar->isHidden(); }));
  document->undoStack()->undo();
  EXPECT_EQ(document->project().net.restPosition(2, 3), 0.0);
}

TEST_F(WindowTest, ImportDialogSaysWhyItCannot)
{
  const QString path = folder.filePath("empty.stl");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), ""));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  auto* message = dialog.findChild<QLabel*>("importMessage");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !message->text().isEmpty(); }));
  EXPECT_TRUE(message->text().contains("empty.stl"));
  EXPECT_FALSE(dialog.findChild<QAbstractButton*>("importOk")->isEnabled());
}

// A new organ keeps the base tissue of the former one, but no regions, which lie where that one was; unless
// the user says otherwise. One step of undo either way, and the camera shows the new organ.
TEST_F(WindowTest, ReplacingTheModelAsksWhatStaysOfItsTissue)
{
  const QString path = folder.filePath("far.organ");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 900 0 0\nv 940 0 0\nv 900 40 0\nv 940 40 0\nf 1 2 3\nf 2 4 3\n"));
  Document* document = window->document();
  document->setInput(0, 0.9, 0);
  Region region;
  region.name = "wall";
  region.ellipsoid.semiAxes.setConstant(0.02);
  document->addRegion(region); // and it is what the panels show
  ASSERT_EQ(document->inputTarget(), 0);
  ViewSettings looked = window->sceneView()->viewSettings();
  looked.distance = 0.7;
  const TissueModel former = document->project().tissue;
  const int steps = document->undoStack()->count();
  const auto replaceBy = [&](int row) {
    window->sceneView()->setViewSettings(looked);
    JobRunner jobs;
    ImportDialog dialog({path}, &jobs, false, document->project().tissue);
    auto* keeps = dialog.findChild<QComboBox*>("importKeeps");
    EXPECT_FALSE(keeps->isHidden());
    EXPECT_EQ(keeps->currentIndex(), 0);
    keeps->setCurrentIndex(row);
    auto* ok = dialog.findChild<QAbstractButton*>("importOk");
    ASSERT_TRUE(QTest::qWaitFor([&] { return ok->isEnabled(); }));
    dialog.accept();
    ASSERT_TRUE(document->importModel(dialog.takeModel(), dialog.replaces()));
  };
  const auto same = [](const TissueModel& a, const TissueModel& b) {
    return a.rules == b.rules && a.inputs == b.inputs && settingsOf(a) == settingsOf(b);
  };
  ASSERT_NO_FATAL_FAILURE(replaceBy(0));
  EXPECT_TRUE(document->project().tissue.regions.empty());
  EXPECT_TRUE(same(document->project().tissue, former));
  EXPECT_EQ(document->inputTarget(), -1);
  EXPECT_EQ(document->undoStack()->count(), steps + 1);
  EXPECT_EQ(window->sceneView()->viewSettings().distance, 0.0) << "0: it fits the model";
  document->undoStack()->undo();
  EXPECT_EQ(document->project().tissue.regions, former.regions);
  EXPECT_EQ(document->project().net.nodeCount(), 64);

  ASSERT_NO_FATAL_FAILURE(replaceBy(1));
  EXPECT_EQ(document->project().tissue.regions, former.regions);
  EXPECT_TRUE(same(document->project().tissue, former));
  document->undoStack()->undo();

  fuzzy::RuleBase fewer = document->ruleBase(); // other rules, so that all panels must follow
  fewer.rules.resize(1);
  document->setRuleBase(fewer, "fewer");
  document->setInputTarget(0);
  ASSERT_NO_FATAL_FAILURE(replaceBy(2));
  EXPECT_TRUE(same(document->project().tissue, defaultTissue()));
  EXPECT_TRUE(document->project().tissue.regions.empty());
  document->undoStack()->undo();
  EXPECT_EQ(document->ruleBase(), fewer);
  EXPECT_EQ(document->project().tissue.regions.size(), 1u);
}

// What the status bar tells of a net goes with it, and so does the word that it came.
TEST_F(WindowTest, AReplacedModelTakesItsNewsWithIt)
{
  Document* document = window->document();
  const auto* derived = find<QLabel>("lblDerived");
  document->setInput(0, 0.9, 0);
  ASSERT_TRUE(derived->text().contains("derived")) << qPrintable(derived->text());
  IncomingModel model;
  model.name = "other";
  model.net = test::sheetProject(3).net;
  ASSERT_TRUE(document->importModel(std::move(model), true));
  EXPECT_TRUE(derived->text().isEmpty()) << qPrintable(derived->text());
  window->statusBar()->showMessage("Opened other.dae");
  document->undoStack()->undo();
  EXPECT_TRUE(window->statusBar()->currentMessage().isEmpty());
}

// Nothing was there before: there is nothing to ask, and what was set up for the organ to come holds.
TEST_F(WindowTest, TheFirstModelKeepsAllOfTheTissue)
{
  const QString path = folder.filePath("first.organ");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), "v 0 0 0\nv 40 0 0\nv 0 40 0\nf 1 2 3\n"));
  TissueModel tissue = defaultTissue();
  Region region;
  region.name = "wall";
  region.ellipsoid.semiAxes.setConstant(0.02);
  region.inputs = tissue.inputs;
  tissue.regions.push_back(region);
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, tissue);
  EXPECT_TRUE(dialog.findChild<QComboBox*>("importKeeps")->isHidden());
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  dialog.accept();
  EXPECT_EQ(dialog.takeModel().tissue->regions, tissue.regions);
}

// 30 units are a usual organ in mm, and 30 m in metres: then the user is asked, and the likely unit is
// offered.
TEST_F(WindowTest, AModelOfNoOrgansSizeIsTakenOnlyByAWordOfTheUser)
{
  const QString path = folder.filePath("wall.units");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), "v 0 0 0\nv 30 0 0\nv 0 30 0\nf 1 2 3\n"));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  auto* unit = dialog.findChild<QComboBox*>("importUnit");
  auto* size = dialog.findChild<QLabel*>("importSize");
  auto* ok = dialog.findChild<QAbstractButton*>("importOk");
  const auto ready = [&] { return QTest::qWaitFor([&] { return ok->isEnabled(); }); };
  ASSERT_TRUE(ready());
  EXPECT_EQ(unit->currentText(), "mm");
  EXPECT_FALSE(size->text().contains("unit")) << qPrintable(size->text());
  unit->setCurrentText("m");
  EXPECT_TRUE(size->text().contains("With the unit mm it would be 30 mm large")) << qPrintable(size->text());
  ASSERT_TRUE(ready());
  {
    test::Answer cancel("dlgUnit", "");
    dialog.accept();
    EXPECT_TRUE(cancel.given);
    EXPECT_TRUE(cancel.said.contains("30 m large")) << qPrintable(cancel.said);
    EXPECT_NE(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(unit->currentText(), "m");
  }
  {
    test::Answer use("dlgUnit", "unitUse");
    dialog.accept();
    EXPECT_TRUE(use.given);
    EXPECT_NE(dialog.result(), QDialog::Accepted) << "the net of the other unit is to be seen first";
    EXPECT_EQ(unit->currentText(), "mm");
  }
  unit->setCurrentText("m");
  ASSERT_TRUE(ready());
  {
    test::Answer keep("dlgUnit", "unitKeep");
    dialog.accept();
    EXPECT_TRUE(keep.given);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
  }
  // The next file of the kind has its unit guessed anew, for metres would go unseen among what is remembered.
  ImportDialog next({path}, &jobs, true, defaultTissue());
  auto* nextOk = next.findChild<QAbstractButton*>("importOk");
  ASSERT_TRUE(QTest::qWaitFor([&] { return nextOk->isEnabled(); }));
  EXPECT_FALSE(next.findChild<QLabel*>("importRemembered")->text().isEmpty());
  EXPECT_EQ(next.findChild<QComboBox*>("importUnit")->currentText(), "mm");
  test::Answer none("dlgUnit", "");
  next.accept();
  EXPECT_FALSE(none.given);
  EXPECT_EQ(next.result(), QDialog::Accepted);
}

// From 1 mm to 2 m nothing is asked; the ends belong to it, as float32 writes them too.
TEST(UnitQuestion, ProposesTheUnitOfAUsualSize)
{
  EXPECT_TRUE(isUsualSize(double(0.001f)));
  EXPECT_EQ(likelyUnit(30.0), LengthUnit::Millimetre);
  EXPECT_EQ(likelyUnit(0.12), LengthUnit::Metre);
  EXPECT_FALSE(likelyUnit(50000.0)); // micrometres: none of those that are offered
}

// A dialog whose buttons are below the screen's edge is of no use: 1024 x 768 with a frame is the least.
TEST_F(WindowTest, TheImportDialogFitsSmallScreens)
{
  const QString path = folder.filePath("one.obj");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), "v 0 0 0\nv 40 0 0\nv 0 40 0\nf 1 2 3\n"));
  JobRunner jobs;
  for (const Language spoken : {Language::English, Language::German}) {
    language.set(spoken);
    ImportDialog dialog({path}, &jobs, false, defaultTissue());
    EXPECT_LE(dialog.height(), sizeWithoutFrame(dialog.screen()->availableSize()).height());
    dialog.resize(1016, 672);
    dialog.show();
    QTest::qWait(20);
    EXPECT_LE(dialog.width(), 1016);
    EXPECT_LE(dialog.height(), 672);
    const auto* ok = dialog.findChild<QWidget*>("importOk");
    EXPECT_TRUE(dialog.rect().contains(QRect(ok->mapTo(&dialog, QPoint()), ok->size())));
  }
}

// What is told of a file is told in the window's language, and without options of the command line.
TEST_F(WindowTest, NotesOfTheImporterAreInTheWindowsLanguage)
{
  const std::string welded = "988 vertices were joined with others at the same place.";
  const std::string stated =
    "The file states millimetres and y up, which is used (--ignore-stated uses the choices).";
  EXPECT_EQ(importNoteText(stated), "The file states millimetres and y up, which is used.");
  language.set(Language::German);
  EXPECT_EQ(importNoteText(welded), "Mit anderen am selben Ort verbundene Eckpunkte: 988.");
  EXPECT_EQ(importNoteText("a.stl: " + welded),
            "a.stl: Mit anderen am selben Ort verbundene Eckpunkte: 988.");
  EXPECT_EQ(importNoteText(stated), "Die Datei gibt an: Millimeter und y oben. Das gilt.");
  EXPECT_EQ(importNoteText("3 vertices nearly meet others, within 0.5; --weld-tolerance 0.5 joins them."),
            "Eckpunkte, die andere beinahe treffen: 3. Eine Toleranz von 0,5 verbindet sie.");
  for (const char* shape : {"strips of triangles", "fans of triangles", "lines", "tetrahedra", "faces"})
    EXPECT_TRUE(importNoteText("1 of the element 'tristrips' were read as " + std::string(shape) + ".")
                  .startsWith("Aus dem Element „tristrips“ als "))
      << shape;
  EXPECT_EQ(
    importNoteText("The unit that the file states, '0,001', is no length and is not used; --unit states it."),
    "Die Einheit, die die Datei angibt, „0,001“, ist keine Länge und gilt nicht; bitte selbst wählen.");
  EXPECT_EQ(importNoteText(
              "The axes that the field data states (SPACE) are not read: the array 'SPACE' ends early; the "
              "file is damaged; --patient-axes lps or ras states them."),
            "Die Achsen eines Patienten, die die Datei angibt, waren nicht lesbar; bitte selbst wählen.");
  EXPECT_EQ(importNoteText("Something new."), "Something new.");
}

// Where the file's own frame holds, the boxes show it and not what was chosen for another file.
TEST_F(WindowTest, TheUnitThatHoldsIsTheOneThatIsShown)
{
  RecipeForm form;
  ImportRecipe recipe;
  recipe.unit = LengthUnit::Metre;
  form.setRecipe(recipe);
  form.setStated({1e-3, UpAxis::Y, std::nullopt});
  EXPECT_EQ(form.findChild<QComboBox*>("importUnit")->currentText(), "mm");
  EXPECT_EQ(form.recipe().unit, LengthUnit::Millimetre);
  EXPECT_EQ(form.recipe().up, UpAxis::Y);
  form.setStated({1e-6, UpAxis::X, std::nullopt}); // neither is among the choices
  EXPECT_EQ(form.recipe().unit, LengthUnit::Millimetre);
  recipe.ignoreStated = true;
  form.setRecipe(recipe);
  form.setStated({1e-3, UpAxis::Y, std::nullopt});
  EXPECT_EQ(form.recipe().unit, LengthUnit::Metre);
}
