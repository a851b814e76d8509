// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <sspql/core/serialization.hpp>
#include <sspql/io/atomic_file.hpp>
#include <sspql/io/checkpoint_reader.hpp>
#include <sspql/io/checkpoint_source.hpp>
#include <sspql/io/checkpoint_writer.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/counts_archive.hpp>

/// \file
/// What a robot learnt, in a file:
///
///     sspql::save(agent, "robot.sspql");
///     sspql::load("robot.sspql", agent);
///
/// A checkpoint holds all that decides what a learner does next: parameters, counts, values, shortest paths, plans under
/// way, the random generator, the running episode. A learner that was loaded goes on as if it had never stopped, to the
/// bit, on any machine and with any compiler. The format is in docs/checkpoint-format.md.

namespace sspql {

namespace detail {

template <class T>
struct IsAgent : std::false_type {};
template <class States, class Actions, class Learner>
struct IsAgent<Agent<States, Actions, Learner>> : std::true_type {};

template <class Writer, class Learner>
void write_learner(Writer& writer, const Learner& saved) {
    auto& learner = const_cast<Learner&>(saved);  // serialize changes nothing while writing
    std::size_t states = learner.states();
    std::size_t actions = learner.actions();
    bool grows = learner.grows();
    writer.section("type", [&] {
        writer.tag("learner", Learner::type_name);
        writer.size(states);
        writer.size(actions);
        writer(grows);
    });
    typename Learner::Params params = learner.params();
    writer.section("parameters", [&] { writer(params); });
    SerializationAccess::serialize(learner, writer);
}

/// A learner like `like`, with what the checkpoint holds.
template <class Reader, class Learner>
[[nodiscard]] Learner read_learner(Reader& reader, const Learner& like) {
    std::size_t states = 0;
    reader.section("type", [&] {
        std::size_t actions = 0;
        bool grows = false;
        reader.tag("learner", Learner::type_name);
        reader.size(states);
        reader.size(actions);
        reader(grows);
        const auto differ = [&](const char* what, std::size_t file, std::size_t mine) {
            reader.refuse("the file has " + std::to_string(file) + " " + what + ", this learner " + std::to_string(mine));
        };
        if (actions != like.actions()) differ("actions", actions, like.actions());
        if (grows != like.grows()) {
            reader.refuse(grows ? "the file is of a learner whose states grow in number, this one's do not"
                                : "the file is of a learner with a fixed number of states, this one's grow in number");
        }
        if (!grows && states != like.states()) differ("states", states, like.states());
        // Each (s,a) takes 12 bytes at least, so that memory is only asked for where there is a file to fill it.
        reader.require(!grows || (states < max_ids && states <= reader.left() / 12 / actions),
                       "there are more states than the file has room for");
    });
    typename Learner::Params params = like.params();
    reader.section("parameters", [&] { reader(params); });
    Learner learner = [&] {
        try {
            return Learner(like.grows() ? StateCount::growing() : StateCount(states), like.actions(), params, 0);
        } catch (const std::invalid_argument& error) {
            reader.refuse(error.what());
        }
    }();
    if (states > learner.states()) learner.grow(states);
    SerializationAccess::serialize(learner, reader);
    return learner;
}

/// How an Agent is written and read: its learner, then what its StatePolicy has discovered.
struct AgentArchive {
    template <class Writer, class A>
    static void write(Writer& writer, const A& agent) {
        write_learner(writer, agent.learner_);
        auto& states = const_cast<std::decay_t<decltype(agent.states_)>&>(agent.states_);
        serialize_states(writer, states);
    }

    /// \param finish reads what comes after, before the agent is touched.
    template <class Reader, class A, class Finish>
    static void read(Reader& reader, A& agent, const Finish& finish) {
        auto learner = read_learner(reader, agent.learner_);
        auto states = agent.states_;
        serialize_states(reader, states);
        finish();
        agent.states_ = std::move(states);
        agent.learner_ = std::move(learner);
    }

private:
    template <class Archive, class States>
    static void serialize_states(Archive& archive, States& states) {
        constexpr bool possible = SerializationAccess::possible<States, Archive>();
        static_assert(possible || !grows_v<States>,
                      "sspql: this StatePolicy grows, so a checkpoint must hold what it has discovered; it lacks "
                      "`template <class Archive> void serialize(Archive&)`");
        if constexpr (possible) {
            archive.section("states", [&] { archive(states); });
        }
    }
};

struct NoUserData {};

template <class Sink, class T, class User>
void write_checkpoint(Sink& sink, const T& object, const User& user) {
    CheckpointWriter<Sink> writer(sink);
    if constexpr (IsAgent<T>::value) {
        AgentArchive::write(writer, object);
    } else {
        write_learner(writer, object);
    }
    if constexpr (!std::is_same_v<User, NoUserData>) {
        writer.section("user", [&] { writer(const_cast<User&>(user)); });
    }
    writer.finish();
}

template <class Source, class T, class User>
void read_checkpoint(Source& source, const std::string& name, T& object, User& user) {
    CheckpointReader<Source> reader(source, name);
    User new_user = user;
    const auto finish = [&] {
        if constexpr (!std::is_same_v<User, NoUserData>) {
            reader.section("user", [&] { reader(new_user); });
        }
        reader.finish();
    };
    if constexpr (IsAgent<T>::value) {
        AgentArchive::read(reader, object, finish);
    } else {
        T learner = read_learner(reader, object);
        finish();
        object = std::move(learner);
    }
    user = std::move(new_user);
}

}  // namespace detail

/// Writes a learner, or an Agent with its StatePolicy's discoveries, to a file. The file is replaced whole or not at all
/// (AtomicFile): a crash or a power cut in the middle leaves the old one. May be called at any time, within an episode
/// too; changes nothing. O(what was learnt); memory 128 KiB.
/// \throws std::runtime_error "cannot write PATH: REASON".
template <class T>
void save(const T& learner_or_agent, const std::string& path) {
    AtomicFile file(path);
    detail::write_checkpoint(file, learner_or_agent, detail::NoUserData{});
    file.commit();
}

/// With something of yours that must never be out of step with what was learnt, such as the number of episodes: numbers,
/// strings, vectors, types with a member serialize (core/serialization.hpp).
template <class T, class User>
void save(const T& learner_or_agent, const std::string& path, const User& user) {
    AtomicFile file(path);
    detail::write_checkpoint(file, learner_or_agent, user);
    file.commit();
}

/// Makes a learner or an Agent what it was when it was saved, parameters included; it must be of the same type, with the
/// same number of actions and, unless it grows, of states. An episode that was running goes on: call abort() if the robot
/// was moved meanwhile. What reserve() promised has to be asked for again.
///
/// The whole file is checked before anything is interpreted, and everything that was read before the object is touched:
/// if this throws, it is as it was. Memory: the new learner, besides the old one, and 192 KiB. What a forged file can
/// make it ask for is bounded by the file's size.
/// \throws std::runtime_error "checkpoint PATH: ..." naming the section and what is wrong, "cannot read PATH: REASON".
template <class T>
void load(const std::string& path, T& learner_or_agent) {
    FileSource source(path);
    detail::NoUserData none;
    detail::read_checkpoint(source, path, learner_or_agent, none);
}

/// With what was saved besides; a file without it is refused.
template <class T, class User>
void load(const std::string& path, T& learner_or_agent, User& user) {
    FileSource source(path);
    detail::read_checkpoint(source, path, learner_or_agent, user);
}

/// The same in memory: the bytes of a file.
template <class T>
[[nodiscard]] std::string save_to_bytes(const T& learner_or_agent) {
    MemorySink sink;
    detail::write_checkpoint(sink, learner_or_agent, detail::NoUserData{});
    return std::move(sink.bytes());
}

/// load() from what save_to_bytes() gave. \param name what error messages call the bytes.
template <class T>
void load_from_bytes(std::string_view bytes, T& learner_or_agent, const std::string& name = "in memory") {
    MemorySource source(bytes);
    detail::NoUserData none;
    detail::read_checkpoint(source, name, learner_or_agent, none);
}

}  // namespace sspql
