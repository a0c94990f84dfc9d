"""C text becomes a shared library, once: compiled by the user's compiler, kept under the hash of all that made it."""

from softcat_sym.native.beside import beside
from softcat_sym.native.cache import CacheEntry, cache_entries, clear_cache
from softcat_sym.native.compiler import Compiler, compiler_name, find_compiler
from softcat_sym.native.folder import cache_folder
from softcat_sym.native.library import OPTIMISED, SOON, compile_library, load
from softcat_sym.native.limit import cache_limit, size_text
from softcat_sym.native.texts import kept_texts

__all__ = [
    "OPTIMISED",
    "SOON",
    "CacheEntry",
    "Compiler",
    "beside",
    "cache_entries",
    "cache_folder",
    "cache_limit",
    "clear_cache",
    "compile_library",
    "compiler_name",
    "find_compiler",
    "kept_texts",
    "load",
    "size_text",
]
