// SPDX-License-Identifier: MIT
#include "grpc/message_values.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

namespace slipstitch {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::internal::WireFormatLite;

class Counter {
 public:
  Counter(long values, google::protobuf::io::CodedInputStream& in) : left_(values), in_(in) {}

  // False: too many, or bytes that are no message.
  bool count(const Descriptor& type) {
    while (const std::uint32_t tag = in_.ReadTag()) {
      const FieldDescriptor* field = type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
      const bool length = WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
      const bool message = length && field != nullptr && field->message_type() != nullptr;
      left_ -= message ? 10 : length ? 3 : 1;
      if (left_ < 0) return false;
      if (!(message ? enter(*field->message_type()) : WireFormatLite::SkipField(&in_, tag))) return false;
    }
    return true;
  }

  bool too_many() const { return left_ < 0; }

 private:
  bool enter(const Descriptor& type) {
    const auto [limit, depth] = in_.IncrementRecursionDepthAndPushLimit(size());
    if (depth < 0 || !count(type)) return false;
    return in_.DecrementRecursionDepthAndPopLimit(limit);
  }

  int size() {
    int bytes = 0;
    return in_.ReadVarintSizeAsInt(&bytes) ? bytes : 0;
  }

  long left_;
  google::protobuf::io::CodedInputStream& in_;
};

}  // namespace

bool holds_at_most(long values, const Descriptor& type, google::protobuf::io::ZeroCopyInputStream& bytes) {
  google::protobuf::io::CodedInputStream in(&bytes);
  Counter counter(values, in);
  counter.count(type);
  return !counter.too_many();
}

}  // namespace slipstitch
