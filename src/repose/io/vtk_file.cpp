// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/vtk_file.hpp"

#include "repose/io/whole_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <numeric>
#include <string_view>

namespace repose {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are declared little-endian");

/// The data after the XML: blocks, each preceded by its size. It holds references to the arrays, which must outlive it.
class Appended {
 public:
  template <class T>
  std::uint64_t add(const std::vector<T>& values) {
    const auto offset = size_;
    blocks_.emplace_back(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    size_ += sizeof(std::uint64_t) + blocks_.back().size();
    return offset;
  }

  void write(WholeFile& file) const {
    for (const auto& block : blocks_) {
      const std::uint64_t size = block.size();
      file.write({reinterpret_cast<const char*>(&size), sizeof size});
      file.write(block);
    }
  }

 private:
  std::vector<std::string_view> blocks_;
  std::uint64_t size_ = 0;
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

/// The offsets of cells with `points_each` points: the end of each cell in the list of points.
std::vector<std::int64_t> ends(std::size_t cells, std::int64_t points_each) {
  std::vector<std::int64_t> offsets(cells);
  std::iota(offsets.begin(), offsets.end(), 1);
  for (auto& offset : offsets) offset *= points_each;
  return offsets;
}

}  // namespace

void write_vtp(const std::string& path, const VtkPolyData& data) {
  const auto points = data.points.size() / 3;
  std::vector<std::int64_t> vertices(data.vertices ? points : 0);
  std::iota(vertices.begin(), vertices.end(), 0);
  const auto vertex_ends = ends(vertices.size(), 1);
  const auto line_ends = ends(data.lines.size() / 2, 2);
  const auto triangle_ends = ends(data.triangles.size() / 3, 3);
  Appended appended;
  WholeFile file(path);
  file.print(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n");
  file.print(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      points, vertices.size(), line_ends.size(), triangle_ends.size());
  file.write(arrays_text("PointData", data.point_data, appended));
  file.write(arrays_text("CellData", data.cell_data, appended));
  file.write("<Points>\n" + array_text("Points", 3, data.points, appended) + "</Points>\n");
  const auto cells = [&](const char* element, const auto& connectivity, const auto& offsets) {
    file.write(fmt::format("<{}>\n", element) + array_text("connectivity", 1, connectivity, appended) +
               array_text("offsets", 1, offsets, appended) + fmt::format("</{}>\n", element));
  };
  cells("Verts", vertices, vertex_ends);
  cells("Lines", data.lines, line_ends);
  if (!data.triangles.empty()) cells("Polys", data.triangles, triangle_ends);
  file.write("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
  appended.write(file);
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

void write_vti(const std::string& path, const VtkGrid& grid) {
  Appended appended;
  WholeFile file(path);
  file.print(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<ImageData WholeExtent=\"0 {0} 0 {1} 0 0\" Origin=\"{2} {3} 0\" "
      "Spacing=\"{4} {4} {4}\">\n<Piece Extent=\"0 {0} 0 {1} 0 0\">\n",
      grid.columns, grid.rows, grid.x, grid.y, grid.cell);
  file.write(arrays_text("CellData", grid.cell_data, appended));
  file.write("</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_");
  appended.write(file);
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& files) {
  WholeFile file(path);
  file.print(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n");
  for (const auto& [time, name] : files) {
    file.print("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, name);
  }
  file.print("</Collection>\n</VTKFile>\n");
  file.commit();
}

}  // namespace repose
