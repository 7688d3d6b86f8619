// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"

#include <QObject>

#include <functional>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace esm {

/// Work off the GUI thread, one task at a time: `process` runs on a thread of its own and must own copies of
/// all it needs; `finish` gets its result on the GUI thread. Starting another task or cancel() stops the
/// former by its WorkControl and drops its result: whoever cancels is free at once, the task ends soon after.
/// The destructor stops and waits, so a runner belongs to the window, not to a dialog.
class JobRunner : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  ~JobRunner() override;

  /// @param process `Result<T>(WorkControl*)`; an exception in it (a full memory) becomes an Internal error.
  template <class Process, class Finish>
  void start(Process process, Finish finish)
  {
    using Outcome = std::invoke_result_t<Process, WorkControl*>;
    cancel();
    const std::uint64_t ticket = ++m_ticket;
    m_control = std::make_shared<WorkControl>();
    launch([this, ticket, control = m_control, process = std::move(process),
            finish = std::move(finish)]() mutable {
      auto outcome = std::make_shared<Outcome>(guarded<Outcome>(process, control.get()));
      deliver(ticket, [outcome, finish = std::move(finish)]() mutable { finish(std::move(*outcome)); });
    });
  }

  void cancel();
  bool busy() const noexcept { return m_busy; }
  double done() const noexcept; ///< share of the running task's present stage, 0 ... 1; 0 without one

signals:
  void busyChanged(bool busy);

private:
  template <class Outcome, class Process>
  static Outcome guarded(Process& process, WorkControl* control) noexcept
  {
    try {
      return process(control);
    } catch (const std::exception& fault) {
      return Error{ErrorCode::Internal, fault.what()};
    }
  }
  void launch(std::function<void()> body);
  void deliver(std::uint64_t ticket, std::function<void()> finish); ///< worker thread
  void setBusy(bool busy);

  std::vector<std::thread> m_threads;     ///< joined by the destructor
  std::shared_ptr<WorkControl> m_control; ///< of the running task, or null
  std::uint64_t m_ticket = 0;
  bool m_busy = false;
};

} // namespace esm
