#include "base/error.hpp"
#include "ident/study/team.hpp"

namespace jointid::ident {

std::unique_ptr<Team> join_team() {
  if (processes_started() == 1) return make_team_of_one();
  if (process_number() > 0) throw ToldElsewhere();
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "mpirun",
                    .problem = "this build has no MPI, and its processes cannot share a study",
                    .remedy = "build with JOINTID_WITH_MPI, or run one process with --threads"});
}

}  // namespace jointid::ident
