// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

/// \file
/// Plain structures as JSON and back, every bit of every number. A structure T takes part through one function in this
/// namespace, which serves both directions and names each member:
///
///     template <class Io>
///     void fields(Io& io, Like<Io, ArenaPose>& pose) {
///         auto& [x, y, heading] = pose;  // a member more, and this does not compile
///         io("x_m", x);   ...
///     }

namespace sspql::shards {

using Json = nlohmann::ordered_json;

/// A field that is missing or is not what it must be: "part.runs[3].seed must be a whole number, is \"x\"".
class FieldError : public std::runtime_error {
public:
    explicit FieldError(const std::string& what, std::string path = {})
        : std::runtime_error((path.empty() ? "the content" : "field " + path) + " " + what), what_(what), path_(path) {}

    /// The same, seen from the structure that has the field.
    [[nodiscard]] FieldError within(const std::string& outer) const {
        return FieldError(what_, path_.empty() || path_.front() == '[' ? outer + path_ : outer + "." + path_);
    }

private:
    std::string what_;
    std::string path_;
};

/// A value as short JSON, for messages.
[[nodiscard]] std::string brief(const Json& value);

class FieldWriter;
class FieldReader;

/// T, or const T for what is written.
template <class Io, class T>
using Like = std::conditional_t<std::is_same_v<Io, FieldWriter>, const T, T>;

template <class T>
[[nodiscard]] Json written(const T& value);

/// \throws FieldError if the JSON is no T.
template <class T>
void read(const Json& json, T& value);

/// `object[name]`. \throws FieldError naming the field, if there is none.
[[nodiscard]] const Json& member(const Json& object, const std::string& name);

/// Reads `object[name]`. \throws FieldError naming the field.
template <class T>
void read_field(const Json& object, const std::string& name, T& value) {
    const Json& json = member(object, name);
    try {
        read(json, value);
    } catch (const FieldError& error) {
        throw error.within(name);
    }
}

/// The same as a result.
template <class T>
[[nodiscard]] T field(const Json& object, const std::string& name) {
    T value{};
    read_field(object, name, value);
    return value;
}

class FieldWriter {
public:
    template <class T>
    void operator()(const char* name, const T& value) {
        json_[name] = written(value);
    }
    [[nodiscard]] Json take() { return std::move(json_); }

private:
    Json json_ = Json::object();
};

class FieldReader {
public:
    explicit FieldReader(const Json& json) : json_(json) {}

    template <class T>
    void operator()(const char* name, T& value) {
        read_field(json_, name, value);
    }

private:
    const Json& json_;
};

// JSON has no word for these, and a merge must not change them.
[[nodiscard]] inline Json written_number(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

inline void read_number(const Json& json, double& value) {
    if (json.is_number()) {
        value = json.get<double>();
    } else if (json == "nan") {
        value = std::numeric_limits<double>::quiet_NaN();
    } else if (json == "inf" || json == "-inf") {
        value = (json == "inf" ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
    } else {
        throw FieldError("must be a number, is " + brief(json));
    }
}

template <class T>
void read_whole(const Json& json, T& value) {
    const bool fits = json.is_number_unsigned()
                          ? json.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<T>::max())
                          : json.is_number_integer() && std::is_signed_v<T> &&
                                json.get<std::int64_t>() >= static_cast<std::int64_t>(std::numeric_limits<T>::min());
    if (!fits) throw FieldError("must be a whole number in range, is " + brief(json));
    value = json.get<T>();
}

/// \throws FieldError unless it is an array, of `size` elements.
void require_array(const Json& json, std::optional<std::size_t> size = std::nullopt);

/// Calls element(i, json) for the elements of an array of `size`, in order. \throws FieldError naming the element.
template <class Element>
void read_elements(const Json& json, std::size_t size, const Element& element) {
    require_array(json, size);
    std::size_t i = 0;
    for (const Json& one : json) {
        try {
            element(i, one);
        } catch (const FieldError& error) {
            throw error.within("[" + std::to_string(i) + "]");
        }
        ++i;
    }
}

/// The same for `object[name]`.
template <class Element>
void read_elements(const Json& object, const std::string& name, std::size_t size, const Element& element) {
    const Json& json = member(object, name);
    try {
        read_elements(json, size, element);
    } catch (const FieldError& error) {
        throw error.within(name);
    }
}

template <class T>
struct ListOf : std::false_type {};
template <class T>
struct ListOf<std::vector<T>> : std::true_type {};
template <class T, std::size_t N>
struct ListOf<std::array<T, N>> : std::true_type {};
template <class T>
struct OptionalOf : std::false_type {};
template <class T>
struct OptionalOf<std::optional<T>> : std::true_type {};

template <class T>
Json written(const T& value) {
    if constexpr (std::is_same_v<T, double>) {
        return written_number(value);
    } else if constexpr (std::is_integral_v<T> || std::is_same_v<T, std::string> || std::is_same_v<T, Json>) {
        return value;
    } else if constexpr (OptionalOf<T>::value) {
        return value ? written(*value) : Json(nullptr);
    } else if constexpr (ListOf<T>::value) {
        Json array = Json::array();
        for (const auto& element : value) array.push_back(written(element));
        return array;
    } else {
        FieldWriter writer;
        fields(writer, value);
        return writer.take();
    }
}

template <class T>
void read(const Json& json, T& value) {
    if constexpr (std::is_same_v<T, double>) {
        read_number(json, value);
    } else if constexpr (std::is_same_v<T, bool>) {
        if (!json.is_boolean()) throw FieldError("must be true or false, is " + brief(json));
        value = json.get<bool>();
    } else if constexpr (std::is_integral_v<T>) {
        read_whole(json, value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        if (!json.is_string()) throw FieldError("must be a text, is " + brief(json));
        value = json.get<std::string>();
    } else if constexpr (std::is_same_v<T, Json>) {
        value = json;
    } else if constexpr (OptionalOf<T>::value) {
        value.reset();
        if (!json.is_null()) read(json, value.emplace());
    } else if constexpr (ListOf<T>::value) {
        if constexpr (std::is_same_v<T, std::vector<typename T::value_type>>) {
            require_array(json);
            value.assign(json.size(), {});
        }
        read_elements(json, value.size(), [&](std::size_t i, const Json& one) { read(one, value[i]); });
    } else {
        FieldReader reader(json);
        fields(reader, value);
    }
}

}  // namespace sspql::shards
