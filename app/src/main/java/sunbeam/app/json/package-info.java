/** JSON files that remember on which line each value stands, for messages. */
package sunbeam.app.json;
