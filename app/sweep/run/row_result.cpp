// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/row_result.h"

#include <fmt/format.h>

#include "app/json/json.h"

namespace sherd {
namespace {

std::string hash_text(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

std::uint64_t hash_of_text(const std::string& text) {
    return std::stoull(text, nullptr, 16);
}

}  // namespace

std::string to_line(const RowResult& result) {
    Json json{{"row", hash_text(result.identity)},
              {"program", hash_text(result.program)},
              {"exit", result.exit_code},
              {"wall_seconds", result.wall_seconds},
              {"cpu_seconds", result.processor_seconds},
              {"message", result.message},
              {"values", result.values},
              {"python", Json::object()}};
    for (const auto& [key, value] : result.python) json["python"][key] = value;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // the message may not be UTF-8
}

std::optional<RowResult> row_result(const std::string& line) try {
    const Json json = Json::parse(line);
    RowResult result;
    result.identity = hash_of_text(json.at("row"));
    result.program = hash_of_text(json.at("program"));
    json.at("exit").get_to(result.exit_code);
    json.at("wall_seconds").get_to(result.wall_seconds);
    json.at("cpu_seconds").get_to(result.processor_seconds);
    json.at("message").get_to(result.message);
    json.at("values").get_to(result.values);
    for (const auto& [key, value] : json.at("python").items()) result.python.emplace_back(key, value);
    return result;
} catch (const std::exception&) {
    return std::nullopt;
}

}  // namespace sherd
