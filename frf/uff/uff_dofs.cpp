#include "frf/uff/uff_dofs.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>

#include "base/error.hpp"
#include "base/text.hpp"

namespace jointid::frf::uff {
namespace {

using Name = std::tuple<std::string, std::int64_t, int>;

/// Responses or references of the records.
struct Side {
  DofRecord Header58::*dof;
  const char* what;
  const char* option;
  const char* key;
};
constexpr Side responses{&Header58::response, "responses", "--response", "dofs"};
constexpr Side references{&Header58::reference, "references", "--reference", "reference_dofs"};

Name name_of(const DofRecord& dof) { return {dof.entity, dof.node, dof.direction}; }

std::string shown(const Name& name) {
  const auto& [entity, node, direction] = name;
  return entity.empty() ? std::to_string(node) : "'" + entity + "'";
}

[[noreturn]] void fail(const std::string& file, std::string problem, std::string remedy) {
  throw InputError(
      {.kind = ErrorKind::usage, .file = file, .place = {}, .problem = std::move(problem), .remedy = std::move(remedy)});
}

void set(DofRecord& record, const Dof& dof) {
  record.node = dof.node;
  record.direction = dof.sign * static_cast<int>(dof.direction);
}

/// The k-th FRF, and the k-th coherence, gets the k-th DOF.
void give_in_order(std::vector<Dataset>& datasets, const std::vector<Dof>& given, const Side& side) {
  std::map<int, std::size_t> next;  // by function type
  for (Dataset& dataset : datasets) {
    if (!dataset.function) continue;
    DofRecord& dof = (*dataset.function).*side.dof;
    std::size_t& k = next[dataset.function->function_type];
    if (!dof.is_dof() && k < given.size()) set(dof, given[k]);
    ++k;
  }
}

void give_by_name(std::vector<Dataset>& datasets, const std::vector<Dof>& given, const std::vector<Name>& names,
                  const Side& side) {
  for (Dataset& dataset : datasets) {
    if (!dataset.function) continue;
    DofRecord& dof = (*dataset.function).*side.dof;
    const auto found = std::ranges::find(names, name_of(dof));
    if (!dof.is_dof() && found != names.end()) set(dof, given[static_cast<std::size_t>(found - names.begin())]);
  }
}

std::vector<Dof> own_dofs(const std::vector<Dataset>& datasets, const std::vector<std::size_t>& records, const Side& side) {
  std::vector<Dof> dofs;
  for (const std::size_t record : records) {
    const Dof dof = ((*datasets[record].function).*side.dof).dof();
    if (std::ranges::find(dofs, dof) == dofs.end()) dofs.push_back(dof);
  }
  return dofs;
}

/// The names of those without DOF, in the order in which they appear.
std::vector<Name> names_without_dof(const std::vector<Dataset>& datasets, const std::vector<std::size_t>& records,
                                    const Side& side) {
  std::vector<Name> names;
  for (const std::size_t record : records) {
    const DofRecord& dof = (*datasets[record].function).*side.dof;
    if (!dof.is_dof() && std::ranges::find(names, name_of(dof)) == names.end()) names.push_back(name_of(dof));
  }
  return names;
}

void give(std::vector<Dataset>& datasets, const std::vector<std::size_t>& records, const std::vector<Dof>& given,
          const Side& side, const std::string& file) {
  const std::vector<Name> names = names_without_dof(datasets, records, side);
  if (names.empty()) {
    if (own_dofs(datasets, records, side) == given) return;
    const std::string own = ((*datasets[records.front()].function).*side.dof).name();
    fail(file,
         std::string("its ") + side.what + " are given (" + side.option + ", or " + side.key +
             " in a scene), and its records name their own, " + own + " first",
         "leave them out; to change names of sensors use rename or rename_reference under [data.files.\"NAME\"]");
  }
  if (names.size() == given.size()) return give_by_name(datasets, given, names, side);
  if (names.size() == 1 && given.size() == records.size()) return give_in_order(datasets, given, side);
  fail(file,
       std::to_string(given.size()) + " " + side.what + " are given, and its records without a direction have " +
           std::to_string(names.size()) + ": " + comma_list(names, shown),
       std::string("give one for each, ") + side.option + " (" + side.key + " in a scene)");
}

std::string proposal(const Header58& header, bool has_references) {
  const auto response = dof_of_name(header.response.entity), reference = dof_of_name(header.reference.entity);
  std::string options, keys;
  const auto add = [&](const DofRecord& dof, const std::optional<Dof>& named, const Side& side, const char* example) {
    if (dof.is_dof()) return;
    options += std::string(options.empty() ? "" : " ") + side.option + " " + (named ? named->name() : example);
    keys += std::string(keys.empty() ? "" : " and ") + side.key;
  };
  add(header.response, response, responses, "4:+Y");
  if (has_references) add(header.reference, reference, references, "1:+X");
  return options + " (" + keys + " in a scene)";
}

}  // namespace

std::optional<Dof> dof_of_name(std::string_view name) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const std::size_t axis = name.find_last_of("XYZxyz");
  if (axis == std::string_view::npos || axis == 0) return std::nullopt;
  const std::string_view behind = name.substr(axis + 1);
  if (!behind.empty() && behind != "+" && behind != "-") return std::nullopt;
  bool minus = behind == "-";
  std::size_t end = axis;
  const bool rotation = name[end - 1] == 'R' || name[end - 1] == 'r';
  if (rotation) --end;
  while (end > 0 && !is_digit(name[end - 1])) {
    const char c = name[--end];
    if (c != ':' && c != '+' && c != '-' && c != ' ' && c != '_') return std::nullopt;
    minus = minus || c == '-';
  }
  std::size_t begin = end;
  while (begin > 0 && is_digit(name[begin - 1])) --begin;
  if (begin == end || end - begin > 18) return std::nullopt;
  const int direction = (std::toupper(static_cast<unsigned char>(name[axis])) - 'X') + (rotation ? 4 : 1);
  return Dof{.node = std::stoll(std::string(name.substr(begin, end - begin))),
             .direction = static_cast<Direction>(direction),
             .sign = minus ? -1 : 1};
}

void give_dofs(std::vector<Dataset>& datasets, const std::vector<std::size_t>& records, const OpenOptions& options,
               bool has_references, const std::string& file) {
  const std::vector<Dof>&response = options.response, &reference = options.reference;
  const bool one_name =
      names_without_dof(datasets, records, responses).size() == 1 && names_without_dof(datasets, records, references).size() == 1;
  if (has_references && one_name && response.size() > 1 && reference.size() > 1) {
    fail(file,
         "its records have one name, and " + std::to_string(response.size()) + " responses and " +
             std::to_string(reference.size()) + " references are given",
         "the records do not state which is which: export the FRFs of each reference to a file of its own");
  }
  if (!response.empty()) give(datasets, records, response, responses, file);
  if (!has_references) return;
  if (!reference.empty()) give(datasets, records, reference, references, file);
  const std::vector<Name> others = names_without_dof(datasets, records, references);
  if (reference.empty() && !others.empty() && others.size() == response.size())
    give_by_name(datasets, response, others, references);
}

void require_dofs(const Dataset& dataset, bool has_references) {
  const Header58& header = *dataset.function;
  const bool of_response = !header.response.is_dof();
  if (!of_response && (!has_references || header.reference.is_dof())) return;
  const DofRecord& dof = of_response ? header.response : header.reference;
  dataset.place.fail(
      "record 6",
      std::string(of_response ? "response" : "reference") + " node " + std::to_string(dof.node) + " with direction code " +
          std::to_string(dof.direction) + " is not a DOF" + (dof.entity.empty() ? "" : "; its name is '" + dof.entity + "'"),
      "give the DOFs, e.g. " + proposal(header, has_references) +
          ", export the FRFs with nodes and directions, or write them there: 1 to 3 for +X to +Z, 4 to 6 for rotations, negative "
          "against the axis");
}

}  // namespace jointid::frf::uff
