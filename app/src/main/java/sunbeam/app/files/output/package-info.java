/** Files that commands write: complete under their name, or not at all. */
package sunbeam.app.files.output;
