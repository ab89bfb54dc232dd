#include "ident/equations/part_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace jointid::ident {
namespace {

/// Reads and forms the rows of one part.
class PartReader {
 public:
  PartReader(const PartOfRows& part, const Coordinates& at, const Dofs& columns, std::size_t n_columns, frf::FrfSystem& substructures,
             const Dofs& assembly_rows)
      : rows_(joined(part.n_rows, part.j_rows)), columns_(columns.size()), joint_(part.support.a_dofs.size()) {
    Dofs own_columns;
    for (const std::size_t j : part.support.a_dofs) own_columns.push_back(at.joint[j]);
    for (std::size_t l = 0; l < columns.size(); ++l) {
      if (substructures.source_of(columns[l]) != part.source) continue;
      const std::size_t place = frf::find_coordinate(own_columns, columns[l]);
      own_.push_back({l, place == frf::npos ? own_columns.size() : place});
      if (place == frf::npos) own_columns.push_back(columns[l]);
    }
    reader_ = std::make_unique<frf::BlockReader>(substructures, rows_, own_columns);
    for (const frf::Dof& dof : rows_) motion_rows_.push_back(frf::find_coordinate(assembly_rows, dof));
    for (const std::size_t j : part.support.b_dofs) joint_rows_.push_back(frf::find_coordinate(assembly_rows, at.joint[j]));
    product_.row_class.assign(part.n_rows.size(), 0);
    product_.row_class.resize(rows_.size(), 1);
    product_.column_class.assign(n_columns, 0);
    product_.column_class.resize(columns.size(), 1);
  }

  std::size_t entries() const { return reader_->rows() * reader_->columns(); }

  void read(std::span<const std::size_t> lines) {
    values_.resize(lines.size() * entries());
    reader_->read(lines, values_);
  }

  /// `motion`: the assembly's FRFs of the line.
  void form(std::size_t line, const minimise::View& motion, const bool (&wanted)[2][2], minimise::LineProduct& out) {
    const std::size_t width = reader_->columns(), m = rows_.size();
    const Complex* own = values_.data() + line * entries();
    b_.resize(joint_rows_.size() * columns_);
    for (std::size_t j = 0; j < joint_rows_.size(); ++j) std::copy_n(&motion(joint_rows_[j], 0), columns_, b_.data() + j * columns_);
    c1_.assign(m * columns_, Complex());
    c2_.resize(m * columns_);
    for (std::size_t r = 0; r < m; ++r) {
      std::copy_n(&motion(motion_rows_[r], 0), columns_, c2_.data() + r * columns_);
      for (const auto& [column, place] : own_) c1_[r * columns_ + column] = own[r * width + place];
    }
    product_.frequency_hz = out.frequency_hz;
    product_.wants_error_scale = out.wants_error_scale;
    for (std::size_t i = 0; i < 4; ++i) product_.wanted[i / 2][i % 2] = wanted[i / 2][i % 2];
    product_.a = {own, m, joint_, width};
    product_.b = {b_.data(), joint_rows_.size(), columns_, columns_};
    product_.c1 = {c1_.data(), m, columns_, columns_};
    product_.c2 = {c2_.data(), m, columns_, columns_};
    out = product_;
  }

 private:
  Dofs rows_;
  std::size_t columns_, joint_;
  std::vector<std::pair<std::size_t, std::size_t>> own_;  ///< columns on this part, and where they are among those read
  std::vector<std::size_t> motion_rows_, joint_rows_;  ///< of the assembly's rectangle
  std::unique_ptr<frf::BlockReader> reader_;
  std::vector<Complex> values_, b_, c1_, c2_;
  minimise::LineProduct product_;
};

class PartRows final : public EquationBuilder {
 public:
  PartRows(const std::vector<PartOfRows>& parts, const Coordinates& at, const EquationSet& use, frf::FrfSystem& substructures,
           frf::FrfSystem& assembly)
      : columns_(part_columns(at, use, assembly)), wanted_{{use.nn, use.nj}, {use.jn, use.jj}} {
    const Dofs motion = joined(at.responses, at.joint);
    assembly_ = std::make_unique<Rectangle>(assembly, std::vector<Band>{{motion, columns_}}, columns_);
    const auto at_joint = [&](const frf::Dof& dof) { return frf::has(at.joint, dof); };
    const auto n_columns = static_cast<std::size_t>(std::ranges::find_if(columns_, at_joint) - columns_.begin());
    for (const PartOfRows& part : parts) readers_.emplace_back(part, at, columns_, n_columns, substructures, motion);
  }

  void read(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines) override {
    for (PartReader& reader : readers_) reader.read(substructure_lines);
    assembly_->read(assembly_lines);
  }

  std::size_t products() const override { return readers_.size(); }

  bool product(std::size_t i, std::size_t k, minimise::LineProduct& out) override {
    readers_[k].form(i, assembly_->line(i), wanted_, out);
    return true;
  }

  bool line(std::size_t i, minimise::LineProduct& out) override { return product(i, 0, out); }

  Dofs columns() const override { return columns_; }

  std::size_t entries_per_line() const override {
    std::size_t entries = assembly_->entries_per_line();
    for (const PartReader& reader : readers_) entries += reader.entries();
    return entries;
  }

 private:
  Dofs columns_;
  bool wanted_[2][2];
  std::vector<PartReader> readers_;
};

}  // namespace

Dofs part_columns(const Coordinates& coordinates, const EquationSet& equations, const frf::FrfSystem& assembly) {
  Dofs out = only_if(equations.nn || equations.jn, coordinates.references);
  for (const frf::Dof& dof : coordinates.joint) {
    if ((equations.nj || equations.jj) && frf::has(assembly.references(), dof)) out.push_back(dof);
  }
  return out;
}

std::vector<PartOfRows> parts_of_rows(const Coordinates& coordinates, const EquationSet& equations,
                                      const restrictions::Restriction& restriction, const frf::FrfSystem& substructures) {
  struct Touched {
    std::set<std::size_t> rows, columns, unknowns;
  };
  std::vector<std::size_t> joint_source;
  for (const frf::Dof& dof : coordinates.joint) joint_source.push_back(substructures.source_of(dof));
  std::vector<Touched> touched(substructures.source_count());
  const auto touch = [&](std::size_t row, std::size_t column) -> Touched& {
    Touched& of = touched[joint_source[row]];
    of.rows.insert(row);
    of.columns.insert(column);
    return of;
  };
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    for (const restrictions::Term& term : matrix.terms) touch(term.row, term.column).unknowns.insert(term.unknown);
    for (const restrictions::Known& known : matrix.known) touch(known.row, known.column);
  }
  std::vector<PartOfRows> parts;
  std::vector<std::size_t> place(touched.size(), frf::npos);
  for (std::size_t s = 0; s < touched.size(); ++s) {
    const Touched& of = touched[s];
    if (of.unknowns.empty()) continue;
    place[s] = parts.size();
    parts.push_back({.source = s,
                     .n_rows = {},
                     .j_rows = {},
                     .support = {{of.rows.begin(), of.rows.end()},
                                 {of.columns.begin(), of.columns.end()},
                                 {of.unknowns.begin(), of.unknowns.end()}}});
  }
  const auto add = [&](const Dofs& dofs, Dofs PartOfRows::* rows) {
    for (const frf::Dof& dof : dofs) {
      const std::size_t source = substructures.source_of(dof);
      if (source < place.size() && place[source] != frf::npos) (parts[place[source]].*rows).push_back(dof);
    }
  };
  if (equations.nn || equations.nj) add(coordinates.responses, &PartOfRows::n_rows);
  if (equations.jn || equations.jj) add(coordinates.joint, &PartOfRows::j_rows);
  std::erase_if(parts, [](const PartOfRows& part) { return part.n_rows.empty() && part.j_rows.empty(); });
  return parts;
}

std::vector<AssemblySpec> part_specs(const std::vector<PartOfRows>& parts, const AssemblySpec& whole, std::size_t columns) {
  std::vector<AssemblySpec> out;
  for (const PartOfRows& part : parts) {
    AssemblySpec& spec = out.emplace_back();
    spec.restriction = whole.restriction;
    spec.columns = whole.columns;
    spec.weighting = whole.weighting;
    spec.delta = whole.delta;
    spec.omega0 = whole.omega0;
    spec.supports = {part.support};
    spec.column_support.assign(columns, 0);
    spec.is_of_part = true;
    make_expanders(spec);
  }
  return out;
}

std::unique_ptr<EquationBuilder> make_part_rows(std::vector<PartOfRows> parts, const Coordinates& coordinates, const EquationSet& equations,
                                                frf::FrfSystem& substructures, frf::FrfSystem& assembly) {
  return std::make_unique<PartRows>(parts, coordinates, equations, substructures, assembly);
}

}  // namespace jointid::ident
