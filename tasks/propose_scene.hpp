#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tasks/joint/joint_layout.hpp"
#include "tasks/propose_joint.hpp"
#include "tasks/propose_range.hpp"
#include "tasks/propose_roles.hpp"

namespace jointid::tasks {

/// Which variable of a file of named arrays holds the FRFs, where somebody has chosen it (frf_variables()).
using ChosenVariables = std::map<std::filesystem::path, std::string>;

/// A first scene for files of which nothing is said yet.
struct ProposedScene {
  using Files = std::vector<std::vector<std::filesystem::path>>;  ///< runs of one measurement together
  Files substructures, assembly;
  std::vector<frf::Dof> joint;
  /// Springs between pairs of nodes, where full matrices over `joint` would have more than many_unknowns; else empty.
  std::optional<JointLayout> springs{};
  std::optional<std::array<double, 2>> range_hz;
  std::vector<std::string> reasons;  ///< of every choice, one sentence each
  std::vector<std::string> doubts;   ///< what the user should look at or fill in
  ChosenVariables variables{};       ///< as they were given
};

/// Opens the files and proposes. Throws InputError for files that are no FRFs, as propose_roles() and propose_range(), and
/// Interrupted.
ProposedScene propose_scene(const std::vector<std::filesystem::path>& files, const std::function<bool()>& interrupted = {},
                            const ChosenVariables& variables = {});

/// The scene as TOML with the reasons as comments; files are named relative to `folder`. Stiffness and hysteretic damping are
/// unknown: springs where they are proposed, else symmetric matrices.
std::string scene_text(const ProposedScene& proposed, const std::filesystem::path& folder);

/// A scene that only shows what files hold, for files that are not parts and assembly: it names each as a substructure, and no
/// assembly. `why` stands above it as a comment.
std::string look_text(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder, const std::string& why,
                      const ChosenVariables& variables = {});

}  // namespace jointid::tasks
