// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slipstitch::test {

/// Curves read from a file. These parsers share no code with the writers; nothing comes back from a malformed file.
template <class Real>
struct Curves {
  std::vector<std::vector<std::array<Real, 3>>> curves;
};

/// `v x y z` and `l i j ...`; other keywords are passed over. One curve an `l`.
std::optional<Curves<double>> parse_obj(std::string_view text);

struct Bcc : Curves<float> {
  std::string type;  // two letters
  int up = 0;        // axis
  std::string info;
};
std::optional<Bcc> parse_bcc(std::string_view bytes);

struct Vtp : Curves<double> {
  double time = 0.0;
  std::map<std::string, std::vector<double>> point_data;  // by array name
  std::vector<std::vector<std::int64_t>> lines;           // point numbers of each line
};
std::optional<Vtp> parse_vtp(std::string_view bytes);

/// (timestep, file) of a .pvd.
std::optional<std::vector<std::pair<double, std::string>>> parse_pvd(std::string_view text);

}  // namespace slipstitch::test
