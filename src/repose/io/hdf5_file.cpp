// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/hdf5_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_handle.hpp"
#include "repose/io/seal.hpp"
#include "repose/io/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

namespace repose {

namespace {

/// Values from which on a dataset is stored in compressed chunks of about that many rows.
constexpr std::size_t worth_compressing = 16384;

/// Properties of a new dataset, without the time of day: the same content gives the same file.
hid_t same_bits_layout() {
  const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(layout, false);
  return layout;
}

/// A unit in L, M and T as one in m, kg and s; words stay.
std::string in_si(std::string_view unit) {
  std::string text;
  const auto letter = [&](std::size_t k) {
    return k < unit.size() && std::isalpha(static_cast<unsigned char>(unit[k]));
  };
  for (std::size_t k = 0; k < unit.size(); ++k) {
    const bool alone = !letter(k + 1) && (k == 0 || !letter(k - 1));
    const auto found = std::string_view("LMT").find(unit[k]);
    if (alone && found != std::string_view::npos) {
      constexpr std::string_view si[] = {"m", "kg", "s"};
      text += si[found];
    } else {
      text += unit[k];
    }
  }
  return text;
}

/// Creates and writes an attribute; false on failure.
bool write_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type, hid_t space,
                     const void* value) {
  const Handle target(H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose);
  if (target.failed()) return false;
  const Handle attribute(H5Acreate2(target.id(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return !attribute.failed() && H5Awrite(attribute.id(), type, value) >= 0;
}

}  // namespace

Hdf5File::Hdf5File(std::string path, std::string units)
    : path_(std::move(path)), units_(std::move(units)), temporary_(path_ + ".tmp") {
  set_up_hdf5();
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(creation.id(), seal_size);
  file_ = H5Fcreate(temporary_.c_str(), H5F_ACC_TRUNC, creation.id(), H5P_DEFAULT);
  if (file_ < 0) fail();
}

Hdf5File::~Hdf5File() {
  if (file_ < 0) return;
  H5Fclose(file_);
  std::remove(temporary_.c_str());
}

void Hdf5File::fail() const { throw RunError(fmt::format("{}: cannot write: {}", path_, hdf5_reason())); }

void Hdf5File::group(const std::string& name) {
  if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0) return;
  const Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (group.failed()) fail();
  if (!units_.empty()) attribute(name, "units", units_);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, const std::string& value) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);  // h5py reads it as str, and text of fixed length as bytes
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const char* const characters = value.c_str();
  if (!write_attribute(file_, object, name, type.id(), space.id(), &characters)) fail();
}

void Hdf5File::attribute(const std::string& object, const std::string& name, std::int64_t value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  if (!write_attribute(file_, object, name, H5T_NATIVE_INT64, space.id(), &value)) fail();
}

void Hdf5File::attribute(const std::string& object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  if (!write_attribute(file_, object, name, H5T_NATIVE_DOUBLE, space.id(), &value)) fail();
}

void Hdf5File::attribute(const std::string& object, const std::string& name, const std::vector<double>& values) {
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  if (!write_attribute(file_, object, name, H5T_NATIVE_DOUBLE, space.id(), values.data())) fail();
}

template <class T>
void Hdf5File::dataset(const std::string& name, const std::vector<T>& values, std::size_t columns,
                       std::string_view unit, std::string_view meaning) {
  write(name, values, columns, columns == 1 ? 1 : 2, unit, meaning);
}

void Hdf5File::table(const std::string& name, const std::vector<double>& values, std::size_t columns,
                     std::string_view unit, std::string_view meaning) {
  write(name, values, columns, 2, unit, meaning);
}

void Hdf5File::create(const std::string& name, std::int64_t type, std::size_t rows, std::size_t columns, int rank) {
  const hsize_t shape[2] = {rows, columns};
  const Handle space(H5Screate_simple(rank, shape, nullptr), H5Sclose);
  const Handle layout(same_bits_layout(), H5Pclose);
  if (rows * columns >= worth_compressing) {
    const hsize_t chunk[2] = {std::min<hsize_t>(rows, worth_compressing), columns};
    H5Pset_chunk(layout.id(), rank, chunk);
    H5Pset_shuffle(layout.id());
    H5Pset_deflate(layout.id(), 4);
  }
  const Handle dataset(H5Dcreate2(file_, name.c_str(), type, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
                       H5Dclose);
  if (dataset.failed()) fail();
}

template <class T>
void Hdf5File::write(const std::string& name, const std::vector<T>& values, std::size_t columns, int rank,
                     std::string_view unit, std::string_view meaning) {
  const hsize_t rows = values.size() / columns;
  const auto all = expected_.value_or(rows);
  REPOSE_ASSERT(written_ + rows <= all);
  if (written_ == 0) create(name, native_type<T>(), all, columns, rank);
  if (rows > 0) {
    const hsize_t start[2] = {written_, 0};
    const hsize_t shape[2] = {rows, columns};
    const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (dataset.failed()) fail();
    const Handle block(H5Screate_simple(rank, shape, nullptr), H5Sclose);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, shape, nullptr);
    if (H5Dwrite(dataset.id(), native_type<T>(), block.id(), space.id(), H5P_DEFAULT, values.data()) < 0) fail();
  }
  written_ += rows;
  if (written_ < all) return;
  expected_.reset();
  written_ = 0;
  attribute(name, "unit", units_ == "SI" ? in_si(unit) : std::string(unit));
  attribute(name, "meaning", std::string(meaning));
}

template void Hdf5File::dataset(const std::string&, const std::vector<double>&, std::size_t, std::string_view,
                                std::string_view);
template void Hdf5File::dataset(const std::string&, const std::vector<float>&, std::size_t, std::string_view,
                                std::string_view);
template void Hdf5File::dataset(const std::string&, const std::vector<std::int64_t>&, std::size_t, std::string_view,
                                std::string_view);
template void Hdf5File::dataset(const std::string&, const std::vector<std::uint16_t>&, std::size_t, std::string_view,
                                std::string_view);
template void Hdf5File::dataset(const std::string&, const std::vector<std::uint8_t>&, std::size_t, std::string_view,
                                std::string_view);

void Hdf5File::bytes(const std::string& name, std::size_t item, std::size_t count, const void* data) {
  const hsize_t shape[2] = {count, item};
  const Handle space(H5Screate_simple(2, shape, nullptr), H5Sclose);
  const Handle layout(same_bits_layout(), H5Pclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  const Handle dataset(
      H5Dcreate2(file_, name.c_str(), H5T_NATIVE_UINT8, space.id(), links.id(), layout.id(), H5P_DEFAULT), H5Dclose);
  if (dataset.failed()) fail();
  if (count > 0 && H5Dwrite(dataset.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) fail();
}

void Hdf5File::texts(const std::string& name, const std::vector<std::string>& values, std::string_view meaning) {
  std::size_t longest = 1;
  for (const auto& value : values) longest = std::max(longest, value.size());
  std::vector<char> characters(values.size() * longest, '\0');
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::copy(values[k].begin(), values[k].end(), characters.begin() + static_cast<std::ptrdiff_t>(k * longest));
  }
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), longest);
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  const hsize_t size = values.size();
  {
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle layout(same_bits_layout(), H5Pclose);
    const Handle dataset(H5Dcreate2(file_, name.c_str(), type.id(), space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
                         H5Dclose);
    if (dataset.failed()) fail();
    if (size > 0 && H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, characters.data()) < 0) fail();
  }
  attribute(name, "meaning", std::string(meaning));
}

void Hdf5File::external_link(const std::string& name, const std::string& file, const std::string& object) {
  if (H5Lcreate_external(file.c_str(), object.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0) fail();
}

void Hdf5File::commit() {
  if (H5Fflush(file_, H5F_SCOPE_LOCAL) < 0) fail();
  if (H5Fclose(std::exchange(file_, -1)) < 0) {
    const std::string why = hdf5_reason();
    std::remove(temporary_.c_str());
    throw RunError(fmt::format("{}: cannot write: {}", path_, why));
  }
  try {
    seal(temporary_);
  } catch (const RunError&) {
    std::remove(temporary_.c_str());
    throw RunError(fmt::format("{}: cannot write its seal", path_));
  }
  publish(temporary_, path_);
}

void write_text_file(const std::string& path, const std::string& text) {
  WholeFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace repose
