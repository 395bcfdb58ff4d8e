// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "math/types.h"

namespace slipstitch::golden {

using Json = nlohmann::json;

/// The cases of a file in tests/data, or in the folder named by the environment variable SLIPSTITCH_GOLDEN_DIR.
/// A missing, unreadable or empty file throws, which fails the test that asked.
Json load_cases(const std::string& file_name);

/// Those with "term" == term. None: throws.
Json cases_of_term(const std::string& term);

/// Fails for every listed category that no case has.
void expect_categories(const Json& cases, const std::vector<std::string>& categories);

template <int N>
Vec<N> vec(const Json& numbers) {
  const auto values = numbers.get<std::vector<double>>();
  if (values.size() != static_cast<std::size_t>(N)) throw std::runtime_error("wrong number of components");
  return Eigen::Map<const Vec<N>>(values.data());
}

template <int N>
Mat<N> mat(const Json& rows) {
  Mat<N> m;
  if (rows.size() != static_cast<std::size_t>(N)) throw std::runtime_error("wrong number of rows");
  for (int i = 0; i < N; ++i) m.row(i) = vec<N>(rows[static_cast<std::size_t>(i)]).transpose();
  return m;
}

/// |value - reference| <= tol.KEY |reference| + tol.KEY_abs, in the 2-norm (Frobenius for matrices).
template <class Value>
void expect_close(const Json& golden_case, const std::string& key, const Value& value, const Value& reference) {
  const Json& tolerance = golden_case.at("tol");
  const double allowed = tolerance.at(key).get<double>() * reference.norm() + tolerance.value(key + "_abs", 0.0);
  EXPECT_LE((value - reference).norm(), allowed) << golden_case.at("name") << " " << key;
}

inline void expect_close(const Json& golden_case, const std::string& key, double value) {
  expect_close(golden_case, key, Vec<1>(value), Vec<1>(golden_case.at(key).get<double>()));
}

}  // namespace slipstitch::golden
