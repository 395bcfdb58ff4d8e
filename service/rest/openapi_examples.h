// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "rest/operations.h"

namespace slipstitch::rest {

/// The job that examples speak of.
inline constexpr char kExampleId[] = "01jz3k8m9p0q1r2s";

/// A body that the operation takes; null: it takes none.
nlohmann::ordered_json request_example(Operation operation);

/// A body of 200 of that Content-Type, or the first part of one; null for bytes.
nlohmann::ordered_json response_example(Operation operation, std::string_view type);

/// An error of that reason, made as the server makes it. Throws std::invalid_argument for a reason that none has.
struct ErrorExample {
  unsigned status = 500;
  nlohmann::ordered_json body;
};
ErrorExample error_example(std::string_view reason);

}  // namespace slipstitch::rest
