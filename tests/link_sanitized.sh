#!/bin/sh
# Links a test whose own objects have no sanitizers with libraries that have them:
#
#   link_sanitized.sh <compiler and options> -- <objects> -- <libraries>
#
# What headers of src/ define inline is in objects of both, and linkers take the first that they see. So
# the libraries of src/ stand first, whole, and each once.
set -eu
link='' objects='' whole=''
while [ "$1" != -- ]; do link="$link $1" && shift; done
shift
while [ "$1" != -- ]; do objects="$objects $1" && shift; done
shift
for library in "$@"; do
    case $library in
        src/*.a) case " $whole " in *" $library "*) ;; *) whole="$whole $library" ;; esac ;;
    esac
done
# shellcheck disable=SC2086 # lists of words
exec $link -Wl,--whole-archive $whole -Wl,--no-whole-archive $objects "$@"
