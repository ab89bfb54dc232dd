#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "dense/one_blas_thread.hpp"
#include "minimise/modules.hpp"

namespace jointid::minimise {
namespace {

using Ipopt::Index;
using Ipopt::Number;

/// r and J at the last point that was asked for: value, gradient and Hessian come one after the other.
class Problem final : public Ipopt::TNLP {
 public:
  Problem(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options)
      : problem_(problem),
        start_(start.begin(), start.end()),
        options_(options),
        r_(problem.residuals()),
        jacobian_(problem.residuals() * problem.unknowns()) {}

  const std::vector<double>& found() const { return found_; }

  bool get_nlp_info(Index& n, Index& m, Index& nonzeros, Index& nonzeros_of_hessian, IndexStyleEnum& style) override {
    n = static_cast<Index>(start_.size());
    m = nonzeros = 0;
    nonzeros_of_hessian = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number*, Number*) override {
    constexpr Number none = 1e20;  // as far as Ipopt's options say
    for (Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      lower[i] = options_.lower.empty() ? -none : std::max(options_.lower[k], -none);
      upper[i] = options_.upper.empty() ? none : std::min(options_.upper[k], none);
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* q, bool, Number*, Number*, Index, bool, Number*) override {
    std::ranges::copy(start_, q);
    return true;
  }

  bool eval_f(Index, const Number* q, bool is_new, Number& value) override {
    if (!at(q, is_new)) return false;
    value = 0.0;
    for (const double each : r_) value += each * each;
    return true;
  }

  bool eval_grad_f(Index n, const Number* q, bool is_new, Number* gradient) override {
    if (!at(q, is_new)) return false;
    std::fill(gradient, gradient + n, 0.0);
    const double* row = jacobian_.data();
    for (const double each : r_) {
      for (Index i = 0; i < n; ++i) gradient[i] += 2.0 * each * *row++;
    }
    return true;
  }

  bool eval_g(Index, const Number*, bool, Index, Number*) override { return true; }
  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index*, Index*, Number*) override { return true; }

  bool eval_h(Index n, const Number* q, bool is_new, Number factor, Index, const Number*, bool, Index count, Index* rows,
              Index* columns, Number* values) override {
    if (values == nullptr) {
      for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j <= i; ++j) {
          *rows++ = i;
          *columns++ = j;
        }
      }
      return true;
    }
    if (!at(q, is_new)) return false;
    std::fill(values, values + count, 0.0);
    for (std::size_t row = 0; row < r_.size(); ++row) {
      const double* d = jacobian_.data() + row * static_cast<std::size_t>(n);
      Number* value = values;
      for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j <= i; ++j) *value++ += 2.0 * factor * d[i] * d[j];
      }
    }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* q, const Number*, const Number*, Index, const Number*,
                         const Number*, Number, const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    found_.assign(q, q + n);
  }

 private:
  bool at(const Number* q, bool is_new) {
    if (is_new || !known_) defined_ = problem_.evaluate({q, start_.size()}, r_, jacobian_);
    known_ = true;
    return defined_;
  }

  const LeastSquares& problem_;
  std::vector<double> start_, found_;
  const IpoptOptions& options_;
  std::vector<double> r_, jacobian_;
  bool known_ = false, defined_ = false;
};

/// MUMPS, the only linear solver of Debian's Ipopt, has global state.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

Minimum minimum_of(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options) {
  const std::lock_guard lock(one_at_a_time());
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  application->Options()->SetIntegerValue("print_level", 0);
  application->Options()->SetStringValue("sb", "yes");
  application->Options()->SetNumericValue("tol", options.tolerance);
  application->Options()->SetIntegerValue("max_iter", options.most_iterations);
  if (application->Initialize() != Ipopt::Solve_Succeeded) throw std::logic_error("Ipopt refuses its options");
  Problem* own = new Problem(problem, start, options);  // held by the pointer below, as Ipopt's interface has it
  const Ipopt::SmartPtr<Ipopt::TNLP> held = own;
  const Ipopt::ApplicationReturnStatus status = application->OptimizeTNLP(held);
  Minimum out{own->found().empty() ? std::vector<double>(start.begin(), start.end()) : own->found(), 0, false};
  if (Ipopt::IsValid(application->Statistics()))
    out.iterations = static_cast<std::size_t>(application->Statistics()->IterationCount());
  out.converged = status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level;
  return out;
}

class OwnIpopt final : public IpoptModule {
 public:
  Minimum minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options) override {
    return minimum_of(problem, start, options);
  }
};

}  // namespace
}  // namespace jointid::minimise

extern "C" void* jointid_module() {
  jointid::dense::use_one_blas_thread();
  static jointid::minimise::OwnIpopt module;
  return static_cast<jointid::minimise::IpoptModule*>(&module);
}
