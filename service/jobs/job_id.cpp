// SPDX-License-Identifier: MIT
#include "jobs/job_id.h"

#include <algorithm>
#include <chrono>

namespace slipstitch::jobs {
namespace {

constexpr std::string_view kDigits = "0123456789abcdefghjkmnpqrstvwxyz";
constexpr std::size_t kTimeDigits = 10, kRandomDigits = 6;
constexpr std::string_view kTokenPrefix = "p1";

std::string base32(std::uint64_t value, std::size_t width) {
  std::string text(width, '0');
  for (std::size_t i = width; i-- > 0; value >>= 5) text[i] = kDigits[value & 31U];
  return text;
}

std::uint64_t from_base32(std::string_view text) {
  std::uint64_t value = 0;
  for (const char c : text) value = value << 5 | kDigits.find(c);
  return value;
}

std::uint64_t now_ms() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count());
}

}  // namespace

std::string JobIdMaker::next() {
  last_ms_ = std::max(now_ms(), last_ms_ + 1);
  return base32(last_ms_, kTimeDigits) + base32(random_(), kRandomDigits);
}

void JobIdMaker::keep_above(std::string_view id) {
  last_ms_ = std::max(last_ms_, from_base32(id.substr(0, kTimeDigits)));
}

bool is_job_id(std::string_view text) {
  return text.size() == kTimeDigits + kRandomDigits && text.find_first_not_of(kDigits) == std::string_view::npos;
}

std::string encode_page_token(const PageMark& mark) {
  return std::string(kTokenPrefix) + mark.list + std::string(mark.last_id.rbegin(), mark.last_id.rend());
}

std::optional<PageMark> decode_page_token(std::string_view token) {
  if (!token.starts_with(kTokenPrefix) || token.size() <= kTokenPrefix.size()) return {};
  const std::string_view reversed = token.substr(kTokenPrefix.size() + 1);
  PageMark mark{std::string(reversed.rbegin(), reversed.rend()), token[kTokenPrefix.size()]};
  return is_job_id(mark.last_id) ? std::optional(std::move(mark)) : std::nullopt;
}

}  // namespace slipstitch::jobs
