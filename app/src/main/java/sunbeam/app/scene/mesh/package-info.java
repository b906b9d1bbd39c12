/**
 * Meshes: read from files, written to them, or generated. No OpenGL.
 *
 * <p>Lengths are in meters, z points up, triangles are counter-clockwise seen from outside. Every mesh has unit normals, and unit tangents
 * along the texture's u with their handedness; {@link sunbeam.app.scene.mesh.VertexAssembly} computes normals and tangents that a file lacks.
 */
package sunbeam.app.scene.mesh;
