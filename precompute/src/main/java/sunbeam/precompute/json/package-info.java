/** JSON files that remember on which line each value stands, for messages; settings are read from and written to them. */
package sunbeam.precompute.json;
