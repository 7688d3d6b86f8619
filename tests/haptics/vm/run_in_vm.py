#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Runs a test program under Debian's own kernel in QEMU: real USB core, real usbhid, no hardware, no root, no network.

usage: run_in_vm.py WORKDIR GUEST_TEST USBIP_DEVICE

The kernel package is downloaded once into WORKDIR and unpacked there, nothing is installed. Exit 77: cannot be done
here (the reason is printed).
"""
import gzip
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

SKIP = 77
MODULES = ["usbip-core", "vhci-hcd", "usbhid", "hid-generic"]
TIMEOUT = 360  # s; under TCG on an idle machine it takes a small part of that
INIT = """#!/bin/busybox sh
/bin/busybox mkdir -p /proc /sys /dev /tmp
/bin/busybox mount -t proc none /proc
/bin/busybox mount -t sysfs none /sys
/bin/busybox mount -t devtmpfs none /dev
exec </dev/console >/dev/console 2>&1
/bin/busybox chmod 1777 /tmp
for module in $(/bin/busybox cat /modules); do /bin/busybox insmod $module || echo "GUEST: no $module"; done
/bin/guest-test
/bin/busybox dmesg | /bin/busybox grep -i "force feedback"
/bin/busybox poweroff -f
"""


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIP)


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def kernel(work):
    """The unpacked package's folder."""
    unpacked = work / "kernel"
    if list(unpacked.glob("boot/vmlinuz-*")):
        return unpacked
    if not shutil.which("apt-get"):
        skip("no apt-get to fetch a kernel with")
    depends = run("apt-cache", "depends", "linux-image-amd64").stdout
    name = re.search(r"Depends: (linux-image-\S+-amd64)", depends)
    if not name:
        skip("apt knows no kernel linux-image-amd64")
    fetched = run("apt-get", "download", name.group(1), cwd=work)
    package = next(iter(sorted(work.glob("linux-image-*.deb"))), None)
    if fetched.returncode != 0 or not package:
        skip("the kernel package could not be downloaded: " + fetched.stderr.strip().splitlines()[-1])
    subprocess.run(["dpkg", "-x", package, unpacked], check=True)
    package.unlink()
    return unpacked


def with_dependencies(tree, names):
    """Module files in the order in which they have to be loaded."""
    files = {path.stem.replace("_", "-"): path for path in tree.glob("lib/modules/**/*.ko")}
    order = []

    def add(name):
        name = name.replace("_", "-")
        if name not in files or files[name] in order:
            return
        data = files[name].read_bytes()
        found = re.search(rb"\0depends=([^\0]*)\0", b"\0" + data)
        for needed in (found.group(1).decode().split(",") if found else []):
            if needed:
                add(needed)
        order.append(files[name])

    for name in names:
        if name not in files:
            skip(f"the kernel has no module {name}")
        add(name)
    return order


def libraries(program):
    """What the program loads, by where it expects it."""
    return re.findall(r"(/\S+) \(0x", run("ldd", program).stdout)


def entry(name, data, mode, number):
    """One file of a cpio archive (newc)."""
    encoded = name.encode() + b"\0"
    fields = [number, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(encoded), 0]
    header = b"070701" + b"".join(b"%08X" % field for field in fields)
    return (header + encoded).ljust((len(header) + len(encoded) + 3) & ~3, b"\0") + data.ljust((len(data) + 3) & ~3, b"\0")


def initramfs(tree, guest_test, usbip_device):
    files = {"bin/busybox": shutil.which("busybox"), "bin/guest-test": guest_test, "bin/esm-usbip-device": usbip_device}
    for program in (guest_test, usbip_device):
        for library in libraries(program):
            files[library.lstrip("/")] = library
    modules = with_dependencies(tree, MODULES)
    for module in modules:
        files["modules.d/" + module.name] = module
    contents = {name: (Path(path).read_bytes(), 0o100755) for name, path in files.items()}
    contents["init"] = (INIT.encode(), 0o100755)
    contents["modules"] = ("\n".join("/modules.d/" + module.name for module in modules).encode(), 0o100644)
    contents["etc/passwd"] = (b"root:x:0:0::/:/bin/sh\n", 0o100644)
    folders = sorted({str(parent) for name in contents for parent in Path(name).parents if str(parent) != "."})
    archive = b""
    for number, folder in enumerate(folders):
        archive += entry(folder, b"", 0o040755, number + 1)
    for number, (name, (data, mode)) in enumerate(contents.items()):
        archive += entry(name, data, mode, 1000 + number)
    return archive + entry("TRAILER!!!", b"", 0, 0)


def main():
    work = Path(sys.argv[1])
    work.mkdir(parents=True, exist_ok=True)
    for program in ("qemu-system-x86_64", "busybox", "dpkg", "ldd"):
        if not shutil.which(program):
            skip(f"no {program}")
    tree = kernel(work)
    image = work / "initramfs.gz"
    image.write_bytes(gzip.compress(initramfs(tree, sys.argv[2], sys.argv[3]), 1))
    vmlinuz = next(tree.glob("boot/vmlinuz-*"))
    log = work / "console.log"
    command = ["qemu-system-x86_64", "-accel", "tcg", "-cpu", "max", "-m", "512", "-smp", "2", "-nodefaults", "-no-reboot", "-display",
               "none", "-serial", f"file:{log}", "-kernel", vmlinuz, "-initrd", image,
               # no_timer_check: on a busy host the emulated timer is late, which the kernel takes for a broken one
               "-append", "console=ttyS0 loglevel=3 panic=-1 no_timer_check rdinit=/init"]
    try:
        subprocess.run(command, timeout=TIMEOUT, check=True)
    except subprocess.TimeoutExpired:
        print(f"the guest did not end within {TIMEOUT} s")
    text = log.read_text(errors="replace")
    print(text)
    accepted = "Force feedback for USB HID PID devices" in text
    print("ok   the kernel's own hid-pidff accepts the stick's descriptor" if accepted else "FAIL hid-pidff")
    sys.exit(0 if "GUEST: ALL HOLDS" in text and accepted and "FAIL" not in text else 1)


main()
