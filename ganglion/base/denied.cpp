#include "ganglion/base/denied.h"

#include <exception>
#include <new>
#include <system_error>

namespace ganglion {

Error denied() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {ErrorCode::TooLarge,
            say({"out of memory: take fewer robots, threads or seeds, or a smaller world",
                 "no queda memoria: tome menos robots, hilos o semillas, o un mundo más pequeño"})};
  } catch (const std::system_error& error) {
    return {
        ErrorCode::TooLarge,
        say({"the system denies what is needed (threads, descriptors): end other programs, or take fewer threads: {}",
             "el sistema niega lo necesario (hilos, descriptores): cierre otros programas o tome menos hilos: {}"},
            error.what())};
  } catch (const std::exception& error) {
    return {ErrorCode::Unsupported, say({"this is a fault of the program, please report it: {}",
                                         "es un error del programa, por favor avise: {}"},
                                        error.what())};
  }
}

}  // namespace ganglion
