#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tasks/propose_joint.hpp"
#include "tasks/propose_range.hpp"
#include "tasks/propose_roles.hpp"

namespace jointid::tasks {

/// A first scene for files of which nothing is said yet.
struct ProposedScene {
  using Files = std::vector<std::vector<std::filesystem::path>>;  ///< runs of one measurement together
  Files substructures, assembly;
  std::vector<frf::Dof> joint;
  std::optional<std::array<double, 2>> range_hz;
  std::vector<std::string> reasons;  ///< of every choice, one sentence each
  std::vector<std::string> doubts;   ///< what the user should look at or fill in
};

/// Opens the files and proposes. Throws InputError for files that are no FRFs, as propose_roles() and propose_range(), and
/// Interrupted.
ProposedScene propose_scene(const std::vector<std::filesystem::path>& files, const std::function<bool()>& interrupted = {});

/// The scene as TOML with the reasons as comments; files are named relative to `folder`. Stiffness and hysteretic damping are
/// unknown.
std::string scene_text(const ProposedScene& proposed, const std::filesystem::path& folder);

}  // namespace jointid::tasks
