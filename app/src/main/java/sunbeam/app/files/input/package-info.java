/** Readers of commands' input files, which are untrusted. */
package sunbeam.app.files.input;
