#include "cli/run.hpp"

#include <malloc.h>

#include <csignal>
#include <iostream>
#include <string>

#include "cli/provenance/provenance.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "frf/hdf5/file_origin.hpp"
#include "ident/team/team.hpp"

namespace jointid::cli {
namespace {

int told(ExitCode code, const std::string& line) {
  if (interrupted()) claim_end();
  print_error(line);
  return static_cast<int>(code);
}

/// For what all processes that mpirun started find alike: the first tells, the others end quietly, and with 0, as mpirun kills
/// the rest when one fails.
int told_once(ExitCode code, const std::string& line) { return ident::process_number() == 0 ? told(code, line) : 0; }

/// The exit code, unless what was printed did not get through (a full disk, a closed file).
int finish(ExitCode code) {
  std::cout.flush();
  if (!std::cout) return told(ExitCode::data, "cannot write to standard output");
  if (interrupted()) return told_once(ExitCode::interrupted, "interrupted");
  return static_cast<int>(code);
}

/// Memory that was freed is kept for the next matrices: given back, it comes anew with a page fault for every 4 KiB.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

/// What cannot be shared is done once, by the first process: each would do it, and write the same files.
int perform(const ChosenCommand& command) {
  if (const std::size_t processes = ident::processes_started(); processes > 1 && !command.is_shared) {
    if (ident::process_number() != 0) return 0;
    print_warning("this command is not shared by the " + std::to_string(processes) +
                  " processes that mpirun started; one of them does it");
  }
  catch_interrupts();
  keep_freed_memory();
  return finish(command.execute(std::cout));
}

int print(const Notice& notice) {
  if (notice.code != ExitCode::done) return told_once(notice.code, notice.text);
  std::cout << notice.text;
  return finish(notice.code);
}

}  // namespace

int run(int argc, const char* const* argv, Parse parse) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow (ulimit -f) is one that cannot be written
  begin_provenance(argc, argv);
  frf::set_file_origin(provenance_text);
  try {
    const auto parsed = parse(argc, argv);
    const auto* notice = std::get_if<Notice>(&parsed);
    return notice ? print(*notice) : perform(std::get<ChosenCommand>(parsed));
  } catch (const ident::ToldElsewhere&) {
    return 0;
  } catch (...) {
    const Failure failure = explain(std::current_exception());
    return told(failure.code, failure.line);
  }
}

}  // namespace jointid::cli
