/** Expansions of exp(i k w h) into functions of direction and wavelength times functions of the height. */
package sunbeam.precompute.expansion;
