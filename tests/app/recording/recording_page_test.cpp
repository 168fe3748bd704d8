// SPDX-License-Identifier: GPL-3.0-or-later
// Compares docs/recording.md with the tables from which recordings are written and read.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/recording/recording_format.h"

namespace sherd::recording_format {
namespace {

class RecordingPage : public testing::Test {
  protected:
    RecordingPage() {
        const std::ifstream file(std::filesystem::path(SHERD_SCENES) / "../docs/recording.md");
        std::ostringstream content;
        content << file.rdbuf();
        page = content.str();
    }
    void expect(const std::string& words) const {
        EXPECT_NE(page.find(words), std::string::npos) << words << " is not in docs/recording.md";
    }
    /// Expects that the page has a dataset with its shape, as in "`rest/faces` [F, 3]".
    void expect_array(const std::string& name, char rows, std::size_t width) const {
        const std::string columns = width > 1 ? ", " + std::to_string(width) : "";
        expect("`" + name + "` [" + rows + columns + "]");
    }

    std::string page;
};

char letter(Elements entries) {
    return entries == Elements::vertices ? 'V'
           : entries == Elements::faces  ? 'F'
           : entries == Elements::edges  ? 'E'
                                         : 'R';
}

template <class T>
std::size_t width_of(const std::vector<T>&) {
    return hdf5::Element<T>::width;
}
std::size_t width_of(const Positions&) {
    return 3;
}
std::size_t width_of(const VectorXd&) {
    return 1;
}

// A user of h5py who does not find a dataset on the page would take it for another one.
TEST_F(RecordingPage, HasEveryArrayOfAFrameWithItsShape) {
    const Snapshot frame{};
    const auto look_up = [&](const SnapshotArray& array, const auto& values) {
        expect_array(array.name, letter(array.entries), width_of(values));
    };
    visit_arrays(frame, look_up);
    visit_rest_arrays(frame.rest, look_up);
    visit_fields(frame.fields, [&](const std::string& name, const auto&, const FieldMeaning&) {
        expect("`face/" + name + "`");
    });
}

TEST_F(RecordingPage, HasEveryAttributeOfFilesWithItsShape) {
    visit_recorded_attributes(
        [&]<class Element, class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            const std::string name = std::string("rest/") + attribute.recorded;
            const char rows = std::same_as<Element, Vertex> ? 'R' : 'F';
            if constexpr (requires(Value value) { value.use_count(); })
                expect_array(name, rows, 1);
            else
                expect_array(name, rows, hdf5::Element<Value>::width);
        });
}

TEST_F(RecordingPage, HasEveryColumnOfTheTables) {
    visit_tables([&]<class Row>(std::type_identity<Row>) {
        Table<Row>::visit(
            [&](const std::string& name, const hdf5::Meaning&, auto) { expect("`" + name + "`"); });
    });
}

}  // namespace
}  // namespace sherd::recording_format
