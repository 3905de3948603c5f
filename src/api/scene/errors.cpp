#include "api/scene/errors.h"

#include <filesystem>
#include <new>
#include <system_error>

#include <fmt/format.h>

#include "base/file.h"

namespace isomotion::api {

void throw_error() {
    using Code = Error::Code;
    try {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::invalid_argument& error) {
        throw Error(Code::input, error.what());
    } catch (const std::length_error& error) {
        throw Error(Code::limit, error.what());
    } catch (const std::filesystem::filesystem_error& error) { // a path that is too long
        const base::FileError same(error.path1(), "cannot be reached", error.code().value());
        throw Error(Code::file, same.what());
    } catch (const std::system_error& error) { // no thread is to be had
        throw Error(Code::device, fmt::format("{}: too little memory or too many processes (ulimit "
                                              "-v, ulimit -u)",
                                              error.code().message()));
    } catch (const std::logic_error& error) {
        throw Error(Code::internal, error.what());
    } catch (const std::runtime_error& error) { // a library or a driver refuses
        throw Error(Code::device, error.what());
    } catch (const std::exception& error) {
        throw Error(Code::internal, error.what());
    }
}

} // namespace isomotion::api
