/** Command {@code orders}: the light in each diffraction order. */
package sunbeam.app.cli.orders;
