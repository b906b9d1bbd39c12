/** Plans of the sums for a patch, a window and the directions that a scene can reach; the shader's arrays, defines and uniforms. */
package sunbeam.precompute.plan;
