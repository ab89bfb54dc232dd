#include "tasks/propose_roles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <filesystem>
#include <set>
#include <tuple>

#include "base/error.hpp"

namespace jointid::tasks {
namespace {

using Headers = std::vector<const frf::FrfHeader*>;
using Group = ProposedRoles::Group;

constexpr std::size_t most_groups = 12;  // 2^12 choices are looked at

std::set<std::int64_t> keys_of(const frf::FrfHeader& file) {
  std::set<std::int64_t> keys;
  for (const frf::Dof& dof : coordinates_of(file)) keys.insert(frf::coordinate_key(dof));
  return keys;
}

bool are_runs(const frf::FrfHeader& a, const frf::FrfHeader& b) {
  return a.response == b.response && a.reference == b.reference && a.frequency_hz == b.frequency_hz && a.quantity == b.quantity;
}

std::vector<Group> groups_of(const Headers& files) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto same =
        std::ranges::find_if(groups, [&](const Group& group) { return are_runs(*files[group.front()], *files[i]); });
    if (same == groups.end())
      groups.push_back({i});
    else
      same->push_back(i);
  }
  return groups;
}

/// Of two files that are alike one may be the part and the other the assembly: a joint to ground.
void split_the_only(std::vector<Group>& groups) {
  if (groups.size() == 1 && groups.front().size() == 2) groups = {{groups[0][0]}, {groups[0][1]}};
}

std::string short_name(const frf::FrfHeader& file) { return std::filesystem::path(file.file).filename().string(); }

/// +1: the name speaks of an assembly, −1: of a part, 0: of neither.
int said_by_name(const frf::FrfHeader& file) {
  std::string name = short_name(file);
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto has = [&](const auto& words) {
    return std::ranges::any_of(words, [&](const char* word) { return name.find(word) != name.npos; });
  };
  if (has(std::array{"assembl", "asm", "coupled", "joined", "joint", "bolted"})) return +1;
  return has(std::array{"substructure", "part", "beam", "sub_", "free"}) ? -1 : 0;
}

class Chooser {
 public:
  Chooser(const Headers& files, const std::vector<Group>& groups) : files_(files), groups_(groups) {
    for (const Group& group : groups) keys_.push_back(keys_of(*files[group.front()]));
  }

  /// More is better; a choice is the set of groups that are the assembly. Empty: it cannot be.
  using Score = std::tuple<std::size_t, int, int, std::size_t>;
  bool is_possible(unsigned assembly) const {
    if (assembly == 0 || std::popcount(assembly) == static_cast<int>(groups_.size())) return false;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (!is_in(assembly, i) && (touched_by(i, ~assembly) > 0 || touched_by(i, assembly) == 0)) return false;
      if (is_in(assembly, i) && (touched_by(i, ~assembly) == 0 || overlaps_in(assembly, i))) return false;
    }
    return true;
  }
  Score score(unsigned assembly) const {
    std::size_t spanning = 0, dofs = 0;
    int names = 0;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      names += said_by_name(*files_[groups_[i].front()]) * (is_in(assembly, i) ? +1 : -1);
      if (!is_in(assembly, i)) continue;
      spanning = std::max(spanning, touched_by(i, ~assembly));
      dofs += keys_[i].size();
    }
    return {spanning, names, -std::popcount(assembly), dofs};
  }
  static bool is_in(unsigned set, std::size_t i) { return (set >> i & 1U) != 0; }

 private:
  /// With how many other groups of a set group i shares coordinates.
  std::size_t touched_by(std::size_t i, unsigned set) const {
    std::size_t count = 0;
    for (std::size_t j = 0; j < groups_.size(); ++j) {
      if (j == i || !is_in(set, j)) continue;
      count += std::ranges::any_of(keys_[i], [&](std::int64_t key) { return keys_[j].contains(key); }) ? 1U : 0U;
    }
    return count;
  }
  /// Whether an FRF of group i is in another group of the set, too.
  bool overlaps_in(unsigned set, std::size_t i) const {
    const frf::FrfHeader& own = *files_[groups_[i].front()];
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_in(set, j)) continue;
      const frf::FrfHeader& other = *files_[groups_[j].front()];
      const auto share = [](const std::vector<frf::Dof>& a, const std::vector<frf::Dof>& b) {
        return std::ranges::any_of(a, [&](const frf::Dof& dof) { return frf::has(b, dof); });
      };
      if (share(own.response, other.response) && share(own.reference, other.reference)) return true;
    }
    return false;
  }

  const Headers& files_;
  const std::vector<Group>& groups_;
  std::vector<std::set<std::int64_t>> keys_;
};

std::string listed(const Headers& files, const std::vector<Group>& groups) {
  std::string text;
  for (const Group& group : groups) {
    for (const std::size_t file : group) text += (text.empty() ? "" : ", ") + short_name(*files[file]);
  }
  return text;
}

[[noreturn]] void fail(const std::string& problem, const std::string& remedy) {
  throw InputError({ErrorKind::usage, "", "new scene", problem, remedy});
}

void explain(const Headers& files, ProposedRoles& roles, bool one_choice, bool by_name) {
  const std::string assembly = listed(files, roles.assembly);
  roles.reasons.push_back(
      "Substructures: " + listed(files, roles.substructures) +
      (roles.substructures.size() > 1 ? " share no coordinate with each other." : " is the only file besides the assembly."));
  roles.reasons.push_back("Assembly: " + assembly + " has coordinates of " +
                          (roles.substructures.size() > 1 ? "the parts." : "the part."));
  for (const auto& group : roles.substructures) {
    if (group.size() > 1)
      roles.reasons.push_back(listed(files, {group}) + " have the same DOFs and lines: runs of one measurement.");
  }
  for (const auto& group : roles.assembly) {
    if (group.size() > 1)
      roles.reasons.push_back(listed(files, {group}) + " have the same DOFs and lines: runs of one measurement.");
  }
  if (!one_choice) {
    roles.doubts.push_back(std::string("The DOFs alone do not identify the assembly; ") + assembly +
                           (by_name ? " was taken for it by its name." : " is assumed, because it has the most DOFs."));
  }
}

}  // namespace

std::vector<frf::Dof> coordinates_of(const frf::FrfHeader& file) {
  std::vector<frf::Dof> all = file.response;
  for (const frf::Dof& dof : file.reference) {
    if (!frf::has(all, dof)) all.push_back(dof);
  }
  return all;
}

ProposedRoles propose_roles(const Headers& files) {
  if (files.size() < 2) fail("one file is not enough", "give the FRFs of the parts and those of the assembly");
  std::vector<Group> groups = groups_of(files);
  split_the_only(groups);
  if (groups.size() < 2) fail("all files have the same DOFs", "give the FRFs of the parts and those of the assembly");
  if (groups.size() > most_groups) fail("these are more than 12 structures", "write the [data] of the scene by hand");
  const Chooser chooser(files, groups);
  unsigned best = 0;
  std::size_t choices = 0;
  for (unsigned set = 1; set + 1 < 1U << groups.size(); ++set) {
    if (!chooser.is_possible(set)) continue;
    const bool spans_more = best == 0 || std::get<0>(chooser.score(set)) > std::get<0>(chooser.score(best));
    choices = spans_more ? 1 : choices + (std::get<0>(chooser.score(set)) == std::get<0>(chooser.score(best)) ? 1 : 0);
    if (best == 0 || chooser.score(set) > chooser.score(best)) best = set;
  }
  if (best == 0) {
    fail("the files cannot be parted into parts, which share no coordinate, and an assembly, which has coordinates of every part",
         "use the same node numbers in the files of the parts and of the assembly");
  }
  ProposedRoles roles;
  for (std::size_t i = 0; i < groups.size(); ++i)
    (Chooser::is_in(best, i) ? roles.assembly : roles.substructures).push_back(groups[i]);
  explain(files, roles, choices == 1, std::get<1>(chooser.score(best)) > 0);
  return roles;
}

}  // namespace jointid::tasks
