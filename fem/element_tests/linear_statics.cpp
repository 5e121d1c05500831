#include "fem/element_tests/linear_statics.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>

#include "fem/element_tests/linear_stiffness.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

class StaticSearch {
 public:
  StaticSearch(const LinearBody& body, const LinearStatics& problem)
      : body_(body),
        size_(static_cast<int>(2 * body.position.size())),
        stiffness_(size_, size_),
        given_(size_, 0),
        wall_(body.position.size(), std::nan("")),
        u_(Eigen::VectorXd::Zero(size_)) {
    stiffness_.setFromTriplets(body.stiffness.begin(), body.stiffness.end());
    for (const int node : body.axis_nodes) given_[2 * node] = 1;
    for (std::size_t node = 0; node < body.position.size(); ++node) {
      const auto& [r, z] = body.position[node];
      take(problem.radial, r, z, 2 * static_cast<int>(node));
      take(problem.axial, r, z, 2 * static_cast<int>(node) + 1);
      if (!problem.indenter) continue;
      if (const auto wall = problem.indenter(r, z)) wall_[node] = *wall;
    }
  }

  /// Active set: what is pulled is let go, what would be pierced is held.
  LinearAnswer solve() {
    constexpr int most = 100;
    for (std::size_t node = 0; node < wall_.size(); ++node)
      if (wall_[node] < 0.0) hold(node);
    for (int iteration = 0; iteration < most; ++iteration) {
      balance();
      if (!revise()) return answer();
    }
    throw Error(ExitCode::solver_failed, "the contact of a linear indentation did not settle");
  }

 private:
  void take(const LinearStatics::Given& given, double r, double z, int unknown) {
    if (!given) return;
    if (const auto value = given(r, z)) {
      given_[unknown] = 1;
      u_[unknown] = *value;
    }
  }
  void hold(std::size_t node) {
    given_[2 * node + 1] = 1;
    u_[static_cast<Eigen::Index>(2 * node + 1)] = wall_[node];
  }

  void balance() {
    std::vector<int> place(size_, -1);
    int free = 0;
    for (int i = 0; i < size_; ++i)
      if (!given_[i]) {
        place[i] = free++;
        u_[i] = 0.0;
      }
    const Eigen::VectorXd load = stiffness_ * u_;
    Eigen::VectorXd right(free);
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& entry : body_.stiffness)
      if (place[entry.row()] >= place[entry.col()] && place[entry.col()] >= 0)
        entries.emplace_back(place[entry.row()], place[entry.col()], entry.value());
    for (int i = 0; i < size_; ++i)
      if (place[i] >= 0) right[place[i]] = -load[i];
    Matrix matrix(free, free);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver(matrix);
    if (solver.info() != Eigen::Success)
      throw Error(ExitCode::solver_failed, "a linear body's stiffness has no factors");
    const Eigen::VectorXd found = solver.solve(right);
    for (int i = 0; i < size_; ++i)
      if (place[i] >= 0) u_[i] = found[place[i]];
    force_ = stiffness_ * u_;
  }

  /// Whether the contact changed. A node on the axis has no weight and stays as it began.
  bool revise() {
    const double tiny = 1e-9 * force_.cwiseAbs().maxCoeff();
    const double slight = 1e-9 * u_.cwiseAbs().maxCoeff();
    bool changed = false;
    for (std::size_t node = 0; node < wall_.size(); ++node) {
      const auto axial = static_cast<Eigen::Index>(2 * node + 1);
      if (std::isnan(wall_[node]) || body_.position[node][0] == 0.0) continue;
      if (given_[axial] && force_[axial] > tiny) {
        given_[axial] = 0;
        changed = true;
      } else if (!given_[axial] && u_[axial] > wall_[node] + slight) {
        hold(node);
        changed = true;
      }
    }
    return changed;
  }

  LinearAnswer answer() const {
    LinearAnswer answer{.position = body_.position, .displacement = {}, .force = {}};
    for (int i = 0; i < size_; i += 2) {
      answer.displacement.push_back({u_[i], u_[i + 1]});
      answer.force.push_back({force_[i], force_[i + 1]});
    }
    return answer;
  }

  const LinearBody& body_;
  int size_;
  Matrix stiffness_;
  std::vector<char> given_;
  std::vector<double> wall_;
  Eigen::VectorXd u_, force_;
};

}  // namespace

LinearAnswer linear_statics(const Mesh& mesh, CellKind cells, const LinearStatics& problem) {
  const LinearBody body = linear_body(mesh, cells, problem.material);
  return StaticSearch(body, problem).solve();
}

}  // namespace rebound::fem
