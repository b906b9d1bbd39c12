/** The diffraction methods: what a user fixes of each, as types in which nothing else can be said (docs/methods.md). */
package sunbeam.precompute.method;
