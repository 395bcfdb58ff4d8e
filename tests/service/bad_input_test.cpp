// SPDX-License-Identifier: MIT
#include <grpcpp/impl/codegen/client_unary_call.h>

#include <cmath>
#include <functional>

#include "raw_message.h"
#include "service_fixture.h"
#include "support/resident_memory.h"

namespace slipstitch::test {
namespace {

// What is wrong with one field and how it is said.
struct Fault {
  std::string path, value, expected;
};

// One kind of bad input, in a scene file and in a request.
struct BadInput {
  std::string name;
  std::string file;  // text of the scene file
  std::vector<Fault> in_file;
  std::function<std::string()> request;  // bytes of the CreateSimJobRequest
  std::vector<Fault> in_request;
  grpc::StatusCode code = grpc::StatusCode::INVALID_ARGUMENT;
  std::string reason = "INVALID_SCENE";
};

void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.name; }

std::string yarn_file(const std::string& more) {
  return R"({"yarns": [{"points_m": [0, 0, 0, 0.1, 0, 0]}], "effects": {"stretch": {}})" + more + "}";
}

std::string chart_file(const std::string& rows) {
  return R"({"knit": {"chart": {"rows": )" + rows + R"(}, "gauge": {"yarn_per_stitch_m": 0.011}}})";
}

std::function<std::string()> request_with(const std::function<void(v1::CreateSimJobRequest&, v1::Scene&)>& spoil) {
  return [spoil] {
    v1::CreateSimJobRequest request;
    request.mutable_spec()->mutable_simulate();
    v1::Scene& scene = *request.mutable_spec()->mutable_scene();
    scene = swing(2, 1.0, 30.0, 1e-2);
    spoil(request, scene);
    return request.SerializeAsString();
  };
}

std::function<std::string()> chart_request(const std::vector<std::string>& rows) {
  return request_with([rows](v1::CreateSimJobRequest&, v1::Scene& scene) {
    scene.clear_yarns();
    scene.clear_handles();
    scene.mutable_knit()->mutable_chart()->mutable_rows()->Add(rows.begin(), rows.end());
    scene.mutable_knit()->mutable_gauge()->set_yarn_per_stitch_m(0.011);
  });
}

std::vector<BadInput> bad_inputs() {
  const std::string number = "a finite number > 0";
  return {
      {"malformed",
       R"({"name": "a", })",
       {{"name", "", "valid JSON"}},
       [] { return std::string("\x0a\xff{"); },
       {{"request", "other bytes", "a CreateSimJobRequest"}},
       grpc::StatusCode::INVALID_ARGUMENT,
       "INVALID_FIELD"},
      {"unknown_field",
       yarn_file(R"(, "yarn": {"radiu_m": 1})"),
       {{"yarn.radiu_m", "", "did you mean \"radius_m\"?"}},
       request_with([](v1::CreateSimJobRequest& request, v1::Scene& scene) {
         v1::YarnMaterial& yarn = *scene.mutable_yarn();
         yarn.GetReflection()->MutableUnknownFields(&yarn)->AddVarint(4711, 1);
         scene.GetReflection()->MutableUnknownFields(&scene)->AddVarint(4712, 1);
         request.GetReflection()->MutableUnknownFields(&request)->AddVarint(4713, 1);
       }),
       {{"", "unknown field number 4713", "the fields of slipstitch.v1.CreateSimJobRequest"},
        {"spec.scene", "unknown field number 4712", "fields of Scene"},
        {"spec.scene.yarn", "unknown field number 4711", "fields of YarnMaterial"}}},
      {"row_length",
       chart_file(R"(["KKK", "KK", "KKK"])"),
       {{"knit.chart.rows[1]", "2 stitches", "3"}},
       chart_request({"KKK", "KK", "KKK"}),
       {{"spec.scene.knit.chart.rows[1]", "2 stitches", "3"}}},
      {"unknown_stitch",
       chart_file(R"(["KXK", "KKK"])"),
       {{"knit.chart.rows[0]", "X in column 2", "K or P"}},
       chart_request({"KXK", "KKK"}),
       {{"spec.scene.knit.chart.rows[0]", "X in column 2", "K or P"}}},
      {"negative_radius",
       yarn_file(R"(, "yarn": {"radius_m": -0.001})"),
       {{"yarn.radius_m", "-0.001", number}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.mutable_yarn()->set_radius_m(-0.001); }),
       {{"spec.scene.yarn.radius_m", "-0.001", number}}},
      {"not_a_number",
       yarn_file(R"(, "yarn": {"radius_m": "NaN"})"),
       {{"yarn.radius_m", "\"NaN\"", "a finite number"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.mutable_yarn()->set_radius_m(NAN); }),
       {{"spec.scene.yarn.radius_m", "nan", number}}},
      {"bare_nan",
       yarn_file(R"(, "duration_s": NaN)"),
       {{"duration_s", "", "valid JSON"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.set_duration_s(NAN); }),
       {{"spec.scene.duration_s", "nan", "a finite number >= 0"}}},
      {"infinite",
       yarn_file(R"(, "duration_s": "Infinity")"),
       {{"duration_s", "\"Infinity\"", "a finite number"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.set_duration_s(INFINITY); }),
       {{"spec.scene.duration_s", "inf", "a finite number >= 0"}}},
      {"accuracy_of_nothing",
       yarn_file(R"(, "accuracy": {"tolerance_m": -0.001})"),
       {{"accuracy.tolerance_m", "-0.001", "a finite number >= 1e-09"}},
       request_with(
           [](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.mutable_accuracy()->set_tolerance_m(-0.001); }),
       {{"spec.scene.accuracy.tolerance_m", "-0.001", "a finite number >= 1e-09"}}},
      {"neither_tolerance_nor_budget",
       yarn_file(R"(, "accuracy": {})"),
       {{"accuracy", "empty", "either tolerance_m or budget_s"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.mutable_accuracy(); }),
       {{"spec.scene.accuracy", "empty", "either tolerance_m or budget_s"}}},
      {"budget_of_nothing",
       yarn_file(R"(, "accuracy": {"budget_s": 0})"),
       {{"accuracy.budget_s", "0", "a finite number > 0"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) { scene.mutable_accuracy()->set_budget_s(0.0); }),
       {{"spec.scene.accuracy.budget_s", "0", "a finite number > 0"}}},
      {"too_many_stitches",
       R"({"knit": {"preset": {"name": "stockinette", "courses": 30000, "wales": 30000},
          "gauge": {"yarn_per_stitch_m": 0.011}}})",
       {{"knit.preset", "900000000 stitches", "at most 250000 stitches"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) {
         scene.clear_yarns();
         scene.clear_handles();
         scene.mutable_knit()->mutable_gauge()->set_yarn_per_stitch_m(0.011);
         v1::Preset& preset = *scene.mutable_knit()->mutable_preset();
         preset.set_name("stockinette");
         preset.set_courses(30000);
         preset.set_wales(30000);
       }),
       {{"spec.scene.knit.preset", "900000000 stitches", "at most 250000 stitches"}},
       grpc::StatusCode::RESOURCE_EXHAUSTED,
       "SCENE_TOO_BIG"},
      {"too_many_frames",
       yarn_file(R"(, "duration_s": 1e200, "frames_per_s": 1e200)"),
       {{"frames_per_s", "too many frames", "at most 1000000 frames"}},
       request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) {
         scene.set_duration_s(1e200);
         scene.set_frames_per_s(1e200);
       }),
       {{"spec.scene.frames_per_s", "too many frames", "at most 1000000 frames"}},
       grpc::StatusCode::RESOURCE_EXHAUSTED,
       "SCENE_TOO_BIG"},
      {"several_at_once",
       yarn_file(R"(, "yarn": {"radius_m": -1}, "durationS": 2, "frames_per_s": 0)"),
       {{"yarn.radius_m", "-1", number}, {"durationS", "", "\"duration_s\""}, {"frames_per_s", "0", number}},
       request_with([](v1::CreateSimJobRequest& request, v1::Scene& scene) {
         scene.mutable_yarn()->set_radius_m(-1.0);
         scene.set_frames_per_s(0.0);
         scene.set_name("a\nb");
         request.set_request_id("a b");
         request.mutable_spec()->set_threads(5000);
         request.mutable_spec()->clear_work();
       }),
       {{"spec.work", "missing", "exactly one kind of work"},
        {"spec.scene.name", "a text with control characters", "printable characters"},
        {"spec.scene.yarn.radius_m", "-1", number},
        {"spec.scene.frames_per_s", "0", number},
        {"request_id", "a b", "at most 128"},
        {"spec.threads", "5000", "0 to 1024"}}},
  };
}

// Every file below a folder with its content.
std::map<std::string, std::string> content_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    content[entry.path()] = entry.is_regular_file() ? read_bytes(entry.path()) : "";
  }
  return content;
}

void expect_described(const std::string& text, const Fault& fault) {
  EXPECT_NE(text.find("is " + fault.value), std::string::npos) << fault.path << ": " << text;
  EXPECT_NE(text.find("expected "), std::string::npos) << fault.path << ": " << text;
  EXPECT_NE(text.find(fault.expected), std::string::npos) << fault.path << ": " << text;
}

// One line a fault, no other line that names a field.
void expect_told(const std::string& err, const std::vector<Fault>& faults) {
  std::istringstream lines(err);
  std::vector<std::string> told;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("expected ") != std::string::npos) told.push_back(line);
  }
  ASSERT_EQ(told.size(), faults.size()) << err;
  for (const Fault& fault : faults) {
    const auto line = std::find_if(told.begin(), told.end(),
                                   [&](const std::string& text) { return text.starts_with(fault.path + ": "); });
    ASSERT_NE(line, told.end()) << fault.path << " in\n" << err;
    expect_described(*line, fault);
  }
}

void expect_violations(const grpc::Status& status, const std::vector<Fault>& faults) {
  const Details details = details_of(status);
  ASSERT_EQ(details.bad_requests.size(), 1U);
  const auto& violations = details.bad_requests[0].field_violations();
  ASSERT_EQ(violations.size(), static_cast<int>(faults.size())) << details.bad_requests[0].DebugString();
  for (const Fault& fault : faults) {
    const auto found = std::find_if(violations.begin(), violations.end(),
                                    [&](const auto& violation) { return violation.field() == fault.path; });
    ASSERT_NE(found, violations.end()) << fault.path << " in\n" << details.bad_requests[0].DebugString();
    expect_described(found->description(), fault);
  }
}

class RawRequestTest : public ServiceTest {
 protected:
  void SetUp() override { start_server(); }

  grpc::Status create_raw(const std::string& request) {
    const grpc::internal::RpcMethod method("/slipstitch.v1.SimJobs/CreateSimJob",
                                           grpc::internal::RpcMethod::NORMAL_RPC);
    grpc::ClientContext context;
    grpc::ByteBuffer answer;
    return grpc::internal::BlockingUnaryCall<grpc::ByteBuffer, grpc::ByteBuffer>(channel_.get(), method, &context,
                                                                                 raw_message(request), &answer);
  }
};

// No row may change anything on disk, beside the scene file or in the server's data directory.
class BadInputTest : public RawRequestTest, public testing::WithParamInterface<BadInput> {};

TEST_P(BadInputTest, IsRefusedFromAFileByEveryCommand) {
  const BadInput& bad = GetParam();
  const std::string file = folder_ / "scene.json", program = SLIPSTITCH_BIN_DIR "/slipstitch";
  write_bytes(file, bad.file);
  const auto before = content_of(folder_.path());
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{program, "validate", file},
                                             {program, "simulate", file, "--out", folder_ / "out"},
                                             {program, "submit", file, "--server", server_->address()}}) {
    SCOPED_TRACE(command[1]);
    const Finished end = run_program(command);
    EXPECT_EQ(end.code, 2) << end.err;
    EXPECT_EQ(end.out, "");
    expect_told(end.err, bad.in_file);
  }
  EXPECT_EQ(content_of(folder_.path()), before);
}

TEST_P(BadInputTest, IsRefusedInARequest) {
  const BadInput& bad = GetParam();
  const auto before = content_of(folder_.path());
  const grpc::Status refused = create_raw(bad.request());
  expect_error(refused, bad.code, bad.reason);
  expect_violations(refused, bad.in_request);
  const auto metadata = details_of(refused).infos.at(0).metadata();
  EXPECT_EQ(metadata.contains("limit"), bad.reason == "SCENE_TOO_BIG");
  if (metadata.contains("limit")) {
    EXPECT_NE(bad.in_request[0].expected.find(" " + metadata.at("limit") + " "), std::string::npos);
  }
  EXPECT_TRUE(list_names().empty());
  EXPECT_EQ(content_of(folder_.path()), before);
}

// Each takes, or once took, much more memory than its bytes.
TEST_F(RawRequestTest, MemoryIsBounded) {
  const auto expect_refused = [&](const std::string& reason, const std::function<std::string()>& request) {
    const grpc::Status refused = create_raw(request());
    EXPECT_EQ(details_of(refused).infos.at(0).reason(), reason) << refused.error_message();
  };
  expect_refused("SCENE_TOO_BIG", chart_request({std::string(9'000'000, 'X'), std::string(7'000'000, 'Z')}));
  expect_refused("SCENE_TOO_BIG", chart_request(std::vector<std::string>(5'000'000)));
  expect_refused("SCENE_TOO_BIG", request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) {
                   for (int i = 0; i < 5'000'000; ++i) scene.add_yarns();
                 }));
  expect_refused("INVALID_SCENE", request_with([](v1::CreateSimJobRequest&, v1::Scene& scene) {
                   scene.set_name(std::string(16'000'000, '\n'));
                 }));
  EXPECT_LT(peak_bytes(server_->pid()), 400L << 20);
}

INSTANTIATE_TEST_SUITE_P(Table, BadInputTest, testing::ValuesIn(bad_inputs()),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace slipstitch::test
