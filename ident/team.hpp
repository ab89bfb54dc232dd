#pragma once

#include <cstdint>
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

/// The processes that share a study; number 0 leads and writes. To be used by the main thread only.
class Team {
 public:
  virtual ~Team() = default;
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;

  /// Everybody says once whether it is ready; true when all are. A team that is left before says no.
  virtual bool agree(bool ready) = 0;
  /// Gives the leader's numbers to all.
  virtual void share(std::vector<std::uint64_t>& numbers) = 0;
  /// To the leader.
  virtual void send(const std::vector<double>& numbers) = 0;
  virtual void send_end(const std::string& failure) = 0;
  /// For the leader: the next message that has arrived, without waiting.
  virtual std::optional<TeamMessage> receive() = 0;
  /// For the leader: asks the others to end; stopped() tells them.
  virtual void stop_others() = 0;
  virtual bool stopped() = 0;
};

/// The processes that mpirun started together; without mpirun a team of one, and MPI is not touched. Throws InputError when
/// mpirun started several processes of a build without MPI.
std::unique_ptr<Team> join_team();

/// A team of one.
std::unique_ptr<Team> make_team_of_one();

/// How many processes mpirun says it started, 1 without it.
std::size_t processes_started();

}  // namespace jointid::ident
