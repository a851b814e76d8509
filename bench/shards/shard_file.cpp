// SPDX-License-Identifier: MIT
#include "shards/shard_file.hpp"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <sspql/core/line_reader.hpp>
#include <sspql/io/crc32.hpp>

namespace sspql::shards {

namespace {

constexpr const char* format_name = "sspql shard";
constexpr const char* ending = "\n}\n";

std::string checksum_of(const char* data, std::size_t size) {
    detail::Crc32 crc;
    crc.add(data, size);
    std::string text;
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[(crc.value() >> shift) & 0xFu];
    return text;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// The first line as an object, or null if it is none of ours.
Json first_line(const std::string& text) {
    constexpr std::size_t longest = 200;
    const std::size_t end = text.find('\n');
    if (end == std::string::npos || end > longest) return nullptr;
    Json line = Json::parse(text.substr(0, end) + "null}", nullptr, false);
    return line.is_object() && line.contains("format") && line["format"] == format_name ? line : Json(nullptr);
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw std::runtime_error(name + ": " + what);
}

/// The second line, found to be whole.
std::string_view content_text(const std::string& text, const std::string& name) {
    const Json line = first_line(text);
    if (line.is_null()) {
        refuse(name,
               text.empty() ? "the file is empty" : "not a shard file: those are what --shard i/n writes with --out");
    }
    const int version = field<int>(line, "format_version");
    if (version != format_version) {
        refuse(name, "shard format " + std::to_string(version) + ", this merge_results reads format " +
                         std::to_string(format_version));
    }
    const std::size_t begin = text.find('\n') + 1;
    const std::size_t whole = begin + field<std::size_t>(line, "bytes") + std::string(ending).size();
    if (text.size() != whole) {
        refuse(name, "damaged shard file: " + std::to_string(text.size()) + " bytes, should be " +
                         std::to_string(whole) + (text.size() < whole ? ": was all of it copied?" : ""));
    }
    const std::size_t size = whole - begin - std::string(ending).size();
    if (checksum_of(text.data() + begin, size) != field<std::string>(line, "crc32")) {
        refuse(name, "damaged shard file: its checksum (crc32) does not fit its content");
    }
    return std::string_view(text).substr(begin, size);
}

ShardContent content_of(const Json& json) {
    ShardContent content;
    read_field(json, "run", content.run);
    const auto number = field<std::size_t>(json, "shard");
    const auto count = field<std::size_t>(content.run, "shards");
    if (number < 1 || number > count) throw FieldError("must be from 1 to " + std::to_string(count), "shard");
    content.shard = {number - 1, count};
    read_field(json, "command", content.command);
    read_field(json, "compiler", content.compiler);
    return content;
}

}  // namespace

std::string ShardContent::program() const { return field<std::string>(run, "program"); }

std::string shard_text(ShardContent content) {
    Json json = Json::object();
    json["run"] = std::move(content.run);
    json["shard"] = content.shard.index + 1;
    json["command"] = std::move(content.command);
    json["compiler"] = std::move(content.compiler);
    json["part"] = std::move(content.part);
    const std::string text = dumped(json);
    const Json line = {{"format", format_name},
                       {"format_version", format_version},
                       {"bytes", text.size()},
                       {"crc32", checksum_of(text.data(), text.size())}};
    std::string out = dumped(line);
    out.back() = ',';
    out += "\"content\":\n";
    out += text;
    return out + ending;
}

ShardContent parse_shard_text(const std::string& text, const std::string& name) {
    try {
        Json json = Json::parse(content_text(text, name));
        ShardContent content = content_of(json);
        content.part = std::move(json["part"]);
        if (!content.part.is_object()) throw FieldError("is missing", "part");
        return content;
    } catch (const FieldError& error) {
        refuse(name, std::string("damaged shard file: ") + error.what());
    } catch (const nlohmann::json::exception& error) {
        refuse(name, std::string("damaged shard file: ") + error.what());
    }
}

ShardContent load_shard(const std::string& path) {
    std::ifstream file = open_text(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (file.bad()) throw std::runtime_error(path + ": cannot be read");
    return parse_shard_text(text, path);
}

}  // namespace sspql::shards
