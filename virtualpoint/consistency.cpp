#include "virtualpoint/consistency.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "virtualpoint/mixture.hpp"

namespace jointid::virtualpoint {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

/// Complex products with real matrices, part by part.
MatrixXcd filtered(const MatrixXd& filter, const MatrixXcd& y) { return (filter.cast<Complex>() * y).eval(); }

/// |a + b|²/(2|a|² + 2|b|²); 1 where both are zero.
double criterion(Complex a, Complex b) {
  const double sum = 2.0 * (std::norm(a) + std::norm(b));
  return sum > 0.0 ? std::norm(a + b) / sum : 1.0;
}

double share(double part, double whole) { return whole > 0.0 ? part / whole : 1.0; }

/// Collects the consistency of one side line by line; `y`: its channels are the rows.
class SideSums {
 public:
  explicit SideSums(const Transformation& side) : filter_(side.any() ? side.filter() : MatrixXd()) { out_.dofs = side.dofs; }

  void add(const MatrixXcd& y) {
    if (!out_.any()) return;
    const VectorXcd u = y.rowwise().sum(), explained = filtered(filter_, u);
    out_.specific.resize(out_.dofs.size(), 0.0);
    for (std::size_t i = 0; i < out_.dofs.size(); ++i) out_.specific[i] += criterion(u[at(i)], explained[at(i)]);
    out_.overall.push_back(share(explained.norm(), u.norm()));
  }

  SideConsistency result() {
    for (double& sum : out_.specific) sum /= static_cast<double>(out_.overall.size());
    return std::move(out_);
  }

 private:
  MatrixXd filter_;
  SideConsistency out_;
};

double rigidity(const Transformation& sensors, const Transformation& impacts, const MatrixXcd& y) {
  MatrixXcd explained = sensors.any() ? filtered(sensors.filter(), y) : y;
  if (impacts.any()) explained = filtered(impacts.filter(), explained.transpose());
  return share(explained.norm(), y.norm());
}

std::vector<std::size_t> channels(const Transformation& side, std::size_t all) {
  return side.any() ? side.channels : first_indices(all);
}

}  // namespace

Consistency consistency(frf::FrfSource& source, const VirtualPoint& point, std::span<const std::size_t> lines) {
  const frf::FrfHeader& header = source.header();
  const Transformation sensors = transformation(point, Side::sensors, header),
                       impacts = transformation(point, Side::impacts, header);
  Consistency out{
      .file = header.file, .point = name(point), .frequency_hz = {}, .sensors = {}, .impacts = {}, .rigidity = {}, .wrong = {}};
  if (!sensors.any() && !impacts.any()) return out;
  const std::vector<std::size_t> rows = channels(sensors, header.response.size()),
                                 columns = channels(impacts, header.reference.size());
  SideSums of_sensors(sensors), of_impacts(impacts);
  std::vector<MatrixXcd> kept;
  RowMatrixXc y(at(rows.size()), at(columns.size()));
  for (const std::size_t line : lines) {
    source.read({std::span(&line, 1), rows, columns}, std::span(y.data(), rows.size() * columns.size()));
    if (!y.allFinite()) continue;
    out.frequency_hz.push_back(header.frequency_hz[line]);
    of_sensors.add(y);
    of_impacts.add(y.transpose());
    out.rigidity.push_back(rigidity(sensors, impacts, y));
    kept.emplace_back(y);
  }
  if (kept.empty()) return out;
  out.sensors = of_sensors.result();
  out.impacts = of_impacts.result();
  if (sensors.any()) out.wrong = wrong_directions(point, Side::sensors, sensors, kept);
  if (impacts.any()) {
    for (MatrixXcd& of_line : kept) of_line.transposeInPlace();
    const std::vector<WrongDirection> more = wrong_directions(point, Side::impacts, impacts, kept);
    out.wrong.insert(out.wrong.end(), more.begin(), more.end());
  }
  return out;
}

}  // namespace jointid::virtualpoint
