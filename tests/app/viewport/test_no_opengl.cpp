// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/scene_view.h"
#include "tests/app/viewport/sample_nets.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QtTest>

using namespace esm;

// On this platform a QOpenGLWidget would end the process: the page that says so must come instead, and every
// call must be harmless.
TEST(WithoutOpenGl, APageSaysWhatIsMissingAndEverythingElseWorks)
{
  QString why;
  EXPECT_FALSE(SceneView::openGlUsable(&why));
  EXPECT_TRUE(why.contains("offscreen")) << why.toStdString();

  SceneView view;
  view.resize(400, 300);
  view.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
  EXPECT_FALSE(view.hasOpenGl());
  EXPECT_EQ(view.findChild<QOpenGLWidget*>(), nullptr);
  const auto* page = view.findChild<QLabel*>("view3dPlaceholder");
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(page->isVisible());
  EXPECT_TRUE(page->text().startsWith("3D preview needs OpenGL 3.3; everything else works."));
  EXPECT_EQ(view.objectName(), "view3d");
  EXPECT_FALSE(view.accessibleName().isEmpty());

  const auto net = samples::sphere(2, 0.05);
  view.setNet(net, 1);
  view.setSnapshot(samples::restSnapshot(*net, 1, 1));
  view.setParameters(net);
  view.setRegions({Region{}}, 0);
  view.setColouring(Colouring::Force);
  view.setShown(false, false, false);
  view.setToolForce({0, 0, 1});
  view.setTool(Tool::Pull);
  view.fit();
  EXPECT_EQ(view.tool(), Tool::Pull);

  QSignalSpy pulled(&view, &SceneView::pullStarted), moved(&view, &SceneView::viewChanged);
  QTest::mousePress(&view, Qt::LeftButton, {}, view.project(net->restPosition.col(3)).toPoint());
  QTest::mouseMove(&view, {10, 10});
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {10, 10});
  QTest::keyClick(&view, Qt::Key_7);
  EXPECT_EQ(pulled.count() + moved.count(), 0);
  EXPECT_FALSE(view.picture().isNull());
  view.setNet(nullptr, 2);
}

// A project opened and saved on a machine without OpenGL keeps its view.
TEST(WithoutOpenGl, ViewSettingsSurvive)
{
  SceneView view;
  ViewSettings settings;
  settings.distance = 0.4;
  settings.azimuth = 1.0;
  settings.colouring = "strain";
  settings.showSurface = false;
  view.setViewSettings(settings);
  EXPECT_EQ(view.viewSettings().distance, 0.4);
  EXPECT_EQ(view.viewSettings().azimuth, 1.0);
  EXPECT_EQ(view.viewSettings().colouring, "strain");
  EXPECT_FALSE(view.viewSettings().showSurface);
}
