// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QObject>

#include <functional>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace esm {

/// Work off the GUI thread, one task at a time: `process` runs on a thread of its own and must own copies of
/// all it needs; `finish` gets its result on the GUI thread. Starting another task or cancel() drops the
/// result of the former: it runs to its end, nobody listens. The destructor waits for the threads, so a
/// runner belongs to the window, not to a dialog.
class JobRunner : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  ~JobRunner() override;

  /// @param process `Result<T>()`; an exception in it (a full memory) becomes an Internal error.
  template <class Process, class Finish>
  void start(Process process, Finish finish)
  {
    using Outcome = std::invoke_result_t<Process>;
    const std::uint64_t ticket = ++m_ticket;
    launch([this, ticket, process = std::move(process), finish = std::move(finish)]() mutable {
      auto outcome = std::make_shared<Outcome>(guarded<Outcome>(process));
      deliver(ticket, [outcome, finish = std::move(finish)]() mutable { finish(std::move(*outcome)); });
    });
  }

  void cancel();
  bool busy() const noexcept { return m_busy; }

signals:
  void busyChanged(bool busy);

private:
  template <class Outcome, class Process>
  static Outcome guarded(Process& process) noexcept
  {
    try {
      return process();
    } catch (const std::exception& fault) {
      return Error{ErrorCode::Internal, fault.what()};
    }
  }
  void launch(std::function<void()> body);
  void deliver(std::uint64_t ticket, std::function<void()> finish); ///< worker thread
  void setBusy(bool busy);

  std::vector<std::thread> m_threads; ///< joined by the destructor
  std::uint64_t m_ticket = 0;
  bool m_busy = false;
};

} // namespace esm
