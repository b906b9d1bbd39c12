/** Colors of bodies: textures of meshes, generated or read from files. */
package sunbeam.app.scene.texture;
