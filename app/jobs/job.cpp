// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job.h"

#include <QMetaObject>

namespace esm {

JobRunner::~JobRunner()
{
  cancel();
  for (std::thread& thread : m_threads) thread.join(); // events posted to us die with us
}

void JobRunner::launch(std::function<void()> body)
{
  m_threads.emplace_back(std::move(body));
  setBusy(true);
}

void JobRunner::deliver(std::uint64_t ticket, std::function<void()> finish)
{
  QMetaObject::invokeMethod(
    this,
    [this, ticket, finish = std::move(finish)] {
      if (ticket != m_ticket) return; // dropped: cancelled, or a newer task runs
      m_control.reset();
      setBusy(false);
      finish();
    },
    Qt::QueuedConnection);
}

void JobRunner::cancel()
{
  if (m_control) m_control->cancelled = true;
  m_control.reset();
  ++m_ticket;
  setBusy(false);
}

double JobRunner::done() const noexcept
{
  return m_control ? m_control->done.load(std::memory_order_relaxed) : 0.0;
}

void JobRunner::setBusy(bool busy)
{
  if (busy == m_busy) return;
  m_busy = busy;
  emit busyChanged(busy);
}

} // namespace esm
