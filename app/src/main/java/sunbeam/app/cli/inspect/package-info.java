/** What a patch shows before any light meets it: figures as text and pictures on one sheet. */
package sunbeam.app.cli.inspect;
