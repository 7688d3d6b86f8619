// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/project/frame_writers.h"

namespace esm {

namespace {

constexpr std::uint8_t kLine = 3, kTriangle = 5; // VTK cell types

/// The XML head and the raw blocks behind it, which the head refers to by their place.
class VtuFile {
public:
  template <class T>
  void array(const char* type, const char* name, int components, const T* values, std::size_t count)
  {
    m_head += std::string("        <DataArray type=\"") + type + "\" Name=\"" + name +
              "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"appended\" offset=\"" +
              std::to_string(m_blocks.size()) + "\"/>\n";
    appendRaw(m_blocks, static_cast<std::uint64_t>(count * sizeof(T)));
    appendRaw(m_blocks, values, count);
  }
  void vectors(const char* name, const Eigen::Matrix3Xd& values)
  {
    array("Float64", name, 3, values.data(), static_cast<std::size_t>(values.size()));
  }
  void scalars(const char* name, const Eigen::ArrayXd& values)
  {
    array("Float64", name, 1, values.data(), static_cast<std::size_t>(values.size()));
  }
  void open(const std::string& tag) { m_head += "      <" + tag + ">\n"; }
  void close(const std::string& tag) { m_head += "      </" + tag + ">\n"; }

  std::string finish(const Frame& frame) const
  {
    const SpringNet& net = *frame.net;
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n"
           "  <UnstructuredGrid>\n"
           "    <FieldData>\n"
           "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
           formatDouble(frame.time) +
           "</DataArray>\n"
           "    </FieldData>\n"
           "    <Piece NumberOfPoints=\"" +
           std::to_string(net.nodeCount()) + "\" NumberOfCells=\"" +
           std::to_string(net.springCount() + net.triangleCount()) + "\">\n" + m_head +
           "    </Piece>\n"
           "  </UnstructuredGrid>\n"
           "  <AppendedData encoding=\"raw\">\n   _" +
           m_blocks + "\n  </AppendedData>\n</VTKFile>\n";
  }

private:
  std::string m_head, m_blocks;
};

/// One value per cell: those of the springs, then 0 for every triangle, since VTK wants all cells covered.
Eigen::ArrayXd perCell(const SpringNet& net, const Eigen::ArrayXd& ofSprings)
{
  Eigen::ArrayXd values = Eigen::ArrayXd::Zero(net.springCount() + net.triangleCount());
  values.head(net.springCount()) = ofSprings;
  return values;
}

void addCells(VtuFile& file, const SpringNet& net)
{
  const auto cells =
    static_cast<std::size_t>(net.springCount()) + static_cast<std::size_t>(net.triangleCount());
  std::vector<std::int64_t> connectivity(net.ends.data(), net.ends.data() + net.ends.size());
  connectivity.insert(connectivity.end(), net.triangles.data(), net.triangles.data() + net.triangles.size());
  std::vector<std::int64_t> offsets(cells);
  std::vector<std::uint8_t> types(cells, kTriangle);
  std::int64_t end = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const bool spring = cell < static_cast<std::size_t>(net.springCount());
    if (spring) types[cell] = kLine;
    offsets[cell] = end += spring ? 2 : 3;
  }
  file.open("Cells");
  file.array("Int64", "connectivity", 1, connectivity.data(), connectivity.size());
  file.array("Int64", "offsets", 1, offsets.data(), offsets.size());
  file.array("UInt8", "types", 1, types.data(), types.size());
  file.close("Cells");
}

} // namespace

std::string encodeVtu(const Frame& frame)
{
  const SpringNet& net = *frame.net;
  VtuFile file;
  file.open("PointData");
  file.vectors("displacement", *frame.position - net.restPosition);
  file.vectors("velocity", frame.velocity ? *frame.velocity : Eigen::Matrix3Xd::Zero(3, net.nodeCount()));
  file.scalars("mass", net.mass);
  file.array("UInt8", "fixed", 1, net.fixed.data(), net.fixed.size());
  file.close("PointData");
  file.open("CellData");
  file.scalars("stiffness", perCell(net, net.stiffness));
  file.scalars("damping", perCell(net, net.viscosity));
  file.scalars("rest_length", perCell(net, net.restLength));
  file.scalars("strain", perCell(net, springStrains(frame)));
  if (frame.tension) file.scalars("force", perCell(net, *frame.tension));
  file.close("CellData");
  file.open("Points");
  file.vectors("position", *frame.position);
  file.close("Points");
  addCells(file, net);
  return file.finish(frame);
}

/// VTK XML unstructured grid with raw appended blocks, for ParaView. Springs come first, as line cells.
Status writeVtu(const Frame& frame, const std::filesystem::path& path)
{
  return writeFileAtomically(path, encodeVtu(frame));
}

} // namespace esm
