// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/reference/fast_net.h"

#include <memory>
#include <string>
#include <vector>

namespace esm::bench {

/// How large motions of the scene are, RMS over nodes and frames: what tolerances of adaptive competitors
/// are relative to. Taken from the reference, which is more than a competitor could know by itself.
struct Scales {
  double displacement = 1.0; ///< [m]
  double speed = 1.0;        ///< [m/s]
};

/// One competitor. Plain but careful: nothing is allocated in a step of the explicit ones, matrices are
/// analysed once, factors kept where the method allows.
class Method {
public:
  virtual ~Method() = default;
  /// @param setting  steps per frame, or the tolerance of an adaptive method.
  virtual void prepare(FastNet& net, double setting, const Scales& scales) = 0;
  /// Moves x and v from t0 to t1, one frame. `changed`: see FastNet::beginFrame().
  /// @return false if the method gave up.
  virtual bool frame(FastNet& net, double t0, double t1, bool changed, Nodes& x, Nodes& v) = 0;
};

struct MethodEntry {
  std::string name;
  bool adaptive = false;  ///< setting is a tolerance
  bool implicit = false;  ///< bounded at any step
  bool secondary = false; ///< never on the front so far; run only when asked for all
  int largestNet = 0;     ///< nodes above which it is hopeless; 0 = none
  std::unique_ptr<Method> (*make)() = nullptr;
};
const std::vector<MethodEntry>& competitors();

std::unique_ptr<Method> makeSymplecticEuler();
std::unique_ptr<Method> makeVelocityVerlet();
std::unique_ptr<Method> makeClassicalRungeKutta();
std::unique_ptr<Method> makeDormandPrince();
std::unique_ptr<Method> makeBaraffWitkinPcg();
std::unique_ptr<Method> makeBaraffWitkinCholesky();
std::unique_ptr<Method> makeFastMassSprings();
std::unique_ptr<Method> makeXpbd();
#if defined(ESM_BENCH_SUNDIALS)
std::unique_ptr<Method> makeCvodeCholesky();
std::unique_ptr<Method> makeCvodeKlu();
std::unique_ptr<Method> makeArkodeCholesky();
std::unique_ptr<Method> makeArkodeKlu();
std::unique_ptr<Method> makeArkodeExplicit();
#endif

} // namespace esm::bench
