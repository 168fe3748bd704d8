// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/table/study_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/files/disk/checksum.h"
#include "app/messages/nearest_name.h"
#include "app/messages/number_list.h"
#include "app/recording/hdf5_file.h"
#include "app/sweep/run/row_run.h"
#include "app/sweep/study/study_measures.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Makes a column. cell: function of a row and its result, or null if there is none, that returns the text of
/// the cell.
template <class Cell>
StudyColumn make_column(const std::string& group, const std::string& name, const std::string& unit,
                        const StudyRows& rows, const RowResults& results, Cell cell) {
    StudyColumn column{group, name, unit, {}};
    for (const StudyRow& row : rows.rows) {
        const auto found = results.find(row.identity);
        column.cells.push_back(cell(row, found == results.end() ? nullptr : &found->second));
    }
    return column;
}

std::string number_cell(double value) {
    return fmt::format("{}", value);
}

/// Returns the names of the measures that the study asks for; if it asks for none, of all measures that its
/// rows have.
std::vector<std::string> measure_names(const Study& study, const StudyRows& rows, const RowResults& results) {
    if (!study.measures.empty()) return study.measures;
    std::vector<std::string> names;
    for (const RunMeasure& measure : all_measures()) names.push_back(measure.name);
    const std::size_t fixed = names.size();
    for (const StudyRow& row : rows.rows)
        if (const auto found = results.find(row.identity); found != results.end())
            for (const auto& [name, value] : found->second.values)
                if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    std::sort(names.begin() + static_cast<std::ptrdiff_t>(fixed), names.end());
    return names;
}

/// Returns the keys that the study's Python file gives, in the order in which they appear in the rows.
std::vector<std::string> python_names(const StudyRows& rows, const RowResults& results) {
    std::vector<std::string> names;
    for (const StudyRow& row : rows.rows)
        if (const auto found = results.find(row.identity); found != results.end())
            for (const auto& [name, value] : found->second.python)
                if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

void add_values(StudyTable& table, const Study& study, const StudyRows& rows, const RowResults& results) {
    for (const std::string& name : measure_names(study, rows, results))
        table.push_back(make_column("measures", name, measure_unit(name), rows, results,
                                    [&](const StudyRow&, const RowResult* result) {
                                        const auto* values = result ? &result->values : nullptr;
                                        const bool there = values && values->contains(name);
                                        return there ? number_cell(values->at(name)) : std::string();
                                    }));
    for (const std::string& name : python_names(rows, results))
        table.push_back(make_column(
            "python", name, "", rows, results, [&](const StudyRow&, const RowResult* result) -> std::string {
                if (!result) return "";
                const auto found = std::ranges::find(result->python, name, [](auto& it) { return it.first; });
                return found == result->python.end() ? "" : number_cell(found->second);
            }));
}

void add_run_columns(StudyTable& table, const StudyRows& rows, const RowResults& results,
                     const std::filesystem::path& folder) {
    const auto add = [&](const char* name, const char* unit, auto cell) {
        table.push_back(make_column("run", name, unit, rows, results, cell));
    };
    const auto add_result = [&](const char* name, const char* unit, auto cell) {
        add(name, unit, [cell](const StudyRow&, const RowResult* result) {
            return result ? cell(*result) : std::string();
        });
    };
    const auto hash = [](std::uint64_t sum) { return fmt::format("{:016x}", sum); };
    add_result("exit", "", [](const RowResult& result) { return std::to_string(result.exit_code); });
    add_result("wall_seconds", "s",
               [](const RowResult& result) { return fmt::format("{:.3f}", result.wall_seconds); });
    add_result("cpu_seconds", "s",
               [](const RowResult& result) { return fmt::format("{:.3f}", result.processor_seconds); });
    add_result("message", "", [](const RowResult& result) { return result.message; });
    add("command", "", [&](const StudyRow& row, const RowResult*) { return row_command(rows, row); });
    add("scene_hash", "", [&](const StudyRow& row, const RowResult*) { return hash(row.scene); });
    add("files_hash", "", [&](const StudyRow& row, const RowResult*) { return hash(row.files); });
    add_result("program_hash", "", [&](const RowResult& result) { return hash(result.program); });
    add("recording", "", [&](const StudyRow& row, const RowResult* result) {
        const std::filesystem::path file = row_recording(folder, row);
        return result && std::filesystem::exists(file) ? file.lexically_relative(folder).string() : "";
    });
}

bool is_numeric(const StudyColumn& column) {
    return std::ranges::all_of(column.cells,
                               [](const std::string& cell) { return cell.empty() || number_of(cell); }) &&
           !column.name.ends_with("_hash") && column.name != "message" && column.name != "recording";
}

}  // namespace

std::vector<double> StudyColumn::numbers() const {
    std::vector<double> values;
    for (const std::string& cell : cells)
        values.push_back(number_of(cell).value_or(std::numeric_limits<double>::quiet_NaN()));
    return values;
}

StudyTable study_table(const Study& study, const StudyRows& rows, const RowResults& results,
                       const std::filesystem::path& folder) {
    StudyTable table;
    table.push_back(make_column("run", "row", "", rows, results, [&](const StudyRow& row, const RowResult*) {
        return std::to_string(&row - rows.rows.data());
    }));
    for (std::size_t p = 0; p < study.parameters.size(); ++p)
        table.push_back(make_column("parameters", study.parameters[p].name, "", rows, results,
                                    [p](const StudyRow& row, const RowResult*) { return row.values[p]; }));
    if (std::ranges::find(study.parameters, "seed", &StudyParameter::name) == study.parameters.end())
        table.push_back(
            make_column("run", "seed", "", rows, results,
                        [](const StudyRow& row, const RowResult*) { return std::to_string(row.seed); }));
    add_values(table, study, rows, results);
    add_run_columns(table, rows, results, folder);
    return table;
}

CsvRows csv_rows(const StudyTable& table) {
    CsvRows rows(1 + (table.empty() ? 0 : table[0].cells.size()));
    for (const StudyColumn& column : table) {
        rows[0].push_back(column.name);
        for (std::size_t i = 0; i < column.cells.size(); ++i) rows[i + 1].push_back(column.cells[i]);
    }
    return rows;
}

StudyTable read_study_table(const std::filesystem::path& csv) {
    const CsvRows rows = parse_csv(text_of(csv), csv);
    if (rows.empty()) throw Error(fmt::format("'{}' is empty; give the table of a study", csv.string()));
    StudyTable table;
    for (std::size_t c = 0; c < rows[0].size(); ++c) {
        table.push_back({"", rows[0][c], measure_unit(rows[0][c]), {}});
        for (std::size_t r = 1; r < rows.size(); ++r) table.back().cells.push_back(rows[r][c]);
    }
    return table;
}

const StudyColumn& find_column(const StudyTable& table, const std::string& name) {
    std::vector<const StudyColumn*> found;
    std::vector<std::string> names;
    for (const StudyColumn& column : table) {
        if (column.name == name) return column;
        if (column.name.ends_with("." + name)) found.push_back(&column);
        names.push_back(column.name);
    }
    if (found.size() == 1) return *found.front();
    const std::string nearest = nearest_name(name, names);
    throw Error(fmt::format(
        "the table has {} '{}'; {}it has: {}", found.empty() ? "no column" : "several columns that end in",
        name, nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest), fmt::join(names, ", ")));
}

void write_study_h5(const StudyTable& table, const OutputLock& whole, const std::filesystem::path& file) {
    PendingFile pending(file, Fault::input, whole);
    hdf5::write_new(pending, [&](hid_t h5) {
        for (const StudyColumn& column : table) {
            std::string name = column.name;
            std::ranges::replace(name, '/', '_');
            const std::string path = column.group + "/" + name;
            if (is_numeric(column))
                hdf5::write<double>(h5, path, column.numbers(),
                                    {.unit = column.unit.empty() ? "1" : column.unit.c_str()});
            else
                hdf5::write_texts(h5, path, column.cells);
        }
    });
    pending.publish(true);
}

}  // namespace sherd
