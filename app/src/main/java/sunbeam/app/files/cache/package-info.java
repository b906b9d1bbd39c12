/** Tables of surfaces in the cache folder, and what is computed where they are missing. */
package sunbeam.app.files.cache;
