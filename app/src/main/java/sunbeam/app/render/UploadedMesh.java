package sunbeam.app.render;

import java.util.Optional;
import java.util.function.Supplier;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.VertexBuffer;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;

/**
 * A mesh in graphics memory.
 *
 * @param ground ground below the mesh; present if the mesh was uploaded with the visible share of the sky per vertex
 */
record UploadedMesh(Mesh mesh, VertexBuffer buffer, Optional<Ground> ground) implements AutoCloseable {

    /** Uploads a mesh for a scene; may wait for the visible share of the sky. */
    static UploadedMesh upload(RenderContext context, Scene scene, Mesh mesh, Supplier<SkyVisibility> sky) {
        if (!scene.occludesSky()) {
            return new UploadedMesh(mesh, context.createVertexBuffer("mesh", mesh.toVertexData()), Optional.empty());
        }
        SkyVisibility seen = sky.get();
        VertexBuffer buffer = context.createVertexBuffer("mesh", mesh.toVertexData(seen.ofVertices()));
        Ground ground = Resource.orClose(() -> Ground.create(context, SkyVisibility.ground(mesh), seen), buffer::close);
        return new UploadedMesh(mesh, buffer, Optional.of(ground));
    }

    @SuppressWarnings("ReferenceEquality") // comparing triangles would take as long as uploading them
    boolean serves(Scene scene, Mesh wanted) {
        return mesh == wanted && (ground.isPresent() || !scene.occludesSky());
    }

    @Override
    public void close() {
        ground.ifPresent(Ground::close);
        buffer.close();
    }
}
