// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sample_files.h"
#include "app/text/error_text.h"
#include "app/window/screen_room.h"
#include "app/window/window_actions.h"
#include "core/base/file_io.h"
#include "core/project/project_io.h"
#include "meshimport/mesh_importer.h"
#include "tests/app/window_test.h"

#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QFileSystemWatcher>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScreen>
#include <QStatusBar>

#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

using namespace esm;
using test::Answer;
using test::WindowTest;

namespace {

/// The window with a project that has a file, and has been edited since.
struct WindowFilesTest : WindowTest {
  QString path;
  std::string theirs; ///< what somebody else writes

  void SetUp() override
  {
    WindowTest::SetUp();
    path = folder.filePath("organ.esm");
    ASSERT_TRUE(saveProject(test::sheetProject(4), path.toStdString()));
    ASSERT_TRUE(window->openPath(path));
    window->document()->rename("mine");
    Project other = test::sheetProject(5);
    other.name = "theirs";
    theirs = toJson(other);
  }
  std::string onDisk() const { return *readFile(path.toStdString()); }
  std::string nameOnDisk() const { return loadProject(path.toStdString())->name; }
};

} // namespace

TEST_F(WindowFilesTest, SavesWithoutAQuestionWhatNobodyElseTouched)
{
  Answer answer("dlgOtherVersion", "");
  ASSERT_TRUE(window->saveProject());
  window->document()->rename("mine again"); // what was saved is known too
  ASSERT_TRUE(window->saveProject());
  EXPECT_FALSE(answer.given);
  EXPECT_EQ(nameOnDisk(), "mine again");
}

// What is written into a device is nowhere: the window says so, and the work stays unsaved work.
TEST_F(WindowFilesTest, SavesIntoFilesOnly)
{
  for (const char* device : {"/dev/null", "/dev/full"}) {
    ASSERT_TRUE(QFile::remove(path));
    ASSERT_TRUE(QFile::link(device, path));
    Answer error("dlgError", "");
    EXPECT_FALSE(window->saveProject());
    EXPECT_TRUE(error.given);
    EXPECT_TRUE(error.said.contains("a device") && error.said.contains("another name"))
      << qPrintable(error.said);
    EXPECT_TRUE(window->document()->isModified());
  }
  ASSERT_TRUE(window->document()->saveAs(folder.filePath("elsewhere.esm")));
  EXPECT_FALSE(window->document()->isModified());
}

// What somebody else has saved in the meantime is lost only by a word of the user.
TEST_F(WindowFilesTest, AsksBeforeAnotherVersionIsOverwritten)
{
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), theirs));
  Answer cancel("dlgOtherVersion", "");
  EXPECT_FALSE(window->saveProject());
  EXPECT_TRUE(cancel.given);
  EXPECT_TRUE(cancel.said.contains("organ.esm")) << qPrintable(cancel.said);
  EXPECT_EQ(onDisk(), theirs);
  EXPECT_TRUE(window->document()->isModified());

  Answer overwrite("dlgOtherVersion", "otherVersionOverwrite");
  EXPECT_TRUE(window->saveProject());
  EXPECT_TRUE(overwrite.given);
  EXPECT_EQ(nameOnDisk(), "mine");
  EXPECT_TRUE(overwrite.said.contains("organ.esm.other.bak")) << qPrintable(overwrite.said);

  window->document()->rename("once more"); // from now on it is this window's version
  auto none = std::make_unique<Answer>("dlgOtherVersion", "");
  EXPECT_TRUE(window->saveProject());
  EXPECT_FALSE(none->given);
  none.reset();
  EXPECT_EQ(*readFile(path.toStdString() + ".other.bak"), theirs)
    << "no save touches what was promised to stay";

  ASSERT_TRUE(writeFileAtomically(path.toStdString(), theirs + "\n"));
  Answer again("dlgOtherVersion", "otherVersionOverwrite");
  EXPECT_TRUE(window->saveProject());
  EXPECT_TRUE(again.said.contains("organ.esm.other2.bak")) << qPrintable(again.said);
  EXPECT_EQ(*readFile(path.toStdString() + ".other.bak"), theirs);
  EXPECT_EQ(*readFile(path.toStdString() + ".other2.bak"), theirs + "\n");
}

// Another organ does not take the file of the former one by the way.
TEST_F(WindowFilesTest, AsksBeforeAnotherModelTakesTheFile)
{
  Document* document = window->document();
  const auto bring = [&](bool replace) {
    IncomingModel model;
    model.name = "other";
    model.net = test::sheetProject(3).net;
    ASSERT_TRUE(document->importModel(std::move(model), replace));
  };
  const std::string before = onDisk();
  ASSERT_NO_FATAL_FAILURE(bring(true));
  Answer cancel("dlgOtherModel", "");
  EXPECT_FALSE(window->saveProject());
  EXPECT_TRUE(cancel.said.contains("organ.esm")) << qPrintable(cancel.said);
  EXPECT_EQ(onDisk(), before);
  EXPECT_TRUE(document->isModified());

  document->undoStack()->undo(); // and the question with it
  auto none = std::make_unique<Answer>("dlgOtherModel", "");
  EXPECT_TRUE(window->saveProject());
  ASSERT_NO_FATAL_FAILURE(bring(false)); // what is added takes nothing away
  EXPECT_TRUE(window->saveProject());
  EXPECT_FALSE(none->given);
  none.reset();
  document->undoStack()->undo();

  ASSERT_NO_FATAL_FAILURE(bring(true));
  Answer overwrite("dlgOtherModel", "otherVersionOverwrite");
  EXPECT_TRUE(window->saveProject());
  EXPECT_TRUE(overwrite.given);
  EXPECT_EQ(loadProject(path.toStdString())->net.nodeCount(), 9);
  document->rename("later"); // it is this organ's file now
  Answer again("dlgOtherModel", "");
  EXPECT_TRUE(window->saveProject());
  EXPECT_FALSE(again.given);
  document->undoStack()->undo();
  document->undoStack()->undo(); // the former organ is another one than the file's
  EXPECT_FALSE(window->saveProject());
  EXPECT_TRUE(again.given);
}

namespace {

/// Names a file in the next dialog that asks for one, and lets it replace what is there.
class ChosenFile : public QTimer {
public:
  explicit ChosenFile(const QString& path)
  {
    connect(this, &QTimer::timeout, this, [this, path] {
      QWidget* shown = QApplication::activeModalWidget();
      if (auto* files = qobject_cast<QFileDialog*>(shown); files != nullptr && !m_isNamed) {
        m_isNamed = true;
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))
          ->setText(path); // selectFile() leaves it while it has focus
        QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
      } else if (auto* replace = qobject_cast<QMessageBox*>(shown); m_isNamed && replace != nullptr) {
        if (QAbstractButton* yes = replace->button(QMessageBox::Yes)) yes->click();
      }
    });
    start(10);
  }

private:
  bool m_isNamed = false;
};

} // namespace

TEST_F(WindowFilesTest, SavesAnotherVersionElsewhere)
{
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), theirs));
  Answer elsewhere("dlgOtherVersion", "otherVersionSaveAs");
  const QString other = folder.filePath("elsewhere.esm");
  const ChosenFile chosen(other);
  EXPECT_TRUE(window->saveProject());
  EXPECT_EQ(onDisk(), theirs);
  EXPECT_EQ(loadProject(other.toStdString())->name, "mine");
  EXPECT_EQ(window->document()->path(), other);
}

// Save As onto what somebody else has written, in this project's file or another one, keeps that under a name that no
// later save touches; a version of this window's own goes to .bak as ever.
TEST_F(WindowFilesTest, SaveAsKeepsWhatSomebodyElseHasWritten)
{
  const QString other = folder.filePath("other.esm");
  const auto saveAs = [&](const QString& to) {
    const ChosenFile chosen(to);
    return window->saveProjectAs();
  };
  ASSERT_TRUE(writeFileAtomically(other.toStdString(), theirs));
  ASSERT_TRUE(saveAs(other)); // another project's file
  ASSERT_TRUE(QFile::exists(other + ".other.bak"));
  EXPECT_EQ(*readFile(other.toStdString() + ".other.bak"), theirs);
  EXPECT_TRUE(window->statusBar()->currentMessage().contains("other.esm.other.bak"))
    << qPrintable(window->statusBar()->currentMessage());
  window->document()->rename("mine again");
  ASSERT_TRUE(saveAs(other)); // this window's own by now
  EXPECT_FALSE(QFile::exists(other + ".other2.bak"));
  EXPECT_FALSE(window->statusBar()->currentMessage().contains(".bak"));
  EXPECT_EQ(*readFile(other.toStdString() + ".other.bak"), theirs);

  ASSERT_TRUE(writeFileAtomically(other.toStdString(), theirs + "\n")); // changed since it was saved here
  window->document()->rename("third");
  ASSERT_TRUE(saveAs(other));
  ASSERT_TRUE(QFile::exists(other + ".other2.bak"));
  EXPECT_EQ(*readFile(other.toStdString() + ".other2.bak"), theirs + "\n");
  EXPECT_EQ(loadProject(other.toStdString())->name, "third");

  const QString empty = folder.filePath("empty.esm"), fresh = folder.filePath("fresh.esm");
  ASSERT_TRUE(writeFileAtomically(empty.toStdString(), ""));
  ASSERT_TRUE(saveAs(empty) && saveAs(fresh)); // nothing to lose
  EXPECT_FALSE(QFile::exists(empty + ".other.bak") || QFile::exists(fresh + ".other.bak"));
}

// Closing asks first whether to save, then this; a window that may not save stays.
TEST_F(WindowFilesTest, ClosingDoesNotOverwriteEither)
{
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), theirs));
  Answer unsaved("dlgUnsaved", "unsavedSave");
  Answer cancel("dlgOtherVersion", "");
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(cancel.given);
  EXPECT_EQ(onDisk(), theirs);
}

// A file that is gone has nothing to lose; neither has one that was only touched.
TEST_F(WindowFilesTest, AsksForNoReasonOfNothing)
{
  Answer answer("dlgOtherVersion", "");
  const std::string bytes = onDisk();
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), bytes)); // as a copy that was put back
  EXPECT_TRUE(window->saveProject());
  ASSERT_TRUE(QFile::remove(path));
  window->document()->rename("back");
  EXPECT_TRUE(window->saveProject());
  EXPECT_FALSE(answer.given);
  EXPECT_EQ(nameOnDisk(), "back");
}

// Two windows on one file: each learns that the other was first.
TEST_F(WindowFilesTest, TwoDocumentsOfOneFileNoticeEachOther)
{
  Document other;
  ASSERT_TRUE(other.open(path));
  other.rename("other");
  EXPECT_FALSE(other.fileChangedOnDisk());
  ASSERT_TRUE(window->saveProject());
  EXPECT_TRUE(other.fileChangedOnDisk());
  ASSERT_TRUE(other.saveAs(path));
  EXPECT_FALSE(other.fileChangedOnDisk());
  EXPECT_TRUE(window->document()->fileChangedOnDisk());
}

// A project may name anything as its mesh file. Watching opens no pipe, waits for none, and watches no folder
// of devices; the files beside them are watched as ever.
TEST_F(WindowTest, TheWatchOfChangedFilesLeavesDevicesAndPipesAlone)
{
  const std::string pipe = folder.filePath("wall.obj").toStdString();
  const std::string mesh = folder.filePath("changed.obj").toStdString();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ASSERT_TRUE(writeFileAtomically(mesh, "v 0 0 0\n"));
  const QString link = folder.filePath("link.obj");
  ASSERT_TRUE(QFile::link(QString::fromStdString(pipe), link));
  Project project = test::sheetProject(3);
  project.source.files = {{pipe, 1}, {"/dev/zero", 2}, {link.toStdString(), 3}, {mesh, 4}};
  window->document()->start(std::move(project), QString());
  const auto* bar = window->findChild<QFrame*>("changedFilesBar");
  const auto* watcher = bar->findChild<QFileSystemWatcher*>();
  const auto nobodyReads = [&] { // to open a pipe for writing succeeds at once only if somebody reads it
    const int file = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (file >= 0) ::close(file);
    return file < 0;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] {
    EXPECT_TRUE(nobodyReads());
    return !bar->isHidden();
  }));
  EXPECT_TRUE(window->findChild<QLabel*>("changedFilesText")->text().endsWith(": changed.obj"));
  EXPECT_EQ(watcher->files(), QStringList{QString::fromStdString(mesh)});
  EXPECT_EQ(watcher->directories(), QStringList{folder.path()});

  ASSERT_TRUE(std::filesystem::remove(mesh)); // and while it watches
  ASSERT_EQ(::mkfifo(mesh.c_str(), 0600), 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar->isHidden(); }));
  EXPECT_FALSE(watcher->files().contains(QString::fromStdString(mesh)));
}

namespace {

/// A sound glTF whose numbers are in another file.
std::string gltfOf(const std::string& buffer)
{
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], )"
         R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "accessors": [{"bufferView": 0, )"
         R"("componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}], )"
         R"("bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": ")" +
         buffer + R"("}]})";
}

/// What core says of files that are wrong in the ways that users meet.
std::vector<Error> errorsOfFiles(const QTemporaryDir& folder)
{
  std::vector<Error> errors;
  const auto written = [&](const char* name, const std::string& bytes) {
    const std::string path = folder.filePath(name).toStdString();
    EXPECT_TRUE(writeFileAtomically(path, bytes));
    return path;
  };
  const std::string good = toJson(test::sheetProject(3));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = good;
    EXPECT_NE(changed.find(from), std::string::npos) << from;
    return changed.replace(changed.find(from), from.size(), to);
  };
  const std::string pipe = folder.filePath("pipe.esm").toStdString();
  EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path :
       {folder.filePath("absent.esm").toStdString(), folder.path().toStdString(), pipe,
        std::string("/dev/zero"), written("empty.esm", ""), written("text.esm", "no project"),
        written("cut.esm", good.substr(0, 700)),
        written("newer.esm", with("\"schema_version\": 1", "\"schema_version\": 7")),
        written("key.esm", with("\"name\"", "\"nom\"")),
        written("twice.esm", with("\"name\"", "\"name\": \"a\", \"name\"")),
        written("type.esm", with("\"name\": \"sheet\"", "\"name\": 5")),
        written("solver.esm", with("\"solver\": \"auto\"", "\"solver\": \"magic\""))}) {
    const auto project = loadProject(path);
    EXPECT_FALSE(project) << path;
    if (!project) errors.push_back(project.error());
  }
  for (const std::string& path :
       {folder.filePath("absent.obj").toStdString(),
        folder.path().toStdString(),
        std::string("/dev/zero"),
        written("empty.stl", ""),
        written("blank.obj", "  \n"),
        written("noise.stl", std::string(60, '\x01')),
        written("points.obj", "v 0 0 0\n"),
        written("comma.obj", "v 0,5 0 0\n"),
        written("far.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"),
        written("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n"),
        written("cloud.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                             "y\nproperty float z\nend_header\n0 0 0\n"),
        written("picture.obj", "\x89PNG\r\n\x1a\n"),
        written("plate.step", "ISO-10303-21;\nHEADER;\n"),
        written("deck.inp", "*HEADING\n*NODE\n"),
        written("paged.obj", "<!doctype html>\n"),
        written("lost.gltf", gltfOf("../outside.bin")),
        written("gone.gltf", gltfOf("gone.bin")),
        written("old.off", "OFF\n3 1 0\n0 0 0\n"),
        written("torn.amf", "<amf>\n<object>\n</amf>"),
        written("cut.dae", "<?xml version=\"1.0\"?><COLLADA"),
        written("torn.3mf", "PK\3\4 no archive"),
        written("cut.lwo", "FARM"),
        written("letter.nff", "p 3\n0 0 0\n1 a 0\n0 1 0\n"),
        written("none.3ds", "no 3DS at all"),
        written("cut.fbx", "; FBX 7.3.0 project file\nObjects:  {\n"),
        written("torn.iv", "#Inventor V2.1 ascii\nSeparator {\n Coord3 { }\n}\n"),
        written("cut.gltf", gltfOf("gone.bin").substr(0, 200)),
        written("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n")}) {
    const auto mesh = importMesh(path);
    EXPECT_FALSE(mesh) << path;
    if (!mesh) errors.push_back(mesh.error());
  }
  Project broken = test::sheetProject(3);
  broken.net.stiffness[0] = -3.0;
  for (const Status& saved :
       {saveProject(test::sheetProject(3), folder.filePath("no/such/folder/a.esm").toStdString()),
        saveProject(test::sheetProject(3), folder.path().toStdString()),
        saveProject(broken, folder.filePath("broken.esm").toStdString())}) {
    EXPECT_FALSE(saved);
    if (!saved) errors.push_back(saved.error());
  }
  return errors;
}

} // namespace

// The file is sound, only its part stays closed or is not there.
TEST_F(WindowTest, AFileWhosePartsAreMissingIsNotCalledDamaged)
{
  const std::string path = folder.filePath("a.gltf").toStdString();
  ASSERT_TRUE(writeFileAtomically(path, gltfOf("../outside.bin")));
  const auto mesh = importMesh(path);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(errorLead(mesh.error().code), "The file cannot be read.");
  language.set(Language::German);
  EXPECT_EQ(errorLead(mesh.error().code), "Die Datei kann nicht gelesen werden.");
  EXPECT_EQ(
    errorDetail(mesh.error()),
    QString::fromStdString(path) +
      ": ihr Teil „../outside.bin“ fehlt hier: es liegt außerhalb des Ordners des Modells und bleibt "
      "geschlossen; die Teile daneben legen, oder sie in dem Programm, aus dem sie kommt, als OBJ, PLY oder "
      "STL speichern");
}

// Should a sentence of the core change, its translation is missed here: in German each part is another text.
TEST_F(WindowTest, WhatIsWrongWithAFileIsSaidInTheWindowsLanguage)
{
  const std::vector<Error> errors = errorsOfFiles(folder);
  for (const Error& error : errors) EXPECT_EQ(errorDetail(error).toStdString(), error.detail); // English
  language.set(Language::German);
  const QStringList english{" is ", " the ", " be ", " file", "cannot", " it ", " no ", " has ", " not "};
  for (const Error& error : errors) {
    const QString said = QLatin1Char(' ') + errorDetail(error) + QLatin1Char(' ');
    for (const QString& word : english)
      EXPECT_FALSE(said.contains(word)) << qPrintable(word) << " in " << qPrintable(said);
  }
  EXPECT_EQ(errorDetail(QStringLiteral(
              "/a: b/x.obj: line 3: a vertex needs three coordinates; is the file cut short?")),
            "/a: b/x.obj: Zeile 3: eine Ecke braucht drei Koordinaten; ist die Datei abgeschnitten?");
  EXPECT_EQ(
    errorDetail(
      QStringLiteral("x.step: this is a STEP file, which holds surfaces and no mesh; mesh it in the "
                     "CAD program and save that as STL or OBJ")),
    "x.step: das ist eine STEP-Datei, die Flächen enthält und kein Netz; im CAD-Programm vernetzen und das "
    "als STL oder OBJ speichern");
  EXPECT_EQ(
    errorDetail(QStringLiteral("x.amf: line 4: </a> stands where </b> should, begun in line 2; mend it, or "
                               "save it as OBJ, PLY or STL in the program it comes from")),
    "x.amf: Zeile 4: </a> steht, wo </b> stehen müsste, begonnen in Zeile 2; sie in Ordnung bringen, oder "
    "sie in dem Programm, aus dem sie kommt, als OBJ, PLY oder STL speichern");
  EXPECT_EQ(
    errorDetail(QStringLiteral("x.x: the reader for this format failed: it crashed (segmentation fault), "
                               "by a fault of its own or because the file is damaged; convert the file to "
                               "OBJ, PLY or STL")),
    "x.x: der Leser dieses Formats ist gescheitert: er ist abgestürzt (Speicherschutzfehler), durch einen "
    "eigenen Fehler oder weil die Datei beschädigt ist; die Datei in OBJ, PLY oder STL umwandeln");
  // counted things, and lists of them
  EXPECT_EQ(errorDetail(QStringLiteral("x.msh: line 7: it promises 90 blocks of nodes, but the file is too "
                                       "small for them; it is cut short, fetch it again")),
            "x.msh: Zeile 7: sie verspricht 90 Blöcke von Knoten, aber dafür ist die Datei zu klein; sie ist "
            "abgeschnitten, neu holen");
  EXPECT_EQ(errorDetail(QStringLiteral(
              "x.dxf: it holds no line, polyline or face, only 2 entities on layers that are frozen or off "
              "(a, b), 3 CIRCLE, 1 INSERT without its block; save solids and surfaces as STL, move what is "
              "wanted to model space and show it")),
            "x.dxf: sie enthält keine Linie, Polylinie oder Fläche, nur 2 Objekte auf gefrorenen oder "
            "ausgeschalteten Layern (a, b), 3 CIRCLE, 1 INSERT ohne seinen Block; Körper und Flächen als STL "
            "speichern, das Gewünschte in den Modellbereich legen und sichtbar machen");
  // what nobody knows is the library's, and said to be
  EXPECT_EQ(errorDetail(QStringLiteral(
              "x.b3d: the file cannot be read; save it as OBJ, PLY or STL in the program it comes "
              "from; the reading library says: B3D: line 5; a file is odd")),
            "x.b3d: die Datei kann nicht gelesen werden; sie in dem Programm, aus dem sie kommt, als OBJ, "
            "PLY oder STL "
            "speichern; die lesende Bibliothek sagt: B3D: line 5; a file is odd");
  EXPECT_EQ(errorDetail(QStringLiteral("x.esm: cannot be read (Permission denied)")),
            "x.esm: nicht lesbar (keine Berechtigung)");
  EXPECT_EQ(errorDetail(QStringLiteral("%2.obj: line 1: '%1' is no corner (as 7, 7/1, 7//3 or 7/1/3)")),
            "%2.obj: Zeile 1: „%1“ ist keine Ecke (wie 7, 7/1, 7//3 oder 7/1/3)");
}

// An organ is called in the menu and in the title as the window's language calls it.
TEST_F(WindowTest, SamplesAreNamedInTheWindowsLanguage)
{
  EXPECT_EQ(sampleTitle("/x/fallopian_tube.esm"), "Fallopian tube");
  EXPECT_EQ(sampleTitle("/x/my_own_organ.obj"), "my own organ");
  window->setLanguage(Language::German);
  QStringList names;
  for (const QAction* action : window->actions()->sampleMenu->actions()) names << action->text();
  EXPECT_TRUE(names.contains("Eileiter") && names.contains("Gallenblase") && names.contains("Gebärmutter"))
    << qPrintable(names.join(' '));
  ASSERT_TRUE(window->openSample());
  EXPECT_TRUE(window->windowTitle().startsWith("Eileiter")) << qPrintable(window->windowTitle());
}

// Nobody wonders why nothing moves.
TEST_F(WindowFilesTest, AnOpenedProjectSaysThatItIsPausedAndSoDoesAPull)
{
  const QStatusBar* bar = window->statusBar();
  EXPECT_TRUE(bar->currentMessage().contains("organ.esm")) << qPrintable(bar->currentMessage());
  EXPECT_TRUE(bar->currentMessage().contains("paused")) << qPrintable(bar->currentMessage());
  window->controller()->setPlaying(true);
  EXPECT_TRUE(bar->currentMessage().isEmpty()) << qPrintable(bar->currentMessage());
  emit window->sceneView()->pullStarted(0, 0.0, 0.0, 0.01);
  EXPECT_TRUE(bar->currentMessage().isEmpty());
  emit window->sceneView()->pullEnded();
  window->controller()->setPlaying(false);
  emit window->sceneView()->pullStarted(0, 0.0, 0.0, 0.01);
  EXPECT_TRUE(bar->currentMessage().contains("paused"));
  emit window->sceneView()->pullEnded();
}

// A window is all on the screen with its frame, wherever it was when it was last closed.
TEST(ScreenRoom, ThePlaceOfAWindowIsAllOnTheScreen)
{
  const QRect room(0, 24, 1366, 744); // a panel of the desktop above
  const QMargins frame(4, 30, 4, 4);
  const auto isAll = [&](const QRect& place) { return room.contains(place.marginsAdded(frame)); };
  EXPECT_TRUE(isAll(placeWithin(room, QRect(0, 0, 1600, 1000), frame)));    // as large as another screen
  EXPECT_TRUE(isAll(placeWithin(room, QRect(1500, 300, 800, 600), frame))); // to the right of it
  EXPECT_TRUE(isAll(placeWithin(room, QRect(-700, -90, 800, 600), frame)));
  EXPECT_EQ(placeWithin(room, QRect(1500, 300, 800, 600), frame).size(), QSize(800, 600));
  const QRect fits(100, 100, 800, 600);
  EXPECT_EQ(placeWithin(room, fits, frame), fits);
}

TEST_F(WindowTest, AStoredLayoutIsBroughtBackToTheScreen)
{
  const QRect room = window->screen()->availableGeometry();
  {
    MainWindow other(&language);
    other.setGeometry(room.right() - 200, room.bottom() - 100, room.width() + 400, room.height() + 300);
    other.show();
    other.close(); // stores it
  }
  MainWindow restored(&language);
  const ScreenKeeper keeper;
  restored.restoreLayout();
  restored.show();
  // Panels have a least width, which the screen of this test may not have.
  EXPECT_TRUE(QTest::qWaitFor([&] {
    const QRect place = restored.frameGeometry();
    return room.contains(place.topLeft()) && room.bottom() >= place.bottom();
  }))
    << restored.frameGeometry().x() << ", " << restored.frameGeometry().y() << ", "
    << restored.frameGeometry().width() << " x " << restored.frameGeometry().height();
}

TEST_F(WindowTest, DialogsLargerThanTheScreenAreBroughtBackToIt)
{
  const QRect room = window->screen()->availableGeometry();
  const ScreenKeeper keeper;
  QDialog dialog(window.get());
  dialog.setGeometry(room.right() - 100, room.bottom() - 100, room.width() + 400, room.height() + 300);
  dialog.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return room.contains(dialog.frameGeometry()); }));
}

// What "Save" would overwrite is named, though the project is called otherwise.
TEST_F(WindowTest, TheTitleNamesTheFile)
{
  EXPECT_TRUE(window->windowTitle().startsWith("sheet[*] "));
  ASSERT_TRUE(window->document()->saveAs(folder.filePath("mine.esm")));
  EXPECT_TRUE(window->windowTitle().startsWith("sheet (mine.esm)[*] ")) << qPrintable(window->windowTitle());
  ASSERT_TRUE(window->document()->saveAs(folder.filePath("sheet.esm")));
  EXPECT_TRUE(window->windowTitle().startsWith("sheet.esm[*] ")) << qPrintable(window->windowTitle());
}
