// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// esm_bench import: nanoseconds of processor time per triangle from a mesh file to a finished net (welded,
// unique edges, components, rest lengths), beside the assimp library in the same run, one thread. Every run
// has a process of its own, so that memory starts cold and its peak is its own. Before each run memory is
// used and given back: a virtual machine's free memory may have gone back to its host, and what the host
// takes to bring it again (here twenty times as long as the guest's own work on a fresh page) is none of the
// reader's time. CSV: file, who, median and best of the runs [ns/triangle], peak memory above the start of
// the run with and without the file's own size [bytes/triangle], nodes.
#include "bench/import_files.h"
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/large_pages.h"
#include "core/net/net_builder.h"
#include "meshimport/mesh_importer.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace esm::bench {

namespace {

constexpr int kCompetitorRuns = 3;

struct Cost {
  double seconds; ///< of processor time
  double peak;    ///< bytes above the start
  long nodes;
};

double processorSeconds()
{
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peakBytes()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Uses so much fresh memory in a child process and gives it back. @return seconds of processor time
double useMemoryOnce(std::size_t bytes)
{
  const auto used = [] {
    rusage usage = {};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  };
  const double before = used();
  const pid_t child = fork();
  if (child == 0) {
    constexpr std::size_t kPage = 4096;
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) _exit(1);
    useLargePages(memory, bytes);
    for (std::size_t i = 0; i < bytes; i += kPage) static_cast<volatile char*>(memory)[i] = 1;
    _exit(0);
  }
  if (child > 0) waitpid(child, nullptr, 0);
  return used() - before;
}

/// Leaves so much free memory that the machine has at hand: its use took the usual time.
void warmMemory(std::size_t bytes)
{
  constexpr double kUsual = 0.25e-9; // seconds per byte, about twice what clearing a page takes
  constexpr int kMostRounds = 2;
  for (int round = 0; round < kMostRounds; ++round)
    if (useMemoryOnce(bytes) <= kUsual * static_cast<double>(bytes)) return;
}

/// Runs `work` in a child process; it returns the number of nodes, negative for a failure.
std::optional<Cost> costOf(const std::function<long()>& work)
{
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    const double memory = peakBytes(), start = processorSeconds();
    const long nodes = work();
    const Cost cost{processorSeconds() - start, peakBytes() - memory, nodes};
    const bool told = write(ends[1], &cost, sizeof cost) == sizeof cost;
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  Cost cost = {};
  const bool heard = read(ends[0], &cost, sizeof cost) == sizeof cost;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return heard && cost.nodes > 0 ? std::optional(cost) : std::nullopt;
}

long ourNet(const std::filesystem::path& file)
{
  keepBigArraysInHeap(); // as the programs do when they start
  Result<ImportedMesh> imported = importMesh(file);
  if (!imported) return -1;
  const Result<SpringNet> net =
    buildNet(std::move(imported->mesh), nullptr, nullptr, std::move(imported->edges));
  return net && imported->report.components == 1 ? long{net->nodeCount()} : -1;
}

long assimpMesh(const std::filesystem::path& file, unsigned flags)
{
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), flags);
  return scene && scene->mNumMeshes > 0 ? long{scene->mMeshes[0]->mNumVertices} : -1;
}

struct Contender {
  const char* name;
  std::function<long(const std::filesystem::path&)> run;
  std::size_t memory; ///< more than it needs [bytes]
};

const std::vector<Contender>& contenders()
{
  static const std::vector<Contender> all{
    {"esm", ourNet, std::size_t{1} << 29},
    {"assimp flags 0", [](const auto& file) { return assimpMesh(file, 0); }, std::size_t{1} << 29},
    {"assimp Triangulate+Join",
     [](const auto& file) {
       return assimpMesh(file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
     },
     std::size_t{9} << 28}};
  return all;
}

/// All contenders on one file, in turns. @return whether all could read it
bool race(const std::filesystem::path& file, double triangles, int runs, bool alone)
{
  std::vector<std::vector<double>> times(contenders().size());
  std::vector<Cost> last(contenders().size());
  const std::size_t count = alone ? 1 : contenders().size();
  for (int run = 0; run < runs; ++run) {
    for (std::size_t c = 0; c < count; ++c) {
      if (c > 0 && run >= kCompetitorRuns) continue; // some take a quarter of a minute
      warmMemory(contenders()[c].memory);
      const std::optional<Cost> cost = costOf([&] { return contenders()[c].run(file); });
      if (!cost) {
        std::fprintf(stderr, "esm_bench: %s did not read %s\n", contenders()[c].name, file.c_str());
        return false;
      }
      times[c].push_back(1e9 * cost->seconds / triangles);
      last[c] = *cost;
    }
  }
  const double size = static_cast<double>(std::filesystem::file_size(file));
  for (std::size_t c = 0; c < count; ++c) {
    const double median = medianTime(times[c]), best = *std::min_element(times[c].begin(), times[c].end());
    std::printf("%s,%s,%.1f,%.1f,%.1f,%.1f,%ld,%.1f\n", file.filename().c_str(), contenders()[c].name, median,
                best, last[c].peak / triangles, (last[c].peak - size) / triangles, last[c].nodes,
                median / medianTime(times[0]));
    std::fflush(stdout);
  }
  return true;
}

} // namespace

int runImport(const std::vector<std::string>& words)
{
  const bool quick = isQuick(words);
  const bool alone = std::find(words.begin(), words.end(), "--alone") != words.end();
  const int runs = quick ? 3 : 5;
  std::string folder = (std::filesystem::temp_directory_path() / "esm_bench_import.XXXXXX").string();
  if (!mkdtemp(folder.data())) {
    std::fprintf(stderr, "esm_bench: no folder for the mesh files in %s\n", folder.c_str());
    return 1;
  }
  std::printf("file,who,ns_per_triangle,best,peak_bytes_per_triangle,peak_over_file,nodes,times_esm\n");
  bool good = true;
  const bool isChosen =
    std::any_of(words.begin(), words.end(), [](const auto& word) { return word[0] != '-'; });
  for (const MeshFile& file : meshFiles()) {
    if (isChosen && std::find(words.begin(), words.end(), file.name) == words.end()) continue;
    const std::filesystem::path path = std::filesystem::path(folder) / file.name;
    const double triangles = quick ? 100'000 : 1'000'000;
    // In a process of its own, so that this one stays small and the runs' peaks are their own.
    const auto written = costOf([&] { return file.write(path, static_cast<int>(triangles)) ? 1L : -1L; });
    good = written && race(path, triangles, runs, alone) && good;
    std::filesystem::remove(path);
  }
  std::filesystem::remove_all(folder);
  if (!good) std::fprintf(stderr, "esm_bench: a file could not be written or read\n");
  return good ? 0 : 1;
}

} // namespace esm::bench
