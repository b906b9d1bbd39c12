/** Command {@code evaluate}, the thesis's evaluation by the grating equation: a patch's period from its response to light. */
package sunbeam.app.cli.evaluate;
