// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/linear/block_cholesky.h"

#include "core/forces/spring_pass.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

ESM_INLINE void storeLanes(const Lanes& from, double* to) noexcept
{
  __builtin_memcpy(to, &from, sizeof(from));
}

/// A finished 3 x 3 block of the triangle, with S, and what columns below it are multiplied with.
struct Pivot {
  double inverse[3] = {};                                ///< 1 / (s l) of the diagonal
  double sign[3] = {1, 1, 1};                            ///< s
  double lower10 = 0.0, lower20 = 0.0, lower21 = 0.0;    ///< l
  double signed10 = 0.0, signed20 = 0.0, signed21 = 0.0; ///< s l

  /// From the lower half of a block. @return how many pivots are negative; -1 if one is 0 or not finite.
  ESM_INLINE int factor(double a00, double a10, double a20, double a11, double a21, double a22) noexcept
  {
    if (!invert(0, a00)) return -1;
    lower10 = a10 * inverse[0];
    lower20 = a20 * inverse[0];
    signed10 = sign[0] * lower10;
    signed20 = sign[0] * lower20;
    if (!invert(1, a11 - lower10 * signed10)) return -1;
    lower21 = (a21 - lower20 * signed10) * inverse[1];
    signed21 = sign[1] * lower21;
    if (!invert(2, (a22 - lower20 * signed20) - lower21 * signed21)) return -1;
    return (sign[0] < 0.0) + (sign[1] < 0.0) + (sign[2] < 0.0);
  }

private:
  ESM_INLINE bool invert(int i, double pivot) noexcept
  {
    const double size = __builtin_fabs(pivot);
    if (!(size > 0.0) || !(size <= std::numeric_limits<double>::max())) return false;
    sign[i] = pivot > 0.0 ? 1.0 : -1.0;
    inverse[i] = sign[i] / __builtin_sqrt(size);
    return true;
  }
};

/// sum = c - a b^T for R x 4 rows and 3 columns, over `depth` columns of a and b.
template <int R>
ESM_INLINE void subtractProducts(const double* c, Index leadC, const double* a, const double* b, Index lead,
                                 Index depth, Lanes (&sum)[R][3]) noexcept
{
  for (int r = 0; r < R; ++r)
    for (int column = 0; column < 3; ++column) loadLanes(c + column * leadC + 4 * r, sum[r][column]);
  for (Index k = 0; k < depth; ++k, a += lead, b += lead) {
    const Lanes b0 = Lanes{0, 0, 0, 0} + b[0], b1 = Lanes{0, 0, 0, 0} + b[1], b2 = Lanes{0, 0, 0, 0} + b[2];
    for (int r = 0; r < R; ++r) {
      Lanes row;
      loadLanes(a + 4 * r, row);
      sum[r][0] -= row * b0;
      sum[r][1] -= row * b1;
      sum[r][2] -= row * b2;
    }
  }
}

template <int R>
ESM_INLINE void storeRows(const Lanes (&sum)[R][3], double* c, Index leadC) noexcept
{
  for (int r = 0; r < R; ++r)
    for (int column = 0; column < 3; ++column) storeLanes(sum[r][column], c + column * leadC + 4 * r);
}

/// Rows times the inverse of the transposed triangle of `pivot`.
template <int R>
ESM_INLINE void divideRows(const Pivot& pivot, Lanes (&sum)[R][3]) noexcept
{
  for (int r = 0; r < R; ++r) {
    sum[r][0] *= pivot.inverse[0];
    sum[r][1] = (sum[r][1] - sum[r][0] * pivot.signed10) * pivot.inverse[1];
    sum[r][2] = ((sum[r][2] - sum[r][0] * pivot.signed20) - sum[r][1] * pivot.signed21) * pivot.inverse[2];
  }
}

/// Rows of three panel columns: what earlier columns take away, then the division by the pivot.
template <int R>
ESM_INLINE void finishRows(double* c, const double* a, const double* b, Index lead, Index depth,
                           const Pivot& pivot) noexcept
{
  Lanes sum[R][3];
  subtractProducts<R>(c, lead, a, b, lead, depth, sum);
  divideRows<R>(pivot, sum);
  storeRows<R>(sum, c, lead);
}

template <int R>
ESM_INLINE void updateRows(double* c, Index leadC, const double* a, const double* b, Index lead,
                           Index depth) noexcept
{
  Lanes sum[R][3];
  subtractProducts<R>(c, leadC, a, b, lead, depth, sum);
  storeRows<R>(sum, c, leadC);
}

/// The first rows of three panel columns, with their triangle. @return see Pivot::factor().
template <int R>
ESM_INLINE int finishHead(double* c, const double* a, const double* b, Index lead, Index depth, Index above,
                          Pivot& pivot) noexcept
{
  Lanes sum[R][3];
  subtractProducts<R>(c, lead, a, b, lead, depth, sum);
  storeRows<R>(sum, c, lead);
  const double* c0 = c + above;
  const double* c1 = c0 + lead;
  const double* c2 = c1 + lead;
  const int negative = pivot.factor(c0[0], c0[1], c0[2], c1[1], c1[2], c2[2]);
  divideRows<R>(pivot, sum);
  storeRows<R>(sum, c, lead);
  for (Index row = 0; row < above + 3; ++row) c[row] = c[row + lead] = c[row + 2 * lead] = 0.0;
  double* triangle = c + above; // with the inverses of the diagonal, without sign
  triangle[0] = pivot.inverse[0] * pivot.sign[0];
  triangle[1] = pivot.lower10;
  triangle[2] = pivot.lower20;
  triangle[lead + 1] = pivot.inverse[1] * pivot.sign[1];
  triangle[lead + 2] = pivot.lower21;
  triangle[2 * lead + 2] = pivot.inverse[2] * pivot.sign[2];
  return negative;
}

struct Panel {
  double* values;
  double* signedCopy; ///< filled from the first negative pivot on
  double* sign;       ///< by columns
  Index width, inner, lead;
};

/// @return negative pivots, -1 for failure; `right` is what the rows of the update take as second factor.
ESM_CPU_CLONES_AVX512 int factorColumns(const Panel& panel, const double** right) noexcept
{
  const Index lead = panel.lead;
  const double* b = panel.values;
  int negative = 0;
  for (Index column = 0; column < panel.width; column += 3) {
    double* c = panel.values + static_cast<std::ptrdiff_t>(column) * lead;
    const Index head = column / 4 * 4;
    Pivot pivot;
    const bool isNarrow = column - head <= 1; // the triangle's rows lie in one group of four
    const int found =
      isNarrow ? finishHead<1>(c + head, panel.values + head, b + column, lead, column, column - head, pivot)
               : finishHead<2>(c + head, panel.values + head, b + column, lead, column, column - head, pivot);
    if (found < 0) return -1;
    Index row = head + (isNarrow ? 4 : 8);
    for (; row + 16 <= lead; row += 16)
      finishRows<4>(c + row, panel.values + row, b + column, lead, column, pivot);
    switch ((lead - row) / 4) {
    case 3:
      finishRows<3>(c + row, panel.values + row, b + column, lead, column, pivot);
      break;
    case 2:
      finishRows<2>(c + row, panel.values + row, b + column, lead, column, pivot);
      break;
    case 1:
      finishRows<1>(c + row, panel.values + row, b + column, lead, column, pivot);
      break;
    default:
      break;
    }
    for (int i = 0; i < 3; ++i) panel.sign[column + i] = pivot.sign[i];
    const bool isFirst = found > 0 && negative == 0;
    negative += found;
    if (negative == 0) continue;
    b = panel.signedCopy;
    for (Index k = isFirst ? 0 : column; k < column + 3; ++k)
      for (Index i = 0; i < lead; ++i)
        panel.signedCopy[k * lead + i] = panel.values[k * lead + i] * panel.sign[k];
  }
  *right = b;
  return negative;
}

/// Lower half of update -= a b^T; both of `width` columns, `lead` apart.
ESM_CPU_CLONES_AVX512 void subtractSquare(double* update, Index rows, Index outer, const double* a,
                                          const double* b, Index lead, Index width) noexcept
{
  for (Index column = 0; column < rows; column += 3) {
    double* c = update + static_cast<std::ptrdiff_t>(column) * outer;
    Index row = column / 4 * 4;
    for (; row + 16 <= outer; row += 16) updateRows<4>(c + row, outer, a + row, b + column, lead, width);
    switch ((outer - row) / 4) {
    case 3:
      updateRows<3>(c + row, outer, a + row, b + column, lead, width);
      break;
    case 2:
      updateRows<2>(c + row, outer, a + row, b + column, lead, width);
      break;
    case 1:
      updateRows<1>(c + row, outer, a + row, b + column, lead, width);
      break;
    default:
      break;
    }
  }
}

ESM_INLINE void addNumbers(const double* from, double* to, Index count) noexcept
{
  Index i = 0;
  for (; i + 4 <= count; i += 4) {
    Lanes a, b;
    loadLanes(from + i, a);
    loadLanes(to + i, b);
    storeLanes(a + b, to + i);
  }
  for (; i < count; ++i) to[i] += from[i];
}

/// What the solution of L y = b takes from the rows of a panel. @param t  the front's rows; in: b of the
/// triangle's rows, 0 below; out: y, and what to add to the rows below.
ESM_CPU_CLONES_AVX512 void solveForward(const double* panel, Index width, Index lead, double* t) noexcept
{
  for (Index column = 0; column < width; column += 3) {
    const double* l = panel + static_cast<std::ptrdiff_t>(column) * lead;
    const double* triangle = l + column;
    const double y0 = t[column] * triangle[0];
    const double y1 = (t[column + 1] - triangle[1] * y0) * triangle[lead + 1];
    const double y2 = ((t[column + 2] - triangle[2] * y0) - triangle[lead + 2] * y1) * triangle[2 * lead + 2];
    for (Index row = column / 4 * 4; row < lead; row += 4) {
      Lanes l0, l1, l2, value;
      loadLanes(l + row, l0);
      loadLanes(l + lead + row, l1);
      loadLanes(l + 2 * lead + row, l2);
      loadLanes(t + row, value);
      storeLanes(((value - l0 * y0) - l1 * y1) - l2 * y2, t + row);
    }
    t[column] = y0;
    t[column + 1] = y1;
    t[column + 2] = y2;
  }
}

/// Solves L^T x = z. @param z  of the triangle's rows; x is put in its place. @param t  in: 0 in the rows of
/// the triangle, x in those below.
ESM_CPU_CLONES_AVX512 void solveBackward(const double* panel, Index width, Index lead, double* z,
                                         double* t) noexcept
{
  for (Index column = width - 3; column >= 0; column -= 3) {
    const double* l = panel + static_cast<std::ptrdiff_t>(column) * lead;
    Lanes sum0 = {0, 0, 0, 0}, sum1 = sum0, sum2 = sum0;
    for (Index row = column / 4 * 4; row < lead; row += 4) {
      Lanes l0, l1, l2, value;
      loadLanes(l + row, l0);
      loadLanes(l + lead + row, l1);
      loadLanes(l + 2 * lead + row, l2);
      loadLanes(t + row, value);
      sum0 += l0 * value;
      sum1 += l1 * value;
      sum2 += l2 * value;
    }
    const double* triangle = l + column;
    const double x2 = (z[column + 2] - sumLanes(sum2)) * triangle[2 * lead + 2];
    const double x1 = ((z[column + 1] - sumLanes(sum1)) - triangle[lead + 2] * x2) * triangle[lead + 1];
    const double x0 = (((z[column] - sumLanes(sum0)) - triangle[1] * x1) - triangle[2] * x2) * triangle[0];
    z[column] = t[column] = x0;
    z[column + 1] = t[column + 1] = x1;
    z[column + 2] = t[column + 2] = x2;
  }
}

} // namespace

void BlockCholesky::addUpdate(const Front& child, const Front& parent) noexcept
{
  const double* from = m_updates.data() + child.update;
  double* panel = m_panels.data() + parent.panel;
  double* update = m_updates.data() + parent.update;
  const Run* begin = m_runs.data() + child.firstRun;
  const Run* end = begin + child.runCount;
  for (const Run* columns = begin; columns != end; ++columns)
    for (Index i = 0; i < columns->count; ++i) {
      const Index place = columns->to + i;
      const bool isInPanel = place < parent.width;
      double* to =
        isInPanel ? panel + static_cast<std::ptrdiff_t>(place) * parent.lead
                  : update + static_cast<std::ptrdiff_t>(place - parent.inner) * parent.outer - parent.inner;
      const double* source = from + static_cast<std::ptrdiff_t>(columns->from + i) * child.outer;
      const Index skip = i / 3 * 3; // what is above the diagonal block
      addNumbers(source + columns->from + skip, to + columns->to + skip, columns->count - skip);
      for (const Run* rows = columns + 1; rows != end; ++rows)
        addNumbers(source + rows->from, to + rows->to, rows->count);
    }
}

bool BlockCholesky::factor(const NodeBlock* diagonal, const NodeBlock* coupling, Interruption* interruption)
{
  m_negativePivots = 0;
  m_panels.resize(m_panelNumbers);
  m_updates.resize(m_updateNumbers);
  std::fill(m_panels.begin(), m_panels.end(), 0.0);
  const auto add = [&](const Place& place, const NodeBlock& block) {
    double* corner = m_panels.data() + place.corner;
    for (Index column = 0; column < 3; ++column)
      for (Index row = 0; row < 3; ++row) corner[column * place.lead + row] += block.column[column][row];
  };
  for (std::size_t i = 0; i < m_diagonal.size(); ++i) add(m_diagonal[i], diagonal[i]);
  for (std::size_t i = 0; i < m_coupling.size(); ++i) add(m_coupling[i], coupling[i]);
  constexpr double kProductsOfPiece = 8e6; // about 2 ms
  double products = 0.0;
  for (const Front& front : m_fronts) {
    double* update = m_updates.data() + front.update;
    const auto outer = static_cast<std::size_t>(front.outer);
    std::fill(update, update + outer * outer, 0.0);
    for (std::size_t c = 0; c < front.childCount; ++c)
      addUpdate(m_fronts[static_cast<std::size_t>(m_children[front.firstChild + c])], front);
    if (!factorPanel(front)) return false;
    products += static_cast<double>(front.lead) * front.lead * front.width;
    if (interruption == nullptr || products < kProductsOfPiece) continue;
    products = 0.0;
    if (interruption->isDue()) return false;
  }
  return true;
}

bool BlockCholesky::factorPanel(const Front& front) noexcept
{
  double* values = m_panels.data() + front.panel;
  const Panel panel{
    values,      m_signed.data(), m_sign.data() + 3 * static_cast<std::ptrdiff_t>(front.firstColumn),
    front.width, front.inner,     front.lead};
  const double* right = nullptr;
  const int negative = factorColumns(panel, &right);
  if (negative < 0) return false;
  m_negativePivots += negative;
  if (front.rowCount > 0)
    subtractSquare(m_updates.data() + front.update, 3 * front.rowCount, front.outer, values + front.inner,
                   right + front.inner, front.lead, front.width);
  return true;
}

void BlockCholesky::solve(Lanes* vector) noexcept
{
  double* x = m_vector.data();
  for (std::size_t place = 0; place < m_nodeAt.size(); ++place)
    for (std::size_t i = 0; i < 3; ++i)
      x[3 * place + i] = vector[static_cast<std::size_t>(m_nodeAt[place])][static_cast<int>(i)];
  solveUpwards(x);
  if (m_negativePivots > 0)
    for (std::size_t i = 0; i < m_vector.size(); ++i) x[i] *= m_sign[i];
  solveDownwards(x);
  for (std::size_t place = 0; place < m_nodeAt.size(); ++place)
    vector[static_cast<std::size_t>(m_nodeAt[place])] =
      Lanes{x[3 * place], x[3 * place + 1], x[3 * place + 2], 0.0};
}

/// With A = L S L^T, a column of the inverse of L^T at a negative sign is such a vector.
bool BlockCholesky::negativeDirection(Lanes* vector) noexcept
{
  const auto negative = std::find(m_sign.begin(), m_sign.end(), -1.0);
  if (m_negativePivots == 0 || negative == m_sign.end()) return false;
  double* x = m_vector.data();
  std::fill(m_vector.begin(), m_vector.end(), 0.0);
  x[negative - m_sign.begin()] = 1.0;
  solveDownwards(x);
  for (std::size_t place = 0; place < m_nodeAt.size(); ++place)
    vector[static_cast<std::size_t>(m_nodeAt[place])] =
      Lanes{x[3 * place], x[3 * place + 1], x[3 * place + 2], 0.0};
  return true;
}

/// x = L^-1 x, in the order of elimination.
void BlockCholesky::solveUpwards(double* x) noexcept
{
  double* t = m_frontVector.data();
  for (const Front& front : m_fronts) {
    double* own = x + 3 * static_cast<std::ptrdiff_t>(front.firstColumn);
    std::copy(own, own + front.width, t);
    std::fill(t + front.width, t + front.lead, 0.0);
    solveForward(m_panels.data() + front.panel, front.width, front.lead, t);
    std::copy(t, t + front.width, own);
    const double* below = t + front.inner;
    for (Index i = 0; i < front.rowCount; ++i, below += 3) {
      double* row = x + 3 * static_cast<std::ptrdiff_t>(m_rows[front.firstRow + static_cast<std::size_t>(i)]);
      for (int k = 0; k < 3; ++k) row[k] += below[k];
    }
  }
}

/// x = L^-T x.
void BlockCholesky::solveDownwards(double* x) noexcept
{
  double* t = m_frontVector.data();
  for (std::size_t f = m_fronts.size(); f-- > 0;) {
    const Front& front = m_fronts[f];
    double* below = t + front.inner;
    std::fill(t, below, 0.0);
    for (Index i = 0; i < front.rowCount; ++i, below += 3) {
      const double* row =
        x + 3 * static_cast<std::ptrdiff_t>(m_rows[front.firstRow + static_cast<std::size_t>(i)]);
      for (int k = 0; k < 3; ++k) below[k] = row[k];
    }
    std::fill(below, t + front.lead, 0.0);
    solveBackward(m_panels.data() + front.panel, front.width, front.lead,
                  x + 3 * static_cast<std::ptrdiff_t>(front.firstColumn), t);
  }
}

} // namespace esm
