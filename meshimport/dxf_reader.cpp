// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/dxf_reader.h"

#include "core/base/ascii_case.h"
#include "core/base/text_encoding.h"
#include "meshimport/content.h"
#include "meshimport/dxf_groups.h"
#include "meshimport/dxf_passed_over.h"
#include "meshimport/raw_mesh.h"

#include <Eigen/Geometry>

#include <array>
#include <map>

namespace esm {

namespace {

constexpr int kDeepest = 16;                                 ///< blocks in blocks
constexpr std::size_t kMostReadAgain = std::size_t{1} << 23; ///< bytes of blocks that a small file may place

/// From entity to world coordinates, and the layer for what lies on layer 0 of a block.
struct Placement {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  std::string_view layer = "0";
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return turn * p + shift; }
};

/// The axes of an entity with the given extrusion direction (DXF reference, arbitrary axis algorithm).
Eigen::Matrix3d axesOf(const DxfEntity& entity)
{
  Eigen::Vector3d z(entity.number(210, 0.0), entity.number(220, 0.0), entity.number(230, 1.0));
  const double length = z.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return Eigen::Matrix3d::Identity();
  z /= length;
  const bool isNearWorldZ = std::abs(z.x()) < 1.0 / 64 && std::abs(z.y()) < 1.0 / 64;
  const Eigen::Vector3d x =
    (isNearWorldZ ? Eigen::Vector3d::UnitY().cross(z) : Eigen::Vector3d::UnitZ().cross(z)).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x).normalized(), z;
  return axes;
}

struct Block {
  Eigen::Vector3d base;
  DxfEntities entities;
  std::string_view file; ///< where its entities are, if they are in another drawing
};

class DxfParser {
public:
  DxfParser(std::string_view bytes, const std::string& origin, WorkControl* control)
    : m_text(bytes), m_origin(origin), m_control(control), m_readAgain(kMostReadAgain + 16 * bytes.size())
  {}

  Result<Mesh> run(std::vector<std::string>& notes)
  {
    DxfEntities entities(m_text);
    if (Status status = sections(entities); !status) return status.error();
    if (m_raw.isEmpty())
      return fault(ErrorCode::EmptyResult, m_origin, 0,
                   "it holds no line, polyline or face" + m_passedOver.reason());
    m_passedOver.tellNotes(notes);
    if (!m_hasEnd) notes.push_back("The file ends without EOF; it may be cut short.");
    if (m_bulges > 0) notes.push_back(std::to_string(m_bulges) + " arcs of polylines became their chords.");
    return finishMesh(std::move(m_raw), m_origin, notes, m_control);
  }

  bool hasPlacedBlocks() const { return m_hasPlaced; }

private:
  Error wrong(long line, const std::string& text) const
  {
    return fault(ErrorCode::BadFormat, m_origin, line, text);
  }

  Status sections(DxfEntities& entities)
  {
    DxfEntity entity;
    std::string_view section;
    bool ended = false;
    while (!ended && entities.next(entity)) {
      if (entity.name == "SECTION") {
        section = entity.text(2);
      } else if (entity.name == "ENDSEC") {
        section = {};
      } else if (entity.name == "EOF") {
        ended = true;
      } else if (entity.name == "LAYER" && section == "TABLES") {
        m_passedOver.addLayer(entity);
      } else if (entity.name == "BLOCK" && section == "BLOCKS") {
        addBlock(entity, entities);
      } else if (section == "ENTITIES") {
        if (Status status = place(entity, entities, {}, 0); !status) return status;
      }
      if (m_count++ % 1024 == 0) {
        tellDone(m_control,
                 1.0 - static_cast<double>(entities.bytesLeft()) / static_cast<double>(m_text.size()));
        if (stopWanted(m_control)) return cancelledError();
      }
    }
    if (!ended && !entities.atEnd())
      return wrong(entities.line(), "here a DXF group should begin with its number; is the file damaged?");
    if (!ended && entity.name != "ENDSEC")
      return wrong(0, "it ends without EOF; it is cut short, fetch it again");
    m_hasEnd = ended;
    return {};
  }

  void addBlock(const DxfEntity& block, DxfEntities& entities)
  {
    constexpr long long kExternal = 4 | 8; // attached or overlaid
    Block& made =
      m_blocks.emplace(std::string(block.text(2)), Block{block.point(10), entities, {}}).first->second;
    bool isEmpty = true;
    const std::string name = asciiLower(block.text(2));
    const bool isSheet = name.starts_with("*paper_space") || name.starts_with("$paper_space");
    DxfEntity entity;
    while (entities.next(entity) && entity.name != "ENDBLK") {
      isEmpty = false;
      if (isSheet && !isPart(entity) && entity.name != "VIEWPORT") m_passedOver.addPaper();
    }
    if (isEmpty && (block.integer(70) & kExternal) != 0) made.file = block.text(1);
  }

  /// Of the entity before it.
  static bool isPart(const DxfEntity& entity)
  {
    return entity.name == "VERTEX" || entity.name == "SEQEND" || entity.name == "ATTRIB";
  }

  /// Puts one entity into the mesh; of a POLYLINE the vertices that follow it, too.
  Status place(const DxfEntity& entity, DxfEntities& following, const Placement& at, int depth)
  {
    if (m_raw.isTooLarge()) return tooManyError(m_origin);
    if (isPart(entity) || !m_passedOver.shows(entity, layerOf(entity, at))) return {};
    if (entity.name == "LINE") return polyline({entity.point(10), entity.point(11)}, false, at, entity);
    if (entity.name == "3DFACE") return face(entity, at);
    if (entity.name == "LWPOLYLINE") return lightPolyline(entity, at);
    if (entity.name == "POLYLINE") return heavyPolyline(entity, following, at);
    if (entity.name == "INSERT") return insert(entity, at, depth);
    m_passedOver.addKind(entity.name);
    return {};
  }

  static std::string_view layerOf(const DxfEntity& entity, const Placement& at)
  {
    const std::string_view own = entity.text(8);
    return own.empty() || own == "0" ? at.layer : own;
  }

  Result<Index> vertex(const Eigen::Vector3d& p, const Placement& at, const DxfEntity& entity)
  {
    const Eigen::Vector3d world = at(p);
    if (!world.allFinite())
      return wrong(entity.line,
                   "this " + std::string(entity.name.substr(0, 20)) +
                     " has a coordinate that is no finite number (numbers are written with a point)");
    m_raw.addVertex(world.x(), world.y(), world.z(), entity.line);
    return m_raw.vertexCount() - 1;
  }
  Status vertices(const std::vector<Eigen::Vector3d>& points, const Placement& at, const DxfEntity& entity)
  {
    m_corners.clear();
    for (const Eigen::Vector3d& p : points) {
      const Result<Index> index = vertex(p, at, entity);
      if (!index) return index.error();
      m_corners.push_back(*index);
    }
    return {};
  }

  Status polyline(const std::vector<Eigen::Vector3d>& points, bool isClosed, const Placement& at,
                  const DxfEntity& entity)
  {
    if (Status status = vertices(points, at, entity); !status) return status;
    if (isClosed && m_corners.size() > 2) m_corners.push_back(m_corners.front());
    m_raw.addPolyline(m_corners);
    return {};
  }

  Status face(const DxfEntity& entity, const Placement& at)
  {
    std::vector<Eigen::Vector3d> points{entity.point(10), entity.point(11), entity.point(12)};
    // A triangle has its third corner twice, or no fourth one.
    if (entity.text(13).data() && entity.point(13) != points[2]) points.push_back(entity.point(13));
    if (Status status = vertices(points, at, entity); !status) return status;
    m_raw.addFace(m_corners);
    return {};
  }

  Status lightPolyline(const DxfEntity& entity, const Placement& at)
  {
    const double elevation = entity.number(38);
    std::vector<Eigen::Vector3d> points;
    for (const DxfGroup& group : entity.groups) {
      const double value = parseForeignDouble(group.value).value_or(std::numeric_limits<double>::quiet_NaN());
      if (group.code == 10) points.push_back({value, 0.0, elevation});
      if (group.code == 20 && !points.empty()) points.back().y() = value;
      if (group.code == 42 && value != 0.0) ++m_bulges;
    }
    return polyline(points, (entity.integer(70) & 1) != 0, inAxesOf(entity, at), entity);
  }

  static Placement inAxesOf(const DxfEntity& entity, const Placement& at)
  {
    return {at.turn * axesOf(entity), at.shift, at.layer};
  }

  Status heavyPolyline(const DxfEntity& entity, DxfEntities& following, const Placement& at)
  {
    const long long flags = entity.integer(70);
    const bool isSpatial = (flags & (8 | 16 | 64)) != 0;
    const DxfEntity head = entity; // `entity` may be the one that is read into below
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<long long, 4>> faces;
    DxfEntity part;
    for (;;) {
      const DxfEntities before = following;
      if (!following.next(part))
        return following.atEnd()
                 ? wrong(head.line, "the file ends within this POLYLINE; it is cut short, fetch it again")
                 : wrong(following.line(),
                         "here a DXF group should begin with its number; is the file damaged?");
      if (part.name != "VERTEX") {
        if (part.name != "SEQEND") following = before; // some writers leave it out
        break;
      }
      const long long kind = part.integer(70);
      if ((flags & 64) != 0 && (kind & 64) == 0) {
        faces.push_back({part.integer(71), part.integer(72), part.integer(73), part.integer(74)});
      } else if ((kind & 16) == 0 || (flags & 4) == 0) { // the frame of a spline is no part of the curve
        Eigen::Vector3d p = part.point(10);
        if (!isSpatial) p.z() = head.number(30);
        points.push_back(p);
        if (part.number(42) != 0.0) ++m_bulges;
      }
    }
    if ((flags & 64) != 0) return polyface(points, faces, at, head);
    if ((flags & 16) != 0) return grid(points, flags, at, head);
    return polyline(points, (flags & 1) != 0, isSpatial ? at : inAxesOf(head, at), head);
  }

  /// Corners are vertices from 1; a minus hides the edge that begins there.
  Status polyface(const std::vector<Eigen::Vector3d>& points,
                  const std::vector<std::array<long long, 4>>& faces, const Placement& at,
                  const DxfEntity& entity)
  {
    const Index first = m_raw.vertexCount();
    if (Status status = vertices(points, at, entity); !status) return status;
    for (const auto& face : faces) {
      m_corners.clear();
      for (const long long corner : face) {
        if (corner == 0) continue;
        const auto number =
          corner < 0 ? 0 - static_cast<unsigned long long>(corner) : static_cast<unsigned long long>(corner);
        if (number > points.size())
          return fault(ErrorCode::InvalidValue, m_origin, entity.line,
                       "a face of this POLYLINE uses vertex " + std::to_string(number) + ", but it has " +
                         std::to_string(points.size()));
        m_corners.push_back(first + static_cast<Index>(number) - 1);
      }
      m_raw.addFace(m_corners);
    }
    return {};
  }

  /// M x N vertices, each row closed or not.
  Status grid(const std::vector<Eigen::Vector3d>& points, long long flags, const Placement& at,
              const DxfEntity& entity)
  {
    const bool isSmooth = (flags & 4) != 0; // then the finer counts hold
    const long long rows = entity.integer(isSmooth ? 73 : 71), columns = entity.integer(isSmooth ? 74 : 72);
    const auto most = static_cast<long long>(points.size());
    if (rows < 2 || columns < 2 || rows > most || columns > most || rows * columns != most)
      return wrong(entity.line, "this POLYLINE mesh says " + std::to_string(rows) + " x " +
                                  std::to_string(columns) + " vertices, but it has " +
                                  std::to_string(points.size()));
    const Index first = m_raw.vertexCount();
    if (Status status = vertices(points, at, entity); !status) return status;
    const auto at2 = [&](long long m, long long n) {
      return first + static_cast<Index>((m % rows) * columns + n % columns);
    };
    const long long lastRow = (flags & 1) != 0 ? rows : rows - 1,
                    lastColumn = (flags & 32) != 0 ? columns : columns - 1;
    for (long long m = 0; m < lastRow; ++m)
      for (long long n = 0; n < lastColumn; ++n)
        m_raw.addFace({at2(m, n), at2(m + 1, n), at2(m + 1, n + 1), at2(m, n + 1)});
    return {};
  }

  Status insert(const DxfEntity& entity, const Placement& at, int depth)
  {
    const auto block = m_blocks.find(entity.text(2));
    if (block == m_blocks.end()) {
      m_passedOver.addKind("INSERT without its block");
      return {};
    }
    if (!block->second.file.empty()) m_passedOver.addPart(block->second.file);
    m_hasPlaced = true;
    if (depth >= kDeepest) return wrong(entity.line, "blocks are nested too deep; is a block inside itself?");
    const Eigen::Vector3d scale(entity.number(41, 1.0), entity.number(42, 1.0), entity.number(43, 1.0));
    const Eigen::Matrix3d axes = axesOf(entity);
    const Eigen::Matrix3d spin =
      Eigen::AngleAxisd(entity.number(50) * M_PI / 180.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const long long columns = std::max(1LL, entity.integer(70)), rows = std::max(1LL, entity.integer(71));
    const Eigen::Vector3d insertion = entity.point(10);
    const double columnStep = entity.number(44), rowStep = entity.number(45);
    const std::string_view layer = layerOf(entity, at);
    const Block copy = block->second; // `entity` and the map may change below
    for (long long row = 0; row < rows; ++row) {
      for (long long column = 0; column < columns; ++column) {
        const Eigen::Vector3d offset(static_cast<double>(column) * columnStep,
                                     static_cast<double>(row) * rowStep, 0);
        const Eigen::Matrix3d local = axes * spin;
        Placement inner{at.turn * local * scale.asDiagonal(), {}, layer};
        inner.shift = at(axes * insertion + local * offset) - inner.turn * copy.base;
        if (Status status = placeBlock(copy, inner, depth + 1); !status) return status;
      }
    }
    return {};
  }

  Status placeBlock(const Block& block, const Placement& at, int depth)
  {
    DxfEntities entities = block.entities;
    DxfEntity entity;
    for (std::size_t left = entities.bytesLeft(); entities.next(entity) && entity.name != "ENDBLK";) {
      if (Status status = place(entity, entities, at, depth); !status) return status;
      const std::size_t read = left - entities.bytesLeft();
      left = entities.bytesLeft();
      if (Status status = spend(read, entity.line); !status) return status;
      if (stopWanted(m_control)) return cancelledError();
    }
    return spend(16, 0); // an empty block costs its reader something, too
  }
  Status spend(std::size_t bytes, long line)
  {
    if (bytes > m_readAgain)
      return fault(ErrorCode::Unsupported, m_origin, line,
                   "it places its blocks more often than a drawing of its size should; explode them first");
    m_readAgain -= bytes;
    return {};
  }

  std::string_view m_text;
  const std::string& m_origin;
  WorkControl* m_control;
  RawMesh m_raw;
  std::vector<Index> m_corners;
  std::map<std::string, Block, std::less<>> m_blocks;
  std::size_t m_readAgain; ///< bytes of blocks that may still be placed
  DxfPassedOver m_passedOver;
  std::size_t m_bulges = 0, m_count = 0;
  bool m_hasEnd = false, m_hasPlaced = false;
};

constexpr std::string_view kBinaryMagic = "AutoCAD Binary DXF";

bool recognisesDxf(std::string_view bytes, std::string_view)
{
  if (bytes.substr(0, kBinaryMagic.size()) == kBinaryMagic) return true;
  if (!looksLikeText(bytes)) return false;
  bytes = withoutByteOrderMark(bytes);
  DxfEntities entities(bytes.substr(0, 1 << 14)); // comments (999) may come first
  DxfEntity first;
  return entities.next(first) && first.name == "SECTION";
}

Result<Mesh> readDxf(std::string_view bytes, const std::string& origin, FileStory& story,
                     WorkControl* control)
{
  std::string& format = story.format;
  std::vector<std::string>& notes = story.notes;
  format = "DXF";
  if (bytes.substr(0, kBinaryMagic.size()) == kBinaryMagic)
    return fault(ErrorCode::Unsupported, origin, 0, "binary DXF is not read; save it as DXF in text (ASCII)");
  bytes = withoutByteOrderMark(bytes);
  DxfParser parser(bytes, origin, control);
  Result<Mesh> mesh = parser.run(notes);
  story.isPlaced = parser.hasPlacedBlocks();
  return mesh;
}

} // namespace

MeshReader dxfReader()
{
  return {"DXF", recognisesDxf, readDxf};
}

} // namespace esm
