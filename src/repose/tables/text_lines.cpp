// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/tables/text_lines.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>

namespace repose {

namespace {

constexpr std::size_t block_size = 1U << 16U;
constexpr std::size_t longest_line = 1U << 24U;

/// What a file is that begins with these bytes, and what to do.
struct OtherFile {
  std::string_view beginning;
  const char* what;
};
constexpr OtherFile other_files[] = {
    {"\x89HDF\r\n\x1a\n",
     "is an HDF5 file; the run.h5 of a run must keep its ending .h5, others must be written as text"},
    {"PK\x03\x04", "is a zip archive or a spreadsheet; unpack it, or save it as CSV"},
    {"BZh", "is packed by bzip2; unpack it, or pack it by gzip"},
    {"\xFD\x37zXZ", "is packed by xz; unpack it, or pack it by gzip"},
    {"\x28\xB5\x2F\xFD", "is packed by zstd; unpack it, or pack it by gzip"},
    {"\x93NUMPY", "is a NumPy array; write it with numpy.savetxt"},
    {"MATLAB 5.0 MAT-file", "is a MATLAB file; write a table with writetable"},
    {"PAR1", "is a Parquet file; write a CSV file"},
    {"%PDF", "is a PDF document, no table"},
};

bool has_control_bytes(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return c == '\0' || c == '\x1f' || c == '\x1a'; });
}

/// The number of NUL bytes at even or odd places of the text.
std::ptrdiff_t count_nul(std::string_view text, std::size_t first) {
  std::ptrdiff_t count = 0;
  for (std::size_t k = first; k < text.size(); k += 2) count += text[k] == '\0' ? 1 : 0;
  return count;
}

void append_utf8(std::uint32_t code, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80U) {
    add(code);
  } else if (code < 0x800U) {
    add(0xC0U | (code >> 6U));
    add(0x80U | (code & 0x3FU));
  } else if (code < 0x10000U) {
    add(0xE0U | (code >> 12U));
    add(0x80U | ((code >> 6U) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  } else {
    add(0xF0U | (code >> 18U));
    add(0x80U | ((code >> 12U) & 0x3FU));
    add(0x80U | ((code >> 6U) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
}

/// Whether the bytes that are not ASCII form characters of UTF-8: a lead byte and as many more as it says.
bool is_utf8(std::string_view text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (byte < 0x80U) continue;
    const std::size_t more = byte >= 0xF0U ? 3 : byte >= 0xE0U ? 2 : byte >= 0xC2U ? 1 : 0;
    if (more == 0 || byte > 0xF4U || k + more >= text.size()) return false;
    for (std::size_t next = 0; next < more; ++next) {
      if ((static_cast<unsigned char>(text[++k]) & 0xC0U) != 0x80U) return false;
    }
  }
  return true;
}

std::string from_latin1(std::string_view text) {
  std::string result;
  for (const char c : text) append_utf8(static_cast<unsigned char>(c), result);
  return result;
}

}  // namespace

/// zlib passes a file that is not packed through as it is.
struct TextLines::Packed {
  gzFile file;

  explicit Packed(const std::string& path) : file(::gzopen(path.c_str(), "rb")) {
    if (file != nullptr) ::gzbuffer(file, block_size);
  }
  ~Packed() {
    if (file != nullptr) ::gzclose(file);
  }
  Packed(const Packed&) = delete;
  Packed& operator=(const Packed&) = delete;
};

TextLines::TextLines(std::string path) : path_(std::move(path)), file_(std::make_unique<Packed>(path_)) {
  if (file_->file == nullptr) fail("cannot be read");
  begin();
}

TextLines::~TextLines() = default;

void TextLines::fail(const std::string& what) const { throw InputError(fmt::format("{}: {}", path_, what)); }

void TextLines::rewind() {
  if (::gzrewind(file_->file) != 0) fail("cannot be read again from its start");
  begin();
}

void TextLines::begin() {
  block_.clear();
  undecoded_.clear();
  place_ = 0;
  number_ = 0;
  end_ = after_return_ = false;
  encoding_ = Encoding::utf8;
  fill();
  constexpr std::size_t enough = 4096;
  auto head = std::string_view(block_).substr(0, enough);
  refuse_other_files(head);
  const auto most = static_cast<std::ptrdiff_t>(head.size() / 4);  // half of the bytes of plain letters in UTF-16
  const bool little = head.starts_with("\xFF\xFE") || (head.size() >= 4 && count_nul(head, 1) > most);
  const bool big = head.starts_with("\xFE\xFF") || (head.size() >= 4 && count_nul(head, 0) > most);
  if (little || big) {
    encoding_ = little ? Encoding::utf16_little : Encoding::utf16_big;
    const std::string bytes = std::move(block_);
    block_.clear();
    decode_utf16(bytes);
    head = std::string_view(block_).substr(0, enough);
  }
  if (head.starts_with("\xEF\xBB\xBF")) place_ = 3;
  if (has_control_bytes(head))
    fail(
        "is binary; must be text: a table of grains, or a file of another program that docs/"
        "reference/scene.md lists");
}

void TextLines::refuse_other_files(std::string_view head) const {
  for (const auto& other : other_files) {
    if (head.starts_with(other.beginning)) fail(other.what);
  }
}

/// Replaces the block by the next one.
void TextLines::fill() {
  block_.resize(block_size);
  place_ = 0;
  const int count = ::gzread(file_->file, block_.data(), static_cast<unsigned>(block_.size()));
  int error = Z_OK;
  const char* message = ::gzerror(file_->file, &error);
  if (count < 0 || (error != Z_OK && error != Z_STREAM_END)) {
    if (error == Z_ERRNO) fail("cannot be read");
    fail(error == Z_BUF_ERROR ? "is packed by gzip, and its end is missing"
                              : fmt::format("is packed by gzip and damaged: {}", message));
  }
  block_.resize(static_cast<std::size_t>(count));
  end_ = count == 0;
  if (encoding_ == Encoding::utf8) return;
  const std::string bytes = undecoded_ + block_;
  undecoded_.clear();
  block_.clear();
  decode_utf16(bytes);
}

void TextLines::decode_utf16(std::string_view bytes) {
  const bool little = encoding_ == Encoding::utf16_little;
  const auto unit = [&](std::size_t k) {
    const auto first = static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k]));
    const auto second = static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k + 1]));
    return little ? first | (second << 8U) : (first << 8U) | second;
  };
  std::size_t k = 0;
  while (k + 1 < bytes.size()) {
    std::uint32_t code = unit(k);
    const bool pair = code >= 0xD800U && code < 0xDC00U;
    if (pair && k + 3 >= bytes.size()) break;
    if (pair) {
      code = 0x10000U + ((code - 0xD800U) << 10U) + ((unit(k + 2) - 0xDC00U) & 0x3FFU);
      k += 2;
    }
    append_utf8(code, block_);
    k += 2;
  }
  undecoded_ = bytes.substr(k);
}

bool TextLines::next(std::string& line) {
  line.clear();
  bool any = false;
  while (true) {
    if (place_ == block_.size()) {
      if (!end_) fill();
      if (place_ == block_.size() && end_) break;
      continue;
    }
    if (after_return_ && block_[place_] == '\n') {
      after_return_ = false;
      ++place_;
      continue;
    }
    after_return_ = false;
    any = true;
    const auto begin = block_.begin() + static_cast<std::ptrdiff_t>(place_);
    const auto stop = std::find_if(begin, block_.end(), [](char c) { return c == '\n' || c == '\r'; });
    line.append(begin, stop);
    if (line.size() > longest_line) fail(fmt::format("line {} is longer than 16 MiB: is no table", number_ + 1));
    place_ = static_cast<std::size_t>(stop - block_.begin());
    if (stop == block_.end()) continue;
    after_return_ = *stop == '\r';
    ++place_;
    break;
  }
  if (any) ++number_;
  if (!is_utf8(line)) line = from_latin1(line);
  return any;
}

}  // namespace repose
