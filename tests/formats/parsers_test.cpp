// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "formats/formats.h"
#include "support/parsers/curves.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

// The parsers against files written by hand, so that a shared misunderstanding with the writers would show.
TEST(Parsers, ObjByHand) {
  const auto file = parse_obj("# x\nv 1 2 3\nv 4e0 5 6.5\no a\nl 1 2\nl 2 1 2\n");
  ASSERT_TRUE(file);
  ASSERT_EQ(file->curves.size(), 2u);
  EXPECT_EQ(file->curves[1][0], (std::array<double, 3>{4, 5, 6.5}));
  EXPECT_EQ(parse_obj("v 5e-324 0 -0\nv 1 2 3\nl 1 2\n")->curves[0][0][0], 5e-324);
  EXPECT_FALSE(parse_obj("v 1 2\n"));
  EXPECT_FALSE(parse_obj("v 1 2 x\n"));
  EXPECT_FALSE(parse_obj("v 1 2 3\nl 1 2\n"));
  EXPECT_FALSE(parse_obj("v 1 2 3\nl 1\n"));
}

TEST(Parsers, BccByHand) {
  std::string bytes("BCC\x44PL\x03\x02\1\0\0\0\0\0\0\0\2\0\0\0\0\0\0\0", 24);
  bytes.resize(64, '\0');
  bytes += std::string("\2\0\0\0", 4) + std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0", 12);  // 1, 0, 0
  bytes += std::string("\0\0\0\x40\0\0\0\xc0\0\0\0\0", 12);                               // 2, -2, 0
  const auto file = parse_bcc(bytes);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->type, "PL");
  EXPECT_EQ(file->up, 2);
  ASSERT_EQ(file->curves.size(), 1u);
  EXPECT_EQ(file->curves[0][1], (std::array<float, 3>{2, -2, 0}));
  for (std::size_t kept = 0; kept < bytes.size(); ++kept) EXPECT_FALSE(parse_bcc(bytes.substr(0, kept)));
  EXPECT_FALSE(parse_bcc(bytes + "x"));
}

TEST(Parsers, VtpByHand) {
  const std::string head =
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt64\"><PolyData><FieldData>"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.5</DataArray>"
      "</FieldData><Piece NumberOfPoints=\"1\" NumberOfLines=\"1\"><PointData></PointData><Points>"
      "<DataArray type=\"Float64\" Name=\"Points\" format=\"appended\" offset=\"0\"/></Points><Lines>"
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"appended\" offset=\"32\"/>"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"appended\" offset=\"48\"/></Lines></Piece></PolyData>"
      "<AppendedData encoding=\"raw\">_";
  const std::string one("\0\0\0\0\0\0\xf0\x3f", 8), eight("\x8\0\0\0\0\0\0\0", 8), zero(8, '\0');
  const std::string arrays = std::string("\x18\0\0\0\0\0\0\0", 8) + one + zero + one + eight + zero + eight +
                             std::string("\1\0\0\0\0\0\0\0", 8);
  const auto file = parse_vtp(head + arrays);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->time, 0.5);
  ASSERT_EQ(file->curves.size(), 1u);
  EXPECT_EQ(file->curves[0][0], (std::array<double, 3>{1, 0, 1}));
  EXPECT_FALSE(parse_vtp(head + arrays.substr(0, arrays.size() - 1)));
  EXPECT_FALSE(parse_vtp(head));
}

}  // namespace
}  // namespace slipstitch::test
