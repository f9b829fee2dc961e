"""Generates the .meta files by which Unity identifies each file and folder of the package. The identifier, which must
never change, is the hash of the file's path, so that git does not need the .meta files."""

from __future__ import annotations

import hashlib
from pathlib import Path

# Platforms, in Unity's terms, on which the installed libraries are loaded. hrt_plate is not installed for Android.
LINUX = {"Editor: Editor": {"CPU": "x86_64", "DefaultValueInitialized": "true", "OS": "Linux"},
         "Standalone: Linux64": {"CPU": "x86_64"}}
WINDOWS = {"Editor: Editor": {"CPU": "x86_64", "DefaultValueInitialized": "true", "OS": "Windows"},
           "Standalone: Win64": {"CPU": "x86_64"}}
LIBRARIES = {
    "Runtime/Plugins/Android/arm64-v8a/libhaptic_retargeting.so": {"Android: Android": {"CPU": "ARM64"}},
    "Runtime/Plugins/Linux/x86_64/libhaptic_retargeting.so": LINUX,
    "Runtime/Plugins/Linux/x86_64/libhrt_plate.so": LINUX,
    "Runtime/Plugins/Windows/x86_64/haptic_retargeting.dll": WINDOWS,
    "Runtime/Plugins/Windows/x86_64/hrt_plate.dll": WINDOWS,
}
PLATFORMS = {"Android: Android": "Android", "Editor: Editor": "Editor", "Standalone: Linux64": "Linux64",
             "Standalone: OSXUniversal": "OSXUniversal", "Standalone: Win": "Win", "Standalone: Win64": "Win64"}

IMPORTERS = {".cs": "MonoImporter", ".asmdef": "AssemblyDefinitionImporter", ".md": "TextScriptImporter"}
MONO = "  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n"
END = "  userData: \n  assetBundleName: \n  assetBundleVariant: \n"


def platform_data(loaded_by: dict[str, dict[str, str]]) -> str:
    excluded = "".join(f"        Exclude {name}: {int(key not in loaded_by)}\n" for key, name in PLATFORMS.items())
    text = f"  platformData:\n  - first:\n      : Any\n    second:\n      enabled: 0\n      settings:\n{excluded}"
    text += "  - first:\n      Any: \n    second:\n      enabled: 0\n      settings: {}\n"
    for key in PLATFORMS:
        settings = loaded_by.get(key, {"CPU": "None"} if key.startswith("Standalone") else {})
        text += f"  - first:\n      {key}\n    second:\n      enabled: {int(key in loaded_by)}\n"
        text += "      settings:\n" + "".join(f"        {k}: {v}\n" for k, v in settings.items()) if settings \
            else "      settings: {}\n"
    return text


def meta(asset: Path, is_folder: bool) -> str:
    guid = hashlib.md5(f"com.haptic-retargeting/{asset.as_posix()}".encode()).hexdigest()
    text = f"fileFormatVersion: 2\nguid: {guid}\n"
    if asset.as_posix() in LIBRARIES:
        return (text + "PluginImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  iconMap: {}\n"
                "  executionOrder: {}\n  defineConstraints: []\n  isPreloaded: 0\n  isOverridable: 0\n"
                "  isExplicitlyReferenced: 0\n  validateReferences: 1\n"
                + platform_data(LIBRARIES[asset.as_posix()]) + END)
    if is_folder:
        return text + "folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n" + END
    importer = "PackageManifestImporter" if asset.name == "package.json" else IMPORTERS[asset.suffix]
    return text + f"{importer}:\n  externalObjects: {{}}\n" + (MONO if importer == "MonoImporter" else "") + END


def render(package: Path, generated: list[str]) -> dict[str, str]:
    """Returns the path in the package and the text of each .meta file. `generated`: files of the package that are
    generated too."""
    files = {path.relative_to(package) for path in package.rglob("*") if path.is_file() and path.suffix != ".meta"}
    files |= {Path(name) for name in [*generated, *LIBRARIES]}
    folders = {folder for file in files for folder in file.parents} - {Path(".")}
    # Unity ignores names that begin with a dot, and folders that end with a tilde.
    return {f"{asset.as_posix()}.meta": meta(asset, asset in folders) for asset in files | folders
            if not any(part.startswith(".") or part.endswith("~") for part in asset.parts)}
