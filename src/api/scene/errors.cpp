#include "api/scene/errors.h"

#include <new>

#include <fmt/format.h>

#include "base/file.h"
#include "base/input_error.h"
#include "formula/graph/parser.h"

namespace isomotion::api {

void throw_error() {
    using Code = Error::Code;
    try {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const base::InputError& error) {
        throw Error(Code::input, error.what());
    } catch (const base::FileError& error) {
        throw Error(Code::file, error.what());
    } catch (const formula::ParseError& error) {
        throw Error(Code::formula, error.what());
    } catch (const std::invalid_argument& error) {
        throw Error(Code::input, error.what());
    } catch (const std::length_error& error) {
        throw Error(Code::limit, error.what());
    } catch (const std::exception& error) {
        throw Error(Code::internal, fmt::format("{}; please report this", error.what()));
    }
}

} // namespace isomotion::api
