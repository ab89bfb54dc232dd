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

/// Why, above the scene.
std::string comments(const ProposedScene& proposed) {
  std::string text;
  for (const std::string& reason : proposed.reasons) text += comment(reason);
  for (const std::string& doubt : proposed.doubts) text += comment("LOOK: " + doubt);
  return text;
}

}  // namespace

ProposedScene propose_scene(const std::vector<fs::path>& files, const std::function<bool()>& interrupted) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  std::vector<const frf::FrfHeader*> headers;
  std::vector<frf::FrfSource*> all;
  for (const fs::path& file : files) {
    sources.push_back(frf::open(file));
    headers.push_back(&sources.back()->header());
    all.push_back(sources.back().get());
  }
  const ProposedRoles roles = propose_roles(headers);
  ProposedScene proposed;
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
  const ProposedJoint joint = propose_joint(parts);
  const ProposedRange range = propose_range(all, interrupted);
  proposed.joint = joint.dofs;
  proposed.range_hz = range.range_hz;
  for (const auto* reasons : {&roles.reasons, &range.reasons, &joint.reasons}) {
    proposed.reasons.insert(proposed.reasons.end(), reasons->begin(), reasons->end());
  }
  for (const auto* doubts : {&roles.doubts, &joint.doubts})
    proposed.doubts.insert(proposed.doubts.end(), doubts->begin(), doubts->end());
  return proposed;
}

std::string scene_text(const ProposedScene& proposed, const fs::path& folder) {
  std::string text = comments(proposed) + "\n[data]\n";
  text += "substructures = " + files_text(proposed.substructures, folder) + "\n";
  text += "assembly = " + files_text(proposed.assembly, folder) + "\n";
  if (proposed.range_hz) {
    text += "\n[frequency]\nrange = [" + digits((*proposed.range_hz)[0], "%.12g") + ", " +
            digits((*proposed.range_hz)[1], "%.12g") + "]  # Hz\n";
  }
  text += "\n[joint]\ndofs = " + dofs_text(proposed.joint) + "  # both sides\n";
  text += "\n# Unknown: stiffness and hysteretic damping, both symmetric, no mass.\n";
  return text + "[joint.stiffness]\npattern = \"symmetric\"\n\n[joint.hysteretic_damping]\npattern = \"symmetric\"\n";
}

}  // namespace jointid::tasks
