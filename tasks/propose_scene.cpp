#include "tasks/propose_scene.hpp"

#include <cstdio>
#include <sstream>

#include "base/text.hpp"

namespace jointid::tasks {
namespace {

namespace fs = std::filesystem;

/// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (code >= 0x20 && code != 0x7f)
      out += c;
    else {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04X", static_cast<unsigned>(code));
      out += escape;
    }
  }
  return out + '"';
}

std::string list_text(const std::vector<std::string>& items) {
  std::string text = "[";
  for (const std::string& item : items) text += (text.size() > 1 ? ", " : "") + item;
  return text + "]";
}

/// As a path from the folder; as it is where there is none.
std::string named_from(const fs::path& folder, const fs::path& file) {
  std::error_code none;
  const fs::path near = fs::proximate(file, folder.empty() ? fs::path(".") : folder, none);
  return quoted((none ? file : near).generic_string());
}

std::string files_text(const ProposedScene::Files& files, const fs::path& folder) {
  std::vector<std::string> items;
  for (const auto& runs : files) {
    std::vector<std::string> names;
    for (const fs::path& run : runs) names.push_back(named_from(folder, run));
    items.push_back(names.size() == 1 ? names.front() : list_text(names));
  }
  return list_text(items);
}

/// A table for each file of which the variable was chosen.
std::string variables_text(const ChosenVariables& variables, const fs::path& folder) {
  std::string text;
  for (const auto& [file, variable] : variables)
    text += "\n[data.files." + named_from(folder, file) + "]\nvariable = " + quoted(variable) + "\n";
  return text;
}

/// No runs of one measurement.
ProposedScene::Files each_alone(const std::vector<fs::path>& files) {
  ProposedScene::Files alone;
  for (const fs::path& file : files) alone.push_back({file});
  return alone;
}

std::string dofs_text(const std::vector<frf::Dof>& dofs) {
  std::vector<std::string> items;
  for (const frf::Dof& dof : dofs) items.push_back(quoted(dof.name()));
  return list_text(items);
}

/// A sentence as a comment of lines that an editor shows whole. Control characters of file names would end it.
std::string comment(const std::string& sentence) {
  constexpr std::size_t widest = 64;
  std::string text = "#";
  std::size_t width = 1;
  std::istringstream words(sentence);
  for (std::string word; words >> word;) {
    if (width + 1 + word.size() > widest && width > 3) {
      text += "\n#  ";
      width = 3;
    }
    for (char& c : word) c = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    text += " " + word;
    width += 1 + word.size();
  }
  return text + "\n";
}

/// [joint] with what is unknown.
std::string joint_text(const ProposedScene& proposed) {
  std::string text = "\n[joint]\ndofs = " + dofs_text(proposed.joint) + "  # both sides\n";
  std::string form = "pattern = \"symmetric\"\n";
  if (proposed.springs) {
    form = "springs = " + springs_text(*proposed.springs) + "\n";
    text += "\n# Unknown: a spring with hysteretic damping between the nodes of each pair in each direction.\n";
  } else {
    text += "\n# Unknown: stiffness and hysteretic damping, both symmetric, no mass.\n";
  }
  return text + "[joint.stiffness]\n" + form + "\n[joint.hysteretic_damping]\n" + form;
}

/// Springs between pairs of nodes, where full matrices would have too many unknowns. False where they would not, or no nodes lie in pairs.
bool prefer_springs(const std::vector<const frf::FrfHeader*>& parts, ProposedScene& proposed) {
  const std::size_t size = proposed.joint.size();
  if (size * (size + 1) <= many_unknowns) return false;
  JointLayout layout;
  for (NodePair& pair : propose_pairs(parts)) {
    if (pair.likely) layout.pairs.push_back(std::move(pair));
  }
  if (layout.pairs.empty()) return false;
  proposed.joint = dofs_of(layout);
  const std::string pairs = comma_list(layout.pairs, [](const NodePair& pair) {
    return std::to_string(pair.first) + "–" + std::to_string(pair.second);
  });
  proposed.reasons.push_back("Springs between the nodes " + pairs + ": " + std::to_string(unknowns_of(layout)) +
                             " unknowns. Full matrices would have " + std::to_string(size * (size + 1)) + ".");
  proposed.springs = std::move(layout);
  return true;
}

/// The DOFs; springs where full matrices would have too many unknowns and nodes lie in pairs.
void set_joint(const std::vector<const frf::FrfHeader*>& parts, ProposedScene& proposed) {
  const ProposedJoint joint = propose_joint(parts);
  proposed.joint = joint.dofs;
  proposed.doubts.insert(proposed.doubts.end(), joint.doubts.begin(), joint.doubts.end());
  if (prefer_springs(parts, proposed)) return;
  proposed.reasons.insert(proposed.reasons.end(), joint.reasons.begin(), joint.reasons.end());
}

/// Why, above the scene.
std::string comments(const ProposedScene& proposed) {
  std::string text;
  for (const std::string& reason : proposed.reasons) text += comment(reason);
  for (const std::string& doubt : proposed.doubts) text += comment("LOOK: " + doubt);
  return text;
}

}  // namespace

ProposedScene propose_scene(const std::vector<fs::path>& files, const std::function<bool()>& interrupted,
                            const ChosenVariables& variables) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  std::vector<const frf::FrfHeader*> headers;
  std::vector<frf::FrfSource*> all;
  for (const fs::path& file : files) {
    frf::OpenOptions options;
    if (const auto chosen = variables.find(file); chosen != variables.end()) options.variable = chosen->second;
    sources.push_back(frf::open(file, options));
    headers.push_back(&sources.back()->header());
    all.push_back(sources.back().get());
  }
  const ProposedRoles roles = propose_roles(headers);
  ProposedScene proposed;
  proposed.variables = variables;
  const auto paths = [&](const std::vector<ProposedRoles::Group>& groups) {
    ProposedScene::Files named;
    for (const auto& group : groups) {
      named.emplace_back();
      for (const std::size_t file : group) named.back().push_back(files[file]);
    }
    return named;
  };
  proposed.substructures = paths(roles.substructures);
  proposed.assembly = paths(roles.assembly);
  std::vector<const frf::FrfHeader*> parts;
  for (const auto& group : roles.substructures) parts.push_back(headers[group.front()]);
  const ProposedRange range = propose_range(all, interrupted);
  proposed.range_hz = range.range_hz;
  proposed.reasons = roles.reasons;
  proposed.reasons.insert(proposed.reasons.end(), range.reasons.begin(), range.reasons.end());
  proposed.doubts = roles.doubts;
  set_joint(parts, proposed);
  return proposed;
}

std::string scene_text(const ProposedScene& proposed, const fs::path& folder) {
  std::string text = comments(proposed) + "\n[data]\n";
  text += "substructures = " + files_text(proposed.substructures, folder) + "\n";
  text += "assembly = " + files_text(proposed.assembly, folder) + "\n" + variables_text(proposed.variables, folder);
  if (proposed.range_hz) {
    text += "\n[frequency]\nrange = [" + digits((*proposed.range_hz)[0], "%.12g") + ", " +
            digits((*proposed.range_hz)[1], "%.12g") + "]  # Hz\n";
  }
  return text + joint_text(proposed);
}

std::string look_text(const std::vector<fs::path>& files, const fs::path& folder, const std::string& why,
                      const ChosenVariables& variables) {
  return comment(why) + "\n[data]\nsubstructures = " + files_text(each_alone(files), folder) + "\nassembly = []\n" +
         variables_text(variables, folder);
}

}  // namespace jointid::tasks
