/** Files that commands read; each is untrusted. */
package sunbeam.app.files.input;
