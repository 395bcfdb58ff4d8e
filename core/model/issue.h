// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace slipstitch {

/// One thing wrong with the user's input. `path` uses the schema's spelling, e.g. "yarn.radius_m",
/// "knit.chart.rows[3]".
struct Issue {
  std::string path;
  std::string value;         // the offending value as text
  std::string expected;      // what would have been right
  bool too_big = false;      // over a stated limit rather than malformed
  int line = 0, column = 0;  // in the scene file, 1-based; 0: not known
  long limit = 0;            // how many there may be; only where too_big
  bool unlisted = false;     // stands for all that are not listed
};

/// Problems listed of one input; a last one says that there are more.
inline constexpr std::size_t kMaxIssues = 100;

/// At most `longest` bytes of UTF-8, then "..." if there was more.
std::string shortened(const std::string& text, std::size_t longest);

/// Problems in the order found. Input of any size makes no more than kMaxIssues and the one that stands for the rest,
/// each with texts of a few hundred bytes.
class Issues {
 public:
  Issues() = default;
  Issues(std::initializer_list<Issue> issues);

  /// Shortens the texts; does nothing once full.
  void push_back(Issue issue);

  /// What is found from now on is not listed, so nobody need look for it.
  bool full() const { return !list_.empty() && list_.back().unlisted; }
  /// Whether any problem, listed or not, is one of size.
  bool any_too_big() const { return any_too_big_; }

  bool empty() const { return list_.empty(); }
  std::size_t size() const { return list_.size(); }
  auto begin() { return list_.begin(); }
  auto begin() const { return list_.begin(); }
  auto end() { return list_.end(); }
  auto end() const { return list_.end(); }
  const Issue& operator[](std::size_t i) const { return list_[i]; }
  const Issue& front() const { return list_.front(); }
  const Issue& back() const { return list_.back(); }

 private:
  std::vector<Issue> list_;
  bool any_too_big_ = false;
};

}  // namespace slipstitch
