// SPDX-License-Identifier: MIT
#include "platform/version.h"

#include "platform/blas.h"

namespace slipstitch {

std::string version_string() { return SLIPSTITCH_VERSION; }

std::string version_line(const std::string& program) {
  return program + " " + version_string() + " (" + to_string(blas_in_use()) + ")";
}

}  // namespace slipstitch
