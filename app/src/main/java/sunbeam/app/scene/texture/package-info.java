/** Textures of meshes: colors, relief of scales, orientation maps and patch maps; generated or read from files. */
package sunbeam.app.scene.texture;
