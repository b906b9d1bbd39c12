/** Tables and plans to textures, defines and uniforms of the shaders. */
package sunbeam.app.gpu;
