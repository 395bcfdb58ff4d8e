// SPDX-License-Identifier: MIT
#include <grpcpp/impl/codegen/client_unary_call.h>

#include "raw_message.h"
#include "service_fixture.h"

namespace slipstitch::test {
namespace {

class SurfaceTest : public ServiceTest {
 protected:
  void SetUp() override { start_server(); }

  /// One message there, at most one back, whatever kind of method it is.
  grpc::Status call(const std::string& method, const std::string& request, std::string* response = nullptr) {
    const grpc::internal::RpcMethod rpc(method.c_str(), grpc::internal::RpcMethod::NORMAL_RPC);
    grpc::ClientContext context;
    grpc::ByteBuffer answer;
    const grpc::Status status = grpc::internal::BlockingUnaryCall<grpc::ByteBuffer, grpc::ByteBuffer>(
        channel_.get(), rpc, &context, raw_message(request), &answer);
    if (response != nullptr) *response = text_of(answer);
    return status;
  }
};

TEST_F(SurfaceTest, NoMethodOfTheSchemaIsUnimplemented) {
  int methods = 0;
  for (const auto* file : {v1::SimJob::descriptor()->file(), v1::StreamEnd::descriptor()->file()}) {
    for (int s = 0; s < file->service_count(); ++s) {
      for (int m = 0; m < file->service(s)->method_count(); ++m, ++methods) {
        const std::string name = "/" + file->service(s)->full_name() + "/" + file->service(s)->method(m)->name();
        EXPECT_NE(call(name, "").error_code(), grpc::StatusCode::UNIMPLEMENTED) << name;
      }
    }
  }
  EXPECT_EQ(methods, 9);
  EXPECT_EQ(call("/slipstitch.v1.SimJobs/NoSuchMethod", "").error_code(), grpc::StatusCode::UNIMPLEMENTED);
}

TEST_F(SurfaceTest, HealthKnowsItsServices) {
  for (const std::string service : {"", "slipstitch.v1.SimJobs", "slipstitch.v1.Frames"}) {
    // HealthCheckRequest.service is field 1.
    const std::string request =
        service.empty() ? "" : std::string("\x0a") + static_cast<char>(service.size()) + service;
    std::string response;
    EXPECT_TRUE(call("/grpc.health.v1.Health/Check", request, &response).ok()) << service;
    EXPECT_EQ(response, kServing) << service;
  }
}

TEST_F(SurfaceTest, ReflectionListsTheServices) {
  std::string response;
  // ServerReflectionRequest.list_services is field 7, of any text.
  EXPECT_TRUE(
      call("/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", std::string("\x3a\x00", 2), &response)
          .ok());
  for (const char* service : {"slipstitch.v1.SimJobs", "slipstitch.v1.Frames", "grpc.health.v1.Health"}) {
    EXPECT_NE(response.find(service), std::string::npos) << service;
  }
}

TEST(ServerCommandLine, NamesItsFlags) {
  const Finished help = run_program({kServer, "--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* flag :
       {"--grpc", "--http", "--viewer", "--http-timeout", "--http-connections", "--data-dir", "--slots", "--queue",
        "--max-scene-mib", "--stall-timeout", "--stop-grace", "--worker", "--stop-jobs"}) {
    EXPECT_NE(help.out.find(flag), std::string::npos) << flag;
  }
}

TEST(ServerCommandLine, RefusesNonsense) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{"--slots", "0"},
                                                                                         {"--queue", "-1"},
                                                                                         {"--max-scene-mib", "x"},
                                                                                         {"--grpc", "nowhere"},
                                                                                         {"--http", "nowhere"},
                                                                                         {"--http-timeout", "0"},
                                                                                         {"--http-connections", "0"},
                                                                                         {"--stall-timeout", "nan"},
                                                                                         {"--stop-grace", "-1"},
                                                                                         {"--nonsense"}}) {
    std::vector<std::string> all{kServer};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Finished finished = run_program(all);
    EXPECT_EQ(finished.code, 2) << arguments[0];
    EXPECT_NE(finished.err, "") << arguments[0];
  }
  const TemporaryFolder folder;
  const Finished no_worker =
      run_program({kServer, "--data-dir", folder.path().string(), "--worker", "/nonexistent/worker"});
  EXPECT_EQ(no_worker.code, 1);
  EXPECT_NE(no_worker.err.find("--worker"), std::string::npos);
}

TEST(ServerCommandLine, SaysItsVersion) {
  const Finished version = run_program({kServer, "--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_TRUE(version.out.starts_with("slipstitchd ")) << version.out;
}

}  // namespace
}  // namespace slipstitch::test
