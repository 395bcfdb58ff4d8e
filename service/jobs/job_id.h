// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace slipstitch::jobs {

/// Makes ids that sort by time of creation: 10 digits of milliseconds since 1970, then 6 random ones, in Crockford's
/// base 32 in lower case. Strictly increasing, also after ids seen with keep_above() and when the clock is set back.
class JobIdMaker {
 public:
  std::string next();
  void keep_above(std::string_view id);

 private:
  std::uint64_t last_ms_ = 0;
  std::random_device random_;
};

bool is_job_id(std::string_view text);

/// Where a page of a list ended, and of which list. As opaque, URL-safe text.
struct PageMark {
  std::string last_id;
  char list = 'a';  // one character that names the filter
};
std::string encode_page_token(const PageMark& mark);
/// Empty when `token` was not made by encode_page_token.
std::optional<PageMark> decode_page_token(std::string_view token);

}  // namespace slipstitch::jobs
