#include <bit>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "base/error.hpp"
#include "base/stop_scope.hpp"
#include "base/temporary_file.hpp"
#include "frf/set/virtual_node.hpp"
#include "frf/uff/uff58_header.hpp"
#include "frf/uff/uff_file.hpp"
#include "frf/uff/uff_write_text.hpp"

namespace jointid::frf {
namespace {

using uff::double_field;
using uff::integer_field;
using uff::real_field;
using uff::text_field;

[[noreturn]] void fail(const std::string& file, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// One record of a set: which element of the grid, FRF or coherence.
struct Record {
  std::size_t r = 0;
  std::size_t c = 0;
  bool coherence = false;
};

class Writer {
 public:
  Writer(const FrfSet& set, const UffWriteOptions& options, const std::string& file, std::ostream& out)
      : set_(set),
        options_(options),
        file_(file),
        out_(out),
        axis_(uff::written_axis(set.header.frequency_hz, options.binary)) {}

  void run() {
    require_node_numbers();
    preamble();
    if (!set_.header.nodes.empty()) nodes();
    bool any = false;
    for (std::size_t r = 0; r < set_.header.response.size(); ++r) {
      for (std::size_t c = 0; c < set_.header.reference.size(); ++c) {
        stop_point();
        if (!measured(r, c)) continue;
        any = true;
        record({.r = r, .c = c, .coherence = false});
        if (!set_.coherence.empty()) record({.r = r, .c = c, .coherence = true});
      }
    }
    if (!any) fail(file_, {}, "the set holds no measured FRF", "write a set with data");
  }

 private:
  void require_node_numbers() const {
    for (const auto* dofs : {&set_.header.response, &set_.header.reference}) {
      for (const Dof& dof : *dofs) {
        if (is_virtual(dof.node)) fail(file_, {}, dof.name() + " has no node number", "write virtual points to .h5 or .csv");
      }
    }
  }

  void preamble() {
    out_ << "    -1\n   151\nFRF set\nNONE\njointid\nNONE\nNONE\njointid\nNONE\n    -1\n"
         << "    -1\n   164\n         1" << text_field("SI: Meter (newton)", 20) << "         2\n"
         << "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
         << "  2.73149999999999977D+02\n    -1\n";
  }

  void nodes() {
    out_ << "    -1\n  2411\n";
    for (const Node& node : set_.header.nodes) {
      out_ << integer_field(node.id, 10) << "         0         0        11\n";
      for (const double coordinate : node.position) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%25.16E", coordinate);
        out_ << text.data();
      }
      out_ << '\n';
    }
    out_ << "    -1\n";
  }

  /// Whether an FRF has values on every line; false when it has none; an error in between.
  bool measured(std::size_t r, std::size_t c) const {
    std::size_t present = 0;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < axis_.frequency_hz.size(); ++i) {
      if (is_undefined(i)) continue;
      const Complex value = set_.values[set_.index(i, r, c)];
      ++lines;
      if (!std::isnan(value.real()) && !std::isnan(value.imag())) ++present;
      if (std::isinf(value.real()) || std::isinf(value.imag()))
        fail(file_, pair(r, c), "a value is infinite", "remove that FRF");
    }
    if (present != 0 && present != lines) {
      fail(file_, pair(r, c),
           std::to_string(lines - present) + " of " + std::to_string(lines) + " lines are NaN (not measured)",
           "UFF has no mark for them: write HDF5, or leave out those lines or that FRF");
    }
    return present != 0;
  }

  /// At 0 Hz a mobility or accelerance says nothing of the receptance.
  bool is_undefined(std::size_t line) const {
    return options_.quantity != Quantity::receptance && axis_.frequency_hz[line] == 0.0;
  }

  std::string pair(std::size_t r, std::size_t c) const {
    return "FRF of response " + set_.header.response[r].name() + " and reference " +
           set_.header.reference[c].name();
  }

  void record(const Record& record) {
    const std::uint64_t bytes =
        axis_.frequency_hz.size() * 8 * ((axis_.even ? 0u : 1u) + (record.coherence ? 1u : 2u));
    out_ << "    -1\n    58";
    if (options_.binary) {
      out_ << 'b' << integer_field(1, 6) << integer_field(2, 6) << integer_field(11, 12)
           << integer_field(static_cast<std::int64_t>(bytes), 12) << "     0     0           0           0";
    }
    out_ << '\n';
    header(record);
    if (options_.binary) {
      binary_data(record);
    } else {
      text_data(record);
    }
    out_ << "    -1\n";
  }

  void header(const Record& record) {
    const Dof& response = set_.header.response[record.r];
    const Dof& reference = set_.header.reference[record.c];
    out_ << (record.coherence ? "Coherence " : "FRF ") << response.name() << " / " << reference.name() << '\n'
         << averages() << "\nNONE\nNONE\nNONE\n"
         << integer_field(record.coherence ? uff::function_coherence : uff::function_frf, 5)
         << "         0    0         0" << dof_fields(response) << dof_fields(reference) << '\n'
         << integer_field(record.coherence ? 4 : 6, 10)
         << integer_field(static_cast<std::int64_t>(axis_.frequency_hz.size()), 10)
         << integer_field(axis_.even ? 1 : 0, 10) << real_field(axis_.first) << real_field(axis_.step)
         << real_field(0.0) << '\n'
         << axis_record(uff::type_frequency, "Frequency", "Hz");
    if (record.coherence) {
      out_ << axis_record(0, "Coherence", "NONE") << axis_record(0, "NONE", "NONE");
    } else {
      out_ << motion_record(response)
           << axis_record(uff::type_force, "Excitation force", reference.is_rotation() ? "N*m" : "N");
    }
    out_ << axis_record(0, "NONE", "NONE");
  }

  std::string averages() const {
    if (set_.coherence.empty() || !(set_.header.averages > 0.0)) return "NONE";
    return "averages " + std::to_string(std::llround(set_.header.averages));
  }

  static std::string dof_fields(const Dof& dof) {
    return " " + text_field("NONE", 10) + integer_field(dof.node, 10) +
           integer_field(std::int64_t{dof.sign} * static_cast<int>(dof.direction), 4);
  }

  static std::string axis_record(int type, std::string_view label, std::string_view unit) {
    return integer_field(type, 10) + "    0    0    0 " + text_field(label, 20) + " " + text_field(unit, 20) +
           "\n";
  }

  std::string motion_record(const Dof& response) const {
    const std::string unit = response.is_rotation() ? "rad" : "m";
    switch (options_.quantity) {
      case Quantity::mobility:
        return axis_record(uff::type_velocity, "Velocity", unit + "/s");
      case Quantity::accelerance:
        return axis_record(uff::type_acceleration, "Acceleration", unit + "/s^2");
      case Quantity::receptance:
        break;
    }
    return axis_record(uff::type_displacement, "Displacement", unit);
  }

  /// Calls `use` with each number of the record in file order.
  template <class Abscissa, class Ordinate>
  void for_each_number(const Record& record, Abscissa abscissa, Ordinate ordinate) const {
    for (std::size_t i = 0; i < axis_.frequency_hz.size(); ++i) {
      const std::size_t index = set_.index(i, record.r, record.c);
      if (!axis_.even) abscissa(axis_.frequency_hz[i]);
      if (record.coherence) {
        ordinate(set_.coherence[index]);
        continue;
      }
      const Complex value =
          is_undefined(i) ? Complex()
                          : set_.values[index] * from_receptance(options_.quantity, axis_.frequency_hz[i]);
      ordinate(value.real());
      ordinate(value.imag());
    }
  }

  void binary_data(const Record& record) {
    static_assert(std::endian::native == std::endian::little);
    const auto put = [&](double number) {
      const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(number);
      out_.write(bytes.data(), bytes.size());
    };
    for_each_number(record, put, put);
  }

  void text_data(const Record& record) {
    const std::size_t per_line = axis_.even || record.coherence ? 4 : 3;
    std::size_t column = 0;
    const auto put = [&](const std::string& field) {
      out_ << field;
      column = (column + 1) % per_line;
      if (column == 0) out_ << '\n';
    };
    for_each_number(
        record, [&](double number) { put(real_field(number)); },
        [&](double number) { put(double_field(number)); });
    if (column != 0) out_ << '\n';
  }

  const FrfSet& set_;
  const UffWriteOptions& options_;
  const std::string& file_;
  std::ostream& out_;
  uff::WrittenAxis axis_;
};

}  // namespace

void write_uff(const FrfSet& set, const std::filesystem::path& path, const UffWriteOptions& options) {
  validate(set.header);
  assert(set.values.size() == set.header.lines() * set.header.entries());
  TemporaryFile temporary(path);
  std::ofstream out(temporary.path(), std::ios::binary);
  Writer(set, options, path.string(), out).run();
  out.close();
  if (!out) temporary.fail(std::strerror(errno));
  temporary.commit();
}

}  // namespace jointid::frf
