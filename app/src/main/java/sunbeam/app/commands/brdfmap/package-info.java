/** BRDF maps: directions of the hemisphere as a disc, and their colours. */
package sunbeam.app.commands.brdfmap;
