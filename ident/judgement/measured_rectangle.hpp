#pragma once

#include <optional>
#include <vector>

#include "base/complex.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// A rectangle of one system at some lines, with the variances of its FRFs, row-major per line.
struct MeasuredRectangle {
  std::vector<Complex> values, variances;
  std::size_t rows = 0, columns = 0;

  Complex value(std::size_t line, std::size_t row, std::size_t column) const {
    return values[(line * rows + row) * columns + column];
  }
  /// E|δ|², (m/N)².
  double variance(std::size_t line, std::size_t row, std::size_t column) const {
    const Complex parts = variances[(line * rows + row) * columns + column];
    return parts.real() + parts.imag();
  }
};

/// `lines`: of the system. Variances are those of the scene.
MeasuredRectangle read_rectangle(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns, const Scene& scene,
                                 const std::vector<std::size_t>& lines);

/// At most `most` lines, spread over all of them.
std::vector<Line> spread_lines(const std::vector<Line>& all, std::size_t most);

/// The lines of one system that some lines of the plan are.
std::vector<std::size_t> lines_of(const std::vector<Line>& lines, std::size_t Line::*which);

/// FRFs of one system at some of its lines.
struct Excerpt {
  Dofs rows, columns;
  std::vector<std::size_t> lines;
};

/// Whether files and scene tell the noise of all FRFs.
bool knows_noise(const Plan& plan);

/// The scene of a plan, with a [noise] that is what neighbouring lines of some FRFs scatter where files and scene say nothing;
/// empty where the lines do not tell it.
std::optional<Scene> scene_with_noise(const Plan& plan, const Excerpt& substructures, const Excerpt& assembly);

}  // namespace jointid::ident
