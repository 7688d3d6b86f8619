// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// SUNDIALS (Hindmarsh et al. 2005; Reynolds et al. 2023): CVODE's BDF and ARKODE's DIRK of order 4 on
// y = (x, v), their Newton systems I - gamma J solved by KLU on 6N unknowns, or condensed to
// M + gamma D + gamma^2 K on 3N and solved by Cholesky; and ARKODE's explicit Dormand-Prince pair.
#include "bench/reference/condensed_matrix.h"
#include "bench/reference/method.h"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <array>

namespace esm::bench {
namespace {

void toNodes(const double* from, Nodes& to)
{
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = Vec4{from[3 * i], from[3 * i + 1], from[3 * i + 2], 0.0};
}

void fromNodes(const Nodes& from, double* to)
{
  for (std::size_t i = 0; i < from.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) to[3 * i + axis] = from[i][static_cast<int>(axis)];
}

/// What the callbacks of all variants need. The Newton matrix takes the tangents without the part that comes
/// from turning dampers, and with pressed springs' lateral stiffness at 0: the iteration, not the result,
/// feels that.
struct Problem {
  FastNet* net = nullptr;
  Nodes x, v, force, right, change;
  std::vector<FastNet::Tangent> tangents;
  CondensedMatrix condensed;
  double gamma = 0.0, weightX = 0.0, weightV = 0.0;
  // Of KLU's matrix: where the parts of I - gamma J stand.
  Eigen::SparseMatrix<double> pattern;
};

int rightHandSide(double t, N_Vector y, N_Vector slope, void* data)
{
  auto& p = *static_cast<Problem*>(data);
  const std::size_t half = 3 * p.net->nodeCount();
  const double* from = N_VGetArrayPointer(y);
  double* to = N_VGetArrayPointer(slope);
  toNodes(from, p.x);
  toNodes(from + half, p.v);
  p.net->forces(t, p.x.data(), p.v.data(), p.force.data());
  std::copy(from + half, from + 2 * half, to);
  for (std::size_t i = 0; i < p.force.size(); ++i) p.force[i] *= p.net->inverseMass()[i];
  fromNodes(p.force, to + half);
  return 0;
}

int errorWeights(N_Vector, N_Vector weights, void* data)
{
  const auto& p = *static_cast<Problem*>(data);
  const std::size_t half = 3 * p.net->nodeCount();
  double* to = N_VGetArrayPointer(weights);
  std::fill(to, to + half, p.weightX);
  std::fill(to + half, to + 2 * half, p.weightV);
  return 0;
}

// === Condensed Cholesky as a linear solver of SUNDIALS, with a matrix that is only a token

int newtonMatrix(double, N_Vector y, N_Vector, SUNMatrix, int, int* fresh, double gamma, void* data, N_Vector,
                 N_Vector, N_Vector)
{
  auto& p = *static_cast<Problem*>(data);
  toNodes(N_VGetArrayPointer(y), p.x);
  p.net->tangents(p.x, p.tangents);
  p.gamma = gamma;
  *fresh = 1;
  return p.condensed.factor(*p.net, p.tangents, gamma, gamma * gamma) ? 0 : 1;
}

int newtonMatrixWithMass(double t, N_Vector y, N_Vector f, SUNMatrix matrix, SUNMatrix, int ok, int* fresh,
                         double gamma, void* data, N_Vector a, N_Vector b, N_Vector c)
{
  return newtonMatrix(t, y, f, matrix, ok, fresh, gamma, data, a, b, c);
}

SUNLinearSolver_Type solverType(SUNLinearSolver)
{
  return SUNLINEARSOLVER_DIRECT;
}

int solverSetup(SUNLinearSolver, SUNMatrix)
{
  return 0;
}

/// x - gamma v = r1, M v + gamma (K x + D v) = M r2; held nodes have v = r2.
int solverSolve(SUNLinearSolver solver, SUNMatrix, N_Vector solution, N_Vector right, double)
{
  auto& p = *static_cast<Problem*>(solver->content);
  const std::size_t count = p.net->nodeCount();
  const double* r = N_VGetArrayPointer(right);
  double* s = N_VGetArrayPointer(solution);
  toNodes(r, p.x);
  toNodes(r + 3 * count, p.v);
  for (std::size_t i = 0; i < count; ++i) p.right[i] = Vec4{0, 0, 0, 0};
  addStiffnessTimes(*p.net, p.tangents, 0.0, -p.gamma, p.x.data(), p.right.data());
  for (std::size_t i = 0; i < count; ++i)
    p.right[i] = p.net->held(i) ? p.v[i] * p.net->mass()[i] : p.right[i] + p.v[i] * p.net->mass()[i];
  p.condensed.solve(p.right, p.change);
  fromNodes(p.change, s + 3 * count);
  for (std::size_t i = 0; i < 3 * count; ++i) s[i] = r[i] + p.gamma * s[3 * count + i];
  return 0;
}

SUNMatrix_ID tokenId(SUNMatrix)
{
  return SUNMATRIX_CUSTOM;
}

int tokenZero(SUNMatrix)
{
  return 0;
}

// === KLU on the full matrix

using Triplets = std::vector<Eigen::Triplet<double>>;

void fullMatrix(const FastNet& net, const std::vector<FastNet::Tangent>& tangents, double gamma,
                Triplets& entries)
{
  entries.clear();
  const auto half = static_cast<int>(3 * net.nodeCount());
  for (int i = 0; i < 2 * half; ++i) entries.emplace_back(i, i, 1.0);
  for (int i = 0; i < half; ++i) entries.emplace_back(i, half + i, -gamma);
  const auto add = [&](int i, int j, int row, int column, double k, double c) {
    const double scale = gamma * net.inverseMass()[static_cast<std::size_t>(i)];
    entries.emplace_back(half + 3 * i + row, 3 * j + column, scale * k);
    entries.emplace_back(half + 3 * i + row, half + 3 * j + column, scale * c);
  };
  for (const FastNet::Anchor& anchor : net.anchors())
    for (int axis = 0; axis < 3; ++axis)
      add(anchor.node, anchor.node, axis, axis, anchor.stiffness, anchor.viscosity);
  for (std::size_t s = 0; s < tangents.size(); ++s) {
    const FastNet::Tangent& tangent = tangents[s];
    const int a = net.springs()[s].a, b = net.springs()[s].b;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const double turn = tangent.u[row] * tangent.u[column];
        const double k = (tangent.axial - tangent.lateral) * turn + (row == column ? tangent.lateral : 0.0);
        const double c = tangent.viscous * turn;
        add(a, a, row, column, k, c);
        add(b, b, row, column, k, c);
        add(a, b, row, column, -k, -c);
        add(b, a, row, column, -k, -c);
      }
  }
}

int kluMatrix(double, N_Vector y, N_Vector, SUNMatrix matrix, int, int* fresh, double gamma, void* data,
              N_Vector, N_Vector, N_Vector)
{
  auto& p = *static_cast<Problem*>(data);
  toNodes(N_VGetArrayPointer(y), p.x);
  p.net->tangents(p.x, p.tangents);
  Triplets entries;
  fullMatrix(*p.net, p.tangents, gamma, entries);
  p.pattern.setFromTriplets(entries.begin(), entries.end());
  std::copy_n(p.pattern.outerIndexPtr(), p.pattern.outerSize() + 1, SUNSparseMatrix_IndexPointers(matrix));
  std::copy_n(p.pattern.innerIndexPtr(), p.pattern.nonZeros(), SUNSparseMatrix_IndexValues(matrix));
  std::copy_n(p.pattern.valuePtr(), p.pattern.nonZeros(), SUNSparseMatrix_Data(matrix));
  *fresh = 1;
  return 0;
}

int kluMatrixWithMass(double t, N_Vector y, N_Vector f, SUNMatrix matrix, SUNMatrix, int ok, int* fresh,
                      double gamma, void* data, N_Vector a, N_Vector b, N_Vector c)
{
  return kluMatrix(t, y, f, matrix, ok, fresh, gamma, data, a, b, c);
}

enum class Scheme { Bdf, Dirk, Explicit };

class Sundials final : public Method {
public:
  Sundials(Scheme scheme, bool klu) : m_scheme(scheme), m_klu(klu) { SUNContext_Create(nullptr, &m_context); }
  ~Sundials() override
  {
    if (m_solver && !m_klu) m_solver->content = nullptr; // ours: SUNDIALS would free it
    if (m_solver) SUNLinSolFree(m_solver);
    if (m_matrix) SUNMatDestroy(m_matrix);
    if (m_memory && m_scheme == Scheme::Bdf) CVodeFree(&m_memory);
    if (m_memory && m_scheme == Scheme::Dirk) ARKStepFree(&m_memory);
    if (m_memory && m_scheme == Scheme::Explicit) ERKStepFree(&m_memory);
    if (m_y) N_VDestroy(m_y);
    SUNContext_Free(&m_context);
  }
  Sundials(const Sundials&) = delete;
  Sundials& operator=(const Sundials&) = delete;

  void prepare(FastNet& net, double setting, const Scales& scales) override
  {
    const std::size_t count = net.nodeCount();
    Problem& p = m_problem;
    p.net = &net;
    for (Nodes* nodes : {&p.x, &p.v, &p.force, &p.right, &p.change}) nodes->resize(count);
    p.weightX = 1.0 / (setting * scales.displacement);
    p.weightV = 1.0 / (setting * scales.speed);
    m_y = N_VNew_Serial(static_cast<sunindextype>(6 * count), m_context);
  }

  bool frame(FastNet& net, double t0, double t1, bool changed, Nodes& x, Nodes& v) override
  {
    double* y = N_VGetArrayPointer(m_y);
    const std::size_t half = 3 * x.size();
    if (changed) {
      fromNodes(x, y);
      fromNodes(v, y + half);
      if (!(m_memory ? restart(t0) : create(net, t0))) return false;
    }
    double reached = t0;
    int flag = 0;
    if (m_scheme == Scheme::Bdf) {
      CVodeSetStopTime(m_memory, t1);
      flag = CVode(m_memory, t1, m_y, &reached, CV_NORMAL);
    } else if (m_scheme == Scheme::Dirk) {
      ARKStepSetStopTime(m_memory, t1);
      flag = ARKStepEvolve(m_memory, t1, m_y, &reached, ARK_NORMAL);
    } else {
      ERKStepSetStopTime(m_memory, t1);
      flag = ERKStepEvolve(m_memory, t1, m_y, &reached, ARK_NORMAL);
    }
    toNodes(y, x);
    toNodes(y + half, v);
    return flag >= 0;
  }

private:
  bool restart(double t)
  {
    if (m_scheme == Scheme::Bdf) return CVodeReInit(m_memory, t, m_y) == CV_SUCCESS;
    if (m_scheme == Scheme::Dirk)
      return ARKStepReInit(m_memory, nullptr, rightHandSide, t, m_y) == ARK_SUCCESS;
    return ERKStepReInit(m_memory, rightHandSide, t, m_y) == ARK_SUCCESS;
  }

  bool create(FastNet& net, double t)
  {
    constexpr long kSteps = 1'000'000;
    bool good = true;
    if (m_scheme == Scheme::Explicit) {
      m_memory = ERKStepCreate(rightHandSide, t, m_y, m_context);
      ERKStepSetTableNum(m_memory, ARKODE_DORMAND_PRINCE_7_4_5);
      ERKStepWFtolerances(m_memory, errorWeights);
      ERKStepSetUserData(m_memory, &m_problem);
      ERKStepSetMaxNumSteps(m_memory, kSteps);
      return m_memory != nullptr;
    }
    m_klu ? makeKlu(net) : makeCondensed(net);
    if (m_scheme == Scheme::Bdf) {
      m_memory = CVodeCreate(CV_BDF, m_context);
      CVodeInit(m_memory, rightHandSide, t, m_y);
      CVodeWFtolerances(m_memory, errorWeights);
      CVodeSetUserData(m_memory, &m_problem);
      CVodeSetMaxNumSteps(m_memory, kSteps);
      good = CVodeSetLinearSolver(m_memory, m_solver, m_matrix) == CV_SUCCESS;
      CVodeSetLinSysFn(m_memory, m_klu ? kluMatrix : newtonMatrix);
    } else {
      m_memory = ARKStepCreate(nullptr, rightHandSide, t, m_y, m_context);
      ARKStepSetOrder(m_memory, 4);
      ARKStepWFtolerances(m_memory, errorWeights);
      ARKStepSetUserData(m_memory, &m_problem);
      ARKStepSetMaxNumSteps(m_memory, kSteps);
      good = ARKStepSetLinearSolver(m_memory, m_solver, m_matrix) == ARK_SUCCESS;
      ARKStepSetLinSysFn(m_memory, m_klu ? kluMatrixWithMass : newtonMatrixWithMass);
    }
    return good;
  }

  void makeCondensed(FastNet& net)
  {
    m_problem.condensed.analyse(net);
    m_matrix = SUNMatNewEmpty(m_context);
    m_matrix->ops->getid = tokenId;
    m_matrix->ops->zero = tokenZero;
    m_solver = SUNLinSolNewEmpty(m_context);
    m_solver->content = &m_problem;
    m_solver->ops->gettype = solverType;
    m_solver->ops->setup = solverSetup;
    m_solver->ops->solve = solverSolve;
  }

  void makeKlu(FastNet& net)
  {
    const auto size = static_cast<Eigen::Index>(6 * net.nodeCount());
    net.tangents(m_problem.x, m_problem.tangents);
    Triplets entries;
    fullMatrix(net, m_problem.tangents, 1.0, entries);
    m_problem.pattern.resize(size, size);
    m_problem.pattern.setFromTriplets(entries.begin(), entries.end());
    m_matrix = SUNSparseMatrix(size, size, m_problem.pattern.nonZeros(), CSC_MAT, m_context);
    m_solver = SUNLinSol_KLU(m_y, m_matrix, m_context);
  }

  Scheme m_scheme;
  bool m_klu;
  Problem m_problem;
  SUNContext m_context = nullptr;
  void* m_memory = nullptr;
  N_Vector m_y = nullptr;
  SUNMatrix m_matrix = nullptr;
  SUNLinearSolver m_solver = nullptr;
};

} // namespace

std::unique_ptr<Method> makeCvodeCholesky()
{
  return std::make_unique<Sundials>(Scheme::Bdf, false);
}

std::unique_ptr<Method> makeCvodeKlu()
{
  return std::make_unique<Sundials>(Scheme::Bdf, true);
}

std::unique_ptr<Method> makeArkodeCholesky()
{
  return std::make_unique<Sundials>(Scheme::Dirk, false);
}

std::unique_ptr<Method> makeArkodeKlu()
{
  return std::make_unique<Sundials>(Scheme::Dirk, true);
}

std::unique_ptr<Method> makeArkodeExplicit()
{
  return std::make_unique<Sundials>(Scheme::Explicit, false);
}

} // namespace esm::bench
