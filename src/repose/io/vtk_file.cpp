// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/vtk_file.hpp"

#include "repose/io/hdf5_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <numeric>

namespace repose {

namespace {

static_assert(std::endian::native == std::endian::little, "the files say so");

/// The data behind the XML: each block with its size before it.
class Appended {
 public:
  template <class T>
  std::size_t add(const std::vector<T>& values) {
    const auto offset = bytes_.size();
    const std::uint64_t size = values.size() * sizeof(T);
    append(&size, sizeof size);
    append(values.data(), size);
    return offset;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

template <class T>
constexpr const char* type_name = "Float64";
template <>
constexpr const char* type_name<std::int64_t> = "Int64";
template <>
constexpr const char* type_name<std::uint8_t> = "UInt8";

template <class T>
std::string array_text(const std::string& name, std::size_t components, const std::vector<T>& values, Appended& data) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
      type_name<T>, name, components, data.add(values));
}

std::string arrays_text(const char* element, const std::vector<VtkArray>& arrays, Appended& data) {
  std::string text = fmt::format("<{}>\n", element);
  for (const auto& array : arrays) {
    text += std::visit([&](const auto& values) { return array_text(array.name, array.components, values, data); },
                       array.values);
  }
  return text + fmt::format("</{}>\n", element);
}

std::string cells_text(const char* element, const std::vector<std::int64_t>& connectivity, std::int64_t points_each,
                       Appended& data) {
  std::vector<std::int64_t> offsets;
  for (std::size_t k = 1; k * static_cast<std::size_t>(points_each) <= connectivity.size(); ++k) {
    offsets.push_back(static_cast<std::int64_t>(k) * points_each);
  }
  return fmt::format("<{}>\n", element) + array_text("connectivity", 1, connectivity, data) +
         array_text("offsets", 1, offsets, data) + fmt::format("</{}>\n", element);
}

}  // namespace

void write_vtp(const std::string& path, const VtkPolyData& data) {
  const auto points = data.points.size() / 3;
  std::vector<std::int64_t> vertices(data.vertices ? points : 0);
  std::iota(vertices.begin(), vertices.end(), 0);
  Appended appended;
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  text += fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      points, vertices.size(), data.lines.size() / 2);
  text += arrays_text("PointData", data.point_data, appended);
  text += arrays_text("CellData", data.cell_data, appended);
  text += "<Points>\n" + array_text("Points", 3, data.points, appended) + "</Points>\n";
  text += cells_text("Verts", vertices, 1, appended);
  text += cells_text("Lines", data.lines, 2, appended);
  text += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  write_text_file(path, text + appended.bytes() + "\n</AppendedData>\n</VTKFile>\n");
}

void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const auto& [time, file] : files) {
    text += fmt::format("<DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, file);
  }
  write_text_file(path, text + "</Collection>\n</VTKFile>\n");
}

}  // namespace repose
