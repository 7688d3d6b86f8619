// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/fast_limits.h"
#include "bench/reference/fast_net.h"
#include "bench/scenes.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"
#include "core/forces/force_model.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>

namespace esm::bench {
namespace {

/// Keeps the least time of each benchmark's repetitions.
class LeastTime final : public benchmark::BenchmarkReporter {
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const std::string name = run.run_name.function_name;
      const double seconds = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      const auto [found, isNew] = m_seconds.try_emplace(name, seconds);
      if (!isNew && seconds < found->second) found->second = seconds;
    }
  }
  double seconds(const std::string& name) const
  {
    const auto found = m_seconds.find(name);
    return found == m_seconds.end() ? 0.0 : found->second;
  }

private:
  std::map<std::string, double> m_seconds;
};

SpringNet withoutAnchors(SpringNet net)
{
  net.anchors = {};
  return net;
}

/// The uterus with a measured curve in place of its exponential one: ten points of it.
Scene uterusTable()
{
  Scene scene = uterus();
  scene.name = "uterus-table";
  SpringNet& net = scene.net;
  const double rate = net.lawParameter[0];
  ForceTable& table = net.tables.emplace_back();
  for (int i = 0; i < 10; ++i) {
    const double strain = -0.3 + 0.1 * i;
    table.strain.push_back(strain);
    table.force.push_back(std::expm1(rate * strain) / rate);
  }
  std::fill(net.law.begin(), net.law.end(), SpringLaw::Table);
  net.lawParameter.setZero();
  return scene;
}

/// The uterus with its content, whose pressure acts on all triangles of the wall.
Scene uterusFilled()
{
  Scene scene = uterus();
  scene.name = "uterus-filled";
  constexpr Index kRings = 26, kAround = 48; // as uterus() lays them out, and the two ends
  PressureBody& body = scene.net.pressure.emplace_back();
  body.bulkModulus = 1e4;
  body.triangles.resize(3, 2 * kRings * kAround);
  Index triangle = 0;
  for (Index r = 0; r < kRings; ++r)
    for (Index a = 0; a < kAround; ++a) {
      const Index here = r * kAround + a, next = r * kAround + (a + 1) % kAround;
      const Index above = here + kAround, aboveNext = next + kAround;
      if (r == 0) body.triangles.col(triangle++) << kRings * kAround, next, here;
      if (r + 1 == kRings) {
        body.triangles.col(triangle++) << kRings * kAround + 1, here, next;
        continue;
      }
      const bool isOdd = r % 2 != 0;
      body.triangles.col(triangle++) << here, next, (isOdd ? aboveNext : above);
      body.triangles.col(triangle++) << (isOdd ? here : next), aboveNext, above;
    }
  return scene;
}

struct Subject {
  Scene scene;
  ForceModel model, springs; ///< the latter without weight and anchors
  NodeArray x, v, force, damper;
  std::optional<FastNet> plain; ///< which knows neither tables nor pressure
  Nodes plainX, plainV, plainForce;

  explicit Subject(Scene from)
    : scene(std::move(from)),
      model(scene.net, scene.loads.gravity),
      springs(withoutAnchors(scene.net), Eigen::Vector3d::Zero())
  {
    const std::size_t count = model.nodeCount();
    x.resize(count);
    v.assign(count, Lanes{1e-3, 1e-3, 0, 0});
    force.resize(count);
    copyNodes(scene.net.restPosition, x);
    for (Lanes& place : x) place *= 1.001; // at rest there is no pressure, and nothing to do for it
    damper.resize(model.damperSize());
    model.computeForces(x.data(), v.data(), force.data(), damper.data());
    if (!scene.net.tables.empty() || !scene.net.pressure.empty()) return;
    plain.emplace(scene.net, scene.loads);
    plain->start(plainX, plainV);
    plainForce.resize(plainX.size());
    plain->beginFrame(0.0, plainX, plainV);
  }
};

void registerSubject(Subject& subject)
{
  const std::string name = subject.scene.name;
  benchmark::RegisterBenchmark((name + "|ours").c_str(), [&subject](benchmark::State& state) {
    for (auto _ : state) {
      subject.model.computeForces(subject.x.data(), subject.v.data(), subject.force.data());
      benchmark::ClobberMemory();
    }
  });
  benchmark::RegisterBenchmark((name + "|springs").c_str(), [&subject](benchmark::State& state) {
    for (auto _ : state) {
      subject.springs.computeForces(subject.x.data(), subject.v.data(), subject.force.data());
      benchmark::ClobberMemory();
    }
  });
  benchmark::RegisterBenchmark((name + "|dampers").c_str(), [&subject](benchmark::State& state) {
    for (auto _ : state) {
      subject.model.addDamping(subject.damper.data(), subject.v.data(), subject.force.data());
      benchmark::ClobberMemory();
    }
  });
  if (!subject.plain) return;
  benchmark::RegisterBenchmark((name + "|plain").c_str(), [&subject](benchmark::State& state) {
    for (auto _ : state) {
      subject.plain->forces(0.0, subject.plainX.data(), subject.plainV.data(), subject.plainForce.data());
      benchmark::ClobberMemory();
    }
  });
}

} // namespace

int runKernel(const std::vector<std::string>& words)
{
  const bool quick = isQuick(words);
  std::vector<std::unique_ptr<Subject>> subjects;
  for (Scene scene :
       {tube(), uterusLinear(), sheet(), uterus(), uterusTable(), uterusFilled(), organ100k()}) {
    if (quick && scene.net.nodeCount() > 20'000) continue;
    subjects.push_back(std::make_unique<Subject>(std::move(scene)));
    registerSubject(*subjects.back());
  }
  Limits limits;
  limits.registerAll();
  std::string least = quick ? "--benchmark_min_time=0.02" : "--benchmark_min_time=0.1";
  std::string repeats = quick ? "--benchmark_repetitions=5" : "--benchmark_repetitions=15";
  std::string program = "esm_bench";
  char* arguments[] = {program.data(), least.data(), repeats.data()};
  int count = 3;
  benchmark::Initialize(&count, arguments);
  LeastTime reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("what,springs,ns_per_spring,springs_alone_ns,kept_dampers_ns,plain_ns_per_spring\n");
  for (const auto& subject : subjects) {
    const auto springs = static_cast<double>(subject->scene.net.springCount());
    const std::string& name = subject->scene.name;
    const auto perSpring = [&](const char* what) {
      return formatDouble(reporter.seconds(name + what) * 1e9 / springs, 3);
    };
    std::printf("%s,%d,%s,%s,%s,%s\n", name.c_str(), static_cast<int>(springs), perSpring("|ours").c_str(),
                perSpring("|springs").c_str(), perSpring("|dampers").c_str(),
                subject->plain ? perSpring("|plain").c_str() : "");
  }
  for (const auto& [name, springs] : limits.springsPerPass())
    std::printf("limit: %s,,%s,,,\n", name.c_str(),
                formatDouble(reporter.seconds(name) * 1e9 / springs, 3).c_str());
  return 0;
}

} // namespace esm::bench
