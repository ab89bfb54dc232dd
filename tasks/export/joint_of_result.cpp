#include "tasks/export/joint_of_result.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "frf/set/frf_set.hpp"
#include "scene/text.hpp"

namespace jointid::tasks {
namespace {

using Json = nlohmann::json;
using restrictions::Kind;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_dofs = 5000;

/// Reads what report::solution_json() writes, and says which key is not as it should be.
class ResultFile {
 public:
  explicit ResultFile(const std::filesystem::path& file)
      : file_(file), json_(Json::parse(scene::read_text(file), nullptr, false)) {
    if (json_.is_discarded() || !json_.is_object())
      fail("", "it is no JSON", "give a scene, or what `jointid solve SCENE --json FILE` wrote");
  }

  ExportedJoint read(std::size_t band) {
    ExportedJoint out;
    out.source = file_.string();
    out.status = text(member(json_, "status"), "status");
    const Json& names = member(json_, "dofs");
    if (!names.is_array() || names.empty() || names.size() > most_dofs) fail("dofs", "it is no list of DOFs", remedy);
    for (const Json& name : names) {
      const frf::Dof dof = frf::Dof::parse(text(name, "dofs"));
      if (frf::has(out.dofs, dof)) fail("dofs", "'" + dof.name() + "' is there twice", remedy);
      out.dofs.push_back(dof);
    }
    read_matrices(holder(band), out);
    read_unknowns(out);
    return out;
  }

 private:
  static constexpr const char* remedy = "write it anew: jointid solve SCENE --json FILE";

  [[noreturn]] void fail(const std::string& key, const std::string& problem, const std::string& what_helps) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = file_.string(),
                      .place = key.empty() ? "" : "key " + key,
                      .problem = problem,
                      .remedy = what_helps});
  }

  const Json& member(const Json& of, const char* key) const {
    if (!of.contains(key)) fail(key, "it is not there: this is no result of `jointid solve` with a joint of matrices", remedy);
    return of.at(key);
  }

  std::string text(const Json& of, const char* key) const {
    if (!of.is_string()) fail(key, of.dump().substr(0, 40) + " is no text", remedy);
    return of.get<std::string>();
  }

  double number(const Json& of, const std::string& key) const {
    if (!of.is_number() || !std::isfinite(of.get<double>())) fail(key, of.dump().substr(0, 40) + " is no finite number", remedy);
    return of.get<double>();
  }

  /// What has "matrices" or "blocks".
  const Json& holder(std::size_t band) const {
    if (!json_.contains("bands")) {
      if (band > 1) refuse_band(file_, band, 1);
      return json_;
    }
    const Json& bands = json_.at("bands");
    if (!bands.is_array()) fail("bands", "it is no list", remedy);
    if (band < 1 || band > bands.size()) refuse_band(file_, band, bands.size());
    return bands.at(band - 1);
  }

  void read_matrices(const Json& from, ExportedJoint& out) const {
    if (from.contains("blocks")) {
      for (const Json& block : from.at("blocks")) {
        std::vector<std::size_t> places;
        for (const Json& name : member(block, "dofs")) {
          places.push_back(frf::find_coordinate(out.dofs, frf::Dof::parse(text(name, "blocks"))));
          if (places.back() == frf::npos) fail("blocks", name.dump() + " is none of the DOFs", remedy);
        }
        put(member(block, "matrices"), places, out);
      }
    } else {
      std::vector<std::size_t> all(out.dofs.size());
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
      put(member(from, "matrices"), all, out);
    }
    if (out.matrices.empty()) fail("matrices", "there is none", "identify K, M, C or D of the joint");
  }

  void put(const Json& matrices, const std::vector<std::size_t>& places, ExportedJoint& out) const {
    if (!matrices.is_object()) fail("matrices", "it has no matrix", remedy);
    const std::size_t n = out.dofs.size();
    for (const Kind kind : restrictions::all_kinds) {
      const std::string key = restrictions::key(kind);
      if (!matrices.contains(key)) continue;
      const Json& rows = matrices.at(key);
      const auto wrong = [&] {
        fail(key, "it is not " + std::to_string(places.size()) + " × " + std::to_string(places.size()), remedy);
      };
      if (!rows.is_array() || rows.size() != places.size()) wrong();
      ident::Matrix& to = out.matrices[kind];
      if (to.empty()) to.assign(n, std::vector<double>(n, 0.0));
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (!rows[i].is_array() || rows[i].size() != places.size()) wrong();
        for (std::size_t j = 0; j < places.size(); ++j) to[places[i]][places[j]] = number(rows[i][j], key);
      }
    }
  }

  void read_unknowns(ExportedJoint& out) const {
    for (const Json& each : member(json_, "unknowns")) {
      ident::Estimate unknown;
      unknown.name = text(member(each, "name"), "unknowns");
      unknown.unit = text(member(each, "unit"), "unknowns");
      const Json& value = member(each, "value");
      unknown.value = value.is_null() ? not_known : number(value, "unknowns");
      for (const auto& [key, to] :
           {std::pair{"std_error", &unknown.std_error}, std::pair{"error_estimate", &unknown.error_estimate}}) {
        if (each.contains(key) && each.at(key).is_number()) *to = number(each.at(key), "unknowns");
      }
      unknown.determined = !each.contains("determined") || each.at("determined") != Json(false);
      out.unknowns.push_back(std::move(unknown));
    }
  }

  std::filesystem::path file_;
  Json json_;
};

struct NamedPlace {
  Kind kind;
  std::size_t row, column;
};

/// What stands between the last `open` and the end, split at the comma.
std::optional<std::pair<std::string, std::string>> pair_in(const std::string& name, char open, char close) {
  const std::size_t begin = name.rfind(open);
  if (begin == std::string::npos || name.back() != close) return std::nullopt;
  const std::string inside = name.substr(begin + 1, name.size() - begin - 2);
  const std::size_t comma = inside.find(',');
  if (comma == std::string::npos) return std::nullopt;
  return std::pair{inside.substr(0, comma), inside.substr(comma + 1)};
}

std::size_t row_number(const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

/// Where an unknown stands alone, by its name: "K(1,2)" counts rows of a joint without a name, "K[4:+Y,5:+Y]" names DOFs.
std::optional<NamedPlace> place_of(const std::string& name, const std::vector<frf::Dof>& dofs) {
  const std::size_t open = name.find_first_of("([");
  if (open == std::string::npos || open == 0) return std::nullopt;
  const std::string symbol = name.substr(0, open).substr(name.substr(0, open).rfind('.') + 1);
  for (const Kind kind : restrictions::all_kinds) {
    if (symbol != restrictions::symbol(kind)) continue;
    if (const auto springs = pair_in(name, '[', ']')) {
      const auto place = [&](const std::string& dof) { return frf::find_coordinate(dofs, frf::Dof::parse(dof)); };
      const std::size_t first = place(springs->first), second = springs->second == "ground" ? first : place(springs->second);
      if (first == frf::npos || second == frf::npos) return std::nullopt;
      return NamedPlace{kind, first, second};
    }
    const auto cell = name.find('.') == std::string::npos ? pair_in(name, '(', ')') : std::nullopt;
    if (!cell) return std::nullopt;
    const std::size_t row = row_number(cell->first), column = row_number(cell->second);
    if (row < 1 || column < 1 || row > dofs.size() || column > dofs.size()) return std::nullopt;
    return NamedPlace{kind, row - 1, column - 1};
  }
  return std::nullopt;
}

/// Elements by the errors of the unknowns that stand there.
void state_errors(ExportedJoint& out) {
  const std::size_t n = out.dofs.size();
  for (const auto& [kind, rows] : out.matrices) {
    out.errors[kind] = rows;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) out.errors[kind][i][j] = rows[i][j] == 0.0 ? 0.0 : not_known;
    }
  }
  for (const ident::Estimate& unknown : out.unknowns) {
    const auto place = place_of(unknown.name, out.dofs);
    if (!place || !unknown.error() || !out.errors.contains(place->kind)) continue;
    ident::Matrix& errors = out.errors.at(place->kind);
    errors[place->row][place->column] = errors[place->column][place->row] = *unknown.error();
  }
}

}  // namespace

void refuse_band(const std::filesystem::path& file, std::size_t band, std::size_t count) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = file.string(),
                    .place = "--band",
                    .problem = "the joint has " + std::to_string(count) + (count == 1 ? " band" : " bands") + ", " +
                               (band == 0 ? "and a file for another program has one" : "and no band " + std::to_string(band)),
                    .remedy = count == 1 ? "leave it out" : "name one, from 1 to " + std::to_string(count)});
}

ExportedJoint joint_of_result(const std::filesystem::path& file, std::size_t band) {
  ExportedJoint out = ResultFile(file).read(band);
  state_errors(out);
  const std::size_t p = out.unknowns.size();
  out.covariance.assign(p, std::vector<double>(p, not_known));
  for (std::size_t c = 0; c < p; ++c) {
    if (const auto error = out.unknowns[c].error()) out.covariance[c][c] = *error * *error;
  }
  return out;
}

}  // namespace jointid::tasks
