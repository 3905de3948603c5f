// Parses text to an expression graph.
//
//     formula     = { definition ';' } ( value | value '=' value )
//     definition  = name [ '(' names ')' ] '=' value
//     value       = disjunction [ '?' value ':' value ]
//     disjunction = conjunction { 'or' conjunction }
//     conjunction = negation { 'and' negation }
//     negation    = 'not' negation | comparison
//     comparison  = expression { ('<' | '<=' | '>' | '>=' | '!=') expression }
//     expression  = term { ('+' | '-') term }
//     term        = factor { ('*' | '/' | '') factor }
//     factor      = ('-' | '+') factor | power
//     power       = primary [ '^' factor ]     (right associative; -x^2 is -(x^2))
//     primary     = number | name | name '(' arguments ')' | '(' value ')' | '|' expression '|'
//
// These signs and names have other spellings (text_cursor.h, spelling.h). Functions are those of
// functions.h and composed_functions.h, those that are defined before, and those of library.txt. In
// chebyshev(n, a), n is a constant integer. In sum(array, expression), least(array, expression) and
// greatest(array, expression) the array's fields are names; least(array, expression, value) is the
// value of the element whose expression is least. Constants: pi, and e and tau where these names
// have no other meaning. `name = expression;` names a repeated part, `name(u, v) = expression;` a
// function, which must not call itself. An argument or a named part f can be taken at another
// point: f(u, v, w).
#pragma once

#include <string>
#include <string_view>

#include <isomotion/error.h>

#include "formula/graph/graph.h"
#include "formula/graph/names.h"
#include "formula/graph/vocabulary.h"

namespace isomotion::formula {

class ParseError : public Error {
public:
    // `offset` is a byte offset into `text`. what() is the message, followed by the line of the
    // formula with the mistake and a caret below the place.
    ParseError(std::string_view text, std::size_t offset, const std::string& message);

    const std::string& message() const { return message_; }
    int line() const { return line_; }     // 1-based within the formula
    int column() const { return column_; } // 1-based, in characters

private:
    std::string message_;
    int line_ = 1;
    int column_ = 1;
};

// Throws ParseError, also for expressions that cannot have a value: division by the constant 0, the
// logarithm of a negative constant.
NodeId parse(std::string_view text, const Names& names, Graph& graph);
NodeId parse(std::string_view text, const Vocabulary& vocabulary, Graph& graph);

} // namespace isomotion::formula
