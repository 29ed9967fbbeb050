// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/write.hpp"

#include "repose/scene/keys.hpp"
#include "repose/scene/toml_text.hpp"

#include <fmt/format.h>

namespace repose {

namespace {

class Writer final : public Keys {
 public:
  bool given(const std::string&) const override { return true; }
  void number(const std::string& key, double& value, double, const Bounds&, std::string_view unit,
              std::string_view about) override {
    line(key, toml_number(value), unit, about);
  }
  void optional_number(const std::string& key, std::optional<double>& value, std::string_view none, const Bounds&,
                       std::string_view unit, std::string_view about) override {
    if (value) {
      line(key, toml_number(*value), unit, about);
    } else if (!none.empty()) {
      line(key, toml_quoted(none), unit, about);
    }
  }
  void integer(const std::string& key, std::int64_t& value, std::optional<std::int64_t>, std::int64_t,
               std::string_view about) override {
    line(key, fmt::format("{}", value), "", about);
  }
  void flag(const std::string& key, bool& value, bool, std::string_view about) override {
    line(key, value ? "true" : "false", "", about);
  }
  void text(const std::string& key, std::string& value, std::string_view, std::string_view about) override {
    line(key, toml_quoted(value), "", about);
  }
  void choice(const std::string& key, std::string& value, std::string_view, const std::vector<std::string>&,
              std::string_view about) override {
    line(key, toml_quoted(value), "", about);
  }
  void vector(const std::string& key, std::array<double, 2>& value, std::optional<std::array<double, 2>>,
              std::string_view unit, std::string_view about) override {
    line(key, fmt::format("[{}, {}]", toml_number(value[0]), toml_number(value[1])), unit, about);
  }
  void numbers(const std::string& key, std::vector<double>& values, std::string_view unit,
               std::string_view about) override {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + toml_number(value);
    line(key, fmt::format("[{}]", list), unit, about);
  }
  void one_of(const std::string& group, const std::vector<Parameters::Way>& ways, std::size_t& way, double& value,
              double) override {
    line(group + std::string(ways[way].name), toml_number(value), ways[way].unit, ways[way].about);
  }
  void tables(const std::string& key, const std::function<std::size_t(std::size_t)>& resize,
              const std::function<void(const std::string& prefix, std::size_t index)>& each) override {
    const auto count = resize(0);
    for (std::size_t k = 0; k < count; ++k) {
      out_ += fmt::format("\n[[{}]]\n", key);
      section_ = fmt::format("{}[{}]", key, k);
      each(section_ + ".", k);
    }
  }

  const std::string& out() const { return out_; }

 private:
  /// The header of a table inside the present entry of a list: TOML names no places there.
  static std::string without_places(std::string section) {
    for (auto open = section.find('['); open != std::string::npos; open = section.find('[')) {
      section.erase(open, section.find(']', open) - open + 1);
    }
    return section;
  }

  void line(const std::string& key, const std::string& value, std::string_view unit, std::string_view about) {
    const auto dot = key.rfind('.');
    const std::string section = dot == std::string::npos ? "" : key.substr(0, dot);
    if (section != section_) {
      section_ = section;
      out_ += fmt::format("\n[{}]\n", without_places(section));
    }
    const std::string name = dot == std::string::npos ? key : key.substr(dot + 1);
    out_ += fmt::format("{} = {}  # {}{}\n", name, value, unit.empty() ? "" : fmt::format("[{}] ", unit), about);
  }

  std::string out_;
  std::string section_;
};

}  // namespace

std::string scene_text(const Scene& scene) {
  Scene copy = scene;  // the walk is the reader's too and may write; on a complete scene it changes nothing
  Writer writer;
  go_through(copy, writer);
  return writer.out();
}

}  // namespace repose
