# Sourced by the commands beside it: leaves the repository's root as the working directory and the
# packages of packages.txt installed, or says what is missing and stops.

set -eu
cd "$(dirname "$0")/.."

# prepare_packages <package>...
prepare_packages() {
    missing=
    for package in "$@"; do
        case $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) in
            installed) ;;
            *) missing="$missing $package" ;;
        esac
    done
    [ -n "$missing" ] || return 0
    as_root=
    if [ "$(id -u)" != 0 ]; then as_root=$(command -v sudo || echo none); fi
    if [ "$as_root" = none ] || ! command -v apt-get >/dev/null; then
        echo "These Debian packages are missing, and installing them needs apt-get and root:" >&2
        echo "    apt-get install --no-install-recommends$missing" >&2
        exit 3
    fi
    echo "installing:$missing"
    if ! { $as_root apt-get -qq update &&
           $as_root env DEBIAN_FRONTEND=noninteractive \
               apt-get -qq -y --no-install-recommends install $missing >/dev/null; }; then
        echo "apt-get could not install them. By hand:" >&2
        echo "    apt-get update && apt-get install --no-install-recommends$missing" >&2
        exit 3
    fi
}

# prepare_check <check>: its packages of check-packages.txt.
prepare_check() {
    prepare_packages $(sed -n "s/^$1 //p" tools/check-packages.txt)
}

# build <cmake options>: configures and builds build/release, showing the log only on failure.
build() {
    mkdir -p build
    echo "building (build/release, log in build/build.log)"
    if ! { cmake --preset release "$@" && cmake --build --preset release; } >build/build.log 2>&1; then
        cat build/build.log >&2
        exit 3
    fi
}

prepare_packages $(sed 's/#.*//' tools/packages.txt)
