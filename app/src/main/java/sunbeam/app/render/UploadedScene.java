package sunbeam.app.render;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.VertexBuffer;
import org.joml.Vector3fc;
import sunbeam.app.render.GeometryBuffer.SkinGeometry;
import sunbeam.app.render.SceneLoader.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;

/** A scene in graphics memory: mesh, textures, and the method with its tables. */
final class UploadedScene implements AutoCloseable {
    private final RenderContext context;
    private final Shadows shadows;
    private SceneData data;
    private UploadedMesh mesh;
    private SkinTextures body;
    private SkinSurface skin;

    UploadedScene(RenderContext context, SceneData data) {
        this(context);
        orClose(() -> update(data));
    }

    /** Uploads a scene without its diffraction, for moving pictures of the body. */
    UploadedScene(RenderContext context, Scene scene, SceneShape shape) {
        this(context);
        orClose(() -> {
            mesh = UploadedMesh.upload(context, scene, shape.mesh(), shape.sky());
            body = SkinTextures.upload(context, shape.bodies().get(0));
            skin = SkinSurface.ofBody(context);
        });
    }

    private UploadedScene(RenderContext context) {
        this.context = context;
        this.shadows = new Shadows(context);
    }

    private void orClose(Runnable upload) {
        try {
            upload.run();
        } catch (RuntimeException | OutOfMemoryError failure) {
            close();
            throw failure;
        }
    }

    SceneData data() {
        return data;
    }

    VertexBuffer mesh() {
        return mesh.buffer();
    }

    SkinTextures body() {
        return body;
    }

    /** Returns the ground if the blend shows the body's own color, not diffraction alone. */
    Optional<Ground> ground(Scene scene) {
        return scene.ground().isPresent() && scene.hasBody() ? mesh.ground() : Optional.empty();
    }

    SkinSurface skin() {
        return skin;
    }

    /** Geometry of a scene with the uploaded meshes; draws its shadow map first, if it has shadows. */
    SkinGeometry geometry(Scene scene, int width, int height, boolean moves) {
        Optional<Vector3fc> light =
                scene.hasShadows() ? Optional.of(scene.light().towards()) : Optional.empty();
        light.ifPresent(towards -> shadows.draw(mesh(), mesh.mesh().closed(), scene.orientation(), towards, moves));
        // The shading pass of moving pictures reads shadows, so that a moving light leaves the geometry valid.
        Optional<Vector3fc> geometryLight = moves ? Optional.empty() : light;
        return new SkinGeometry(
                mesh(),
                mesh.mesh().closed(),
                body,
                scene.view(),
                scene.orientation(),
                scene.get(SceneSettings.ROTATE_PATCH),
                shadows,
                geometryLight,
                width,
                height);
    }

    void update(SceneData next) {
        UploadedMesh nextMesh = mesh != null && mesh.serves(next.scene(), next.mesh()) ? mesh : null;
        SkinTextures nextBody = body != null && body.isOf(next.body()) ? body : null;
        SkinSurface nextSkin = data != null && next.sharesMethod(data) ? skin : null;
        try {
            nextMesh =
                    nextMesh != null ? nextMesh : UploadedMesh.upload(context, next.scene(), next.mesh(), next.sky());
            nextBody = nextBody != null ? nextBody : SkinTextures.upload(context, next.body());
            nextSkin = nextSkin != null ? nextSkin : SkinSurface.create(context, next);
        } catch (RuntimeException | OutOfMemoryError failure) {
            closeUnlessSame(nextMesh, mesh, UploadedMesh::close);
            closeUnlessSame(nextBody, body, SkinTextures::close);
            closeUnlessSame(nextSkin, skin, SkinSurface::close);
            throw failure;
        }
        closeUnlessSame(mesh, nextMesh, UploadedMesh::close);
        closeUnlessSame(body, nextBody, SkinTextures::close);
        closeUnlessSame(skin, nextSkin, SkinSurface::close);
        mesh = nextMesh;
        body = nextBody;
        skin = nextSkin;
        data = next;
    }

    private static <T> void closeUnlessSame(T part, T other, Consumer<T> closing) {
        if (part != null && part != other) {
            closing.accept(part);
        }
    }

    @Override
    public void close() {
        closeUnlessSame(skin, null, SkinSurface::close);
        closeUnlessSame(body, null, SkinTextures::close);
        closeUnlessSame(mesh, null, UploadedMesh::close);
        shadows.close();
    }

    /** @param ground ground below the mesh; present if the mesh has the visible share of the sky per vertex */
    private record UploadedMesh(Mesh mesh, VertexBuffer buffer, Optional<Ground> ground) implements AutoCloseable {

        /** May wait for the visible share of the sky. */
        static UploadedMesh upload(RenderContext context, Scene scene, Mesh mesh, Supplier<SkyVisibility> sky) {
            if (!scene.occludesSky()) {
                return new UploadedMesh(
                        mesh, context.createVertexBuffer("mesh", mesh.toVertexData()), Optional.empty());
            }
            SkyVisibility seen = sky.get();
            VertexBuffer buffer = context.createVertexBuffer("mesh", mesh.toVertexData(seen.ofVertices()));
            Ground ground =
                    Resource.orClose(() -> Ground.create(context, SkyVisibility.ground(mesh), seen), buffer::close);
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
}
