// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace slipstitch::test {

/// Takes any bytes as requests, one after the other, through parser, router and reader of bodies, as a connection does,
/// and says what is wrong with the outcome, or that another request is read after one whose end is unclear; empty:
/// nothing. The fuzz target; it may be called from LLVMFuzzerTestOneInput as it is.
std::string request_flaw(std::string_view bytes);

/// The files of tests/rest/corpus, by name.
std::vector<std::string> request_corpus();

/// One to four edits: a piece of another request, a changed, a lost or a repeated byte.
std::string mutated_request(std::string text, const std::vector<std::string>& others, std::mt19937_64& random);

}  // namespace slipstitch::test
