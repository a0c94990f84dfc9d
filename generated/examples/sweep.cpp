// The sag of a soft filament over its yield stress, on all cores. C++17.
#include "filament.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// A filament with parameters of its own; const once it is set up, so that threads may share it.
class Filament {
public:
    Filament() { softcat_defaults(params_.data()); }

    Filament& set(int parameter, double value)
    {
        params_.at(static_cast<std::size_t>(parameter)) = value;
        return *this;
    }

    Filament& with_cells(int cells)
    {
        cells_ = cells;
        return *this;
    }

    // Height of the midpoint [m] at increasing times [s].
    std::vector<double> midpoint(const std::vector<double>& times) const
    {
        std::vector<double> height(times.size());
        const int count = static_cast<int>(times.size());
        std::vector<char> memory(softcat_workspace_size(cells_, count, nullptr));
        softcat_status status;
        const int code = softcat_midpoint(params_.data(), cells_, times.data(), count,
                                          height.data(), {memory.data(), memory.size()}, &status);
        if (code == SOFTCAT_BAD_PARAMETER)
            throw std::invalid_argument(
                std::string(softcat_explain(code)) + ": "
                + softcat_filament_structure.parameter_names[status.worst_slot]);
        if (code != SOFTCAT_SOLVED) throw std::runtime_error(softcat_explain(code));
        return height;
    }

private:
    std::array<double, SOFTCAT_PARAMETERS> params_{};
    int cells_ = SOFTCAT_SCENE_CELLS;
};

struct Row {
    double yield_stress = 0.0, sag = 0.0;
    std::string complaint;
};

static void solve(Row& row)
{
    try {
        Filament filament;
        filament.set(SOFTCAT_P_YIELD_STRESS, row.yield_stress).with_cells(20);
        row.sag = -filament.midpoint({1.0}).back();
    } catch (const std::exception& error) {
        row.complaint = error.what();
    }
}

int main()
{
    std::vector<Row> rows(12);
    for (std::size_t n = 0; n < rows.size(); n++) // the last one is refused
        rows[n].yield_stress =
            n + 1 < rows.size() ? 6000.0 + 1000.0 * static_cast<double>(n) : -1.0;

    std::atomic<std::size_t> next{0};
    std::vector<std::thread> workers;
    for (unsigned n = std::max(1U, std::thread::hardware_concurrency()); n > 0; n--)
        workers.emplace_back([&] {
            for (std::size_t k = next++; k < rows.size(); k = next++) solve(rows[k]);
        });
    for (std::thread& worker : workers) worker.join();

    std::printf("yield_stress_Pa,sag_m,complaint\n");
    for (const Row& row : rows)
        std::printf("%g,%.9g,%s\n", row.yield_stress, row.sag, row.complaint.c_str());
}
