#include "api/drawing/errors.h"

#include "api/scene/errors.h"
#include "gpu/context.h"
#include "gpu/error.h"
#include "image/frame.h"
#include "render/renderer.h"
#include "sequence/movies/movie.h"

namespace isomotion::api {

void throw_drawing_error() {
    using Code = Error::Code;
    try {
        throw;
    } catch (const gpu::Unavailable& error) {
        throw Error(Code::device, error.what());
    } catch (const gpu::ContextLost& error) {
        throw Error(Code::device, error.what());
    } catch (const gpu::CompileError& error) {
        throw Error(Code::device, error.what());
    } catch (const gpu::ResourceError& error) {
        throw Error(Code::device, error.what());
    } catch (const image::ImageError& error) {
        throw Error(Code::input, error.what());
    } catch (const sequence::MovieError& error) {
        throw Error(Code::file, error.what());
    } catch (const render::Stopped&) {
        throw_stopped();
    } catch (...) {
        throw_error();
    }
}

} // namespace isomotion::api
