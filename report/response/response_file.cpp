#include "report/response/response_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "base/complex.hpp"
#include "frf/hdf5/table_file.hpp"
#include "report/response/curve_rows.hpp"

namespace jointid::report {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Rows of one width, collected.
class Rows {
 public:
  explicit Rows(std::vector<frf::TableColumn> columns) : columns_(std::move(columns)) {
    for (frf::TableColumn& column : columns_) column.truth = unknown;
  }

  void add(const std::vector<double>& row) { numbers_.insert(numbers_.end(), row.begin(), row.end()); }

  void write(const std::filesystem::path& path, std::map<std::string, std::string> texts) const {
    frf::TableWriter writer(path, {std::move(texts), columns_}, numbers_.size() / columns_.size());
    writer.append(numbers_);
    writer.finish();
  }

 private:
  std::vector<frf::TableColumn> columns_;
  std::vector<double> numbers_;
};

void add_point(const tasks::LevelResponse& level, std::size_t i, Rows& rows) {
  const response::HarmonicSolution& point = level.points[i];
  for (Eigen::Index n = 0; n < point.response.rows(); ++n) {
    for (Eigen::Index dof = 0; dof < point.response.cols(); ++dof) {
      const Complex x = point.response(n, dof);
      const Complex deviation = level.deviations.empty() ? Complex(unknown, unknown) : level.deviations[i].parts(n, dof);
      const bool barred = i < level.left_out.size() && level.left_out[i].size() > 0;
      rows.add({level.level, hertz(point.omega), static_cast<double>(point.harmonics[static_cast<std::size_t>(n)]),
                static_cast<double>(dof + 1), x.real(), x.imag(), deviation.real(), deviation.imag(),
                barred ? level.left_out[i](n, dof) : unknown});
    }
  }
}

}  // namespace

void write_response_table(const std::filesystem::path& path, const tasks::ResponseResult& run) {
  Rows rows({{"force", "N"},
             {"frequency", "Hz"},
             {"harmonic", "1"},
             {"dof", "1"},
             {"re", "m"},
             {"im", "m"},
             {"std dev re", "m"},
             {"std dev im", "m"},
             {"left out", "m"}});
  for (const tasks::LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      if (level.points[i].converged) add_point(level, i, rows);
    }
  }
  rows.write(path, {{"dofs", fmt::format("{}", fmt::join(run.dofs, ","))}});
}

void write_curves_table(const std::filesystem::path& path, const tasks::ResponseResult& run) {
  Rows rows({{"curve", "1"},
             {"place", "1"},
             {"parameter", "SI"},
             {"force", "N"},
             {"frequency", "Hz"},
             {"harmonic", "1"},
             {"dof", "1"},
             {"re", "m"},
             {"im", "m"},
             {"loss", "J"},
             {"damping", "1"}});
  for (const CurveRow& row : curve_rows(run)) {
    rows.add({static_cast<double>(row.curve), static_cast<double>(row.place), row.parameter, row.force, row.frequency_hz,
              static_cast<double>(row.harmonic), static_cast<double>(row.dof + 1), row.x.real(), row.x.imag(), row.loss,
              row.damping.value_or(unknown)});
  }
  rows.write(path, {{"dofs", fmt::format("{}", fmt::join(run.dofs, ","))},
                    {"curves", fmt::format("{}", fmt::join(curve_names(run), ";"))}});
}

void write_history_table(const std::filesystem::path& path, const tasks::ResponseResult& run) {
  std::vector<frf::TableColumn> columns = {{"motion", "1"}, {"time", "s"}};
  for (const std::string& dof : run.dofs) columns.push_back({"x(" + dof + ")", "m"});
  for (const std::string& joint : run.marched)
    columns.insert(columns.end(), {{"q(" + joint + ")", "m"}, {"f(" + joint + ")", "N"}});
  Rows rows(std::move(columns));
  std::vector<std::string> names;
  for (const tasks::TransientRun& each : run.transients) {
    names.push_back(each.name);
    for (std::size_t i = 0; i < each.motion.times.size(); ++i) {
      std::vector<double> row = {static_cast<double>(names.size()), each.motion.times[i]};
      for (Eigen::Index x = 0; x < each.motion.x.cols(); ++x) row.push_back(each.motion.x(at(i), x));
      for (Eigen::Index j = 0; j < each.motion.q.cols(); ++j)
        row.insert(row.end(), {each.motion.q(at(i), j), each.motion.f(at(i), j)});
      rows.add(row);
    }
  }
  rows.write(path, {{"motions", fmt::format("{}", fmt::join(names, ";"))}});
}

bool names_hdf5(const std::filesystem::path& path) { return path.extension() == ".h5" || path.extension() == ".hdf5"; }

}  // namespace jointid::report
