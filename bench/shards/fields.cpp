// SPDX-License-Identifier: MIT
#include "shards/fields.hpp"

namespace sspql::shards {

std::string brief(const Json& value) {
    constexpr std::size_t longest = 60;
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

const Json& member(const Json& object, const std::string& name) {
    if (!object.is_object()) throw FieldError("must be an object, is " + brief(object));
    const auto found = object.find(name);
    if (found == object.end()) throw FieldError("is missing", name);
    return *found;
}

void require_array(const Json& json, std::optional<std::size_t> size) {
    if (!json.is_array()) throw FieldError("must be a list, is " + brief(json));
    if (size && json.size() != *size) {
        throw FieldError("must be a list of " + std::to_string(*size) + ", has " + std::to_string(json.size()));
    }
}

}  // namespace sspql::shards
