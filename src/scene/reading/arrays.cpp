#include "scene/reading/arrays.h"

#include <algorithm>
#include <deque>
#include <map>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/reading/element_table.h"
#include "scene/reading/named_file.h"
#include "scene/reading/names.h"
#include "scene/reading/numbered_files.h"

namespace isomotion::scene {
namespace {

animation::FieldSource read_field(const toml::node& node, const std::string& key) {
    if (node.is_number()) return read_finite(node, key);
    if (const auto text = node.value<std::string>()) return animation::Expression{*text};
    if (const toml::array* list = node.as_array()) {
        std::vector<double> values;
        for (std::size_t k = 0; k < list->size(); ++k) {
            values.push_back(read_finite(*list->get(k), fmt::format("{}[{}]", key, k)));
        }
        return values;
    }
    fail(node, key, "must be a number, an expression in t, i and n, or a list of numbers");
}

// One array as its tables write it, not yet understood.
struct ArrayNodes {
    struct Value {
        const toml::node* node = nullptr;
        std::string key; // for messages
    };
    Value place;
    std::optional<Value> count;
    std::optional<Section> data;    // where a file is named
    std::vector<std::string> order; // of the fields
    std::map<std::string, Value> fields;
};

bool is_of_the_file(const std::string& name) {
    return name == "file" || name == "columns" || name == "interpolation" ||
           name == "extrapolate" || name == "outside" || name == "first_file";
}

void gather(Section section, ArrayNodes& nodes) {
    nodes.place = {&section.table(), section.key()};
    if (section.has("file")) {
        nodes.data = section;
        nodes.count.reset();
        std::erase_if(nodes.order, [&](const std::string& field) {
            return nodes.fields.at(field).node->is_array() && nodes.fields.erase(field);
        });
    }
    for (const std::string& name : section.names()) {
        const toml::node& node = *section.find(name);
        const std::string key = section.dotted(name);
        if (name == "count") {
            nodes.count = {&node, key};
            continue;
        }
        if (section.has("file") && is_of_the_file(name)) continue;
        if (!section.mistakes().attempt([&] { check_name(name, node, key); })) continue;
        if (!nodes.fields.count(name)) nodes.order.push_back(name);
        nodes.fields[name] = {&node, key};
    }
}

int read_count(const ArrayNodes::Value& value) {
    const toml::node& node = *value.node;
    const auto count = node.value_exact<std::int64_t>();
    if (!count || *count < 0 || *count > limits::elements) {
        fail(node, value.key, fmt::format("must be an integer from 0 to {}", limits::elements));
    }
    return int(*count);
}

// `section`: where the file is named.
TableOptions read_data(const ArrayNodes& nodes, Section section, const base::Confines& within) {
    TableOptions options;
    options.most = nodes.count ? read_count(*nodes.count) : limits::elements;
    options.counts_files = !nodes.count;
    const toml::node& file = *section.find("file");
    const auto name = section.text("file");
    if (!name) return options;
    options.file = beside(file, *name);
    options.within = confines_of(file, within);
    const int first_file = section.integer("first_file", 0, limits::frames).value_or(1);
    for (const NumberedFile& one :
         numbered_files(file, section.dotted("file"), options.file, options.within))
        options.frames.emplace_back(std::int64_t(one.number) - first_file + 1, one.file);
    if (options.frames.empty()) {
        options.file =
            named_file(file, section.dotted("file"), std::array{options.file}, options.within);
        if (const toml::node* first = section.find("first_file")) {
            fail(*first, section.dotted("first_file"),
                 "is the number of the file that frame 1 shows; the file's name has no place for "
                 "one, such as ####");
        }
    }
    if (auto columns = section.section("columns")) {
        for (const std::string& field : columns->names()) {
            columns->attempt(
                field, [&] { check_name(field, *columns->find(field), columns->dotted(field)); });
            options.columns[field] = columns->text(field).value_or("");
        }
    }
    if (const auto text = section.text("interpolation")) {
        using enum animation::ElementSamples::Interpolation;
        if (*text == "linear") options.interpolation = linear;
        if (*text == "hold") options.interpolation = hold;
        if (*text == "hermite") options.interpolation = hermite;
        if (!options.interpolation) {
            section.tell("interpolation",
                         fmt::format("must be linear, hold or hermite, not '{}'", *text));
        }
    }
    return options;
}

// The tables of a scene. A file that several arrays name is read once for all of them; arrays that
// name it alike share what they have of it.
class Tables {
public:
    explicit Tables(const animation::Timeline& timeline)
        : timeline_(timeline) {}

    // Call this for all tables before the first is read.
    void add(const TableOptions& options) {
        File& file = file_of(options);
        if (std::ranges::find(file.asked, options) == file.asked.end())
            file.asked.push_back(options);
    }
    const ElementTable& read(const TableOptions& options) {
        File& file = file_of(options);
        if (file.tables.empty()) file.tables = read_element_tables(file.asked, timeline_, budget_);
        const auto k = std::ranges::find(file.asked, options) - file.asked.begin();
        return file.tables[std::size_t(k)];
    }
    const animation::Timeline& timeline() const { return timeline_; }

private:
    struct File {
        std::vector<TableOptions> asked;
        std::vector<ElementTable> tables; // of each
    };

    File& file_of(const TableOptions& options) {
        const auto known = std::ranges::find_if(files_, [&](const File& file) {
            const TableOptions& first = file.asked.front();
            return first.file == options.file && first.within == options.within &&
                   first.frames == options.frames;
        });
        return known != files_.end() ? *known : files_.emplace_back();
    }

    const animation::Timeline& timeline_;
    TableBudget budget_{limits::table_bytes, limits::table_values};
    std::deque<File> files_;
};

// Frames beyond the data would show its ends, standing still.
void check_times(Section section, const TableOptions& options, const ElementTable& read,
                 const animation::Timeline& timeline) {
    const auto extrapolate = section.text("extrapolate");
    if (extrapolate && *extrapolate != "hold") {
        section.tell("extrapolate",
                     fmt::format("must be hold: the first and the last elements stay, not '{}'",
                                 *extrapolate));
    }
    if (!section.mistakes().empty()) return; // the scene's frames may be other ones
    const animation::ElementSamples& samples = *read.samples;
    if (extrapolate || samples.first_time() == samples.last_time()) return;
    const char* first_file =
        options.frames.empty() ? "" : ", or first_file = the number of the file of frame 1";
    if (samples.first_time() > timeline.time(1)) {
        throw SceneError(fmt::format("{}: begins at t = {}, after the scene's first frame; begin "
                                     "at 0, or give the array extrapolate = \"hold\"{}",
                                     read.first, samples.first_time(), first_file));
    }
    if (samples.last_time() < timeline.time(timeline.frames)) {
        throw SceneError(
            fmt::format("{}: ends at t = {}, but frame {} of the scene is at t = "
                        "{}; lower time.frames, or give the array extrapolate = \"hold\"{}",
                        read.last, samples.last_time(), timeline.frames,
                        timeline.time(timeline.frames), first_file));
    }
}

// The columns of a file become fields; a field that the scene writes itself goes before.
void add_data(const ArrayNodes& nodes, Section section, const TableOptions& options, Tables& tables,
              TrackTable& tracks, animation::Array& array) {
    const ElementTable& table = tables.read(options);
    check_times(section, options, table, tables.timeline());
    array.samples = table.samples;
    array.count = nodes.count ? options.most : table.samples->most();
    for (std::size_t k = 0; k < table.fields.size(); ++k) {
        const std::string& field = table.fields[k];
        if (nodes.fields.count(field)) continue;
        // A parameter of the scene goes before the column that an element adds.
        if (table.of_elements.contains(field) && tracks.has(field)) continue;
        array.fields.push_back({field, animation::Column{k}});
        tracks.place(array.name + "." + field, section.dotted("file"), section.find("file"));
    }
}

// A field; one that is wrong is told, and has a number that stands in for it.
void add_field(const std::string& name, const ArrayNodes& nodes, TrackTable& tracks,
               animation::Array& array, MistakeList& mistakes) {
    const ArrayNodes::Value& given = nodes.fields.at(name);
    const toml::node& node = *given.node;
    const std::string& key = given.key;
    animation::FieldSource source = stand_in_number;
    mistakes.attempt([&] {
        animation::FieldSource read = read_field(node, key);
        const auto* list = std::get_if<std::vector<double>>(&read);
        if (list && nodes.data) {
            fail(node, key,
                 "a list beside a file: put it into the file, as a column, or write an expression");
        }
        if (list && list->size() != std::size_t(array.count)) {
            fail(node, key,
                 fmt::format("has {} values for {} elements; give one for each", list->size(),
                             array.count));
        }
        source = std::move(read);
    });
    array.fields.push_back({name, std::move(source)});
    tracks.place(array.name + "." + name, key, &node);
}

// `data`: how it reads its file, if it has one.
animation::Array make_array(const std::string& name, const ArrayNodes& nodes,
                            const TableOptions* data, Tables& tables, TrackTable& tracks,
                            MistakeList& mistakes) {
    animation::Array array;
    array.name = name;
    if (data && nodes.data) {
        add_data(nodes, *nodes.data, *data, tables, tracks, array);
    } else {
        if (!nodes.count) {
            fail(*nodes.place.node, nodes.place.key,
                 "needs count, the number of elements, or file, a table of them");
        }
        array.count = read_count(*nodes.count);
    }
    if (nodes.count) tracks.place(name + ".count", nodes.count->key, nodes.count->node);
    for (const std::string& field : nodes.order) add_field(field, nodes, tracks, array, mistakes);
    if (array.fields.size() > std::size_t(limits::fields)) {
        fail(*nodes.place.node, nodes.place.key,
             fmt::format("has {} fields; at most {} are possible", array.fields.size(),
                         limits::fields));
    }
    return array;
}

// What the catalogue's tables and the scene's say of each array, in the order of first mention.
struct GatheredArrays {
    std::vector<std::string> names;
    std::map<std::string, ArrayNodes> nodes;
};

// Throws PlacedError where an array is wrong as a whole.
GatheredArrays gathered(Section* catalogue, Section& sections) {
    GatheredArrays all;
    for (Section* from : {catalogue, &sections}) {
        auto section = from ? from->section("arrays") : std::nullopt;
        if (!section) continue;
        for (const std::string& name : section->names()) {
            const toml::node& node = *section->find(name);
            const std::string key = section->dotted(name);
            check_name(name, node, key);
            if (!node.is_table()) fail(node, key, fmt::format("must be a table: [{}]", key));
            if (!all.nodes.count(name)) all.names.push_back(name);
            gather(*section->merged_section(name), all.nodes[name]);
        }
    }
    if (all.names.size() > std::size_t(formula::max_arrays)) {
        fail(*all.nodes[all.names.back()].place.node, "arrays",
             fmt::format("a scene has at most {} arrays", formula::max_arrays));
    }
    return all;
}

} // namespace

bool read_arrays(Section* catalogue, Section& sections, const animation::Timeline& timeline,
                 TrackTable& tracks, const base::Confines& within,
                 std::vector<animation::Array>& arrays) {
    MistakeList& mistakes = sections.mistakes();
    GatheredArrays all;
    if (!mistakes.attempt([&] { all = gathered(catalogue, sections); })) return false;
    if (sections.is_wrong("arrays")) return false;
    Tables tables(timeline);
    std::map<std::string, TableOptions> data;
    const std::size_t told = mistakes.size();
    for (const std::string& name : all.names) {
        const ArrayNodes& nodes = all.nodes[name];
        if (!nodes.data) continue;
        const Section& section = *nodes.data;
        mistakes.attempt([&] {
            data[name] = read_data(nodes, section, within);
            tables.add(data[name]);
        });
    }
    bool are_known = mistakes.size() == told && !mistakes.is_full();
    for (const std::string& name : all.names) {
        const auto file = data.find(name);
        const TableOptions* options = file == data.end() ? nullptr : &file->second;
        if (!are_known && all.nodes[name].data) continue;
        // A key that is no field may be a slip of the pen for one that chooses columns.
        const std::size_t before = mistakes.size();
        are_known &= mistakes.attempt([&] {
            arrays.push_back(make_array(name, all.nodes[name], options, tables, tracks, mistakes));
        });
        if (options && mistakes.size() != before) are_known = false;
    }
    return are_known;
}

} // namespace isomotion::scene
