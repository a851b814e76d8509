// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <streambuf>
#include <string>

#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include "ranks/ranks.hpp"

namespace sspql::experiment {

namespace {

/// Whether an MPI launcher (mpirun, srun) started this process: without one, MPI_Init may take long, print or fail.
bool launched() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"}) {
        if (std::getenv(name) != nullptr) return true;
    }
    return false;
}

struct Nowhere : std::streambuf {
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
    std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

Nowhere nowhere;
std::streambuf* terminal = nullptr;

constexpr std::uint64_t largest_piece = std::uint64_t{1} << 28;  // MPI counts with int

void send(const std::string& text) {
    const std::uint64_t size = text.size();
    MPI_Send(&size, 1, MPI_UINT64_T, 0, 0, MPI_COMM_WORLD);
    for (std::uint64_t at = 0; at < size; at += largest_piece) {
        const auto piece = static_cast<int>(std::min(largest_piece, size - at));
        MPI_Send(text.data() + at, piece, MPI_CHAR, 0, 0, MPI_COMM_WORLD);
    }
}

std::string receive(int rank) {
    std::uint64_t size = 0;
    MPI_Recv(&size, 1, MPI_UINT64_T, rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    std::string text(size, '\0');
    for (std::uint64_t at = 0; at < size; at += largest_piece) {
        const auto piece = static_cast<int>(std::min(largest_piece, size - at));
        MPI_Recv(text.data() + at, piece, MPI_CHAR, rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    return text;
}

std::string host_name() {
    std::string name(MPI_MAX_PROCESSOR_NAME, '\0');
    int length = 0;
    MPI_Get_processor_name(name.data(), &length);
    name.resize(static_cast<std::size_t>(length));
    return name;
}

}  // namespace

Ranks::Ranks() {
    if (!launched()) return;
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    int rank = 0;
    int size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    rank_ = static_cast<std::size_t>(rank);
    size_ = static_cast<std::size_t>(size);
    MPI_Comm host = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &host);
    MPI_Comm_size(host, &size);
    MPI_Comm_free(&host);
    on_host_ = static_cast<std::size_t>(size);
    if (rank_ != 0) terminal = std::cout.rdbuf(&nowhere);
}

Ranks::~Ranks() {
    if (terminal != nullptr) std::cout.rdbuf(terminal);
    terminal = nullptr;
    if (launched()) MPI_Finalize();
}

void Ranks::together(const std::function<void()>& task) const {
    if (size_ == 1) return task();
    std::string error;
    bool failed = false;
    try {
        task();
    } catch (const ErrorElsewhere&) {
        throw;  // of a call within this one: all ranks got it
    } catch (const std::exception& caught) {
        failed = true;
        error = caught.what();
    }
    const auto own = static_cast<std::uint64_t>(failed ? rank_ : size_);
    std::uint64_t lowest = own;
    MPI_Allreduce(&own, &lowest, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
    if (lowest == size_) return;
    if (lowest != rank_) throw ErrorElsewhere();
    throw std::runtime_error(rank_ == 0 ? error
                                        : "rank " + std::to_string(rank_) + " on " + host_name() + ": " + error);
}

void Ranks::gather(std::string own, const std::function<void(std::size_t, const std::string&)>& take) const {
    if (rank_ != 0) return send(own);
    // Whatever take says, all texts are received: who sends waits for that.
    std::exception_ptr error;
    for (std::size_t rank = 0; rank < size_; ++rank) {
        try {
            if (rank > 0) own = receive(static_cast<int>(rank));
            if (!error) take(rank, own);
        } catch (...) {
            if (!error) error = std::current_exception();
        }
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace sspql::experiment
