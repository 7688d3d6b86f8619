// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/project/frame_writers.h"
#include "core/project/json_tree.h"

#include <algorithm>
#include <cstdint>

namespace esm {

namespace {

using json::Json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kLines = 1, kTriangles = 4;

/// The binary chunk with the views and accessors into it.
struct Buffer {
  std::string bytes;
  Json views = Json::array(), accessors = Json::array();

  std::size_t add(const void* data, std::size_t size, int target, Json accessor)
  {
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}, {"target", target}});
    bytes.append(static_cast<const char*>(data), size);
    accessor["bufferView"] = views.size() - 1;
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
  }
};

std::size_t addPositions(Buffer& buffer, const Eigen::Matrix3Xd& position)
{
  const Eigen::Matrix3Xf single = position.cast<float>();
  const auto list = [](const Eigen::Vector3f& v) { return Json{v[0], v[1], v[2]}; };
  return buffer.add(single.data(), static_cast<std::size_t>(single.size()) * sizeof(float), kArrayBuffer,
                    {{"componentType", kFloat},
                     {"type", "VEC3"},
                     {"count", single.cols()},
                     {"min", list(single.rowwise().minCoeff())},
                     {"max", list(single.rowwise().maxCoeff())}});
}

template <class Matrix>
std::size_t addIndices(Buffer& buffer, const Matrix& places)
{
  return buffer.add(places.data(), static_cast<std::size_t>(places.size()) * sizeof(Index),
                    kElementArrayBuffer,
                    {{"componentType", kUnsignedInt}, {"type", "SCALAR"}, {"count", places.size()}});
}

void appendChunk(std::string& out, const char* type, std::string content, char padding)
{
  content.resize((content.size() + 3) / 4 * 4, padding);
  appendRaw(out, static_cast<std::uint32_t>(content.size()));
  out.append(type, 4).append(content);
}

/// Triangles and springs (as lines) over one array of single-precision points. glTF is y up; the node's
/// rotation says that our points are z up. Empty if there is nothing to show.
Json documentOf(const Frame& frame, Buffer& buffer)
{
  const SpringNet& net = *frame.net;
  if (net.nodeCount() == 0 || net.springCount() + net.triangleCount() == 0) return {};
  const std::size_t position = addPositions(buffer, *frame.position);
  Json primitives = Json::array();
  const auto add = [&](int mode, std::size_t indices) {
    primitives.push_back({{"attributes", {{"POSITION", position}}}, {"indices", indices}, {"mode", mode}});
  };
  if (net.triangleCount() > 0) add(kTriangles, addIndices(buffer, net.triangles));
  if (net.springCount() > 0) add(kLines, addIndices(buffer, net.ends));

  constexpr double kHalfRoot = 0.70710678118654752;
  return {{"asset", {{"version", "2.0"}, {"generator", "Elastodynamic Shape Modeler"}}},
          {"scene", 0},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes", {{{"mesh", 0}, {"rotation", {-kHalfRoot, 0.0, 0.0, kHalfRoot}}}}},
          {"meshes", {{{"primitives", primitives}}}},
          {"buffers", {{{"byteLength", (buffer.bytes.size() + 3) / 4 * 4}}}},
          {"bufferViews", buffer.views},
          {"accessors", buffer.accessors}};
}

Error emptyError(const std::filesystem::path& path)
{
  return {ErrorCode::EmptyResult, path.string() + ": not written, the net is empty"};
}

/// RFC 4648.
std::string base64(const std::string& bytes)
{
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

} // namespace

/// glTF 2.0 binary.
Status writeGlb(const Frame& frame, const std::filesystem::path& path)
{
  Buffer buffer;
  const Json document = documentOf(frame, buffer);
  if (document.is_null()) return emptyError(path);
  std::string chunks;
  appendChunk(chunks, "JSON", document.dump(), ' ');
  appendChunk(chunks, "BIN" /* and its NUL */, buffer.bytes, '\0');
  std::string bytes = "glTF";
  appendRaw(bytes, std::uint32_t{2});
  appendRaw(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return writeFileAtomically(path, bytes + chunks);
}

/// The same as JSON text with the numbers inside, one file.
Status writeGltf(const Frame& frame, const std::filesystem::path& path)
{
  Buffer buffer;
  Json document = documentOf(frame, buffer);
  if (document.is_null()) return emptyError(path);
  buffer.bytes.resize((buffer.bytes.size() + 3) / 4 * 4);
  document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer.bytes);
  return writeFileAtomically(path, document.dump());
}

} // namespace esm
