// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace repose {

/// The lines of a text file as UTF-8. The file may be packed by gzip, may be UTF-8 or UTF-16 with or without a byte
/// order mark, and its lines may end in LF, CR LF or CR. Memory holds one block of the file and one line. Validated by
/// tests/theory/table_test.cpp.
class TextLines {
 public:
  /// Throws InputError if the file cannot be read or is no text: with what it is, and what to do, if its first bytes
  /// tell.
  explicit TextLines(std::string path);
  ~TextLines();
  TextLines(const TextLines&) = delete;
  TextLines& operator=(const TextLines&) = delete;

  /// Reads the next line, without its end; false at the end of the file. Throws InputError if reading fails.
  bool next(std::string& line);
  std::size_t number() const { return number_; }  ///< of the line read last, from 1; 0 before the first
  void rewind();
  const std::string& path() const { return path_; }

 private:
  enum class Encoding { utf8, utf16_little, utf16_big };
  struct Packed;

  void begin();
  void refuse_other_files(std::string_view head) const;
  void fill();
  void decode_utf16(std::string_view bytes);
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::unique_ptr<Packed> file_;
  Encoding encoding_ = Encoding::utf8;
  std::string block_;      // decoded text
  std::size_t place_ = 0;  // in the block
  std::string undecoded_;  // bytes of a character that the next block completes
  bool end_ = false;
  bool after_return_ = false;  // the last line ended in CR: an LF that follows belongs to it
  std::size_t number_ = 0;
};

}  // namespace repose
