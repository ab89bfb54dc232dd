#include "frf/hdf5_module/hdf5_first_look.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <set>
#include <tuple>

#include "frf/hdf5_module/hdf5_checked_disk.hpp"
#include "frf/hdf5_module/hdf5_visit.hpp"

namespace jointid::frf::hdf5 {
namespace {

constexpr double least_seconds = 1.0, bytes_per_second = 20e6;
constexpr rlim_t least_memory = rlim_t{64} << 20U, memory_per_byte = 2200;
constexpr int asked_for_too_much = 3;

/// A file as it was when it was looked at.
using Seen = std::tuple<dev_t, ino_t, off_t, time_t, long>;

Seen seen(const struct stat& file) { return {file.st_dev, file.st_ino, file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec}; }

void limit_time(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

/// Of all the process has mapped; false where a lower limit is there.
bool limit_memory(rlim_t more) {
  rlimit limit{};
  unsigned long pages = 0;
  std::FILE* const statm = std::fopen("/proc/self/statm", "r");
  if (statm == nullptr) return false;
  const bool known = std::fscanf(statm, "%lu", &pages) == 1;
  std::fclose(statm);
  const rlim_t now = static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
  if (!known || ::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur < now + more) return false;
  limit.rlim_cur = now + more;
  return ::setrlimit(RLIMIT_AS, &limit) == 0;
}

/// No core, no word, no handler of the parent's, no life without it.
void isolate() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int fatal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGPROF}) std::signal(fatal, SIG_DFL);
  for (const int ignored : {SIGINT, SIGTERM, SIGHUP}) std::signal(ignored, SIG_IGN);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
}

[[noreturn]] void look(const std::filesystem::path& path, double size) {
  isolate();
  limit_time(least_seconds + size / bytes_per_second);
  const bool limited = limit_memory(least_memory + memory_per_byte * static_cast<rlim_t>(size));
  poison_memory();
  const bool enough = visit_all(open_checked(path));
  ::_exit(limited && !enough ? asked_for_too_much : 0);
}

Finding finding_of(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 0 ? Finding::nothing : Finding::no_memory;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF) return Finding::no_end;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL ? Finding::no_memory : Finding::crash;
}

}  // namespace

Finding first_look(const std::filesystem::path& path) {
  static std::set<Seen> good;  // HDF5's lock keeps others out
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0 || good.contains(seen(file))) return Finding::nothing;
  const pid_t child = ::fork();
  if (child < 0) return Finding::nothing;
  if (child == 0) look(path, static_cast<double>(file.st_size));
  int status = 0;
  pid_t ended = 0;
  do ended = ::waitpid(child, &status, 0);
  while (ended < 0 && errno == EINTR);
  const Finding found = ended == child ? finding_of(status) : Finding::nothing;
  if (found == Finding::nothing) good.insert(seen(file));
  return found;
}

}  // namespace jointid::frf::hdf5
