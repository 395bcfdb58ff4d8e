// SPDX-License-Identifier: MIT
#include "cli/remote/address.h"

#include <gtest/gtest.h>

namespace slipstitch::test {
namespace {

TEST(Address, IsHostAndPort) {
  for (const char* good :
       {"127.0.0.1:50651", "localhost:1", "server.example:65535", "[::1]:50651", "unix:/run/s.sock"}) {
    EXPECT_TRUE(valid_address(good)) << good;
  }
  for (const char* bad : {"", "localhost", ":50651", "localhost:", "localhost:0", "localhost:65536", "localhost:5o651",
                          "http://localhost:50651", "::1:50651", "a b:1", "user@host:1", "unix:"}) {
    EXPECT_FALSE(valid_address(bad)) << bad;
  }
}

TEST(Address, KnowsThisMachine) {
  for (const char* here : {"127.0.0.1:1", "127.9.9.9:1", "localhost:1", "[::1]:1", "unix:/x"}) {
    EXPECT_TRUE(is_loopback(here)) << here;
  }
  for (const char* away : {"10.0.0.1:1", "localhost.example:1", "128.0.0.1:1", "[::2]:1"}) {
    EXPECT_FALSE(is_loopback(away)) << away;
  }
}

}  // namespace
}  // namespace slipstitch::test
