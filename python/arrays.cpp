#include "python/arrays.hpp"

#include <pybind11/stl.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

/// Whether the interpreter is no more, or ends.
bool is_over() {
#if PY_VERSION_HEX >= 0x030D0000
  return Py_IsFinalizing() || !Py_IsInitialized();
#else
  return _Py_IsFinalizing() || !Py_IsInitialized();
#endif
}

/// A view of an object's numbers. It lets go of them with the interpreter's lock, whatever thread it ends on; where the
/// interpreter ends before it, it keeps them.
template <class T>
class View {
 public:
  View(const py::object& owner, const char* what, const char* format) {
    if (owner.is_none()) return;
    info_ = std::make_unique<py::buffer_info>(py::reinterpret_borrow<py::buffer>(owner).request());
    if (info_->format != format || info_->itemsize != sizeof(T) || !is_contiguous()) {
      refuse(std::string(what) + " is no contiguous buffer of " + format, "numpy.ascontiguousarray(array, dtype) makes one");
    }
  }
  View(View&&) noexcept = default;
  View& operator=(View&&) = delete;
  ~View() {
    if (!info_) return;
    if (is_over()) {
      (void)info_.release();
      return;
    }
    const PyGILState_STATE state = PyGILState_Ensure();  // not gil_scoped_acquire, which may throw
    info_.reset();
    PyGILState_Release(state);
  }

  std::span<const T> numbers() const {
    if (!info_) return {};
    return {static_cast<const T*>(info_->ptr), static_cast<std::size_t>(info_->size)};
  }

 private:
  bool is_contiguous() const {
    py::ssize_t stride = info_->itemsize;
    for (std::size_t axis = info_->shape.size(); axis-- > 0;) {
      if (info_->shape[axis] > 1 && info_->strides[axis] != stride) return false;
      stride *= info_->shape[axis];
    }
    return true;
  }

  std::unique_ptr<py::buffer_info> info_;
};

py::object or_none(const py::dict& of, const char* key) { return of.contains(key) ? py::object(of[key]) : py::none(); }

/// Arrays with those that keep their numbers.
struct KeptArrays : frf::FrfArrays {
  View<Complex> kept_values, kept_variance, kept_covariance, kept_factor, kept_correlation;
  View<double> kept_coherence, kept_diagonal;

  explicit KeptArrays(const py::dict& of)
      : kept_values(of["frfs"], "frfs", "Zd"),
        kept_variance(of["variance"], "variance", "Zd"),
        kept_covariance(of["covariance"], "covariance", "Zd"),
        kept_factor(or_none(of, "factor"), "covariance_factor", "Zd"),
        kept_correlation(of["reference_correlation"], "reference_correlation", "Zd"),
        kept_coherence(of["coherence"], "coherence", "d"),
        kept_diagonal(or_none(of, "factor_diagonal"), "covariance_diagonal", "d") {
    values = kept_values.numbers();
    variance = kept_variance.numbers();
    covariance = kept_covariance.numbers();
    factor = kept_factor.numbers();
    factor_diagonal = kept_diagonal.numbers();
    rank = values.empty() ? 0 : factor.size() / values.size();
    reference_correlation = kept_correlation.numbers();
    coherence = kept_coherence.numbers();
  }
};

std::vector<double> doubles(const py::handle& buffer) {
  const View<double> view(py::reinterpret_borrow<py::object>(buffer), "frequency", "d");
  const auto numbers = view.numbers();
  return {numbers.begin(), numbers.end()};
}

/// Positions by node, and the axes of those that have own ones.
std::vector<frf::Node> nodes_of(const py::handle& positions, const py::handle& axes) {
  std::vector<frf::Node> nodes;
  const auto own = axes.cast<std::map<std::int64_t, frf::Axes>>();
  for (const auto& [id, position] : positions.cast<std::map<std::int64_t, std::array<double, 3>>>()) {
    nodes.push_back({.id = id, .position = position});
    if (const auto found = own.find(id); found != own.end()) nodes.back().axes = found->second;
  }
  return nodes;
}

void fill(frf::FrfHeader& header, const py::dict& of) {
  header.file = of["name"].cast<std::string>();
  header.frequency_hz = doubles(of["frequency"]);
  header.response = dofs_of(of["responses"]);
  header.reference = dofs_of(of["references"]);
  header.quantity = frf::parse_quantity(of["quantity"].cast<std::string>());
  header.averages = of["averages"].cast<double>();
  header.precision = of["precision"].cast<double>();
  header.repeats = of["repeats"].cast<std::size_t>();
  header.nodes = nodes_of(of["nodes"], of["axes"]);
}

}  // namespace

std::shared_ptr<const std::span<const double>> kept_doubles(const py::object& buffer, const char* what) {
  struct Kept {
    View<double> view;
    std::span<const double> numbers;
  };
  auto kept = std::make_shared<Kept>(Kept{View<double>(buffer, what, "d"), {}});
  kept->numbers = kept->view.numbers();
  return {kept, &kept->numbers};
}

std::vector<frf::Dof> dofs_of(const py::handle& names) {
  std::vector<frf::Dof> dofs;
  for (const auto& name : names.cast<std::vector<std::string>>()) dofs.push_back(frf::Dof::parse(name));
  return dofs;
}

std::shared_ptr<const frf::FrfArrays> arrays_of(const py::dict& of) {
  auto arrays = std::make_shared<KeptArrays>(of);
  fill(arrays->header, of);
  if (!arrays->coherence.empty()) arrays->header.noise = frf::NoiseRecord::coherence;
  if (!arrays->variance.empty()) arrays->header.noise = frf::NoiseRecord::variance;
  return arrays;
}

}  // namespace jointid::python
