/** Loads the data of scenes and draws pictures: geometry, skin, shadows, ground, sums over lights and patches. */
package sunbeam.app.render;
