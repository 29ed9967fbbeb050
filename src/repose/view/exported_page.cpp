// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/exported_page.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"
#include "repose/io/whole_file.hpp"
#include "repose/record/record_file.hpp"
#include "repose/view/page.hpp"
#include "repose/view/run_answers.hpp"

#include <zlib.h>

#include <filesystem>
#include <string_view>

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

std::string deflated(const std::string& bytes) {
  auto size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  const auto status =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw RunError("the page cannot be packed: no memory");
  packed.resize(size);
  return packed;
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto byte = [&](std::size_t n) {
      return k + n < bytes.size() ? static_cast<unsigned char>(bytes[k + n]) : static_cast<unsigned char>(0);
    };
    const unsigned three = (unsigned{byte(0)} << 16U) | (unsigned{byte(1)} << 8U) | byte(2);
    for (unsigned n = 0; n < 4; ++n) {
      text += k + n <= bytes.size() ? digits[(three >> (18U - 6U * n)) & 63U] : '=';
    }
  }
  return text;
}

/// An answer as the page holds it: JSON as it is, arrays as packed text.
Json held(const Answer& answer) {
  if (answer.type == "application/json") return Json::parse(answer.body);
  return base64(deflated(answer.body));
}

}  // namespace

ExportedPage exported_page(const std::string& folder, bool frames) {
  refuse_spheres(folder, "a page");
  RunAnswers run(folder);
  auto keys = run.keys();
  if (!frames) keys = {"last"};
  Json data;
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  data["api/folder"] = {{"kind", "run"},
                        {"name", (path.has_filename() ? path : path.parent_path()).filename().string()},
                        {"repose_version", version}};
  for (const auto* address : {"run", "series", "base", "fields", "summary"}) {
    const auto answer = run.answer(address);
    if (answer.status == 200) data[std::string("api/") + address] = held(answer);
  }
  if (!data.contains("api/run")) throw InputError(run.answer("run").body);
  if (!frames) {
    auto& moments = data["api/run"]["frames"];
    moments = Json::array({moments.back()});
  }
  for (const auto& key : keys) data["api/frame/" + key] = base64(deflated(run.frame(key, Precision::packed)));
  return {page_with(data.dump()), keys.size()};
}

void export_page(const ExportOrder& order, const std::string& folder, Exported& done) {
  const auto page = exported_page(order.folder, order.frames);
  done.files = {"run.html"};
  done.moments = page.moments;
  WholeFile file(folder + "/" + done.files.front());
  file.print("{}", page.text);
  file.commit();
}

}  // namespace repose
