#include "response/time/transient.hpp"

#include <cmath>

#include "response/time/algorithm_one.hpp"
#include "response/time/algorithm_two.hpp"
#include "response/time/exact_march.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;

/// Rows of a transient, one an instant.
class Teller {
 public:
  Teller(const JointedStructure& structure, const TransientRequest& request, Transient& out)
      : structure_(structure), request_(request), out_(out) {
    const auto rows = static_cast<Index>(std::llround(request.duration / request.step)) + 1;
    out.x.resize(rows, request.responses.cols());
    out.q.resize(rows, structure.joints());
    out.f.resize(rows, structure.joints());
  }

  void tell(const Instant& now) {
    const Index row = at(out_.times.size());
    out_.times.push_back(now.time);
    out_.x.row(row) = (request_.responses.transpose() * now.x).transpose();
    out_.q.row(row) = (structure_.incidence.transpose() * now.x).transpose();
    out_.f.row(row) = now.f.transpose();
  }

  /// `next` goes on to a time and says whether it came there.
  template <class Next>
  void march(const Instant& start, const Next& next) {
    tell(start);
    const Index rows = out_.x.rows();
    for (Index i = 1; i < rows && out_.complete; ++i) {
      const double time = static_cast<double>(i) * request_.step;
      if (request_.advance) request_.advance(time);
      out_.complete = next(time);
    }
    if (!out_.complete) {
      const Index told = at(out_.times.size());
      for (Eigen::MatrixXd* rows_of : {&out_.x, &out_.q, &out_.f}) rows_of->conservativeResize(told, rows_of->cols());
    }
  }

 private:
  const JointedStructure& structure_;
  const TransientRequest& request_;
  Transient& out_;
};

bool failed(const AlgorithmOne& algorithm) { return algorithm.diverged() || !algorithm.motion().x.allFinite(); }
bool failed(const AlgorithmTwo& algorithm) { return !algorithm.motion().x.allFinite(); }

template <class Algorithm>
void march_steps(Algorithm& algorithm, const TransientRequest& request, Teller& teller) {
  const auto steps = std::llround(request.step / request.delta);
  const Instant rest = algorithm.motion();
  teller.march(rest, [&](double) {
    for (long long i = 0; i < steps && !failed(algorithm); ++i) algorithm.step();
    if (failed(algorithm)) return false;
    teller.tell(algorithm.motion());
    return true;
  });
}

}  // namespace

Transient march_transient(const JointedStructure& structure, const ForceHistory& force, const TransientRequest& request) {
  Transient out;
  Teller teller(structure, request, out);
  switch (request.method) {
    case TransientMethod::exact: {
      ExactMarch march(structure, force);
      teller.march(march.motion(), [&](double time) {
        if (!march.march(time)) return false;
        teller.tell(march.motion());
        return true;
      });
      out.events = march.events();
      break;
    }
    case TransientMethod::newmark:
    case TransientMethod::algorithm_one: {
      const bool direct = request.method == TransientMethod::newmark;
      AlgorithmOne algorithm(structure, force, request.delta, request.loads,
                             direct ? StepIteration::direct : StepIteration::newton);
      march_steps(algorithm, request, teller);
      break;
    }
    case TransientMethod::algorithm_two: {
      AlgorithmTwoOptions options = request.two;
      options.loads = request.loads;
      AlgorithmTwo algorithm(structure, force, request.delta, options);
      march_steps(algorithm, request, teller);
      out.too_soft = algorithm.too_soft();
      out.growth = algorithm.growth();
      break;
    }
  }
  return out;
}

}  // namespace jointid::response
