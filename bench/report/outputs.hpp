// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/findings.hpp"
#include "report/output_file.hpp"

namespace sspql::report {

/// Checks that a program has these outputs. \throws std::invalid_argument "--csv: pusher_mission has no such output".
void require_known(const OutputFiles& files, const std::string& program);

/// Prints the table on stdout and writes the files, each whole or not at all.
/// \throws std::runtime_error "cannot write PATH: REASON".
void publish(const PusherFindings& findings, const OutputFiles& files);
void publish(const GridFindings& findings, const OutputFiles& files);
void publish(const MissionFindings& findings, const OutputFiles& files);

}  // namespace sspql::report
