#include "ident/team/team.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/module.hpp"

namespace jointid::ident {
namespace {

class TeamOfOne final : public Team {
 public:
  std::size_t rank() const override { return 0; }
  std::size_t size() const override { return 1; }
  std::size_t first_failed(bool failed) override { return failed ? 0 : 1; }
  void share(std::vector<std::uint64_t>&) override {}
  std::vector<std::vector<double>> gathered(const std::vector<double>& own) override { return {own}; }
  void send(const std::vector<double>&) override {}
  void send_end(const std::string&) override {}
  std::optional<TeamMessage> receive() override { return std::nullopt; }
  void stop_others() override {}
  bool stopped() override { return false; }
};

/// The number in one of the environment variables, of Open MPI and of MPICH; 0 when there is none.
std::size_t variable(const char* open_mpi, const char* mpich) {
  for (const char* name : {open_mpi, mpich}) {
    if (const char* text = std::getenv(name)) return std::strtoul(text, nullptr, 10);
  }
  return 0;
}

constexpr Module mpi{"mpi", "a study or a solution under mpirun", "libopenmpi-dev"};

}  // namespace

bool has_mpi() { return is_there(mpi); }

std::unique_ptr<Team> join_team() {
  if (processes_started() == 1) return make_team_of_one();
  if (has_mpi()) return interface_of<MpiModule>(mpi).join();
  if (process_number() > 0) throw ToldElsewhere();
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "mpirun",
                    .problem = "this build has no MPI, and its processes cannot share their work",
                    .remedy = "build with JOINTID_WITH_MPI, or run one process with --threads"});
}

std::unique_ptr<Team> make_team_of_one() { return std::make_unique<TeamOfOne>(); }

void start_together(Team& team, const std::function<void()>& start) {
  std::exception_ptr failure;
  try {
    start();
  } catch (...) {
    failure = std::current_exception();
  }
  const std::size_t first = team.first_failed(failure != nullptr);
  if (first == team.size()) return;
  if (first == team.rank()) std::rethrow_exception(failure);
  throw ToldElsewhere();
}

std::string text_of_end(const std::exception_ptr& failure) {
  if (!failure) return {};
  try {
    std::rethrow_exception(failure);
  } catch (const Interrupted&) {
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::exception_ptr failure_elsewhere(const std::string& text) {
  return std::make_exception_ptr(
      InputError({.kind = ErrorKind::data, .file = {}, .place = "another process", .problem = text, .remedy = {}}));
}

std::size_t processes_started() { return std::max(std::size_t{1}, variable("OMPI_COMM_WORLD_SIZE", "PMI_SIZE")); }

std::size_t process_number() { return variable("OMPI_COMM_WORLD_RANK", "PMI_RANK"); }

}  // namespace jointid::ident
