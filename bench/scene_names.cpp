// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/scenes.h"
#include "core/base/hash.h"
#include "core/base/text_number.h"

#include <functional>
#include <utility>

namespace esm::bench {
namespace {

using Maker = std::function<Scene(const SceneOptions&)>;

const std::vector<std::pair<std::string, Maker>>& makers()
{
  static const std::vector<std::pair<std::string, Maker>> table = {
    {"tube", tube}, {"uterus", uterus}, {"sheet", sheet}, {"stiff", stiff}, {"organ100k", organ100k}};
  return table;
}

Status readOption(std::string_view word, SceneOptions& options)
{
  const std::size_t equals = word.find('=');
  const std::string_view key = word.substr(0, equals);
  const double value = equals == word.npos ? 0.0 : parseDouble(word.substr(equals + 1)).value_or(0.0);
  const Error wrong{ErrorCode::InvalidValue,
                    "'" + std::string(word) + "' is no option of a scene; write seed=7, size=2 or time=0.5"};
  if (!(value > 0.0) || value > 1e6) return wrong;
  if (key == "seed")
    options.seed = static_cast<unsigned>(value);
  else if (key == "size")
    options.size = value;
  else if (key == "time")
    options.duration = value;
  else
    return wrong;
  return {};
}

template <class Array>
std::uint64_t hashArray(const Array& array, std::uint64_t seed)
{
  return hashBytes(array.data(), sizeof(*array.data()) * static_cast<std::size_t>(array.size()), seed);
}

std::uint64_t hashCurve(const VectorCurve& curve, std::uint64_t seed)
{
  return hashArray(curve.value, hashArray(curve.time, seed));
}

} // namespace

std::vector<std::string> sceneNames()
{
  std::vector<std::string> names;
  for (const auto& [name, make] : makers()) names.push_back(name);
  return names;
}

Result<Scene> makeScene(std::string_view text)
{
  const std::size_t colon = text.find(':');
  SceneOptions options;
  for (std::string_view rest = colon == text.npos ? "" : text.substr(colon + 1); !rest.empty();) {
    const std::size_t comma = rest.find(',');
    if (Status status = readOption(rest.substr(0, comma), options); !status) return status.error();
    rest = comma == rest.npos ? "" : rest.substr(comma + 1);
  }
  for (const auto& [name, make] : makers())
    if (text.substr(0, colon) == name) {
      Scene scene = make(options);
      scene.name = std::string(text);
      return scene;
    }
  return Error{ErrorCode::InvalidValue, "there is no scene '" + std::string(text.substr(0, colon)) +
                                          "'; choose tube, uterus, sheet, stiff or organ100k"};
}

std::uint64_t hashOf(const Scene& scene)
{
  const SpringNet& net = scene.net;
  std::uint64_t hash = hashBytes(&scene.duration, sizeof scene.duration);
  for (const Eigen::ArrayXd* array : {&net.mass, &net.restLength, &net.stiffness, &net.viscosity,
                                      &net.lawParameter, &net.anchors.stiffness, &net.anchors.viscosity})
    hash = hashArray(*array, hash);
  hash = hashArray(net.restPosition, hashArray(net.anchors.point, hashArray(net.ends, hash)));
  hash = hashArray(net.initialVelocity, hash); // of a net at rest it is empty
  hash = hashArray(net.fixed, hashArray(net.law, hashArray(net.anchors.node, hash)));
  hash = hashArray(scene.loads.gravity, hash);
  for (const NodalForce& force : scene.loads.forces)
    hash = hashCurve(force.force, hashArray(force.nodes, hash));
  for (const PrescribedMotion& motion : scene.loads.motions) {
    hash = hashCurve(motion.displacement, hashArray(motion.nodes, hash));
    const double release = motion.release.value_or(-1.0);
    hash = hashBytes(&release, sizeof release, hash);
  }
  return hash;
}

} // namespace esm::bench
