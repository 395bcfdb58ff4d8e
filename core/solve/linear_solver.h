// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "solve/sparse_pattern.h"

namespace slipstitch {

enum class LinearStatus { ok, not_positive_definite, no_convergence, out_of_memory };

/// What a Cholesky factor takes.
struct FactorSize {
  double entries = 0.0;     // stored
  double operations = 0.0;  // floating-point, of one factorisation
};

/// Solves A x = b for symmetric positive definite A.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  /// Keeps the symbolic analysis while the pattern stays the same object.
  virtual LinearStatus factor(const SparseMatrix& a) = 0;
  /// With the last successful factorisation.
  virtual LinearStatus solve(const VecX& b, VecX& x) = 0;
  virtual std::string name() const = 0;
  /// By the last symbolic analysis; none before the first, or where nobody knows.
  virtual std::optional<FactorSize> factor_size() const { return std::nullopt; }
};

/// Sparse Cholesky of SuiteSparse's CHOLMOD; its dense kernels use the threads that BLAS was started with.
enum class Factorization { supernodal, simplicial };
#ifdef SLIPSTITCH_NO_SUPERNODAL
inline constexpr Factorization kDefaultFactorization = Factorization::simplicial;
#else
inline constexpr Factorization kDefaultFactorization = Factorization::supernodal;
#endif
std::unique_ptr<LinearSolver> make_cholmod_solver(Factorization factorization = kDefaultFactorization);

}  // namespace slipstitch
