#include "python/sets.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "frf/file/memory_file.hpp"
#include "frf/file/open_as_one.hpp"
#include "frf/file/write.hpp"
#include "frf/set/frf_source.hpp"
#include "frf/set/scaled_source.hpp"
#include "frf/set/units.hpp"
#include "python/arrays.hpp"
#include "python/watch.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;
using Shape = std::vector<py::ssize_t>;

/// Numbers that a NumPy array looks at through the buffer protocol.
template <class T>
struct Numbers {
  std::vector<T> values;
  Shape shape;
};

template <class T>
void bind_numbers(py::module_& module, const char* name, const char* format) {
  py::class_<Numbers<T>>(module, name, py::buffer_protocol()).def_buffer([format](Numbers<T>& numbers) {
    Shape strides(numbers.shape.size(), sizeof(T));
    for (std::size_t axis = strides.size(); axis-- > 1;) strides[axis - 1] = strides[axis] * numbers.shape[axis];
    return py::buffer_info(numbers.values.data(), sizeof(T), format, static_cast<py::ssize_t>(numbers.shape.size()),
                           numbers.shape, strides);
  });
}

template <class T>
py::object numbers_of(std::vector<T> values, Shape shape) {
  return py::cast(Numbers<T>{std::move(values), std::move(shape)});
}

py::ssize_t length(std::size_t count) { return static_cast<py::ssize_t>(count); }

/// Receptances as the quantity that the file had, in place.
void as_stored(frf::FrfSet& set) {
  const frf::FrfHeader& header = set.header;
  if (header.quantity == frf::Quantity::receptance) return;
  const std::size_t entries = header.entries(), pairs = frf::pair_count(header.response.size()) * header.reference.size();
  for (std::size_t line = 0; line < header.lines(); ++line) {
    const Complex factor = frf::from_receptance(header.quantity, header.frequency_hz[line]);
    const auto each = [line](auto& numbers, std::size_t count, const auto& change) {
      if (numbers.empty()) return;
      for (std::size_t k = line * count; k < (line + 1) * count; ++k) numbers[k] = change(numbers[k]);
    };
    each(set.values, entries, [factor](Complex value) { return factor * value; });
    each(set.variance, entries, [factor](Complex value) { return frf::scaled_variance(factor, value); });
    each(set.covariance, pairs, [factor](Complex value) { return std::norm(factor) * value; });
    each(set.factor.rows, entries * set.factor.rank, [factor](Complex value) { return std::abs(factor) * value; });
    each(set.factor.diagonal, entries, [factor](double value) { return std::norm(factor) * value; });
  }
}

void put_nodes(const std::vector<frf::Node>& nodes, py::dict& out) {
  py::dict positions, axes;
  for (const frf::Node& node : nodes) {
    positions[py::int_(node.id)] = py::cast(node.position);
    if (node.axes) axes[py::int_(node.id)] = py::cast(*node.axes);
  }
  out["nodes"] = positions;
  out["axes"] = axes;
}

py::object read(const std::vector<std::string>& paths, const frf::OpenOptions& options, const py::object& progress) {
  const std::vector<std::filesystem::path> files(paths.begin(), paths.end());
  return dict_of(watched(progress, 0, [files, options](const ident::Control&) {
    return frf::load_with_covariance(*frf::open_as_one(files, options));
  }));
}

void write_set(const py::dict& of, const std::string& path, const std::string& format) {
  watched(py::none(), 0, [arrays = arrays_of(of), path, format](const ident::Control&) {
    frf::write(frf::load_with_covariance(*frf::from_arrays(arrays)), path, format);
    return true;
  });
}

std::optional<frf::Quantity> quantity_or_none(const std::optional<std::string>& word) {
  return word ? std::optional(frf::parse_quantity(*word)) : std::nullopt;
}

void bind_options(py::module_& module) {
  using frf::OpenOptions;
  py::class_<OpenOptions>(module, "OpenOptions")
      .def(py::init<>())
      .def_property(
          "quantity", [](const OpenOptions& of) { return of.quantity ? std::optional(frf::name(*of.quantity)) : std::nullopt; },
          [](OpenOptions& of, const std::optional<std::string>& word) { of.quantity = quantity_or_none(word); })
      .def_readwrite("unit", &OpenOptions::unit)
      .def_property(
          "responses", [](const OpenOptions& of) { return frf::names(of.response); },
          [](OpenOptions& of, const py::object& names) { of.response = dofs_of(names); })
      .def_property(
          "references", [](const OpenOptions& of) { return frf::names(of.reference); },
          [](OpenOptions& of, const py::object& names) { of.reference = dofs_of(names); })
      .def_readwrite("variable", &OpenOptions::variable)
      .def_readwrite("frequency_variable", &OpenOptions::frequency_variable)
      .def_readwrite("frequency_unit", &OpenOptions::frequency_unit);
}

/// node, direction ("X" … "RZ"), sign.
py::tuple dof_parts(const std::string& text) {
  const frf::Dof dof = frf::Dof::parse(text);
  const std::string name = dof.name();
  return py::make_tuple(name, dof.node, name.substr(name.find(':') + 2), dof.sign);
}

double unit_factor(const std::string& unit, const std::string& quantity) {
  return frf::si_factor(unit, frf::parse_quantity(quantity));
}

std::string quantity_of_unit(const std::string& unit) {
  const auto quantity = frf::quantity_of_unit(unit);
  if (quantity) return frf::name(*quantity);
  frf::require_frf_unit(unit);
  refuse("'" + unit + "' is the unit of no receptance, mobility or accelerance", "write e.g. m/N, m/s/N or g/N");
}

}  // namespace

py::dict dict_of(frf::FrfSet set) {
  as_stored(set);
  const frf::FrfHeader& header = set.header;
  const py::ssize_t lines = length(header.lines()), rows = length(header.response.size()),
                    columns = length(header.reference.size());
  const Shape shape = {lines, rows, columns};
  py::dict out;
  out["name"] = header.file;
  out["frequency"] = numbers_of(header.frequency_hz, {lines});
  out["responses"] = frf::names(header.response);
  out["references"] = frf::names(header.reference);
  out["quantity"] = frf::name(header.quantity);
  out["averages"] = header.averages;
  out["precision"] = header.precision;
  out["repeats"] = header.repeats;
  put_nodes(header.nodes, out);
  out["doubts"] = header.doubts;
  const auto put = [&out](const char* key, auto& numbers, const Shape& of) {
    out[key] = numbers.empty() ? py::object(py::none()) : numbers_of(std::move(numbers), of);
  };
  put("frfs", set.values, shape);
  put("variance", set.variance, shape);
  put("coherence", set.coherence, shape);
  put("covariance", set.covariance, {lines, length(frf::pair_count(header.response.size())), columns});
  put("factor", set.factor.rows, {lines, rows, length(set.factor.rank), columns});
  put("factor_diagonal", set.factor.diagonal, shape);
  put("reference_correlation", set.reference_correlation, {lines, columns, columns});
  return out;
}

void bind_sets(py::module_& module) {
  bind_numbers<Complex>(module, "ComplexNumbers", "Zd");
  bind_numbers<double>(module, "RealNumbers", "d");
  bind_options(module);
  py::class_<frf::MemoryFile>(module, "MemoryFile")
      .def(py::init([](const py::dict& of) { return std::make_unique<frf::MemoryFile>(arrays_of(of)); }))
      .def_property_readonly("path", [](const frf::MemoryFile& file) { return file.path().string(); });
  module.def("read", read);
  module.def("write", write_set);
  module.def("dof_parts", dof_parts);
  module.def("unit_factor", unit_factor);
  module.def("quantity_of_unit", quantity_of_unit);
  module.def("quantity_word", [](const std::string& word) { return frf::name(frf::parse_quantity(word)); });
  module.def("quantity_unit", [](const std::string& word) { return frf::unit(frf::parse_quantity(word)); });
}

}  // namespace jointid::python
