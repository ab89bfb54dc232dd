#include "correlation/expanded_frfs.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "correlation/common_places.hpp"
#include "correlation/criteria.hpp"

namespace jointid::correlation {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

/// FRFs of a line between some responses and references, with the signs of their matches.
MatrixXcd line_of(const frf::FrfSet& set, std::size_t line, const std::vector<Match>& responses,
                  const std::vector<Match>& references) {
  MatrixXcd out(static_cast<Index>(responses.size()), static_cast<Index>(references.size()));
  for (Index r = 0; r < out.rows(); ++r) {
    for (Index c = 0; c < out.cols(); ++c) {
      const Match &row = responses[static_cast<std::size_t>(r)], &column = references[static_cast<std::size_t>(c)];
      out(r, c) = row.sign * column.sign * set.values[set.index(line, row.other, column.other)];
    }
  }
  return out;
}

void append(const MatrixXcd& line, frf::FrfSet& set) {
  for (Index r = 0; r < line.rows(); ++r) {
    for (Index c = 0; c < line.cols(); ++c) set.values.push_back(line(r, c));
  }
}

/// Coordinates that are responses and references.
std::vector<frf::Dof> square_dofs(const frf::FrfHeader& header) {
  std::vector<frf::Dof> out;
  for (const Match& each : common_dofs(header.response, header.reference)) out.push_back(header.response[each.one]);
  return out;
}

[[noreturn]] void refuse_gaps(const frf::FrfSet& parent, double hz) {
  throw InputError({.kind = ErrorKind::data,
                    .file = parent.header.file,
                    .place = std::to_string(hz) + " Hz",
                    .problem = "the parent has values that are no number",
                    .remedy = "the parent is a model: give FRFs between all its coordinates, on all lines"});
}

/// Σ|δ|² and Σ|Y|².
struct Sums {
  double error = 0.0, size = 0.0;

  void add(const MatrixXcd& apart, const MatrixXcd& of) {
    error += apart.squaredNorm();
    size += of.squaredNorm();
  }

  double ratio() const { return std::sqrt(error / size); }
};

/// Without lines; `b` gets the places of `common` in `all`.
ExpandedFrfs begun(const frf::FrfSet& measured, const std::vector<frf::Dof>& all, const std::vector<Match>& common, Places& b) {
  ExpandedFrfs out{.set = {.header = {}, .values = {}, .variance = {}, .coherence = {}}, .measured = {}, .left_out = {}};
  out.set.header.file = "expanded";
  out.set.header.quantity = measured.header.quantity;
  out.set.header.nodes = measured.header.nodes;
  out.set.header.response = all;
  for (const Match& each : common) {
    b.push_back(static_cast<Index>(each.one));
    out.measured.push_back(all[each.one]);
  }
  out.left_out = measured.header.response;
  std::erase_if(out.left_out, [&](const frf::Dof& dof) { return frf::has(out.measured, dof); });
  return out;
}

}  // namespace

ExpandedFrfs expanded(const frf::FrfSet& parent, const frf::FrfSet& measured, Semm way) {
  const Common common = common_of(parent.header, measured.header);
  const std::vector<frf::Dof> all = square_dofs(parent.header), own = square_dofs(measured.header);
  const std::vector<Match> both = common_dofs(all, own);
  if (both.empty())
    fail_nothing_common(parent.header.file, measured.header.file, "coordinates that are response and reference", some_names(all),
                        some_names(own));
  Places b;
  ExpandedFrfs out = begun(measured, all, both, b);
  out.set.header.reference = all;
  if (out.set.header.nodes.empty()) out.set.header.nodes = parent.header.nodes;
  const std::vector<Match> rows = common_dofs(all, parent.header.response), columns = common_dofs(all, parent.header.reference),
                           at_rows = common_dofs(out.measured, measured.header.response),
                           at_columns = common_dofs(out.measured, measured.header.reference);
  Sums at_b;
  for (const Match& line : common.lines) {
    const double hz = parent.header.frequency_hz[line.one];
    const MatrixXcd model = line_of(parent, line.one, rows, columns),
                    overlay = line_of(measured, line.other, at_rows, at_columns);
    if (!model.allFinite()) refuse_gaps(parent, hz);
    const MatrixXcd mix = mixed(model, overlay, b, way);
    out.set.header.frequency_hz.push_back(hz);
    append(mix, out.set);
    if (mix.allFinite()) at_b.add(model(b, b) - overlay, overlay);
  }
  out.parent_error = at_b.ratio();
  return out;
}

ExpandedFrfs expanded(const ModeFile& parent, const frf::FrfSet& measured, std::size_t modes) {
  const std::vector<frf::Dof> all = dofs_of_all(parent);
  const std::vector<Match> common = common_dofs(all, measured.header.response);
  if (common.empty())
    fail_nothing_common(parent.file, measured.header.file, "responses", some_names(all), some_names(measured.header.response));
  std::vector<frf::Uff55Mode> kept = parent.modes;
  if (modes > 0 && modes < kept.size()) kept.resize(modes);
  Places b;
  ExpandedFrfs out = begun(measured, all, common, b);
  out.set.header.frequency_hz = measured.header.frequency_hz;
  out.set.header.reference = measured.header.reference;
  const MatrixXcd to_all = serep(shapes_at(kept, all), b);
  const std::vector<Match> references = common_dofs(measured.header.reference, measured.header.reference);
  Sums at_b;
  for (std::size_t line = 0; line < measured.header.lines(); ++line) {
    const MatrixXcd motion = line_of(measured, line, common, references), whole = to_all * motion;
    append(whole, out.set);
    if (whole.allFinite()) at_b.add(whole(b, Eigen::all) - motion, motion);
  }
  out.parent_error = at_b.ratio();
  return out;
}

}  // namespace jointid::correlation
