#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace jointid::ident {

/// Finished work of another process, or its end with what went wrong there (empty: nothing).
struct TeamEnd {
  std::string failure;
};
using TeamMessage = std::variant<std::vector<double>, TeamEnd>;

/// TeamEnd::failure of a process that ended with this: empty where nothing went wrong or it was stopped.
std::string text_of_end(const std::exception_ptr& failure);

/// What the leader throws where another process ended with such a text: an InputError.
std::exception_ptr failure_elsewhere(const std::string& text);

/// The processes that share a study or a solution; number 0 leads and writes. To be used by the main thread only.
class Team {
 public:
  virtual ~Team() = default;
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;

  /// Everybody says whether it failed; the number of the first that did, size() when none.
  virtual std::size_t first_failed(bool failed) = 0;
  /// Gives the leader's numbers to all.
  virtual void share(std::vector<std::uint64_t>& numbers) = 0;
  /// The numbers of all, in the order of their ranks; everybody calls it, each with as many as it has.
  virtual std::vector<std::vector<double>> gathered(const std::vector<double>& own) = 0;
  /// To the leader.
  virtual void send(const std::vector<double>& numbers) = 0;
  virtual void send_end(const std::string& failure) = 0;
  /// For the leader: the next message that has arrived, without waiting.
  virtual std::optional<TeamMessage> receive() = 0;
  /// For the leader: asks the others to end; stopped() tells them.
  virtual void stop_others() = 0;
  virtual bool stopped() = 0;
};

/// Another process of the team tells what went wrong.
struct ToldElsewhere final : std::exception {
  const char* what() const noexcept override { return "another process could not start"; }
};

/// Runs `start`, which every process of the team does for itself, and returns when all have done it. When it fails somewhere, the
/// first process where it did throws that failure and all others ToldElsewhere: an error is told once.
void start_together(Team& team, const std::function<void()>& start);

/// What the module mpi implements (base/module.hpp).
class MpiModule {
 public:
  virtual ~MpiModule() = default;
  virtual std::unique_ptr<Team> join() = 0;
};

/// Whether the module is there.
bool has_mpi();

/// The processes that mpirun started together; without mpirun a team of one, and MPI is not touched. Throws InputError when
/// mpirun started several processes and the module mpi is missing.
std::unique_ptr<Team> join_team();

/// A team of one.
std::unique_ptr<Team> make_team_of_one();

/// How many processes mpirun says it started, 1 without it.
std::size_t processes_started();

/// The number that mpirun gave this process, from 0; 0 without it.
std::size_t process_number();

}  // namespace jointid::ident
