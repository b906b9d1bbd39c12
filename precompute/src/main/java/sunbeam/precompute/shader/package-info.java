/** What shaders read, made and kept without OpenGL: named arrays, defines and uniforms. */
package sunbeam.precompute.shader;
