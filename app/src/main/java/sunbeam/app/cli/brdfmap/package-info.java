/** Command {@code brdf-map}: colors of all directions of the hemisphere, drawn as a disc. */
package sunbeam.app.cli.brdfmap;
