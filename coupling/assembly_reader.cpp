#include "coupling/assembly_reader.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/stop_scope.hpp"

namespace jointid::coupling {
namespace {

constexpr std::size_t lines_at_once = 32;

std::vector<std::size_t> places(const std::vector<Coordinate>& coordinates, std::size_t part) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (coordinates[i].part == part) out.push_back(i);
  }
  return out;
}

std::vector<frf::Dof> dofs_at(const std::vector<Coordinate>& coordinates, const std::vector<std::size_t>& at) {
  std::vector<frf::Dof> out;
  for (const std::size_t i : at) out.push_back(coordinates[i].dof);
  return out;
}

bool same(const Coordinate& a, const Coordinate& b) { return a.part == b.part && a.dof.same_coordinate(b.dof); }

}  // namespace

/// What one part gives to H.
struct AssemblyReader::PartBlock {
  std::size_t part;
  std::vector<std::size_t> rows, columns;  ///< of H
  PartReader reader;
};

/// How the lines of a block are read and coupled.
struct AssemblyReader::Work {
  std::vector<Coordinate> rows, columns;  ///< of H
  LineFrame frame;
  std::vector<double> row_sign, column_sign;  ///< of the result's DOFs
  std::vector<PartBlock> parts;
  Options options{};  ///< uncertainty as asked for
  bool with_covariance = false;
};

/// One line of H and of its variances, before it is coupled.
struct AssemblyReader::LineInput {
  ComplexMatrix h;
  LineVariance variance;

  void clear(const Work& work, std::size_t unknowns) {
    const auto rows = at(work.rows.size()), columns = at(work.columns.size());
    h = ComplexMatrix::Zero(rows, columns);
    if (needs_variance(work.options)) variance = {RealMatrix::Zero(rows, columns), RealMatrix::Zero(rows, columns)};
    if (work.with_covariance) variance.covariance.assign(work.columns.size(), ComplexMatrix::Zero(rows, rows));
    variance.with_joint.assign(unknowns, ComplexMatrix::Zero(rows, columns));
  }
};

AssemblyReader::AssemblyReader(std::vector<Part> parts, const Assembly& assembly, const Options& options, const std::string& where)
    : parts_(std::move(parts)), options_(options), layout_(make_layout(parts_, assembly, where)) {
  validate(options_, where);
  require_method(where);
  match_axes();
  make_header();
  if (!needs_variance(options_)) return;
  const std::size_t line = 0;  // finds files without variances before any work
  std::vector<std::size_t> responses(header_.response.size()), references(header_.reference.size());
  for (std::size_t i = 0; i < responses.size(); ++i) responses[i] = i;
  for (std::size_t i = 0; i < references.size(); ++i) references[i] = i;
  const Work work = plan_block({{&line, 1}, responses, references}, true);
  const auto any = std::ranges::any_of(work.parts, [](const PartBlock& part) { return part.reader.has_covariance(); });
  has_covariance_ = options_.uncertainty && (any || !layout_.joint.by_unknown.empty());
}

void AssemblyReader::require_method(const std::string& where) const {
  const auto fail = [&](std::string problem, std::string remedy) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = where,
                      .place = "method " + name(options_.method),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  if (options_.method == Method::rc) {
    std::vector<std::size_t> body = bodies(parts_, layout_.connected);
    for (const Index i : layout_.joint.at) {
      const std::size_t joined = body[static_cast<std::size_t>(layout_.joint.at.front())];
      std::ranges::replace(body, std::size_t{body[static_cast<std::size_t>(i)]}, joined);
    }
    if (const auto condition = rc_lacks(layout_.conditions, body)) {
      fail("receptance coupling joins two structures and cannot meet " + layout_.condition_names[*condition], "use grc, pcc or mtc");
    }
  }
  if (options_.method == Method::gic) {
    for (const auto* side : {&layout_.responses, &layout_.references}) {
      const auto& other = side == &layout_.responses ? layout_.references : layout_.responses;
      for (const ResultDof& dof : *side) {
        const bool both = dof.connected >= 0 ||
                          std::ranges::any_of(other, [&](const ResultDof& o) { return same(o.coordinate, dof.coordinate); });
        if (!both) {
          fail("impedance coupling inverts H, but " + dof.dof.name() + " is only a " +
                   (side == &layout_.responses ? "response" : "reference"),
               "use grc, pcc or mtc, or keep other DOFs");
        }
      }
    }
  }
}

void AssemblyReader::match_axes() {
  const std::vector<double>& axis = parts_.front().system->frequency_hz();
  std::vector<std::vector<std::size_t>> partner;
  for (const Part& part : parts_) partner.push_back(frf::match_lines(axis, part.system->frequency_hz()));
  part_line_.resize(parts_.size());
  for (std::size_t line = 0; line < axis.size(); ++line) {
    if (std::ranges::any_of(partner, [&](const auto& of) { return of[line] == frf::npos; })) {
      ++lines_without_partner_;
      continue;
    }
    header_.frequency_hz.push_back(axis[line]);
    for (std::size_t p = 0; p < parts_.size(); ++p) part_line_[p].push_back(partner[p][line]);
  }
  if (!header_.frequency_hz.empty()) return;
  throw InputError({.kind = ErrorKind::data,
                    .file = parts_.back().name,
                    .place = {},
                    .problem = "no frequency line is common to all parts: here " +
                               frf::range_text(parts_.back().system->frequency_hz()) + ", in " + parts_.front().name + " " +
                               frf::range_text(axis),
                    .remedy = "measure or convert them to one axis"});
}

void AssemblyReader::make_header() {
  std::set<std::int64_t> wanted;
  for (const ResultDof& dof : layout_.responses) header_.response.push_back(dof.dof), wanted.insert(dof.dof.node);
  for (const ResultDof& dof : layout_.references) header_.reference.push_back(dof.dof), wanted.insert(dof.dof.node);
  std::set<frf::Quantity> quantities;
  for (const Part& part : parts_) {
    header_.file += (header_.file.empty() ? "" : " + ") + part.name;
    for (std::size_t s = 0; s < part.system->source_count(); ++s) {
      const frf::FrfHeader& source = part.system->source(s).header();
      quantities.insert(source.quantity);
      for (const frf::Node& node : source.nodes) {
        if (wanted.erase(node.id) > 0) header_.nodes.push_back(node);
      }
    }
  }
  if (quantities.size() == 1) header_.quantity = *quantities.begin();
  if (options_.uncertainty) header_.noise = frf::NoiseRecord::variance;
}

AssemblyReader::Work AssemblyReader::plan_block(const frf::Block& block, bool with_variance) const {
  Work work;
  work.rows = work.columns = layout_.connected;
  const auto add = [](const ResultDof& dof, std::vector<Coordinate>& to, std::vector<Index>& wanted, std::vector<double>& sign) {
    sign.push_back(dof.sign);
    const auto found = std::ranges::find_if(to, [&](const Coordinate& other) { return same(other, dof.coordinate); });
    wanted.push_back(found - to.begin());
    if (found == to.end()) to.push_back(dof.coordinate);
  };
  for (const std::size_t r : block.responses) add(layout_.responses[r], work.rows, work.frame.wanted.rows, work.row_sign);
  for (const std::size_t c : block.references) add(layout_.references[c], work.columns, work.frame.wanted.columns, work.column_sign);
  if (options_.method == Method::gic) {
    // A square matrix of the coordinates that either side asks for.
    std::vector<Index> unused;
    std::vector<double> no_sign;
    for (const Coordinate& row : work.rows) add({row, -1, 1.0, row.dof}, work.columns, unused, no_sign);
    std::vector<Coordinate> rows = work.columns;
    for (Index& row : work.frame.wanted.rows) {
      const Coordinate& coordinate = work.rows[static_cast<std::size_t>(row)];
      row = std::ranges::find_if(rows, [&](const Coordinate& other) { return same(other, coordinate); }) - rows.begin();
    }
    work.rows = std::move(rows);
  }
  for (std::size_t k = layout_.connected.size(); k < work.rows.size(); ++k) {
    const auto twin = std::ranges::find_if(work.columns, [&](const Coordinate& other) { return same(other, work.rows[k]); });
    work.frame.twin.push_back(twin == work.columns.end() ? -1 : twin - work.columns.begin());
  }
  work.frame.row_body = bodies(parts_, work.rows);
  work.frame.column_body = bodies(parts_, work.columns);
  for (const Index i : layout_.joint.at) {
    const std::size_t joined = work.frame.row_body[static_cast<std::size_t>(layout_.joint.at.front())];
    const std::size_t body = work.frame.row_body[static_cast<std::size_t>(i)];
    std::ranges::replace(work.frame.row_body, body, joined);
    std::ranges::replace(work.frame.column_body, body, joined);
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    std::vector<std::size_t> rows = places(work.rows, p), columns = places(work.columns, p);
    if (rows.empty() || columns.empty()) continue;
    PartReader reader(parts_[p], dofs_at(work.rows, rows), dofs_at(work.columns, columns), with_variance, options_.noise);
    work.parts.push_back({p, std::move(rows), std::move(columns), std::move(reader)});
  }
  return work;
}

namespace {

/// Lines of H or its variances, [rows, columns] each.
template <class Matrix, class Take>
void place(const std::vector<Complex>& from, std::size_t line, const std::vector<std::size_t>& rows,
           const std::vector<std::size_t>& columns, Matrix& to, Take take) {
  const Complex* value = from.data() + line * rows.size() * columns.size();
  for (const std::size_t r : rows) {
    for (const std::size_t c : columns) to(at(r), at(c)) = take(*value++);
  }
}

/// Covariances of a part's lines, [column][row, row], of H's columns and rows.
void place_covariances(const std::vector<Complex>& from, std::size_t line, const std::vector<std::size_t>& rows,
                       const std::vector<std::size_t>& columns, std::vector<ComplexMatrix>& to) {
  const Complex* value = from.data() + line * columns.size() * rows.size() * rows.size();
  for (const std::size_t column : columns) {
    for (const std::size_t r : rows) {
      for (const std::size_t s : rows) to[column](at(r), at(s)) = *value++;
    }
  }
}

/// Rows and columns of a part as those of H.
SharedColumns in_line(SharedColumns shared, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns) {
  for (Index& row : shared.rows) row = at(rows[static_cast<std::size_t>(row)]);
  for (Index& column : shared.columns) column = at(columns[static_cast<std::size_t>(column)]);
  return shared;
}

/// The share of a covariance of `responses` that counts: all of it where nothing tells what it comes from.
double worth(std::size_t responses, double freedom) {
  return freedom > 0.0 ? freedom / (static_cast<double>(responses) + freedom) : 1.0;
}

/// The covariances of a coupled line, variances on their diagonal, as a set has them: [pair, reference].
void put_covariance(const LineVariance& variance, const std::vector<double>& row_sign, Complex* to) {
  const std::size_t rows = row_sign.size(), columns = variance.covariance.size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      for (std::size_t c = 0; c < columns; ++c) {
        const auto own = [&](std::size_t i) { return variance.real(at(i), at(c)) + variance.imaginary(at(i), at(c)); };
        const bool known = !std::isnan(own(r)) && !std::isnan(own(s));
        const Complex value = r == s ? Complex(own(r)) : row_sign[r] * row_sign[s] * variance.covariance[c](at(r), at(s));
        *to++ = known ? value : Complex(nan, nan);
      }
    }
  }
}

}  // namespace

void AssemblyReader::place_common(const PartBlock& part, const Work& work, double frequency_hz, LineVariance& to) const {
  const double sign = layout_.part_sign[part.part];
  for (const std::size_t r : part.rows) {
    for (const std::size_t c : part.columns) {
      const std::vector<Complex> common =
          layout_.joint.common(parts_[part.part].name, work.rows[r].dof, work.columns[c].dof, frequency_hz);
      for (std::size_t m = 0; m < common.size(); ++m) to.with_joint[m](at(r), at(c)) = sign * common[m];
    }
  }
}

void AssemblyReader::read(const frf::Block& block, std::span<Complex> values, std::span<Complex> variance, std::span<LineRecord> records,
                          std::span<Complex> covariance) {
  read(block, {.values = values, .variance = variance, .covariance = covariance, .records = records, .errors = {}});
}

std::vector<frf::ErrorSums> AssemblyReader::read_errors(const frf::Block& block) {
  std::vector<frf::ErrorSums> out(block.lines.size());
  std::vector<Complex> values(block.size()), variance(values.size());
  read(block, {.values = values, .variance = variance, .covariance = {}, .records = {}, .errors = out});
  return out;
}

void AssemblyReader::read_part(PartBlock& part, const Work& work, std::span<const std::size_t> lines, std::span<LineInput> to) const {
  std::vector<std::size_t> part_lines;
  for (const std::size_t line : lines) part_lines.push_back(part_line_[part.part][line]);
  std::vector<Complex> scratch(part_lines.size() * part.reader.size());
  part.reader.read(part_lines, scratch);
  const double sign = layout_.part_sign[part.part];
  for (std::size_t i = 0; i < lines.size(); ++i) {
    place(scratch, i, part.rows, part.columns, to[i].h, [&](Complex value) { return sign * value; });
  }
  if (!needs_variance(work.options)) return;
  if (work.options.uncertainty && !layout_.joint.by_unknown.empty()) {
    for (std::size_t i = 0; i < lines.size(); ++i) place_common(part, work, header_.frequency_hz[lines[i]], to[i].variance);
  }
  part.reader.read_variance(part_lines, scratch);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    place(scratch, i, part.rows, part.columns, to[i].variance.real, [](Complex v) { return v.real(); });
    place(scratch, i, part.rows, part.columns, to[i].variance.imaginary, [](Complex v) { return v.imag(); });
  }
  if (!work.with_covariance || !part.reader.has_covariance()) return;
  scratch.resize(part_lines.size() * part.reader.size() * part.rows.size());
  part.reader.read_covariance(part_lines, scratch);
  const double share = work.frame.with_errors ? worth(part.rows.size(), part.reader.covariance_freedom()) : 1.0;
  for (Complex& value : scratch) value *= share;  // variances are read for themselves
  for (std::size_t i = 0; i < lines.size(); ++i) {
    place_covariances(scratch, i, part.rows, part.columns, to[i].variance.covariance);
    for (SharedColumns& shared : part.reader.shared_columns(part_lines[i])) {
      to[i].variance.shared.push_back(in_line(std::move(shared), part.rows, part.columns));
    }
  }
}

void AssemblyReader::read(const frf::Block& block, const Results& to) {
  Options options = options_;
  options.uncertainty = !to.variance.empty();  // nobody asks, nothing is worked out
  Work work = plan_block(block, needs_variance(options));
  work.options = options;
  work.with_covariance = options.uncertainty && has_covariance_;
  work.frame.with_errors = !to.errors.empty();
  const std::size_t entries = block.responses.size() * block.references.size();
  const std::size_t pairs = frf::pair_count(block.responses.size()) * block.references.size();
  const auto put = [&](std::size_t place, CoupledLine line) {
    std::size_t entry = place * entries;
    for (std::size_t r = 0; r < block.responses.size(); ++r) {
      for (std::size_t c = 0; c < block.references.size(); ++c, ++entry) {
        const auto row = at(r), column = at(c);
        const double sign = work.row_sign[r] * work.column_sign[c];
        to.values[entry] = sign * line.frf(row, column);
        if (!to.variance.empty()) to.variance[entry] = {line.variance.real(row, column), line.variance.imaginary(row, column)};
        if (to.errors.empty()) continue;
        for (frf::ErrorSums::Term& term : line.errors.terms[r * block.references.size() + c]) term.factor *= sign;
      }
    }
    if (!to.covariance.empty()) put_covariance(line.variance, work.row_sign, to.covariance.data() + place * pairs);
    if (!to.records.empty()) to.records[place] = std::move(line.record);
    if (!to.errors.empty()) to.errors[place] = std::move(line.errors);
  };
  std::vector<LineInput> input(std::min(lines_at_once, block.lines.size()));
  tbb::task_arena arena(options_.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(options_.threads));
  for (std::size_t first = 0; first < block.lines.size(); first += lines_at_once) {
    stop_point();
    const std::span<const std::size_t> lines = block.lines.subspan(first, std::min(lines_at_once, block.lines.size() - first));
    for (std::size_t i = 0; i < lines.size(); ++i) input[i].clear(work, layout_.joint.by_unknown.size());
    for (PartBlock& part : work.parts) read_part(part, work, lines, input);
    const auto couple = [&](std::size_t i) {
      put(first + i, couple_line(input[i].h, input[i].variance, header_.frequency_hz[lines[i]], work.frame, layout_, options));
    };
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, lines.size(), couple); });
  }
}

}  // namespace jointid::coupling
