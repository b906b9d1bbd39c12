/** Uploads methods' tables and compiles shaders with the methods' defines and uniforms. */
package sunbeam.app.gpu;
