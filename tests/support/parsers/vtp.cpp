// SPDX-License-Identifier: MIT
#include <charconv>
#include <cstdint>
#include <cstring>
#include <regex>

#include "support/parsers/curves.h"

namespace slipstitch::test {
namespace {

std::optional<std::string> attribute(const std::string& tag, const std::string& name) {
  std::smatch match;
  if (!std::regex_search(tag, match, std::regex("[ \\n]" + name + "=\"([^\"]*)\""))) return std::nullopt;
  return match[1].str();
}

// The text between <name ...> and </name>, and the opening tag itself.
struct Element {
  std::string tag, inside;
};
std::optional<Element> element(const std::string& xml, const std::string& name) {
  const std::size_t begin = xml.find("<" + name);
  const std::size_t tag_end = xml.find('>', begin);
  const std::size_t end = xml.find("</" + name + ">", begin);
  if (begin == std::string::npos || tag_end == std::string::npos || end == std::string::npos) return std::nullopt;
  return Element{xml.substr(begin, tag_end - begin), xml.substr(tag_end + 1, end - tag_end - 1)};
}

template <class T>
std::vector<double> numbers(std::string_view bytes) {
  std::vector<T> raw(bytes.size() / sizeof(T));
  std::memcpy(raw.data(), bytes.data(), raw.size() * sizeof(T));
  return {raw.begin(), raw.end()};
}

// Every <DataArray .../> of a section, by name.
using Arrays = std::map<std::string, std::vector<double>>;
std::optional<Arrays> read_arrays(const std::string& section, std::string_view appended) {
  Arrays arrays;
  const std::regex tag_pattern("<DataArray[^>]*>");
  for (std::sregex_iterator tag(section.begin(), section.end(), tag_pattern), end; tag != end; ++tag) {
    const std::string text = tag->str();
    const auto type = attribute(text, "type"), name = attribute(text, "Name"), offset = attribute(text, "offset");
    if (!type || !name || !offset || attribute(text, "format") != "appended") return std::nullopt;
    const std::size_t at = std::stoull(*offset);
    std::uint64_t size = 0;
    if (at + sizeof size > appended.size()) return std::nullopt;
    std::memcpy(&size, appended.data() + at, sizeof size);
    if (size > appended.size() - at - sizeof size) return std::nullopt;
    const std::string_view bytes = appended.substr(at + sizeof size, size);
    if (*type == "Float64") arrays[*name] = numbers<double>(bytes);
    if (*type == "Int64") arrays[*name] = numbers<std::int64_t>(bytes);
    if (*type == "Int32") arrays[*name] = numbers<std::int32_t>(bytes);
  }
  return arrays;
}

bool read_lines(const Arrays& arrays, const std::vector<double>& points, Vtp& result) {
  if (!arrays.contains("connectivity") || !arrays.contains("offsets")) return false;
  const auto& connectivity = arrays.at("connectivity");
  std::size_t begin = 0;
  for (const double offset : arrays.at("offsets")) {
    const auto end = static_cast<std::size_t>(offset);
    if (end < begin || end > connectivity.size()) return false;
    auto& line = result.lines.emplace_back();
    auto& curve = result.curves.emplace_back();
    for (; begin < end; ++begin) {
      const auto point = static_cast<std::size_t>(connectivity[begin]);
      if (3 * point + 2 >= points.size()) return false;
      line.push_back(static_cast<std::int64_t>(point));
      curve.push_back({points[3 * point], points[3 * point + 1], points[3 * point + 2]});
    }
  }
  return begin == connectivity.size();
}

}  // namespace

std::optional<Vtp> parse_vtp(std::string_view bytes) {
  const std::string opening = "<AppendedData encoding=\"raw\">";
  const std::size_t appended_tag = bytes.find(opening);
  if (appended_tag == std::string_view::npos) return std::nullopt;
  const std::size_t underscore = bytes.find('_', appended_tag + opening.size());
  if (underscore == std::string_view::npos) return std::nullopt;
  const std::string_view appended = bytes.substr(underscore + 1);
  const std::string xml(bytes.substr(0, appended_tag));
  const auto piece = element(xml, "Piece"), point_data = element(xml, "PointData"), field = element(xml, "FieldData");
  const auto points = element(xml, "Points"), lines = element(xml, "Lines");
  if (!piece || !point_data || !points || !lines || !field) return std::nullopt;
  if (xml.find("header_type=\"UInt64\"") == std::string::npos || xml.find("LittleEndian") == std::string::npos) {
    return std::nullopt;
  }
  Vtp result;
  const auto time = element(field->inside, "DataArray");
  if (!time || attribute(time->tag, "Name") != "TimeValue") return std::nullopt;
  const char* const time_end = time->inside.data() + time->inside.size();
  const auto [end, error] = std::from_chars(time->inside.data(), time_end, result.time);
  if (error != std::errc() || end != time_end) return std::nullopt;
  const auto data = read_arrays(point_data->inside, appended);
  const auto coordinates = read_arrays(points->inside, appended);
  const auto cells = read_arrays(lines->inside, appended);
  if (!data || !coordinates || coordinates->size() != 1 || !cells) return std::nullopt;
  result.point_data = *data;
  const std::vector<double>& xyz = coordinates->begin()->second;
  const bool counted = attribute(piece->tag, "NumberOfPoints") == std::to_string(xyz.size() / 3) &&
                       read_lines(*cells, xyz, result) &&
                       attribute(piece->tag, "NumberOfLines") == std::to_string(result.lines.size());
  if (!counted) return std::nullopt;
  return result;
}

std::optional<std::vector<std::pair<double, std::string>>> parse_pvd(std::string_view text) {
  const std::string xml(text), open = "<Collection>", close = "</Collection>";
  const std::size_t begin = xml.find(open), end = xml.find(close);
  if (begin == std::string::npos || end == std::string::npos || end < begin) return std::nullopt;
  const std::string head = xml.substr(0, begin), inside = xml.substr(begin + open.size(), end - begin - open.size());
  const std::regex head_pattern("<\\?xml version=\"1.0\"\\?>\\s*<VTKFile type=\"Collection\"[^>]*>\\s*");
  const std::regex foot_pattern("\\s*</VTKFile>\\s*"), tag_pattern("<DataSet[^>]*/>"), blank_pattern("\\s*");
  if (!std::regex_match(head, head_pattern)) return std::nullopt;
  if (!std::regex_match(xml.substr(end + close.size()), foot_pattern)) return std::nullopt;
  if (!std::regex_match(std::regex_replace(inside, tag_pattern, ""), blank_pattern)) return std::nullopt;
  std::vector<std::pair<double, std::string>> files;
  for (std::sregex_iterator tag(inside.begin(), inside.end(), tag_pattern), last; tag != last; ++tag) {
    const auto time = attribute(tag->str(), "timestep"), file = attribute(tag->str(), "file");
    if (!time || !file) return std::nullopt;
    files.emplace_back(std::stod(*time), *file);
  }
  return files;
}

}  // namespace slipstitch::test
