// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/assimp_frame.h"

#include "core/base/text_number.h"
#include "meshimport/stated_frame.h"

#include <Eigen/LU>

#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <string>

namespace esm {

namespace {

/// Of these the library turns the scene from z up to y up.
constexpr std::string_view kLaidDown[] = {"3ds", "ase", "ask",     "iqm", "md2",
                                          "md3", "mdc", "md5mesh", "mdl", "q3s"};
constexpr std::string_view kIfc[] = {"ifc", "ifczip", "step", "stp"};

template <std::size_t n>
bool isOneOf(std::string_view ending, const std::string_view (&endings)[n])
{
  return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

/// A whole number that the library keeps of an FBX.
int setting(const aiMetadata& settings, const char* key, int missing)
{
  std::int32_t value = 0;
  return settings.Get(key, value) ? value : missing;
}

/// 0.1 of float32 as 0.1.
double asWritten(float value)
{
  char text[32];
  const char* const end = std::to_chars(std::begin(text), std::end(text), value).ptr;
  return parseDouble({text, static_cast<std::size_t>(end - text)}).value_or(double{value});
}

/// FBX names an axis of its own for right, up and front, each with a sign; its unit is a centimetre or as
/// many as UnitScaleFactor says.
SceneStart startOfFbx(const aiMetadata& settings, const Eigen::Matrix4d& root)
{
  SceneStart start{{}, root};
  float factor = 1.0f;
  settings.Get("UnitScaleFactor", factor);
  stateMetres(start.stated, 0.01 * asWritten(factor));

  Eigen::Matrix4d toYUp = Eigen::Matrix4d::Zero(); // right, up, front
  toYUp(3, 3) = 1.0;
  const char* const names[] = {"CoordAxis", "UpAxis", "FrontAxis"};
  for (int row = 0; row < 3; ++row) {
    const int axis = setting(settings, names[row], row);
    if (axis < 0 || axis > 2) return start;
    toYUp(row, axis) = setting(settings, (std::string(names[row]) + "Sign").c_str(), 1) < 0 ? -1.0 : 1.0;
  }
  if (!(toYUp.determinant() > 0.0)) return start; // no rotation: nothing is mirrored here
  Eigen::Matrix4d zUp = Eigen::Matrix4d::Zero();
  zUp(0, 0) = zUp(1, 2) = zUp(3, 3) = 1.0;
  zUp(2, 1) = -1.0;
  start.stated.up = toYUp == zUp ? UpAxis::Z : UpAxis::Y;
  if (start.stated.up == UpAxis::Y) start.root = toYUp * root;
  return start;
}

/// The value of an OpenGEX metric: Metric (key = "distance") {float {0.01}}
std::string_view metric(std::string_view text, std::string_view key)
{
  const std::size_t place = text.find("\"" + std::string(key) + "\"");
  if (place == text.npos) return {};
  text.remove_prefix(place);
  const std::size_t outer = text.find('{'), inner = text.find('{', outer + 1), end = text.find('}');
  if (outer == text.npos || inner == text.npos || end == text.npos || end < inner) return {};
  text = text.substr(inner + 1, end - inner - 1);
  const std::size_t first = std::min(text.find_first_not_of(" \t\r\n\""), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_first_of(" \t\r\n\""));
}

StatedFrame statedByOpenGex(std::string_view text)
{
  StatedFrame stated;
  stateMetres(stated, parseDouble(metric(text, "distance")).value_or(0.0));
  const std::string_view up = metric(text, "up");
  if (up == "y") stated.up = UpAxis::Y;
  if (up == "z") stated.up = UpAxis::Z;
  return stated;
}

/// The library heeds prefixes of the metre, but no feet and inches.
double metresOfIfc(std::string_view text)
{
  if (text.find(".LENGTHUNIT.,'FOOT'") != text.npos) return 0.3048;
  if (text.find(".LENGTHUNIT.,'INCH'") != text.npos) return 0.0254;
  return 1.0;
}

} // namespace

Eigen::Matrix4d matrixOf(const aiMatrix4x4& m)
{
  Eigen::Matrix4d out;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) out(row, column) = double{m[row][column]};
  return out;
}

SceneStart startOf(const aiScene& scene, std::string_view bytes, std::string_view ending,
                   std::vector<std::string>& notes)
{
  SceneStart start{{}, Eigen::Matrix4d::Identity()};
  if (scene.mRootNode) start.root = matrixOf(scene.mRootNode->mTransformation);
  if (ending == "fbx" && scene.mMetaData) return startOfFbx(*scene.mMetaData, start.root);
  start.stated =
    ending == "ogex" ? statedByOpenGex(bytes) : statedInXml(bytes, ending == "zae" ? "dae" : ending, notes);
  if (ending == "dae" || ending == "zae") start.root.setIdentity(); // unit and axes, nothing else
  if (ending == "glb" || ending == "gltf") start.stated = {1.0, UpAxis::Y, {}};
  if (isOneOf(ending, kIfc)) start.stated = {metresOfIfc(bytes), UpAxis::Y, {}};
  if (isOneOf(ending, kLaidDown)) start.stated.up = UpAxis::Y;
  return start;
}

} // namespace esm
