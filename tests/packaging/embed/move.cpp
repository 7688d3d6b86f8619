// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// Moves the net of a project for a tenth of a second and writes its shape.   move PROJECT SHAPE
#include "core/dynamics/simulation.h"
#include "core/project/export.h"
#include "core/project/project_io.h"

#include <iostream>

int main(int, char** words)
{
  auto project = esm::loadProject(words[1]);
  if (!project) return std::cerr << project.error().detail << '\n', 1;
  project->simulation.solver.duration = 0.1;
  auto motion = esm::Simulation::create(project->net, project->loads, project->simulation.solver);
  if (!motion) return std::cerr << motion.error().detail << '\n', 1;
  for (int frame = 1; frame <= 6; ++frame) motion->advance(frame / 60.0 - motion->state().time);
  const esm::Status done = esm::exportFrame({&motion->net(), &motion->state().position}, words[2]);
  return done ? 0 : (std::cerr << done.error().detail << '\n', 1);
}
