# Shared by ./run, ./test and .ci/run: checks for cargo and a Vulkan driver, and installs Mesa's
# software driver where there is none, and ffmpeg for the tests. Sourced with the repository's root as
# the current folder.

say() { printf '%s\n' "$*" >&2; }
die() { say "error: $*"; exit 2; }

require_cargo() {
    if ! command -v cargo >/dev/null 2>&1 && [ -x "$HOME/.cargo/bin/cargo" ]; then
        PATH="$HOME/.cargo/bin:$PATH"
    fi
    command -v cargo >/dev/null 2>&1 || die "cargo not found; install Rust from https://rustup.rs"
    command -v c++ >/dev/null 2>&1 || command -v clang++ >/dev/null 2>&1 || require_compiler
}

has_vulkan_driver() {
    [ "$(uname -s)" = Darwin ] && return 0
    [ -n "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] && return 0
    local folder
    for folder in /usr/share/vulkan/icd.d /etc/vulkan/icd.d /usr/local/share/vulkan/icd.d \
        "${XDG_DATA_HOME:-$HOME/.local/share}/vulkan/icd.d"; do
        compgen -G "$folder/*.json" >/dev/null && return 0
    done
    return 1
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null 2>&1; then
        sudo "$@"
    else
        die "not root, and no sudo: run as root: $*"
    fi
}

apt_install() {
    command -v apt-get >/dev/null 2>&1 || return 1
    # The lists of a fresh machine are empty or old: only then are they fetched.
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "$@" \
        >/dev/null 2>&1 && return 0
    as_root apt-get update -qq || die "apt-get update failed"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "$@" \
        >/dev/null || die "apt-get install $* failed"
}

require_vulkan() {
    has_vulkan_driver && return 0
    say "No Vulkan driver found: installing Mesa's software driver (mesa-vulkan-drivers)"
    apt_install mesa-vulkan-drivers libvulkan1 || die "no apt-get here: install a Vulkan driver by \
hand, such as Mesa's lavapipe (Fedora: mesa-vulkan-drivers, Arch: vulkan-swrast)"
    has_vulkan_driver || die "the driver was installed, but /usr/share/vulkan/icd.d is empty"
}

# The picture comparison (FLIP) is C++.
require_compiler() {
    say "No C++ compiler found: installing g++"
    apt_install g++ || die "no apt-get here: install a C++ compiler by hand"
}

# Films are encoded by it. Where it is or can be installed, their tests fail without it; elsewhere they
# check only what is said then.
want_ffmpeg() {
    export SWARD_TEST_FFMPEG=1
    command -v ffmpeg >/dev/null 2>&1 && return 0
    say "No ffmpeg found: installing it"
    (apt_install ffmpeg) && return 0
    say "ffmpeg cannot be installed here: films are not tested"
    unset SWARD_TEST_FFMPEG
}

require_runtime_dir() {
    [ -n "${XDG_RUNTIME_DIR:-}" ] && return 0
    XDG_RUNTIME_DIR="${TMPDIR:-/tmp}/sward-runtime-$(id -u)"
    mkdir -p -m 700 "$XDG_RUNTIME_DIR"
    export XDG_RUNTIME_DIR
}
