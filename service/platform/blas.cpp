// SPDX-License-Identifier: MIT
#include "platform/blas.h"

#include <dlfcn.h>

namespace slipstitch {
namespace {

/// A function of the OpenBLAS that is loaded, or null. Looked up by name so that any other BLAS can be linked instead.
template <class Function>
Function* openblas_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

std::optional<std::string> best_blas_core() {
  __builtin_cpu_init();
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512cd");
  if (avx512) return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
  return std::nullopt;
}

std::vector<EnvironmentVariable> blas_environment(int threads) {
  std::vector<EnvironmentVariable> variables = {{"OPENBLAS_NUM_THREADS", std::to_string(threads)}};
  if (const auto core = best_blas_core()) variables.push_back({"OPENBLAS_CORETYPE", *core});
  return variables;
}

BlasInUse blas_in_use() {
  BlasInUse blas;
  if (auto* core_name = openblas_function<char*()>("openblas_get_corename")) blas.kernel = core_name();
  if (auto* num_threads = openblas_function<int()>("openblas_get_num_threads")) blas.threads = num_threads();
  return blas;
}

std::string to_string(const BlasInUse& blas) {
  if (blas.kernel.empty()) return "unknown BLAS";
  std::string text = "OpenBLAS " + blas.kernel;
  if (blas.threads) text += ", " + std::to_string(*blas.threads) + (*blas.threads == 1 ? " thread" : " threads");
  return text;
}

bool set_blas_threads(int threads) {
  auto* set_threads = openblas_function<void(int)>("openblas_set_num_threads");
  if (set_threads == nullptr) return false;
  set_threads(threads);
  return true;
}

}  // namespace slipstitch
