/** Tables of colors as files for other programs. */
package sunbeam.app.cli.export;
