/** Random rows of light, view and color, for learning and for Monte Carlo integrals. */
package sunbeam.app.cli.sample;
