/** Random rows of light, view and color, for learning and for integrals. */
package sunbeam.app.cli.sample;
