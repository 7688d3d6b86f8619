// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/project/frame_writers.h"
#include "core/project/series_files.h"

namespace esm {

/// One kind of time series. Adding one is adding a class here and a line in create().
struct TrajectoryWriter::Impl {
  virtual ~Impl() = default;
  virtual Status add(const Frame& frame) = 0;
  virtual Status finish() = 0;

  std::filesystem::path path;
};

namespace {

/// `t,id,x,y,z`, one line per node and frame.
struct CsvSeries : TrajectoryWriter::Impl {
  explicit CsvSeries(TemporaryFile out) : file(std::move(out)) {}
  Status add(const Frame& frame) override
  {
    std::string text = first ? "t,id,x,y,z\n" : "";
    first = false;
    const std::string time = formatDouble(frame.time);
    for (Index node = 0; node < frame.net->nodeCount(); ++node) {
      text +=
        time + "," + std::to_string(static_cast<Index>(frame.net->nodeId[static_cast<std::size_t>(node)]));
      for (int k = 0; k < 3; ++k) {
        text += ',';
        appendDouble(text, (*frame.position)(k, node));
      }
      text += '\n';
    }
    return file.append(text);
  }
  Status finish() override { return file.commit(); }

  TemporaryFile file;
  bool first = true;
};

/// Raw little-endian float64, frames x nodes x 3.
struct RawSeries : TrajectoryWriter::Impl {
  explicit RawSeries(TemporaryFile out) : file(std::move(out)) {}
  Status add(const Frame& frame) override
  {
    const auto* bytes = reinterpret_cast<const char*>(frame.position->data());
    return file.append({bytes, static_cast<std::size_t>(frame.position->size()) * sizeof(double)});
  }
  Status finish() override { return file.commit(); }

  TemporaryFile file;
};

/// A ParaView collection: NAME.pvd names one .vtu per frame in NAME_frames/.
struct ParaviewSeries : TrajectoryWriter::Impl {
  ParaviewSeries(TemporaryFile out, TemporaryFolder frames) : file(std::move(out)), folder(std::move(frames))
  {}
  Status add(const Frame& frame) override
  {
    std::string number = std::to_string(count++);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    const std::string name = "frame_" + number + ".vtu";
    list += "    <DataSet timestep=\"" + formatDouble(frame.time) + "\" group=\"\" part=\"0\" file=\"" +
            xmlText(folder.name()) + "/" + name + "\"/>\n";
    return folder.write(name, encodeVtu(frame));
  }
  Status finish() override
  {
    Status status = file.append(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n" +
      list + "  </Collection>\n</VTKFile>\n");
    if (!status) return status;
    if (Status moved = folder.commit(); !moved) return moved;
    return file.commit();
  }
  static std::string xmlText(const std::string& text)
  {
    std::string out;
    for (const char c : text)
      out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
  }

  TemporaryFile file;
  TemporaryFolder folder;
  std::string list;
  int count = 0;
};

} // namespace

TrajectoryWriter::TrajectoryWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
TrajectoryWriter::TrajectoryWriter(TrajectoryWriter&&) noexcept = default;
TrajectoryWriter& TrajectoryWriter::operator=(TrajectoryWriter&&) noexcept = default;
TrajectoryWriter::~TrajectoryWriter() = default;

Result<TrajectoryWriter> TrajectoryWriter::create(const std::filesystem::path& path)
{
  const std::string ending = path.extension().string();
  if (ending != ".csv" && ending != ".f64" && ending != ".pvd")
    return Error{ErrorCode::Unsupported,
                 path.string() +
                   ": a motion cannot be written in this format; the ending must be .csv, .f64 or .pvd"};
  Result<TemporaryFile> file = TemporaryFile::create(path);
  if (!file) return file.error();
  std::unique_ptr<Impl> impl;
  if (ending == ".pvd") {
    Result<TemporaryFolder> folder =
      TemporaryFolder::create(path.parent_path() / (path.stem().string() + "_frames"), ".vtu");
    if (!folder) return folder.error();
    impl = std::make_unique<ParaviewSeries>(std::move(*file), std::move(*folder));
  } else if (ending == ".f64") {
    impl = std::make_unique<RawSeries>(std::move(*file));
  } else {
    impl = std::make_unique<CsvSeries>(std::move(*file));
  }
  impl->path = path;
  return TrajectoryWriter(std::move(impl));
}

Status TrajectoryWriter::addFrame(const Frame& frame)
{
  if (Status status = checkFrame(frame, m_impl->path); !status) return status;
  return m_impl->add(frame);
}

Status TrajectoryWriter::finish()
{
  return m_impl->finish();
}

} // namespace esm
