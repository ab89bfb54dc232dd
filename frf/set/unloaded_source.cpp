#include "frf/set/unloaded_source.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "base/complex.hpp"
#include "frf/set/dof_lookup.hpp"
#include "frf/set/scaled_source.hpp"

namespace jointid::frf {
namespace {

/// A mass at a driving point of the file.
struct PointMass {
  std::size_t response, reference;  ///< of the header
  Dof dof;
  double mass;  ///< kg; below 0 where the two roles of the driving point have opposite signs
  double w(double frequency_hz) const {
    const double omega = angular(frequency_hz);
    return omega * omega * mass;
  }
};

/// `indices` with those of `more` that are not among them; `place[i]` is where more[i] stands.
struct Extended {
  std::vector<std::size_t> indices, place;

  Extended(std::vector<std::size_t> some, const std::vector<std::size_t>& more) : indices(std::move(some)) {
    for (const std::size_t index : more) {
      const auto found = std::find(indices.begin(), indices.end(), index);
      place.push_back(static_cast<std::size_t>(found - indices.begin()));
      if (found == indices.end()) indices.push_back(index);
    }
  }
};

/// Rows of a block that were measured with the same masses on the structure.
struct LoadedRows {
  std::vector<std::size_t> position;  ///< in the block's responses
  std::vector<PointMass> masses;
};

/// A rectangle of one line, [rows, columns], and where the masses stand in it.
struct LoadedLine {
  std::span<Complex> values;
  std::size_t columns;
  const std::vector<PointMass>& masses;
  const std::vector<std::size_t>&row, &column;  ///< places of the masses
  double frequency_hz;

  Complex& at(std::size_t r, std::size_t c) const { return values[r * columns + c]; }
  std::size_t rows() const { return values.size() / columns; }

  /// H ← H − w H(:,p) H(p,:)/(1 + w H(p,p)), mass by mass.
  void unload() const {
    std::vector<Complex> from(rows()), to(columns);
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const double w = masses[i].w(frequency_hz);
      const Complex factor = w / (1.0 + w * at(row[i], column[i]));
      for (std::size_t r = 0; r < rows(); ++r) from[r] = factor * at(r, column[i]);
      for (std::size_t c = 0; c < columns; ++c) to[c] = at(row[i], c);
      for (std::size_t r = 0; r < rows(); ++r) {
        for (std::size_t c = 0; c < columns; ++c) at(r, c) -= from[r] * to[c];
      }
    }
  }

  /// A factor of a row or column of the rectangle.
  struct Share {
    std::size_t place;
    Complex factor;
  };

  /// With H free of the masses, dH = (I − H W) dH_m (I − W H): row r of the left factor, column c of the right one.
  std::vector<Share> left(std::size_t r) const {
    return shares(r, row, [&](std::size_t i) { return at(r, column[i]); });
  }
  std::vector<Share> right(std::size_t c) const {
    return shares(c, column, [&](std::size_t i) { return at(row[i], c); });
  }

 private:
  template <class Frf>
  std::vector<Share> shares(std::size_t own, const std::vector<std::size_t>& place, Frf frf) const {
    std::vector<Share> out = {{own, 1.0}};
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const Complex factor = -masses[i].w(frequency_hz) * frf(i);
      if (place[i] == own) {
        out.front().factor += factor;
      } else {
        out.push_back({place[i], factor});
      }
    }
    return out;
  }
};

/// Calls use(i, j, factor) for what the FRF (r, c) free of the masses takes of the error of the measured FRF (i, j).
template <class Use>
void for_each_share(const LoadedLine& line, std::size_t r, std::size_t c, Use use) {
  for (const auto& left : line.left(r)) {
    for (const auto& right : line.right(c)) use(left.place, right.place, left.factor * right.factor);
  }
}

class UnloadedSource final : public FrfSource {
 public:
  UnloadedSource(std::unique_ptr<FrfSource> source, const std::vector<DofNumber>& masses, SensorsOn sensors)
      : source_(std::move(source)), sensors_(sensors) {
    header_ = source_->header();
    for (const DofNumber& mass : masses) masses_.push_back(point_mass(mass));
  }

 private:
  PointMass point_mass(const DofNumber& mass) const {
    const std::size_t response = index_of_dof(header_, header_.response, mass.dof, "sensor_mass");
    const std::size_t reference = find_coordinate(header_.reference, mass.dof);
    if (reference == npos) {
      throw InputError({.kind = ErrorKind::usage,
                        .file = header_.file,
                        .place = "sensor_mass",
                        .problem = "the mass at " + mass.dof.name() + " cannot be removed: the file has no driving-point FRF there, " +
                                   mass.dof.name() + " is no reference",
                        .remedy = "excite " + mass.dof.name() + ", too, or leave its mass out"});
    }
    const double sign = header_.response[response].sign * header_.reference[reference].sign;
    return {response, reference, mass.dof, sign * mass.value};
  }

  bool is_on(const PointMass& mass, const Dof& response) const {
    if (sensors_ == SensorsOn::roving) return mass.dof.same_coordinate(response);
    return sensors_ == SensorsOn::fixed || mass.dof.node == response.node;
  }

  /// Rows with one key were measured with the same masses.
  std::int64_t key_of(const Dof& response) const {
    constexpr std::int64_t together = -1;  // no key of a DOF
    const auto on = [&](const PointMass& mass) { return is_on(mass, response); };
    if (sensors_ == SensorsOn::fixed || std::ranges::none_of(masses_, on)) return together;
    return sensors_ == SensorsOn::roving ? coordinate_key(response) : response.node;
  }

  std::vector<LoadedRows> groups(const Block& block) const {
    std::map<std::int64_t, LoadedRows> by_key;
    for (std::size_t i = 0; i < block.responses.size(); ++i) {
      const Dof& response = header_.response[block.responses[i]];
      LoadedRows& rows = by_key[key_of(response)];
      rows.position.push_back(i);
      if (rows.position.size() > 1) continue;
      std::ranges::copy_if(masses_, std::back_inserter(rows.masses), [&](const PointMass& mass) { return is_on(mass, response); });
    }
    std::vector<LoadedRows> out;
    for (auto& [key, rows] : by_key) out.push_back(std::move(rows));
    return out;
  }

  /// Reads what a group needs and calls use(line index, rectangle of its line free of the masses, all rows and columns read).
  template <class Use>
  void for_each_line(const Block& block, const LoadedRows& group, Use use) {
    std::vector<std::size_t> own, mass_rows, mass_columns;
    for (const std::size_t position : group.position) own.push_back(block.responses[position]);
    for (const PointMass& mass : group.masses) {
      mass_rows.push_back(mass.response);
      mass_columns.push_back(mass.reference);
    }
    const Extended rows(own, mass_rows);
    const Extended columns({block.references.begin(), block.references.end()}, mass_columns);
    const Block wanted{block.lines, rows.indices, columns.indices};
    std::vector<Complex> values(wanted.size());
    source_->read(wanted, values);
    const std::size_t size = rows.indices.size() * columns.indices.size();
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
      const LoadedLine line{std::span(values).subspan(i * size, size), columns.indices.size(), group.masses, rows.place, columns.place,
                            header_.frequency_hz[block.lines[i]]};
      use(i, line, wanted);
    }
  }

  /// Calls put(index in the block, rectangle, row, column) for the group's own entries.
  template <class Put>
  static void for_each_entry(const Block& block, const LoadedRows& group, std::size_t i, const Put& put) {
    for (std::size_t r = 0; r < group.position.size(); ++r) {
      const std::size_t first = (i * block.responses.size() + group.position[r]) * block.references.size();
      for (std::size_t c = 0; c < block.references.size(); ++c) put(first + c, r, c);
    }
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    for (const LoadedRows& group : groups(block)) {
      for_each_line(block, group, [&](std::size_t i, const LoadedLine& line, const Block&) {
        line.unload();
        for_each_entry(block, group, i, [&](std::size_t to, std::size_t r, std::size_t c) { out[to] = line.at(r, c); });
      });
    }
  }

  void do_read_variance(const Block& block, std::span<Complex> out) override {
    for (const LoadedRows& group : groups(block)) {
      std::vector<Complex> measured;
      for_each_line(block, group, [&](std::size_t i, const LoadedLine& line, const Block& wanted) {
        if (i == 0) {
          measured.resize(wanted.size());
          source_->read_variance(wanted, measured);
        }
        const Complex* variance = measured.data() + i * line.values.size();
        line.unload();
        for_each_entry(block, group, i, [&](std::size_t to, std::size_t r, std::size_t c) {
          out[to] = 0.0;
          for_each_share(line, r, c, [&](std::size_t row, std::size_t column, Complex factor) {
            out[to] += scaled_variance(factor, variance[row * line.columns + column]);
          });
        });
      });
    }
  }

  /// With the relative variance e = (1 − γ²)/γ² of each FRF: γ² = 1/(1 + e) of what is left.
  void do_read_coherence(const Block& block, std::span<double> out) override {
    for (const LoadedRows& group : groups(block)) {
      std::vector<double> measured;
      for_each_line(block, group, [&](std::size_t i, const LoadedLine& line, const Block& wanted) {
        if (i == 0) {
          measured.resize(wanted.size());
          source_->read_coherence(wanted, measured);
        }
        const double* coherence = measured.data() + i * line.values.size();
        const std::vector<Complex> loaded(line.values.begin(), line.values.end());
        line.unload();
        for_each_entry(block, group, i, [&](std::size_t to, std::size_t r, std::size_t c) {
          double energy = 0.0;
          for_each_share(line, r, c, [&](std::size_t row, std::size_t column, Complex factor) {
            const std::size_t from = row * line.columns + column;
            const double share = std::norm(factor * loaded[from]);
            if (share > 0.0 || std::isnan(share)) energy += share * (1.0 / coherence[from] - 1.0);
          });
          out[to] = energy > 0.0 ? 1.0 / (1.0 + energy / std::norm(line.at(r, c))) : energy == 0.0 ? 1.0 : energy;
        });
      });
    }
  }

  std::unique_ptr<FrfSource> source_;
  std::vector<PointMass> masses_;
  SensorsOn sensors_;
};

}  // namespace

std::unique_ptr<FrfSource> unloaded_source(std::unique_ptr<FrfSource> source, const std::vector<DofNumber>& masses, SensorsOn sensors) {
  return std::make_unique<UnloadedSource>(std::move(source), masses, sensors);
}

}  // namespace jointid::frf
