// Reads a JSON or TOML document key by key. Mistakes are InputErrors with their place: "file:line:
// key: what is wrong, and what would be right". A key that is given twice is refused.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace isomotion::base {

class DocumentNode;
class DocumentTable;

class Document {
public:
    static Document from_json(std::string_view text, std::string file);
    static Document from_toml(std::string_view text, std::string file);
    Document(Document&&) noexcept;
    ~Document();

    // The document must outlive its nodes.
    DocumentTable table() const;

private:
    friend class DocumentNode;
    explicit Document(std::string file);
    std::size_t line_of(const std::string& key) const; // 0: of the whole document

    std::string file_;
    std::unique_ptr<nlohmann::ordered_json> value_;
    std::map<std::string, std::size_t> lines_; // of TOML keys: "components.12", "events[3]"
    std::string json_;                         // searched for a line when one is needed
};

class DocumentNode {
public:
    [[noreturn]] void fail(const std::string& message) const;
    // The key as messages name it: "bounds.shape", "events[2]"; empty for the whole document.
    const std::string& key() const { return key_; }

    std::string text() const;
    double number() const; // finite
    std::int64_t whole() const;
    int integer(int least, int most) const;
    bool boolean() const;
    std::vector<DocumentNode> list() const;
    std::vector<DocumentNode> list(std::size_t size) const;
    DocumentTable table() const;

    bool is_null() const;
    bool is_number() const;
    bool is_list() const;
    bool is_table() const;

private:
    friend class Document;
    friend class DocumentTable;
    DocumentNode(const Document& document, const nlohmann::ordered_json& value, std::string key)
        : document_(&document)
        , value_(&value)
        , key_(std::move(key)) {}

    const Document* document_;
    const nlohmann::ordered_json* value_;
    std::string key_;
};

class DocumentTable {
public:
    explicit DocumentTable(const DocumentNode& node); // fails if the node is not a table

    DocumentNode at(const std::string& name); // fails if there is no such key
    std::optional<DocumentNode> find(const std::string& name);
    std::vector<DocumentNode> all(); // every value in it, in the order of the file
    std::string key_of(const DocumentNode& node) const; // without the table's own key
    void refuse_rest() const;                           // fails if there is a key that was not read

private:
    DocumentNode node_;
    std::set<std::string> known_;
};

} // namespace isomotion::base
