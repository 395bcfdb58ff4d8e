// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>

#include "formats/formats.h"
#include "formats/number_text.h"

// VTK XML PolyData, file version 1.0: arrays are raw bytes behind the XML, each led by its size as UInt64.

namespace slipstitch {
namespace {

static_assert(std::endian::native == std::endian::little);

class AppendedArrays {
 public:
  template <class T>
  std::string add(const char* type, const char* name, int components, const std::vector<T>& values) {
    std::string tag = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                      std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(bytes_.size()) +
                      "\"/>\n";
    const std::uint64_t size = values.size() * sizeof(T);
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    return tag;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::vector<double> flatten(const std::vector<Vec3>& points) {
  std::vector<double> values;
  values.reserve(3 * points.size());
  for (const Vec3& point : points) values.insert(values.end(), point.begin(), point.end());
  return values;
}

std::vector<std::int64_t> iota(std::size_t count) {
  std::vector<std::int64_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<std::int64_t>(i);
  return values;
}

std::vector<std::int32_t> yarn_of_points(const CurveFrame& frame) {
  std::vector<std::int32_t> yarns(frame.points.size());
  for (int yarn = 0; yarn < frame.num_yarns(); ++yarn) {
    const auto y = static_cast<std::size_t>(yarn);
    for (int point = frame.first[y]; point < frame.first[y + 1]; ++point) yarns[static_cast<std::size_t>(point)] = yarn;
  }
  return yarns;
}

std::string point_data(const CurveFrame& frame, AppendedArrays& arrays) {
  return "<PointData Scalars=\"tension_n\">\n" + arrays.add("Float64", "tension_n", 1, frame.tension_n) +
         arrays.add("Float64", "slid_m", 1, frame.slid_m) +
         arrays.add("Float64", "arc_length_m", 1, frame.arc_length_m) +
         arrays.add("Float64", "radius_m", 1, std::vector<double>(frame.points.size(), frame.radius_m)) +
         arrays.add("Int32", "yarn", 1, yarn_of_points(frame)) + "</PointData>\n";
}

std::string pvd_entry(const FrameFile& file) {
  std::string text = "<DataSet timestep=\"";
  append_number(text, file.t);
  return text + "\" part=\"0\" file=\"" + file.name + "\"/>\n";
}

}  // namespace

std::string write_vtp(const CurveFrame& frame) {
  AppendedArrays arrays;
  std::string time;
  append_number(time, frame.t);
  const std::vector<std::int64_t> ends(frame.first.begin() + 1, frame.first.end());
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<!-- slipstitch; unit: metre -->\n<PolyData>\n<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
      time + "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(frame.points.size()) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(frame.num_yarns()) +
      "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  text += point_data(frame, arrays);
  text += "<Points>\n" + arrays.add("Float64", "Points", 3, flatten(frame.points)) + "</Points>\n";
  text += "<Lines>\n" + arrays.add("Int64", "connectivity", 1, iota(frame.points.size())) +
          arrays.add("Int64", "offsets", 1, ends) + "</Lines>\n";
  text += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + arrays.bytes();
  return text + "\n</AppendedData>\n</VTKFile>\n";
}

const Collection kPvd{"frames.pvd",
                      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
                      "byte_order=\"LittleEndian\">\n<Collection>\n",
                      pvd_entry, "</Collection>\n</VTKFile>\n"};

}  // namespace slipstitch
