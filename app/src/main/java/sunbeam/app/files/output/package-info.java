/** Writers of files, which appear complete under their name or not at all. */
package sunbeam.app.files.output;
