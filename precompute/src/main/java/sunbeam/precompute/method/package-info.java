/** Diffraction methods that a user can choose: their settings, plans and shader tables. */
package sunbeam.precompute.method;
