// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/reply.h"

#include "meshimport/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <type_traits>

namespace esm {

namespace {

static_assert(std::is_trivially_copyable_v<ReplyHead> && sizeof(ReplyHead) == 80);

constexpr std::uint64_t kMostText = 1 << 16; ///< bytes of format, notes or reason
constexpr auto kLastCode = static_cast<std::int64_t>(ErrorCode::Internal);
constexpr auto kLastUp = static_cast<std::int32_t>(UpAxis::X);
constexpr auto kLastAxes = static_cast<std::int32_t>(PatientAxes::Ras);

Error garbled(const std::string& what)
{
  return {ErrorCode::BadFormat, what};
}

template <class Matrix>
std::string_view bytesOf(const Matrix& matrix)
{
  return {reinterpret_cast<const char*>(matrix.data()),
          static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar)};
}

/// Cuts arrays off the front of what has arrived. @pre replySize() fits.
class Arrays {
public:
  explicit Arrays(std::string_view bytes) : m_bytes(bytes) {}

  std::string_view text(std::uint64_t size)
  {
    const std::string_view taken = m_bytes.substr(0, size);
    m_bytes.remove_prefix(taken.size());
    return taken;
  }
  template <class Matrix>
  void fill(Matrix& matrix, std::uint64_t columns)
  {
    matrix.resize(Eigen::NoChange, static_cast<Eigen::Index>(columns));
    const std::string_view taken = text(bytesOf(matrix).size());
    if (!taken.empty()) std::memcpy(matrix.data(), taken.data(), taken.size());
  }

private:
  std::string_view m_bytes;
};

/// Every index in range and, where a place is not finite, unused.
template <class Matrix>
bool usable(const Matrix& indices, const Eigen::Matrix3Xd& position)
{
  const std::span all(indices.data(), static_cast<std::size_t>(indices.size()));
  return std::all_of(all.begin(), all.end(), [&](Index vertex) {
    return vertex >= 0 && vertex < position.cols() && position.col(vertex).allFinite();
  });
}

std::vector<std::string> lines(std::string_view text)
{
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::optional<ReplyHead> headOf(std::string_view begin)
{
  ReplyHead head;
  if (begin.size() < sizeof head) return std::nullopt;
  std::memcpy(&head, begin.data(), sizeof head);
  return head;
}

std::string withHead(ReplyHead head, const std::string& text)
{
  head.textBytes = std::min<std::uint64_t>(text.size(), kMostText);
  std::string bytes(sizeof head, '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes.append(text, 0, static_cast<std::size_t>(head.textBytes));
}

/// Whether unit and axes are those of the enumerations; one that is stated is a positive number.
bool stateable(const ReplyHead& head)
{
  return std::isfinite(head.metres) && head.metres >= 0.0 && head.up >= -1 && head.up <= kLastUp &&
         head.axes >= -1 && head.axes <= kLastAxes;
}

StatedFrame statedBy(const ReplyHead& head)
{
  StatedFrame stated;
  if (head.metres > 0.0) stated.metres = head.metres;
  if (head.up >= 0) stated.up = static_cast<UpAxis>(head.up);
  if (head.axes >= 0) stated.patientAxes = static_cast<PatientAxes>(head.axes);
  return stated;
}

} // namespace

std::string encodeReply(const WorkerReply& reply)
{
  const Mesh& mesh = reply.mesh;
  ReplyHead head;
  if (reply.refusal) {
    head.refusal = static_cast<std::int64_t>(reply.refusal->code);
    return withHead(head, reply.refusal->detail);
  }
  head.vertices = static_cast<std::uint64_t>(mesh.vertexCount());
  head.triangles = static_cast<std::uint64_t>(mesh.triangleCount());
  head.segments = static_cast<std::uint64_t>(mesh.segmentCount());
  head.tetrahedra = static_cast<std::uint64_t>(mesh.tetrahedronCount());
  head.diagonals = static_cast<std::uint64_t>(mesh.diagonals.cols());
  head.metres = reply.stated.metres.value_or(0.0);
  head.up = reply.stated.up ? static_cast<std::int32_t>(*reply.stated.up) : -1;
  head.axes = reply.stated.patientAxes ? static_cast<std::int32_t>(*reply.stated.patientAxes) : -1;
  std::string text = reply.format;
  for (const std::string& note : reply.notes) text += "\n" + note;
  std::string bytes = withHead(head, text);
  const std::string_view arrays[] = {bytesOf(mesh.position), bytesOf(mesh.triangles), bytesOf(mesh.segments),
                                     bytesOf(mesh.tetrahedra), bytesOf(mesh.diagonals)};
  std::size_t size = bytes.size();
  for (const std::string_view array : arrays) size += array.size();
  bytes.reserve(size);
  for (const std::string_view array : arrays) bytes += array;
  return bytes;
}

std::optional<std::uint64_t> replySize(std::string_view begin)
{
  const std::optional<ReplyHead> head = headOf(begin);
  if (!head || head->magic != ReplyHead::kMagic || head->version != ReplyHead::kVersion) return std::nullopt;
  std::uint64_t items = 0;
  for (const std::uint64_t count :
       {head->vertices, head->triangles, head->segments, head->tetrahedra, head->diagonals}) {
    if (count > kMostItems / 4) return std::nullopt; // so that no sum below can overflow
    items += count;
  }
  if (!stateable(*head) || head->textBytes > kMostText || items > kMostItems / 4) return std::nullopt;
  if (head->refusal != ReplyHead::kNone && (head->refusal < 0 || head->refusal > kLastCode || items > 0))
    return std::nullopt;
  return sizeof(ReplyHead) + head->textBytes + 3 * sizeof(double) * head->vertices +
         sizeof(Index) *
           (3 * head->triangles + 2 * head->segments + 4 * head->tetrahedra + 2 * head->diagonals);
}

Result<WorkerReply> decodeReply(std::string_view bytes)
{
  const std::optional<std::uint64_t> size = replySize(bytes);
  if (!size) return garbled("its head is not that of a reply");
  if (*size != bytes.size())
    return garbled("it holds " + std::to_string(bytes.size()) + " bytes where its head promises " +
                   std::to_string(*size));
  const ReplyHead head = *headOf(bytes);
  Arrays arrays(bytes.substr(sizeof head));
  const std::string_view text = arrays.text(head.textBytes);
  WorkerReply reply;
  if (head.refusal != ReplyHead::kNone) {
    if (text.empty()) return garbled("it refuses the file without a reason");
    reply.refusal = Error{static_cast<ErrorCode>(head.refusal), std::string(text)};
    return reply;
  }
  reply.notes = lines(text);
  if (reply.notes.empty()) return garbled("it does not name the format");
  reply.format = std::move(reply.notes.front());
  reply.notes.erase(reply.notes.begin());
  reply.stated = statedBy(head);
  arrays.fill(reply.mesh.position, head.vertices);
  arrays.fill(reply.mesh.triangles, head.triangles);
  arrays.fill(reply.mesh.segments, head.segments);
  arrays.fill(reply.mesh.tetrahedra, head.tetrahedra);
  arrays.fill(reply.mesh.diagonals, head.diagonals);
  const Eigen::Matrix3Xd& position = reply.mesh.position;
  if (!usable(reply.mesh.triangles, position) || !usable(reply.mesh.segments, position) ||
      !usable(reply.mesh.tetrahedra, position) || !usable(reply.mesh.diagonals, position))
    return garbled("a face or line of it uses a vertex that is not there or not finite");
  return reply;
}

} // namespace esm
