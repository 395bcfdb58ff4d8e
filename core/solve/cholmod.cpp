// SPDX-License-Identifier: MIT
// The one file that knows CHOLMOD.
#include <cholmod.h>
#include <omp.h>

#include "solve/linear_solver.h"

namespace slipstitch {
namespace {

/// CHOLMOD splits every small loop of a factorisation over four OpenMP threads, whatever OMP_NUM_THREADS says, and waking
/// them costs four times the arithmetic (40 x 40 loops, two cores: 0.39 s against 0.09 s). While this lives, parallel
/// regions that the calling thread opens run on it alone. BLAS's own threads are not OpenMP's and stay as they are.
class SingleOpenMpThread {
 public:
  SingleOpenMpThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  SingleOpenMpThread(const SingleOpenMpThread&) = delete;
  SingleOpenMpThread& operator=(const SingleOpenMpThread&) = delete;
  ~SingleOpenMpThread() { omp_set_max_active_levels(levels_); }

 private:
  int levels_;
};

constexpr double kMoreOperations = 1.2;  // that an order found for another pattern may take

class CholmodSolver final : public LinearSolver {
 public:
  explicit CholmodSolver(Factorization factorization) : factorization_(factorization) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.quick_return_if_not_posdef = 1;
    // On sheets of yarn nested dissection takes 2.3 times fewer operations than the minimum degree that CHOLMOD would
    // settle for (40 x 40 loops: 1.4e9 against 3.2e9).
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_METIS;
    common_.postorder = 1;
    common_.supernodal = factorization == Factorization::supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    if (factorization == Factorization::simplicial) common_.final_ll = 1;
  }
  CholmodSolver(const CholmodSolver&) = delete;
  CholmodSolver& operator=(const CholmodSolver&) = delete;
  ~CholmodSolver() override {
    free_factor();
    cholmod_free_dense(&x_, &common_);
    cholmod_free_dense(&y_, &common_);
    cholmod_free_dense(&e_, &common_);
    cholmod_finish(&common_);
  }

  LinearStatus factor(const SparseMatrix& a) override {
    const SingleOpenMpThread alone;
    cholmod_sparse view = sparse_view(a);
    if (factor_ == nullptr || analysed_ != a.pattern) {
      analyse(view);
      if (factor_ == nullptr) return LinearStatus::out_of_memory;
      analysed_ = a.pattern;
    }
    cholmod_factorize(&view, factor_, &common_);
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) return LinearStatus::out_of_memory;
    const bool definite = common_.status == CHOLMOD_OK && factor_->minor == factor_->n;
    return definite ? LinearStatus::ok : LinearStatus::not_positive_definite;
  }

  LinearStatus solve(const VecX& b, VecX& x) override {
    const SingleOpenMpThread alone;
    cholmod_dense rhs{};
    rhs.nrow = static_cast<std::size_t>(b.size());
    rhs.ncol = 1;
    rhs.nzmax = rhs.nrow;
    rhs.d = rhs.nrow;
    rhs.x = const_cast<double*>(b.data());
    rhs.xtype = CHOLMOD_REAL;
    rhs.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, factor_, &rhs, nullptr, &x_, nullptr, &y_, &e_, &common_))
      return LinearStatus::out_of_memory;
    x = Eigen::Map<const VecX>(static_cast<const double*>(x_->x), b.size());
    return x.allFinite() ? LinearStatus::ok : LinearStatus::not_positive_definite;
  }

  std::optional<FactorSize> factor_size() const override {
    if (factor_ == nullptr) return std::nullopt;
    const double entries = factor_->is_super ? static_cast<double>(factor_->xsize) : common_.lnz;
    return FactorSize{entries, common_.fl};
  }

  std::string name() const override {
    return factorization_ == Factorization::supernodal ? "cholmod supernodal" : "cholmod simplicial";
  }

 private:
  void free_factor() {
    if (factor_ != nullptr) cholmod_free_factor(&factor_, &common_);
  }

  /// A pattern that is much like the one before, as where yarn has come near other yarn, keeps its order of elimination
  /// while that takes few more operations: finding one costs as much as a factorisation.
  void analyse(cholmod_sparse& view) {
    free_factor();
    if (order_.size() == view.nrow) {
      common_.method[0].ordering = CHOLMOD_GIVEN;
      factor_ = cholmod_analyze_p(&view, order_.data(), nullptr, 0, &common_);
      common_.method[0].ordering = CHOLMOD_METIS;
      if (factor_ == nullptr || common_.fl <= kMoreOperations * operations_) return;
      free_factor();
    }
    factor_ = cholmod_analyze(&view, &common_);
    if (factor_ == nullptr) return;
    const auto* order = static_cast<const int*>(factor_->Perm);
    order_.assign(order, order + factor_->n);
    operations_ = common_.fl;
  }

  static cholmod_sparse sparse_view(const SparseMatrix& a) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(a.pattern->n);
    view.nzmax = a.pattern->row.size();
    view.p = const_cast<int*>(a.pattern->column_first.data());
    view.i = const_cast<int*>(a.pattern->row.data());
    view.x = const_cast<double*>(a.values.data());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
  }

  Factorization factorization_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *x_ = nullptr, *y_ = nullptr, *e_ = nullptr;  // workspaces kept between solves
  std::shared_ptr<const SparsePattern> analysed_;
  std::vector<int> order_;    // of elimination, last found; empty: none yet
  double operations_ = 0.0;   // of a factorisation when it was found
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod_solver(Factorization factorization) {
  return std::make_unique<CholmodSolver>(factorization);
}

}  // namespace slipstitch
