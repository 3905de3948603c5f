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
    mkdir -p build
    rm -f build/installed
    # shellcheck disable=SC2086 # a list of packages
    { $as_root apt-get -qq update &&
          $as_root env DEBIAN_FRONTEND=noninteractive \
              apt-get -qq -y --no-install-recommends -o APT::Status-Fd=3 install $missing \
              3>&1 >/dev/null && : >build/installed; } | show_packages
    if [ ! -e build/installed ]; then
        echo "apt-get could not install them. By hand:" >&2
        echo "    apt-get update && apt-get install --no-install-recommends$missing" >&2
        exit 3
    fi
}

# Reads apt-get's status lines, "pmstatus:libfmt-dev:42.5:Unpacking ...", and shows how far it is: on a
# terminal in one line, else every fourth part.
show_packages() {
    shown=0
    while IFS=: read -r kind _ percent words; do
        case $kind in dlstatus | pmstatus) ;; *) continue ;; esac
        part=${percent%%.*}
        if [ -t 1 ]; then
            printf '\r  %3s %% %-64.64s' "$part" "$words"
        elif [ "$kind" = pmstatus ] && [ "$((part / 25))" -gt "$shown" ]; then
            shown=$((part / 25))
            echo "  $part %"
        fi
    done
    [ ! -t 1 ] || echo
}

# prepare_check <check>: its packages of check-packages.txt.
prepare_check() {
    prepare_packages $(sed -n "s/^$1 //p" tools/check-packages.txt)
}

# Reads what ninja says and shows how far it is: on a terminal in one line, else every tenth part.
show_steps() {
    shown=0 of=0
    while IFS= read -r line; do
        case $line in "["[0-9]*/[0-9]*"]"*) ;; *) continue ;; esac
        step=${line#"["}
        total=${step#*/} step=${step%%/*}
        total=${total%%"]"*}
        [ "$total" = "$of" ] || { shown=0 of=$total; }
        if [ -t 1 ]; then
            printf '\r  step %s of %s  ' "$step" "$total"
        elif [ $((10 * step / total)) -gt $shown ]; then
            shown=$((10 * step / total))
            echo "  step $step of $total"
        fi
    done
    [ ! -t 1 ] || [ "$of" = 0 ] || echo
}

# build_in <preset> <targets> <cmake options>: configures and builds build/<preset>, showing how far it is,
# and the log (build/build.log) only on failure. No targets: all.
build_in() {
    preset=$1 targets=$2
    shift 2
    mkdir -p build
    echo "building (build/$preset, log in build/build.log)"
    rm -f build/built
    # shellcheck disable=SC2086 # a list of targets
    { cmake --preset "$preset" "$@" && cmake --build --preset "$preset" ${targets:+--target $targets} &&
        : >build/built; } 2>&1 | tee build/build.log | show_steps
    if [ ! -e build/built ]; then
        cat build/build.log >&2
        exit 3
    fi
}

# build <cmake options>: all of build/release.
build() { build_in release "" "$@"; }

# What only tests need comes last in the list; `without_tests` leaves it out.
if [ -n "${without_tests:-}" ]; then
    prepare_packages $(sed '/^# to test/,$d; s/#.*//' tools/packages.txt)
else
    prepare_packages $(sed 's/#.*//' tools/packages.txt)
fi
