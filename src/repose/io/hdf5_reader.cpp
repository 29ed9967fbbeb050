// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/hdf5_reader.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_handle.hpp"
#include "repose/io/named_file.hpp"
#include "repose/io/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace repose {

Hdf5Reader::Hdf5Reader(std::string path, Sealing sealing) : path_(std::move(path)) {
  set_up_hdf5();
  std::error_code error;
  if (!std::filesystem::exists(path_, error)) throw InputError(fmt::format("{}: no such file", path_));
  if (const auto why = why_not_readable(path_); !why.empty()) throw InputError(fmt::format("{}: {}", path_, why));
  const bool unsealed = sealing == Sealing::optional && !is_sealed(path_);
  if (const auto broken = unsealed ? "" : broken_seal(path_); !broken.empty()) {
    throw InputError(fmt::format("{}: {}", path_, broken));
  }
  file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) throw InputError(fmt::format("{}: cannot be read: damaged, or not an HDF5 file", path_));
}

Hdf5Reader::~Hdf5Reader() {
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5Reader::fail(const std::string& object, const std::string& what) const {
  throw InputError(fmt::format("{}: {}: {}", path_, object, what));
}

bool Hdf5Reader::has(const std::string& name) const {
  // Every group of the path must exist before the next step is asked for.
  for (std::size_t end = 0; end != std::string::npos;) {
    end = name.find('/', end + 1);
    H5L_info_t link{};
    if (H5Lget_info(file_, name.substr(0, end).c_str(), &link, H5P_DEFAULT) < 0) return false;
    if (link.type != H5L_TYPE_HARD) return false;
  }
  return true;
}

namespace {

/// Text of variable length, as h5py writes it.
std::string variable_text(hid_t attribute, hid_t type) {
  char* characters = nullptr;
  if (H5Aread(attribute, type, &characters) < 0 || characters == nullptr) return "";
  std::string value(characters);
  H5free_memory(characters);
  return value;
}

}  // namespace

std::string Hdf5Reader::text(const std::string& object, const std::string& attribute) const {
  const Handle handle(H5Aopen_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (handle.failed()) fail(object, fmt::format("no attribute {}", attribute));
  const Handle type(H5Aget_type(handle.id()), H5Tclose);
  const Handle space(H5Aget_space(handle.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Sget_simple_extent_npoints(space.id()) != 1) {
    fail(object, fmt::format("attribute {} is not text", attribute));
  }
  if (H5Tis_variable_str(type.id()) > 0) return variable_text(handle.id(), type.id());
  constexpr std::size_t longest_attribute = 1U << 20;
  if (H5Tget_size(type.id()) > longest_attribute) fail(object, fmt::format("attribute {} is too long", attribute));
  std::string value(H5Tget_size(type.id()), '\0');
  if (H5Aread(handle.id(), type.id(), value.data()) < 0) {
    fail(object, fmt::format("attribute {} cannot be read", attribute));
  }
  return value.substr(0, value.find('\0'));
}

namespace {

/// Reads an attribute that is one value; false if it does not exist or has another shape or type.
template <class T>
bool read_attribute(hid_t file, const std::string& object, const std::string& attribute, T& value) {
  const Handle handle(H5Aopen_by_name(file, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (handle.failed()) return false;
  const Handle space(H5Aget_space(handle.id()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) return false;
  return H5Aread(handle.id(), native_type<T>(), &value) >= 0;
}

}  // namespace

double Hdf5Reader::number(const std::string& object, const std::string& attribute) const {
  double value = 0.0;
  if (!read_attribute(file_, object, attribute, value)) fail(object, fmt::format("no number {}", attribute));
  return value;
}

std::int64_t Hdf5Reader::integer(const std::string& object, const std::string& attribute) const {
  std::int64_t value = 0;
  if (!read_attribute(file_, object, attribute, value)) fail(object, fmt::format("no number {}", attribute));
  return value;
}

namespace {

/// Whether a dataset of `rows` times `row_size` bytes can be in its file: what is stored of it is all of it, and
/// compressed by no more than deflate can.
bool fits_its_content(hid_t dataset, hsize_t rows, hsize_t row_size) {
  constexpr hsize_t most_compression = 1100;
  const Handle layout(H5Dget_create_plist(dataset), H5Pclose);
  const bool chunked = !layout.failed() && H5Pget_layout(layout.id()) == H5D_CHUNKED;
  const hsize_t most = H5Dget_storage_size(dataset) * (chunked ? most_compression : 1);
  return row_size == 0 || rows <= most / row_size;
}

constexpr const char* larger_than_content = "is larger than its content: damaged";

}  // namespace

template <class T>
std::vector<T> Hdf5Reader::dataset(const std::string& name, std::size_t columns) const {
  return read<T>(name, columns, columns == 1 ? 1 : 2);
}

template <class T>
std::vector<T> Hdf5Reader::table(const std::string& name, std::size_t columns) const {
  return read<T>(name, columns, 2);
}

template <class T>
std::vector<T> Hdf5Reader::read(const std::string& name, std::size_t columns, int wanted) const {
  const Handle dataset(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (dataset.failed()) fail(name, "no such dataset");
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 2> shape{1, 1};
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank != wanted || H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr) < 0 || shape[1] != columns) {
    fail(name, wanted == 1 ? std::string("must have one dimension")
                           : fmt::format("must have two dimensions, with {} columns", columns));
  }
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (!fits_its_content(dataset.id(), shape[0], shape[1] * H5Tget_size(type.id()))) fail(name, larger_than_content);
  std::vector<T> values(shape[0] * shape[1]);
  if (!values.empty() && H5Dread(dataset.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail(name, "cannot be read: damaged, or of another type");
  }
  return values;
}

template std::vector<double> Hdf5Reader::table(const std::string&, std::size_t) const;
template std::vector<double> Hdf5Reader::dataset(const std::string&, std::size_t) const;
template std::vector<float> Hdf5Reader::dataset(const std::string&, std::size_t) const;
template std::vector<std::int64_t> Hdf5Reader::dataset(const std::string&, std::size_t) const;
template std::vector<std::uint16_t> Hdf5Reader::dataset(const std::string&, std::size_t) const;
template std::vector<std::uint8_t> Hdf5Reader::dataset(const std::string&, std::size_t) const;

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
  const Handle dataset(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (dataset.failed()) fail(name, "no such dataset");
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0) fail(name, "is not text");
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id()));
  const auto length = H5Tget_size(type.id());
  if (!fits_its_content(dataset.id(), count, length)) fail(name, larger_than_content);
  std::string characters(count * length, '\0');
  if (count > 0 && H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, characters.data()) < 0) {
    fail(name, "cannot be read");
  }
  std::vector<std::string> values;
  for (std::size_t k = 0; k < count; ++k) {
    const auto value = characters.substr(k * length, length);
    values.push_back(value.substr(0, value.find('\0')));
  }
  return values;
}

void Hdf5Reader::bytes(const std::string& name, std::size_t item,
                       const std::function<void*(std::size_t count)>& room) const {
  const Handle dataset(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (dataset.failed()) fail(name, "no such dataset");
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 2> shape{};
  const bool table =
      H5Sget_simple_extent_ndims(space.id()) == 2 && H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr) == 2;
  if (!table || shape[1] != item) fail(name, "of another size than expected");
  if (!fits_its_content(dataset.id(), shape[0], item)) fail(name, larger_than_content);
  void* data = room(shape[0]);
  if (data == nullptr && shape[0] > 0) fail(name, "of another size than expected");
  if (shape[0] > 0 && H5Dread(dataset.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
    fail(name, "cannot be read");
  }
}

std::vector<std::size_t> Hdf5Reader::shape(const std::string& name) const {
  const Handle dataset(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (dataset.failed()) return {};
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank <= 0 || H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr) < 0) return {};
  return {sizes.begin(), sizes.end()};
}

Hdf5Reader::Values Hdf5Reader::values(const std::string& name) const {
  const Handle dataset(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (dataset.failed()) fail(name, "no such dataset");
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id()));
  if (!fits_its_content(dataset.id(), count, H5Tget_size(type.id()))) fail(name, larger_than_content);
  const auto read_as = [&](auto kind) -> Values {
    using T = decltype(kind);
    std::vector<T> values(count);
    if (count > 0 && H5Dread(dataset.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
      fail(name, "cannot be read");
    }
    return values;
  };
  switch (H5Tget_class(type.id())) {
    case H5T_INTEGER:
      return read_as(std::int64_t{});
    case H5T_FLOAT:
      return H5Tget_size(type.id()) == sizeof(float) ? read_as(float{}) : read_as(double{});
    case H5T_STRING:
      return texts(name);
    default:
      fail(name, "is neither numbers nor text");
  }
}

std::vector<std::pair<std::string, std::string>> Hdf5Reader::attributes(const std::string& object) const {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Aiterate_by_name(file_, object.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names, H5P_DEFAULT) < 0) {
    fail(object, "no such object");
  }
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& name : names) {
    const Handle handle(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(handle.id()), H5Tclose);
    const Handle space(H5Aget_space(handle.id()), H5Sclose);
    if (H5Sget_simple_extent_npoints(space.id()) != 1) continue;
    switch (H5Tget_class(type.id())) {
      case H5T_INTEGER:
        found.emplace_back(name, fmt::format("{}", integer(object, name)));
        break;
      case H5T_FLOAT:
        found.emplace_back(name, fmt::format("{}", number(object, name)));
        break;
      case H5T_STRING:
        found.emplace_back(name, text(object, name));
        break;
      default:
        break;
    }
  }
  return found;
}

std::string Hdf5Reader::text_or(const std::string& object, const std::string& attribute,
                                const std::string& otherwise) const {
  if (H5Aexists_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT) <= 0) return otherwise;
  return text(object, attribute);
}

std::vector<std::string> Hdf5Reader::groups() const {
  std::vector<std::string> found;
  add_groups("", found);
  return found;
}

void Hdf5Reader::add_groups(const std::string& prefix, std::vector<std::string>& found) const {
  for (const auto& name : names_in(prefix.empty() ? "/" : prefix)) {
    const auto path = prefix + name;
    H5L_info_t link{};
    if (H5Lget_info(file_, path.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) continue;
    const Handle group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), H5Gclose);
    if (group.failed()) continue;
    found.push_back(path);
    add_groups(path + "/", found);
  }
}

std::vector<std::string> Hdf5Reader::names_in(const std::string& group) const {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Literate_by_name(file_, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names, H5P_DEFAULT) < 0) {
    fail(group, "no such group");
  }
  return names;
}

}  // namespace repose
