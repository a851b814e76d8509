// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/io/atomic_file.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/model/transition_counts.hpp>

/// \file
/// What was learnt as files for numpy.load, format 1.0, little endian on every machine. Each file is written whole or
/// not at all (AtomicFile), and equal content gives equal bytes. O(size); memory does not grow with it.
/// \throws std::runtime_error "cannot write PATH: REASON".

namespace sspql {

namespace detail {

/// A .npy file in the making: the header, then put() for each number in C order, then commit().
class NpyFile {
public:
    /// `type` is numpy's descr, such as "'<f8'"; `shape` without parentheses, such as "3, 4" or "7,".
    NpyFile(const std::string& path, const std::string& type, const std::string& shape) : file_(path) {
        std::string header = "{'descr': " + type + ", 'fortran_order': False, 'shape': (" + shape + "), }";
        constexpr std::size_t before = 10;  // bytes; data begin at a multiple of 64
        header.append(63 - (before + header.size()) % 64, ' ');
        header += '\n';
        file_.write("\x93NUMPY\x01", 7);
        file_.write("\0", 1);
        const char size[] = {static_cast<char>(header.size() & 0xFF), static_cast<char>(header.size() >> 8)};
        file_.write(size, 2);
        file_.write(header);
    }

    void put(std::int64_t value) { put_bits(static_cast<std::uint64_t>(value)); }
    void put(double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        put_bits(bits);
    }
    void put(bool value) { file_.write(value ? "\1" : "\0", 1); }

    void commit() { file_.commit(); }

private:
    void put_bits(std::uint64_t bits) {
        char bytes[8];
        for (int i = 0; i < 8; ++i) bytes[i] = static_cast<char>((bits >> (8 * i)) & 0xFF);
        file_.write(bytes, sizeof bytes);
    }

    AtomicFile file_;
};

}  // namespace detail

/// A list of numbers: float64, or int64 for whole numbers, of shape (n,).
template <class Number>
void save_npy(const std::string& path, const std::vector<Number>& values) {
    static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool> && !std::is_same_v<Number, char>,
                  "sspql: save_npy saves numbers");
    using Put = std::conditional_t<std::is_floating_point_v<Number>, double, std::int64_t>;
    detail::NpyFile file(path, std::is_floating_point_v<Number> ? "'<f8'" : "'<i8'",
                         std::to_string(values.size()) + ",");
    for (const Number value : values) file.put(static_cast<Put>(value));
    file.commit();
}

/// Q as float64 of shape (states, actions): `q = numpy.load(path); q.argmax(axis=1)`.
inline void save_npy(const std::string& path, const QTable& q) {
    detail::NpyFile file(path, "'<f8'", std::to_string(q.states()) + ", " + std::to_string(q.actions()));
    for (std::size_t s = 0; s < q.states(); ++s) {
        for (std::size_t a = 0; a < q.actions(); ++a) file.put(q(state_id(s), action_id(a)));
    }
    file.commit();
}

/// The counts as one structured array of shape (n,), a row for each (s,a,s') observed, ascending:
///
///     s, a, next   int64
///     n            int64 N(s,a,s'); float64 where counts fade
///     weight       float64, mean weight of (s,next)
///     terminal     bool, whether the last observation ended the episode
///     reward_sum   float64, only where the cells keep rewards: reward_sum / n is the mean
///
///     c = numpy.load(path)
///     scipy.sparse.coo_matrix((c['n'], (c['s'], c['next'])))      adds up over the actions
template <class Cell>
void save_npy(const std::string& path, const TransitionCounts<Cell>& counts) {
    using Number = std::conditional_t<std::is_integral_v<typename Cell::Number>, std::int64_t, double>;
    struct Row {
        ActionId a;
        StateId next;
        const Cell* cell;
        double weight;
    };
    const auto for_each_row_of = [&counts](StateId s, std::vector<Row>& rows) {
        rows.clear();
        counts.for_each_successor(s, [&](const auto& successor) {
            successor.for_each_action([&](ActionId a, const Cell& cell) {
                rows.push_back({a, successor.state(), &cell, successor.weight()});
            });
        });
        std::sort(rows.begin(), rows.end(),
                  [](const Row& x, const Row& y) { return std::make_pair(x.a, x.next) < std::make_pair(y.a, y.next); });
    };

    std::size_t size = 0;
    std::vector<Row> rows;
    for (std::size_t s = 0; s < counts.states(); ++s) {
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            successor.for_each_action([&](ActionId, const Cell&) { ++size; });
        });
    }
    std::string type = "[('s', '<i8'), ('a', '<i8'), ('next', '<i8'), ('n', '";
    type += std::is_same_v<Number, double> ? "<f8" : "<i8";
    type += "'), ('weight', '<f8'), ('terminal', '|b1')";
    if (Cell::keeps_rewards) type += ", ('reward_sum', '<f8')";
    detail::NpyFile file(path, type + "]", std::to_string(size) + ",");
    for (std::size_t s = 0; s < counts.states(); ++s) {
        for_each_row_of(state_id(s), rows);
        for (const Row& row : rows) {
            file.put(static_cast<std::int64_t>(s));
            file.put(static_cast<std::int64_t>(index(row.a)));
            file.put(static_cast<std::int64_t>(index(row.next)));
            file.put(static_cast<Number>(row.cell->count()));
            file.put(row.weight);
            file.put(row.cell->terminal());
            if constexpr (Cell::keeps_rewards) file.put(row.cell->reward_sum);
        }
    }
    file.commit();
}

}  // namespace sspql
