// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// esm-import-worker: reads one file by a foreign library and writes what is in it to file 3 (see reply.h).
// Started by readInWorker(); what goes wrong in here ends this process alone.
#include "core/base/file_io.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/worker/assimp_scene.h"
#include "meshimport/worker/coin_scene.h"
#include "meshimport/worker/file_guard.h"
#include "meshimport/worker/limits.h"
#include "meshimport/worker/model_folder.h"
#include "meshimport/worker/sandbox.h"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <unistd.h>

namespace {

using namespace esm;

constexpr int kReplyFile = 3;
const char* const kOpenNetwork =
  "The kernel offers no seccomp, so the foreign reader of this format was not kept from the network.";

struct Library {
  const char* name;
  WorkerReply (*read)(std::string_view bytes, const std::string& origin, const std::string& ending);
};

constexpr Library kLibraries[] = {
  {"assimp", readWithAssimp},
#if defined(ESM_HAS_COIN)
  {"coin", readWithCoin},
#endif
};

WorkerReply refused(ErrorCode code, const std::string& origin, const std::string& text)
{
  WorkerReply reply;
  reply.refusal = fault(code, origin, 0, text);
  return reply;
}

WorkerReply readBy(const Library& library, const std::string& origin, const std::string& ending)
{
  std::error_code code;
  if (const std::uintmax_t size = std::filesystem::file_size(origin, code); !code) allowFor(size);
  const Result<std::string> bytes = readFile(origin);
  WorkerReply reply;
  if (!bytes) {
    reply.refusal = bytes.error();
    return reply;
  }
  const std::filesystem::path folder = ModelFolder(origin).path();
  guardFiles(folder);
  closeOtherFolders(folder);
  const bool closed = closeNetwork();
  reply = library.read(*bytes, origin, ending);
  if (!closed) reply.notes.push_back(kOpenNetwork);
  return reply;
}

WorkerReply readSafely(const Library& library, const std::string& origin, const std::string& ending)
{
  try {
    return readBy(library, origin, ending);
  } catch (const std::bad_alloc&) {
    return refused(
      ErrorCode::Unsupported, origin,
      "it needs more memory than a file of its size should; it may be damaged, or simplify it first");
  } catch (const std::exception& error) {
    return refused(ErrorCode::BadFormat, origin,
                   std::string("the ") + library.name + " library gave up on it (" + error.what() + ")");
  } catch (...) {
    return refused(ErrorCode::BadFormat, origin,
                   std::string("the ") + library.name + " library gave up on it");
  }
}

bool send(std::string_view bytes)
{
  while (!bytes.empty()) {
    const ssize_t written = ::write(kReplyFile, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

} // namespace

int main(int count, char** words)
{
  if (count == 2 && std::strcmp(words[1], "--formats") == 0) return std::puts(assimpFormats().c_str()) < 0;
  pid_t parent = 0;
  if (count != 5 || std::from_chars(words[1], words[1] + std::strlen(words[1]), parent).ec != std::errc{}) {
    std::fputs("esm-import-worker is started by esm and esm-modeler, for files that need a foreign library\n",
               stderr);
    return 2;
  }
  if (!lockDown(parent)) return 1;
  for (const Library& library : kLibraries) {
    if (std::strcmp(library.name, words[2]) != 0) continue;
    const bool sent = send(encodeReply(readSafely(library, words[4], words[3])));
    ::_exit(sent ? 0 : 1); // nothing is left to tidy up that the end of the process does not
  }
  std::fprintf(stderr, "there is no library %s in this build\n", words[2]);
  return 2;
}
