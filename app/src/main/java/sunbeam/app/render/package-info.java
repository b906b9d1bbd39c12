/** Loads what scenes show and draws it: geometry, skin, shadows, ground, sums over lights and lit patches. */
package sunbeam.app.render;
