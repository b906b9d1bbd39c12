/** Colors of bodies: pictures made in code or read from files, for meshes to wear. */
package sunbeam.app.scene.texture;
