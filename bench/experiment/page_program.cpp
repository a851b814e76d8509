// SPDX-License-Identifier: MIT
#include "experiment/page_program.hpp"

#include <iostream>

#include "experiment/options.hpp"
#include "report/output_file.hpp"

namespace sspql::experiment {

int page_program(const std::string& program, const std::string& description,
                 const std::function<std::string(const std::vector<report::RecordedRun>&)>& page, int argc,
                 char** argv) {
    return run_program(
        program.c_str(),
        [&](int count, char** arguments) {
            std::vector<std::string> files;
            std::string out;
            Options parser(program, description);
            parser.files("FILE", files, "JSON written by grid_experiment or pusher_experiment");
            parser.text("--out", out, "Write the page to this file instead of the terminal");
            if (!parser.parse(count, arguments)) return 0;

            std::vector<report::RecordedRun> runs;
            for (const std::string& file : files) runs.push_back(report::load_recorded_run(file));
            const std::string text = page(runs);
            if (!out.empty()) {
                report::write_file(out, text);
                return 0;
            }
            std::cout << text << std::flush;
            return std::cout.good() ? 0 : 2;
        },
        argc, argv);
}

}  // namespace sspql::experiment
