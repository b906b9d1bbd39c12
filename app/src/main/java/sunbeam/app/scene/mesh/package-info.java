/**
 * Meshes: read from files, written to them, or generated. No OpenGL.
 *
 * <p>Lengths are metres, z points up, triangles are counter-clockwise seen from outside. Every mesh has what the tangent
 * frame needs: unit normals, and unit tangents along the texture's u with their handedness; where a file lacks them they
 * are computed ({@link sunbeam.app.scene.mesh.MeshReader} says how).
 */
package sunbeam.app.scene.mesh;
