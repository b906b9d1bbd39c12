/** JSON files with the line of each value, for messages; settings are read from and written to them. */
package sunbeam.precompute.json;
