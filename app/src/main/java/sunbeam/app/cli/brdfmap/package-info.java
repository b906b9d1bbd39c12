/** BRDF maps: directions of the hemisphere as a disc, and their colors. */
package sunbeam.app.cli.brdfmap;
