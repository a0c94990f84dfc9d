"""C text becomes a shared library, once: compiled by the user's compiler, kept under the hash of all that made it."""

from softcat_sym.native.cache import CacheEntry, cache_entries, cache_folder, clear_cache
from softcat_sym.native.compiler import Compiler, find_compiler
from softcat_sym.native.library import OPTIMISED, compile_library, load

__all__ = [
    "OPTIMISED",
    "CacheEntry",
    "Compiler",
    "cache_entries",
    "cache_folder",
    "clear_cache",
    "compile_library",
    "find_compiler",
    "load",
]
