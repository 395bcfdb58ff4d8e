// SPDX-License-Identifier: MIT
// request_fuzz [MUTATIONS [SEED]]: so many mutations of every file of the corpus; the first with a flaw is printed.
#include <iostream>

#include "request_fuzz.h"

int main(int argc, char** argv) {
  using namespace slipstitch::test;
  const int mutations = argc > 1 ? std::stoi(argv[1]) : 10'000;
  std::mt19937_64 random(argc > 2 ? std::stoull(argv[2]) : 1);
  const std::vector<std::string> requests = request_corpus();
  for (const std::string& request : requests) {
    for (int i = 0; i < mutations; ++i) {
      const std::string text = mutated_request(request, requests, random);
      if (const std::string flaw = request_flaw(text); !flaw.empty()) {
        std::cout << flaw << "\n--- of\n" << text;
        return 1;
      }
    }
  }
  std::cout << requests.size() * static_cast<std::size_t>(mutations) << " requests, none with a flaw\n";
  return 0;
}
