// SPDX-License-Identifier: MIT
#include "rest/json_writer.h"

#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/rpc_status.h"
#include "slipstitch/v1/frames.pb.h"

namespace slipstitch::rest {
namespace {

std::string written(const google::protobuf::Message& message) {
  std::string text;
  append_json(message, text);
  return text;
}

// Protobuf's own reader finds the same message in it, and its own printer has the same members.
void expect_mapping(const google::protobuf::Message& message) {
  const std::string text = written(message);
  const std::unique_ptr<google::protobuf::Message> back(message.New());
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(text, back.get()).ok()) << text;
  EXPECT_EQ(back->DebugString(), message.DebugString());
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string printed;
  ASSERT_TRUE(google::protobuf::util::MessageToJsonString(message, &printed, options).ok());
  EXPECT_EQ(nlohmann::json::parse(text), nlohmann::json::parse(printed));
}

TEST(JsonWriter, WritesProtobufsMapping) {
  v1::SimJob job;
  expect_mapping(job);
  job.set_name("a\"\n\t\\\xc3\xa4</script>");
  job.set_state(v1::SimJob::FAILED);
  job.set_revision(18446744073709551615U);
  job.mutable_create_time()->set_seconds(1'700'000'000);
  job.mutable_create_time()->set_nanos(120'000'000);
  job.mutable_progress()->set_t(1.0 / 3.0);
  job.mutable_progress()->set_residual(1e-300);
  job.mutable_progress()->set_eta_s(0.0);
  *job.mutable_error() = rpc_status(jobs::Error{jobs::ErrorCode::resource_exhausted,
                                                "QUEUE_FULL",
                                                "full",
                                                {{"b", "2"}, {"a", "1"}},
                                                {{"spec.scene", "1", "2"}},
                                                2.5});
  expect_mapping(job);
}

TEST(JsonWriter, WritesListsAndWhatIsNotFinite) {
  v1::FrameHeader header;
  header.mutable_topology()->add_visit_node(-1);
  header.mutable_topology()->add_visit_slides(true);
  header.mutable_topology()->add_visit_slides(false);
  header.mutable_topology()->add_segment_kind(v1::Topology::CONTACT);
  header.mutable_topology()->add_stitches()->add_node(5);
  header.mutable_yarn()->set_radius_m(5e-324);
  expect_mapping(header);
  v1::JobProgress progress;
  progress.set_t(NAN);
  progress.set_residual(INFINITY);
  progress.set_wall_s(-INFINITY);
  EXPECT_NE(written(progress).find("\"t\":\"NaN\""), std::string::npos);
  EXPECT_NE(written(progress).find("\"residual\":\"Infinity\""), std::string::npos);
  EXPECT_NE(written(progress).find("\"wall_s\":\"-Infinity\""), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::rest
