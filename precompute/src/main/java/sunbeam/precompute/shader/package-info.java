/** Input of shaders, independent of OpenGL: named arrays, defines and uniforms. */
package sunbeam.precompute.shader;
