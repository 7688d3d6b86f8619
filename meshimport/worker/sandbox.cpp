// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/sandbox.h"

#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <iterator>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace esm {

namespace {

#if defined(__x86_64__)
constexpr unsigned kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kMachine = AUDIT_ARCH_AARCH64;
#elif defined(__riscv) && __riscv_xlen == 64
constexpr unsigned kMachine = AUDIT_ARCH_RISCV64;
#else
constexpr unsigned kMachine = 0; // its calls are not known here, so nothing is claimed
#endif

constexpr unsigned kOtherTable = 0x40000000; ///< x32 calls on x86-64; no other machine has numbers so large

constexpr sock_filter statement(int code, unsigned value)
{
  return {static_cast<__u16>(code), 0, 0, value};
}

/// Goes on with the next line if it holds, else leaves `skipped` lines out.
constexpr sock_filter unlessSkip(int comparison, unsigned value, int skipped)
{
  return {static_cast<__u16>(BPF_JMP | BPF_K | comparison), 0, static_cast<__u8>(skipped), value};
}

constexpr sock_filter kRefuse = statement(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES);

bool allowBeneath(int rules, const char* place, unsigned long long access)
{
  const int folder = ::open(place, O_PATH | O_CLOEXEC);
  if (folder < 0) return false;
  landlock_path_beneath_attr beneath{};
  beneath.allowed_access = access;
  beneath.parent_fd = folder;
  const bool added = ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) == 0;
  ::close(folder);
  return added;
}

} // namespace

bool closeNetwork()
{
  if (kMachine == 0) return false;
  constexpr unsigned kForbidden[] = {SYS_socket, SYS_socketpair, SYS_io_uring_setup,
                                     SYS_execve, SYS_execveat,   SYS_ptrace};
  constexpr std::size_t kHead = 6;
  sock_filter lines[kHead + 2 * std::size(kForbidden) + 1] = {
    statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
    {BPF_JMP | BPF_K | BPF_JEQ, 1, 0, kMachine},
    kRefuse,
    statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
    unlessSkip(BPF_JGE, kOtherTable, 1),
    kRefuse,
  };
  std::size_t count = kHead;
  for (const unsigned call : kForbidden) {
    lines[count++] = unlessSkip(BPF_JEQ, call, 1);
    lines[count++] = kRefuse;
  }
  lines[count++] = statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  sock_fprog program{static_cast<unsigned short>(count), lines};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

bool closeOtherFolders(const std::filesystem::path& folder)
{
  constexpr unsigned long long kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = kRead | LANDLOCK_ACCESS_FS_EXECUTE;
  const int rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
  if (rules < 0) return false;
  bool closed = allowBeneath(rules, folder.c_str(), kRead);
  for (const char* const system : kSystemFolders)
    allowBeneath(rules, system,
                 std::filesystem::is_directory(system) ? handled.handled_access_fs
                                                       : LANDLOCK_ACCESS_FS_READ_FILE);
  closed = closed && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::syscall(SYS_landlock_restrict_self, rules, 0) == 0;
  ::close(rules);
  return closed;
}

} // namespace esm
